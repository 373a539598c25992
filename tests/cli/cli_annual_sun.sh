#!/bin/sh
# annual: hours of direct sun as text, JSON and CSV; rooms and weather that have no such figures.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

awk -f "$srcdir/tests/lib/clear_year.awk" >"$scratch/year.epw"
awk -v direct=0 -f "$srcdir/tests/lib/clear_year.awk" >"$scratch/sunless.epw"
annual="annual --samples 16 --patches 145"
year="$annual -w $scratch/year.epw"

# A room of 3 x 9 m with 27 points, each for 1 m2. room NAME GRIDS [SED]: with these elements.
room() {
    sed -e "/<line/d; s|</room>|$2</room>|; ${3-}" "$deep" >"$scratch/$1.xml"
}
grid='<grid spacing="1" margin="0"/>'
room grid "$grid"
room north "$grid" 's|wall="south"|wall="north"|'
room points '<point x="1.5" y="1"/><point x="1.5" y="6"/>'
room two "$grid"'<grid spacing="1.5" margin="0"/>'
room mixed "$grid"'<point x="1.31" y="2.57"/>'

# column NAME PLACE: values of a CSV column in the records of this place, one per line.
column() {
    awk -F, -v name="$1" -v place="$2" '
        NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) at = i }
        at && $3 == place { print $at }' "$scratch/out"
}
# key NAME: the number of this key of the plane in JSON.
key() {
    sed -n "/\"plane\"/,/^  }/s/^ *\"$1\": \([^,]*\),*\$/\1/p" "$scratch/out"
}
# about A B: equal to the digits of CSV and JSON.
about() {
    awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && b > 0 && (a / b - 1)^2 < 1e-16) }' ||
        { echo "$1 is not $2"; return 1; }
}

run $year -f csv "$scratch/grid.xml"
check "a column for each point" test "$(column sun-hours point | wc -l)" -eq 27
sum=$(column sun-hours point | awk '{ sum += $1 } END { print sum }')
mean=$(column sun-hours average)
check "the mean of 27 points" about "$mean" "$(awk "BEGIN { printf \"%.12g\", $sum / 27 }")"
check "hours are not sampled: no error" test "$(column sun-hours_se average)" = 0
check "ASE's points have more than 250 of them" test \
    "$(column sun-hours point | awk '$1 > 250 { n++ } END { printf "%.3f", 100 * n / 27 }')" = 44.444

run $year -f json "$scratch/grid.xml"
check "JSON: the plane" test "$(key area_m2)" = 27
check "JSON: the mean" about "$(key sun_hours_mean_h)" "$mean"
check "JSON: the sum over 1 m2 a point" about "$(key sun_hours_sum_m2h)" "$sum"
check "JSON: ASE" grep -q '"ase1000,250": { "value": 44.44' "$scratch/out"

run $year "$scratch/grid.xml"
check "text: mean and sum" sh -c "tr -s ' \n' '  ' <'$scratch/out' | grep -qF \
    'sun hours mean over the plane $(printf %.0f "$mean") h; sum over its area $sum m2 h (27 m2, hours'"

# Two grids cover the plane twice; their points represent it once.
run $year -f json "$scratch/two.xml"
check "two grids have one plane" about "$(key area_m2)" 27
check "their sum is that of one grid, nearly" awk -v a="$(key sun_hours_sum_m2h)" -v b="$sum" \
    'BEGIN { exit !((a / b - 1)^2 < 0.02^2) }'

# From 9 to 16 h the sun is in the southern half of the sky.
run $year -f json "$scratch/north.xml"
check "a window to the north: none" test "$(key sun_hours_sum_m2h)" = 0
check "which is known" grep -q '"ase1000,250": { "value": 0' "$scratch/out"

# Points without a grid do not represent a plane.
run $year -f json "$scratch/mixed.xml"
check "a point beside the grid: no area" test "$status$(key area_m2)$(key sun_hours_mean_h)" = 0
check "but hours at the points" grep -q '"sun-hours": { "value": [1-9]' "$scratch/out"
run $year "$scratch/points.xml"
check "two points: no sum in the text" test "$status$(grep -c '^  sun hours' "$scratch/out")" = 00

# Without direct sun in the weather file, 0 h would look like a result.
sunless="$annual -w $scratch/sunless.epw"
run $sunless -f json "$scratch/grid.xml"
check "sunless weather: no mean" test "$(key sun_hours_mean_h)" = null
check "no sum" test "$(key sun_hours_sum_m2h)" = null
check "the text has the reason" shows \
    "sun hours       not known: the weather has no direct sun" $sunless "$scratch/grid.xml"

room narrow '<grid spacing="1" margin="1.6"/>'
check "a margin without points" refuses 1 \
    "narrow.xml:13: grid: no point is clear of fittings and 1.6 m or more" \
    $year "$scratch/narrow.xml"
awk -F, 'BEGIN { OFS = "," } NR == 16 { $15 = "bright" } { print }' "$scratch/year.epw" \
    >"$scratch/word.epw"
check "sunshine that is no number" refuses 1 "word.epw:16" $annual -w "$scratch/word.epw" \
    "$scratch/grid.xml"
tap_done
