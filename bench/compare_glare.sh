#!/bin/sh
# compare_glare.sh PROGRAM [FILE.csv] - illuminance at the eye and DGP of 60 moments by PROGRAM's
# `glare`, and by Radiance's evalglare on pictures by `render`: six rooms, two views of each and
# five skies. Prints a table in Markdown; FILE.csv gets a line for each moment. Seven minutes of
# processor time. SIZE: pixels across a picture (default 256).
set -eu
LC_ALL=C
export LC_ALL

if [ $# -lt 1 ]; then
    echo "usage: compare_glare.sh PROGRAM [FILE.csv]" >&2
    exit 2
fi
pepperpot=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
size=${SIZE:-256}
if ! command -v evalglare >/dev/null; then
    echo "Radiance's evalglare is not on PATH: nothing is compared with it."
    exit 0
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
table=${2:-$scratch/moments.csv}

room() { # NAME, then what the room contains
    echo "<room version=\"1\" name=\"$1\">$2</room>" >"$scratch/$1.xml"
}
room open '<plan width="4" depth="6" height="3"/>
<finishes floor="0.2" walls="0.5" ceiling="0.7"/>
<window wall="south" left="0.5" sill="0.9" width="3" height="1.8" glazing="none"/>'
room reveal '<plan width="3.6" depth="5.4" height="2.8"/>
<finishes floor="0.3" walls="0.6" ceiling="0.8"/>
<window wall="south" left="0.2" sill="0.8" width="1.4" height="1.8" reveal="0.3"/>
<window wall="south" left="2" sill="0.8" width="1.4" height="1.8" reveal="0.3">
<overhang depth="0.8" left="0.3" right="0.3"/></window>'
room street '<plan width="5" depth="5" height="2.9"/>
<finishes floor="0.25" walls="0.5" ceiling="0.75"/>
<window wall="south" left="0.3" sill="0.6" width="4.4" height="2" glazing="low-e-double"/>
<block x="-12" y="-22" width="20" depth="10" height="9" reflectance="0.4"/>'
room corner '<plan width="5" depth="6" height="3"/>
<finishes floor="0.2" walls="0.6" ceiling="0.8"/>
<window wall="south" left="1" sill="0.9" width="3" height="1.6" glazing="clear-double"/>
<window wall="west" left="1" sill="0.5" width="2" height="2" glazing="clear-double"/>'
room rooflight '<plan width="6" depth="6" height="3.2"/>
<finishes floor="0.3" walls="0.6" ceiling="0.8"/>
<window wall="south" left="2" sill="1" width="2" height="1.2" glazing="clear-double"/>
<rooflight x="2" y="2.5" width="2" depth="1.2" glazing="clear-double"/>'
room furnished '<plan width="4" depth="7" height="2.8"/>
<finishes floor="0.2" walls="0.5" ceiling="0.7"/>
<window wall="south" left="0.4" sill="0.3" width="3.2" height="2.2" transmittance="0.6" absorbing="yes"/>
<furniture x="0.5" y="2" width="1.6" depth="0.8" height="0.75" reflectance="0.5"/>
<partition from="4 3" to="2.6 3" height="1.8"/>'

# View $2 of room $1: position and bearing.
view() {
    case $1.$2 in
    open.1) echo 2,4 180 ;;
    open.2) echo 1,2 200 ;;
    reveal.1) echo 1.8,2 180 ;;
    reveal.2) echo 1,3.5 150 ;;
    street.1) echo 2.5,2.5 180 ;;
    street.2) echo 4,1.5 225 ;;
    corner.1) echo 2.5,3.5 180 ;;
    corner.2) echo 3,4 235 ;;
    rooflight.1) echo 3,4.6 180 ;;
    rooflight.2) echo 1,5 135 ;;
    furnished.1) echo 1.3,3.4 180 ;;
    furnished.2) echo 2,1.6 240 ;;
    esac
}

# found: illuminance, its standard error, DGP, and yes if the sun is in view, of a CSV table
# by `glare` on standard input.
found() {
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) { sub("\r", "", $i); at[$i] = i }; next }
        { print $at["eye_lx"], $at["eye_se_lx"], $at["dgp"], $at["sun_visible"] }'
}

echo "room,view,sky,sun_visible,eye_lx,eye_se_lx,picture_lx,dgp,evalglare_dgp,specks" >"$table"
for room in open reveal street corner rooflight furnished; do
    for number in 1 2; do
        # shellcheck disable=SC2046 # two words
        set -- $(view "$room" $number)
        at=$1
        bearing=$2
        towards=$(awk -v b="$bearing" 'BEGIN { r = b * 3.14159265358979 / 180
            printf "%.9f,%.9f,0\n", sin(r), cos(r) }')
        for sky in overcast,20000 iso-12,30,180,70000,12000 iso-12,15,240,40000,8000 \
            perez,500,200,45,150 iso-12,40,20,60000,12000; do
            "$pepperpot" glare -q -f csv --error 0.3% --sky "$sky" --view "$at,$bearing" \
                "$scratch/$room.xml" >"$scratch/glare.csv"
            "$pepperpot" render -q --view angular --from "$at,1.2" --direction="$towards" \
                --size "${size}x$size" --sky "$sky" -o "$scratch/view.hdr" "$scratch/$room.xml"
            # A line for each source: number, pixels, place, luminance. The last line: names of
            # the figures, a colon, and the figures. Specks are sources of a few pixels above
            # 100,000 cd/m2: parts of the disc of the sun, or light found by one path only.
            evalglare -d -b 2000 "$scratch/view.hdr" 2>/dev/null | awk '
                /^[0-9]+ [0-9]+[.]/ && $2 < 10 && $5 > 1e5 { specks++ }
                /^dgp,/ { split($0, half, ": "); split(half[2], figure, " ")
                    print figure[3], figure[1], specks + 0 }' >"$scratch/picture"
            # shellcheck disable=SC2046 # several words
            set -- $(found <"$scratch/glare.csv") $(cat "$scratch/picture")
            echo "$room,$number,$(echo "$sky" | tr , ' '),$4,$1,$2,$5,$3,$6,$7" >>"$table"
        done
    done
done

# With the sun in view, the picture's illuminance depends on the few pixels that its disc meets:
# such moments are compared by DGP alone.
awk -F, '
    function size(x) { return x < 0 ? -x : x }
    NR == 1 { next }
    {
        k = $4 == "yes" ? "sun in view" : $10 > 0 ? "no sun in view, a speck in the picture" \
            : "no sun in view"
        n = kind[k]++
        lx = size($5 / $7 - 1); dgp = size($8 - $9)
        if (!n || lx > most_lx[k]) most_lx[k] = lx
        if (!n || dgp > most_dgp[k]) most_dgp[k] = dgp
        near_lx[k] += lx <= 0.005 || size($5 - $7) <= 3 * $6
        near_dgp[k] += dgp <= 0.02
        sum_dgp[k] += dgp
    }
    END {
        print "| moments | number | E_v within 0.5 % or 3 se | largest difference of E_v | DGP within 0.02 | mean and largest difference of DGP |"
        print "| --- | --- | --- | --- | --- | --- |"
        for (k in kind)
            printf "| %s | %d | %s | %s | %d | %.4f, %.4f |\n", k, kind[k],
                k ~ /^no/ ? near_lx[k] : "-", k ~ /^no/ ? sprintf("%.2f %%", 100 * most_lx[k]) : "-",
                near_dgp[k], sum_dgp[k] / kind[k], most_dgp[k]
    }' "$table"
