#!/bin/sh
# Obstructions outlined in a photograph. The photograph is calculated: pixels along the top of an
# infinitely long obstruction, so that the vertical sky component has a closed form.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# The top of an obstruction parallel to the south wall, 30 degrees above the horizon in section:
# tan(altitude) = tan(30) cos(bearing - 180). One camera looks up with its top to the north, the
# other one looks south.
awk -v up="$scratch/up.csv" -v level="$scratch/level.csv" 'BEGIN {
    pi = atan2(0, -1)
    for (i = -89; i <= 89; i += 2) {
        turn = i * pi / 180
        altitude = atan2(sin(pi / 6) / cos(pi / 6) * cos(turn), 1)
        r = (pi / 2 - altitude) / (pi / 2) * 600
        printf "%.3f,%.3f\n", 960 - r * sin(pi + turn), 640 - r * cos(pi + turn) >up
        right = cos(altitude) * sin(turn)
        away = cos(altitude) * cos(turn)
        r = atan2(sqrt(1 - away * away), away) / (pi / 2) * 600
        side = sqrt(right ^ 2 + sin(altitude) ^ 2)
        printf "%.3f,%.3f\n", 960 + r * right / side, 640 - r * sin(altitude) / side >level
    }
}'

# room FILE OUTLINE NORTH: a room with a window at 2, 0, 1.5 m.
room() {
    cat >"$scratch/$1" <<ROOM
<room version="1" name="Outlined" north="${3:-0}">
  <plan width="4" depth="5" height="3"/>
  <window name="W" wall="${4:-south}" left="1" sill="0.8" width="2" height="1.4"/>
  $2
</room>
ROOM
}

# vsc FILE: the vertical sky component of the window in per cent.
vsc() {
    run assess --by-hand --criteria vertical-sky --format csv "$scratch/$1"
    sed 's/"W, [a-z]*"/W/' "$scratch/out" | awk -F, '$5 == "vertical-sky" { print $9 }'
}

# near A B SHARE: two numbers agree.
near() {
    awk -v a="$1" -v b="$2" -v share="$3" \
        'BEGIN { exit !(a > 0 && (a - b)^2 <= (share * b)^2) }' || echo "$1, not $2"
}

camera='x="2" y="0" z="1.5" distance="400" circle="960 640 600"'
room up.xml "<outline file='up.csv' $camera/>"
room level.xml "<outline file='level.csv' view-bearing='180' view-altitude='0' $camera/>"
room turned.xml "<outline file='up.csv' $camera/>" 180
room open.xml ""
# (3/14)(1 - sin 30) + (4/(7 pi)) cos2 30 = 0.24356
check "an outline seen from below gives the vertical sky component of its closed form" \
    nothing "$(near "$(vsc up.xml)" 24.356 2e-3)"
check "and one seen from the window does" nothing "$(near "$(vsc level.xml)" 24.356 2e-3)"
# A room whose +y points south has its window in the north, with the obstruction behind it.
check "bearings are from true north" nothing "$(near "$(vsc turned.xml)" "$(vsc open.xml)" 1e-6)"

check "df counts it as an outline" shows "; 1 outline of " \
    df --methods exact "$scratch/up.xml"
check "a simulation has the outline, too" \
    gives df -m exact -s --samples 256 --points 2,1 --format csv "$scratch/up.xml"
awk -F, '$3 == "point" && $10 == "sc" { print $11, $12 }' "$scratch/out" >"$scratch/sky"
check "with the same sky component" nothing \
    "$(near "$(awk '/traced/ { print $2 }' "$scratch/sky")" \
        "$(awk '/exact/ { print $2 }' "$scratch/sky")" 0.02)"
cat >"$scratch/building.xml" <<BUILDING
<building version="1"><outline file="up.csv" $camera/>
<room name="A"><plan width="4" depth="5" height="3"/>
<window wall="south" left="1" sill="0.8" width="2" height="1.4"/></room></building>
BUILDING
run df -m exact --points 2,1 --format csv "$scratch/building.xml"
check "a building has outlines of its own" test \
    "$(awk -F, '$3 == "point" && $10 == "sc" { print $12 }' "$scratch/out")" = \
    "$(awk '/exact/ { print $2 }' "$scratch/sky")"

printf '960,640\n970,640\n' >"$scratch/zenith.csv"
room bad.xml "<outline file='zenith.csv' $camera/>"
check "a point in the zenith" refuses 1 "zenith.csv:1: the point is 90.0 degrees above" \
    df "$scratch/bad.xml"
room bad.xml "<outline file='none.csv' $camera/>"
check "a file that is not there" refuses 1 "none.csv" df "$scratch/bad.xml"
room bad.xml "<outline file='up.csv' projection='latitude-longitude' $camera/>"
check "a panorama" refuses 1 "expected equidistant, equisolid or hemispherical" \
    df "$scratch/bad.xml"
room bad.xml "<outline file='up.csv' x='2' y='0' z='1.5' circle='960 640 600'/>"
check "no distance" refuses 1 "distance is missing" df "$scratch/bad.xml"
room bad.xml "<outline file='up.csv' x='2' y='2' z='1.5' distance='1' circle='960 640 600'/>"
check "an obstruction in the room" refuses 1 'outline: is inside the room' df "$scratch/bad.xml"

tap_done
