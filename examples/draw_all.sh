#!/bin/sh
# draw_all.sh PROGRAM OUT FORMAT ... - draws charts of the rooms beside this script into
# the folder OUT, in each FORMAT (pdf, svg, png); pictures by `render` only as PNG.
# Sections and plans that are newer than their room and the program are not drawn again.
# CHART_OPTIONS: further options for the chart command.
set -eu
program=$1
out=$2
shift 2
mkdir -p "$out"

# is_drawn CHART FORMAT: true if the chart is newer than $room and the program. Rooms of a
# building have separate files except in PDF; only the file of the first is checked.
is_drawn() {
    for file in "$1.$2" "$1-1.$2"; do
        [ "$file" -nt "$room" ] && [ "$file" -nt "$program" ] && return
    done
    return 1
}
# blank NAME ARGUMENTS ...: draws a diagram without a room, named blank-NAME.
blank() {
    name=$1
    shift
    for format in $formats; do
        "$program" chart ${CHART_OPTIONS-} "$@" -o "$out/blank-$name.$format"
    done
}
formats=$*
blank waldram waldram
blank waldram-unglazed waldram --glazed no
blank waldram-uniform waldram --glazed no --sky uniform
blank pepper-pot pepper-pot
blank pepper-pot-unglazed pepper-pot --glazed no
blank pepper-pot-fine pepper-pot --fine --viewing-distance 60
blank pepper-pot-vertical pepper-pot --receiver vertical
for number in 1 2 3 4 5 6 7 8 9 10; do
    blank protractor-$number protractor --number $number
done
for which in average minimum rooflight; do
    blank nomogram-$which nomogram --which $which
done
blank position-nomogram position-nomogram
blank vertical-sky vertical-sky
blank skylight-indicator skylight-indicator
blank waldram-inclined waldram --inclined 30
blank brs-table brs-table
blank overlay overlay --latitude 51.5
blank overlay-cells overlay --lens stereographic --show cells,sun --latitude 51.5
blank slats slats --slats 0.025,0.02,-30,0.7,0.4,0.002
blank protractor-double-45 protractor --glazing clear-double --slope 45
brussels='--latitude 50.9 --longitude 4.35 --time-zone 1'
blank availability availability $brussels --hours 6-18,7-17,8-18,7-15,8-16,9-17
for format; do
    "$program" chart availability ${CHART_OPTIONS-} $brussels \
        "$(dirname "$0")/deep-office.xml" -o "$out/deep-office-availability.$format"
done

# Charts of some rooms as a whole, and of points in some.
for format; do
    for room in deep-office office classroom; do
        "$program" chart nomogram ${CHART_OPTIONS-} "$(dirname "$0")/$room.xml" \
            -o "$out/$room-nomogram.$format"
    done
    "$program" chart nomogram --which minimum ${CHART_OPTIONS-} \
        "$(dirname "$0")/deep-office-obstructed.xml" \
        -o "$out/deep-office-obstructed-nomogram.$format"
    "$program" chart nomogram --which rooflight ${CHART_OPTIONS-} \
        "$(dirname "$0")/studio.xml" -o "$out/studio-nomogram.$format"
    "$program" chart position-nomogram --points 1.5,6 ${CHART_OPTIONS-} \
        "$(dirname "$0")/deep-office.xml" -o "$out/deep-office-position-nomogram.$format"
done
for format; do
    "$program" chart brs-table --points 1.4,1.5 ${CHART_OPTIONS-} \
        "$(dirname "$0")/office.xml" -o "$out/office-brs-table.$format"
    "$program" chart model-net --scale 100 --paper a4 ${CHART_OPTIONS-} \
        "$(dirname "$0")/office.xml" -o "$out/office-model-net.$format"
    "$program" chart note --points 1.4,1.5 -m bre,average-df ${CHART_OPTIONS-} \
        "$(dirname "$0")/deep-office.xml" -o "$out/deep-office-note.$format"
done
for kind in vertical-sky skylight-indicator; do
    for format; do
        "$program" chart $kind ${CHART_OPTIONS-} \
            "$(dirname "$0")/deep-office-obstructed.xml" \
            -o "$out/deep-office-obstructed-$kind.$format"
    done
done
for kind in waldram pepper-pot protractor; do
    for format; do
        for room in deep-office deep-office-obstructed office; do
            "$program" chart $kind ${CHART_OPTIONS-} --points 1.4,1.5 \
                "$(dirname "$0")/$room.xml" -o "$out/$room-$kind.$format"
        done
        "$program" chart $kind --unsolved ${CHART_OPTIONS-} --points 1.4,1.5 \
            "$(dirname "$0")/deep-office-obstructed.xml" \
            -o "$out/deep-office-obstructed-$kind-exercise.$format"
        "$program" chart $kind ${CHART_OPTIONS-} --points 2,2 \
            "$(dirname "$0")/l-shaped.xml" -o "$out/l-shaped-$kind.$format"
    done
done

# A site, existing and proposed.
site=$(dirname "$0")/sites/corner-house.xml
for format; do
    for kind in site elevation; do
        "$program" chart $kind ${CHART_OPTIONS-} "$site" -o "$out/corner-house-$kind.$format"
    done
    for line in no-sky sky-factor; do
        "$program" chart plan --before existing --line $line --room Study ${CHART_OPTIONS-} \
            "$site" -o "$out/corner-house-$line.$format"
    done
    "$program" chart sun-path --before existing --room Study ${CHART_OPTIONS-} "$site" \
        -o "$out/corner-house-sun-path.$format"
done

# Pictures of the light in rooms.
picture() {
    name=$1 room=$2
    shift 2
    "$program" render --quiet "$@" "$(dirname "$0")/$room.xml" -o "$out/$name.png"
}
picture deep-office-picture deep-office --size 480x360 --exposure human
picture studio-picture studio --size 480x360 --exposure human
picture deep-office-picture-df deep-office --size 480x360 --quantity df --false-colour \
    --paper a5 --dpi 100
picture deep-office-picture-records deep-office --size 480x360 --false-colour --records \
    --no-contours --paper a5 --dpi 100
picture studio-picture-fisheye studio --view hemispherical --size 400x400 --false-colour \
    --grid --paper a5 --dpi 100

for room in "$(dirname "$0")"/*.xml; do
    for kind in section plan; do
        for format; do
            chart=$out/$(basename "$room" .xml)-$kind
            is_drawn "$chart" "$format" ||
                "$program" chart "$kind" --simulate --quiet ${CHART_OPTIONS-} "$room" \
                    -o "$chart.$format"
        done
    done
done
