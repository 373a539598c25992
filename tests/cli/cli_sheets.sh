#!/bin/sh
# Printed sheets of chart: tables as published, overlays and nets, and rejected options.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# each_form NAME WORDS: draws the chart in each format, the SVG twice with identical results, and
# on the smallest and the largest paper.
each_form() {
    sheet=$1
    shift
    for format in pdf svg png; do
        quietly chart "$@" --dpi 30 -o "$scratch/$sheet.$format" || return
    done
    run chart "$@" --format svg
    cmp "$scratch/$sheet.svg" "$scratch/out" || return
    for paper in a5 a2; do
        quietly chart "$@" --paper $paper -o "$scratch/other.svg" || return
    done
}

# The figures of the BRS table: one line on the sheet for each row of the file.
check "a blank BRS table in each form" each_form table brs-table
check "one that is read for a point" each_form read brs-table -p 1.5,2 "$examples/office.xml"
as_printed() {
    pdftotext -layout "$scratch/table.pdf" - | sed 's/\*//g; s/^ *//; s/  */ /g; s/∞/inf/g' \
        >"$scratch/lines"
    grep -v -e '^#' -e h_over "$srcdir/tables/brs_simplified_table.csv" |
        sed 's/^\([0-9]\),/\1.0,/; y/,/ /' >"$scratch/rows"
    [ "$(wc -l <"$scratch/rows")" -eq 29 ] && grep -vxF -f "$scratch/lines" "$scratch/rows" |
        { ! grep . ; }
}
if command -v pdftotext >/dev/null; then
    check "the sheet has the table's figures as printed" as_printed
    check "the sheet's sum is df's" sh -c "pdftotext '$scratch/read.pdf' - | tr '\n' ' ' |
        grep -q 'sky component 1.52 %, externally reflected component 0.14 %'"
else
    skip "the table's figures and sums" "no pdftotext here"
fi
check "an exercise for it" each_form exercise brs-table --unsolved -p 1.5,2 "$deep"
pages() {
    pdfinfo "$scratch/exercise.pdf" | grep -q "^Pages: *$1\$" &&
        pdftotext "$scratch/exercise.pdf" - | grep -q "^Sky component: readings" &&
        ! pdftotext "$scratch/exercise.pdf" - | grep -q "jamb:\|head left"
}
if command -v pdfinfo >/dev/null; then
    check "it has a sheet of the room, without readings, and the blank table" pages 2
else
    skip "the exercise has two sheets" "no pdfinfo here"
fi
check "the table is of the overcast sky" \
    refuses 1 "overcast" chart brs-table --sky uniform -o "$scratch/x.pdf"
check "and of a point" refuses 2 "--points" chart brs-table -o "$scratch/x.pdf" "$deep"
check "and of vertical windows" refuses 1 "vertical" chart brs-table -p 3,3 \
    -o "$scratch/x.pdf" "$examples/studio.xml"

check "droop lines of an inclined facade" \
    quietly chart waldram --inclined -30 -p 1,1.5 -o "$scratch/x.svg" "$deep"
check "and before a window" quietly chart vertical-sky --inclined 45 -o "$scratch/x.pdf"
check "are of Waldram diagrams" refuses 2 "--inclined" chart pepper-pot --inclined 30 \
    -o "$scratch/x.pdf"
check "an angle is a right one at most" refuses 2 "-90" chart waldram --inclined 100 \
    -o "$scratch/x.pdf"

check "an overlay in each form" each_form overlay overlay
check "with the sun, for another lens and sky" \
    quietly chart overlay --latitude -33.9 --lens equisolid --sky iso-3 \
    --show dots,cells,sun -o "$scratch/x.svg"
for latitude in 0 67 90; do
    check "the sun's paths at $latitude degrees" \
        quietly chart overlay --show sun --latitude $latitude -o "$scratch/x.svg"
done
check "the sun's paths are of a place" \
    refuses 1 "--latitude" chart overlay --show sun -o "$scratch/x.pdf"
check "an overlay is of no room" refuses 1 "no room" chart overlay -o "$scratch/x.pdf" "$deep"
check "nor of a weather file" \
    refuses 2 "--weather" chart overlay --weather x.epw -o "$scratch/x.pdf"
check "a lens is one of four" refuses 2 "equisolid" chart overlay --lens wide -o "$scratch/x.pdf"
check "what is shown is one of three" refuses 2 "cells" chart overlay --show rain -o "$scratch/x.pdf"
check "only overlays have a lens" refuses 2 "--lens" chart waldram --lens equisolid \
    -o "$scratch/x.pdf"
check "a circle fits on its sheet" refuses 1 "larger --paper" chart overlay --diameter 200 \
    -o "$scratch/x.pdf"
