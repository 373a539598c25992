#!/bin/sh
# compare_view_out.sh PROGRAM LIST_VIEW_OUT [FOLDER] - the view out from one eye in each of 30
# random rooms, by LIST_VIEW_OUT (bench/list_view_out) and by a count of rays through the scene
# that PROGRAM's `export --to radiance` writes. Radiance's rtrace follows a ray from the eye for
# every tenth of a degree of bearing and quarter of a degree of altitude, to the first surface or
# pane, and from the pane to the first surface outside. Prints a line for each room and a summary.
# FOLDER keeps the last room and the table. Three minutes of processor time.
set -eu
LC_ALL=C
export LC_ALL

if [ $# -lt 2 ]; then
    echo "usage: compare_view_out.sh PROGRAM LIST_VIEW_OUT [FOLDER]" >&2
    exit 2
fi
pepperpot=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
list=$(cd "$(dirname "$2")" && pwd)/$(basename "$2")
for program in oconv rtrace; do
    command -v $program >/dev/null && continue
    echo "Radiance's $program is not on PATH: nothing is compared with it."
    exit 0
done
folder=${3:-$(mktemp -d)}
[ $# -gt 2 ] || trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder"
cd "$folder"

# Room number $1 in room.xml. Its eye is in the file `eye`: x y z and the level of the ground.
room() {
    awk -v room="$1" 'function chance() {
        state = state * 16807 % 2147483647
        return state / 2147483647
    }
    function between(low, high) { return low + (high - low) * chance() }
    function window(wall, wide,    ww, wh, s) {
        ww = wide * between(.2, .9); s = between(.1, 1.3); wh = (h - s) * between(.4, .9)
        printf "<window wall=\"%s\" left=\"%.2f\" sill=\"%.2f\" width=\"%.2f\" height=\"%.2f\"",
            wall, (wide - ww) * chance(), s, ww, wh
        if (chance() < .4) printf " reveal=\"%.2f\"", between(.1, .5)
        printf ">"
        if (chance() < .3) printf "<overhang depth=\"%.2f\" left=\"0.3\"/>", between(.3, 1.2)
        if (chance() < .2) printf "<fin depth=\"%.2f\"/>", between(.3, .8)
        if (chance() < .2) printf "<balcony depth=\"1.3\" left=\"0.5\" right=\"0.5\" parapet=\"0.9\"/>"
        print "</window>"
    }
    BEGIN {
        state = 7919 * room + 1
        for (i = 0; i < 9; i++) chance()
        w = between(2.8, 7); d = between(4, 9); h = between(2.6, 3.4)
        ground = chance() < .4 ? -between(3, 20) : 0
        printf "<room version=\"1\" name=\"%d\"><site ground-level=\"%.2f\"/>\n", room, ground
        printf "<plan width=\"%.2f\" depth=\"%.2f\" height=\"%.2f\"/>\n", w, d, h
        window("south", w)
        if (chance() < .4) window("west", d)
        if (chance() < .2) window("east", d)
        if (chance() < .2) print "<rooflight x=\"1\" y=\"2\" width=\"1\" depth=\"1\"/>"
        n = int(between(0, 3.5))
        for (i = 0; i < n; i++)
            printf "<block x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" depth=\"10\" height=\"%.2f\"/>\n",
                between(-25, 15), -10 - between(4, 60), between(8, 40), between(3, 30)
        if (chance() < .25)
            printf "<skyline wall=\"south\" angle=\"%.1f\" distance=\"%.1f\"/>\n", between(5, 40),
                between(8, 40)
        if (chance() < .4)
            printf "<partition from=\"%.2f %.2f\" to=\"%.2f %.2f\" height=\"%.2f\"/>\n", w * .99, d * .3,
                w * between(.4, .8), d * .3, between(1, 2.2)
        print "<point x=\"1\" y=\"1\"/></room>"
        printf "%.3f %.3f 1.2 %.2f\n", w * between(.15, .85), d * between(.4, .9), ground >"eye"
    }' >room.xml
}

# first SCENE: modifier, name and distance of the first surface that each ray meets.
first() {
    rtrace -h -faa -ab 0 -dt 1 -lr 0 -oMsL "$1"
}

# The view from the eye by counting rays, as LIST_VIEW_OUT prints it.
count() {
    # Surfaces that emit no light: rtrace finds what a ray meets, without shading it.
    grep -hE '^[a-z_A-Z0-9]+ (polygon|ring) ' room.rad glazing.rad outside.rad | awk '!had[$1]++ {
        printf "void glow %s\n0\n0\n4 0 0 0 0\n", $1 }' >black.rad
    oconv black.rad room.rad glazing.rad outside.rad >whole.oct
    oconv black.rad room.rad outside.rad >open.oct
    awk '{ x = $1; y = $2; z = $3 } END {
        r = 3.14159265358979 / 180
        for (b = .05; b < 360; b += .1)
            for (a = -69.875; a < 70; a += .25)
                printf "%.6g %.6g %.6g %.8f %.8f %.8f\n", x, y, z, cos(a * r) * sin(b * r),
                    cos(a * r) * cos(b * r), sin(a * r)
    }' ../eye >rays
    # Rays that meet a pane, except one that faces up; the pane follows the ray.
    first whole.oct <rays >met
    paste -d' ' rays met | tr '\t' ' ' | awk -v h="$(awk -F'"' '
        /<plan/ { print $6 }' ../room.xml)" '
        $7 ~ /^glazing/ && $3 + $6 * $9 < h - 1e-6' >seen
    awk '{ t = $9 + 1e-5; print $1 + $4 * t, $2 + $5 * t, $3 + $6 * t, $4, $5, $6 }' seen |
        first open.oct >behind
    paste -d' ' seen behind | tr '\t' ' ' >lines
    # Weights are solid angles. The ground is level; what is not met is sky or ground.
    awk -v ground="$(cut -d' ' -f4 ../eye)" '
        function wide(v) { return sqrt(1 - v * v) }
        {
            bearing[int(10 * (atan2($4, $5) * 57.29577951 + 180))] = 1
            z = $3 + $6 * $9
            if ($10 == "*" || $10 == "void" || $10 ~ /ground/) {
                far = $6 < 0 ? (z - ground) / -$6 : 1e9
                layer = $6 >= 0 ? 1 : $6 > -sin(5 / 57.29577951) ? 2 : 4
            } else {
                far = $12; layer = 2
            }
            if (far < 2) next
            if (!((layer, $8) in had)) had[layer, $8] = 1
            panes[$8] = 1
            print far, wide($6)
        }
        END {
            for (b in bearing) angle += .1
            for (p in panes) {
                n = 0
                for (l = 1; l <= 4; l *= 2)
                    if ((l, p) in had) { n++; all[l] = l }
                if ((2, p) in had && n > together) together = n
            }
            printf "%.2f %d %d\n", angle, all[1] + all[2] + all[4], together >"counted"
        }' lines | sort -g >distances
    awk 'NR == FNR { whole += $2; next }
        { sum += $2 } sum >= whole / 2 { found = $1; exit }
        END { print found >= 1e9 ? "inf" : found + 0 }' distances distances >median
    awk '{ angle = $1; all = $2; together = $3; getline far <"median"
        print angle, far, all, together }' counted
}

echo "room,angle_deg,counted_deg,distance_m,counted_m,layers,counted_layers,together,counted_together"
number=0
while [ $number -lt 30 ]; do
    number=$((number + 1))
    room $number
    rm -rf scene
    "$pepperpot" export -q --to radiance -o scene room.xml
    read -r x y z _ <eye
    # shellcheck disable=SC2046 # four words each
    set -- $("$list" room.xml "$x" "$y" "$z") $(cd scene && count)
    echo "$number,$1,$5,$2,$6,$3,$7,$4,$8"
done | tee table.csv
awk -F, '
    {
        angle = $2 - $3; angle = angle < 0 ? -angle : angle
        if (angle > most) most = angle
        off = $4 == $5 ? 0 : $4 == "inf" || $5 == "inf" || $5 == 0 ? 9 : $4 / $5 - 1
        off = off < 0 ? -off : off
        if (off > far) far = off
        near_angle += angle <= .5; near_far += off <= .01; same += $6 == $7 && $8 == $9
    }
    END {
        printf "%d rooms: sight angle within 0.5 degrees in %d (greatest difference %.2f), ", NR,
            near_angle, most
        printf "distance within 1 %% in %d (%.2f %%), layers equal in %d\n", near_far, 100 * far, same
    }' table.csv