echo '<room version="1"><plan width="4" depth="5" height="2.8"/><window wall="south" left="1"
    sill="1" width="2" height="1.4"><blind angle="-45"/></window></room>' >"$scratch/blind.xml"
check "slats in each form" each_form slats slats --slats 0.025,0.02,-45,0.6,0.3,0.002
check "the blind of a room" quietly chart slats -o "$scratch/x.svg" "$scratch/blind.xml"
check "a room without blinds has no such chart" refuses 1 "has no blind" chart slats \
    -o "$scratch/x.svg" "$deep"
check "slats are given, or those of a room" refuses 2 "--slats" chart slats -o "$scratch/x.svg"
check "and not both" refuses 2 "--slats" chart slats --slats 0.025,0.02,0 -o "$scratch/x.svg" \
    "$scratch/blind.xml"
check "slats turn by 90 degrees at most" refuses 2 "-90 to 90" chart slats \
    --slats 0.025,0.02,100 -o "$scratch/x.svg"
# The 26th byte of a PNG is its colour type: 6 with transparency, 2 without.
colours() {
    quietly chart "$@" --dpi 40 -o "$scratch/x.png" &&
        od -An -tu1 -j25 -N1 "$scratch/x.png" | tr -d ' '
}
check "a PNG of it has no ground" test "$(colours overlay)" = 6
check "and those of others have" test "$(colours brs-table)" = 2
check "a very large one is refused" refuses 1 "128 MiB" chart overlay --paper a2 --dpi 600 \
    -o "$scratch/x.png"

for room in l-shaped studio deep-office; do
    check "the net of $room" quietly chart model-net -o "$scratch/net.pdf" "$examples/$room.xml"
done
check "a small one in each form" each_form net model-net --scale 150 "$examples/office.xml"
awk '!done && /<window/ { print "<door wall=\"north\" left=\"0.3\"/><dado height=\"1.1\" reflectance=\"0.25\"/>"
    done = 1 } { print }' "$examples/office.xml" >"$scratch/covered.xml"
check "a net with a door and dados" quietly chart model-net -o "$scratch/covered.pdf" \
    "$scratch/covered.xml"
for words in "paint 0.30" "paint 0.25" "Dotted lines"; do
    check "says: $words" says "$scratch/covered.pdf" "$words"
done
check "one sheet does not hold all" refuses 1 "only a PDF can hold" chart model-net \
    -o "$scratch/x.svg" "$examples/office.xml"
sed 's/ width="3.0" depth="9.0" height="2.7"/ width="75" depth="191" height="180"/' "$deep" \
    >"$scratch/huge.xml"
check "a net of thousands of sheets is refused at once" refuses 1 "more than 400 sheets" \
    chart model-net -o "$scratch/x.pdf" "$scratch/huge.xml"
check "a scale is a number" refuses 2 "1:20" chart model-net --scale 1:20 -o "$scratch/x.pdf" "$deep"
check "a box has two numbers" refuses 2 "0.85,0.5" chart model-net --mirror-box 0.9 \
    -o "$scratch/x.pdf" "$deep"
check "only models have a scale" refuses 2 "--scale" chart plan --scale 20 -o "$scratch/x.pdf" "$deep"
check "a net is of a room" refuses 2 "room file" chart model-net -o "$scratch/x.pdf"


# Several sheets are only written after all of them are drawn: the second room has no window.
cat >"$scratch/two.xml" <<END
<building version="1"><room name="A"><plan width="3" depth="4" height="2.7"/>
<window wall="south" left="0.5" sill="0.9" width="2" height="1.4"/></room>
<room name="B" x="9"><plan width="3" depth="4" height="2.7"/>
<rooflight x="1" y="1" width="1" depth="1"/></room></building>
END
echo before >"$scratch/two-1.svg"
check "a chart of which one sheet fails is refused" refuses 1 "vertical" \
    chart vertical-sky "$scratch/two.xml" -o "$scratch/two.svg"
check "and leaves the older files" sh -c "grep -q before '$scratch/two-1.svg' &&
    ! test -e '$scratch/two-2.svg'"
check "a chart of both rooms" quietly chart plan "$scratch/two.xml" -o "$scratch/two.svg"
check "is two files" sh -c "grep -q '<svg' '$scratch/two-1.svg' '$scratch/two-2.svg'"

cat >"$scratch/fonts.conf" <<END
<?xml version="1.0"?><!DOCTYPE fontconfig SYSTEM "fonts.dtd"><fontconfig/>
END
FONTCONFIG_FILE=$scratch/fonts.conf
export FONTCONFIG_FILE
check "without any font no sheet is drawn" refuses 3 "no font is installed" \
    chart plan "$deep" -o "$scratch/boxes.svg"
unset FONTCONFIG_FILE
tap_done
