#!/bin/sh
# A skyline with a distance equals a long block in its place: simulated daylight factors, criteria,
# exports. tests/long/long_streets.sh tests twelve streets and all engines.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/streets.sh"

# figures FILE: the sky of each window, the floor area that sees sky, and the sun.
figures() {
    "$pepperpot" assess -c vertical-sky,sun-exposure,no-sky-line --by-hand --format csv "$1" |
        awk -F, 'NR > 1 { print $5, $(NF - 10) }'
}

for kind in skyline block; do
    street $kind south 8.3 50 0.3 8 >"$scratch/$kind.xml"
    factors path 1% "$scratch/$kind.xml" >"$scratch/$kind"
    street $kind east 8.3 50 0.3 - '<site latitude="51"/>' >"$scratch/$kind-aside.xml"
    figures "$scratch/$kind-aside.xml" >"$scratch/$kind-aside"
done
check "two points and the average" \
    test "$(wc -l <"$scratch/skyline")" -eq 3
check "in a street daylight factors are those with a block" \
    agree "$scratch/skyline" "$scratch/block" 0.04
check "five figures of a window in another wall" \
    test "$(wc -l <"$scratch/skyline-aside")" -eq 5
check "are those with a block" sh -c "paste -d' ' '$scratch/skyline-aside' '$scratch/block-aside' |
    awk '{ print; bad += (\$2 - \$4) ^ 2 > (0.001 * \$4) ^ 2 } END { exit bad > 0 || NR != 5 }'"

"$pepperpot" export -q --to radiance -o "$scratch/scene" "$scratch/skyline.xml"
check "exported, it reflects" grep -A 3 "plastic skyline" "$scratch/scene/materials.rad"
check "and does not glow" sh -c "! grep -B 1 -A 4 skyline '$scratch/scene/sky.rad'"
if command -v rtrace >/dev/null && command -v oconv >/dev/null; then
    "$scratch/scene/daylight_factors.sh" -ab 16 -lr 0 -ad 16384 -as 0 -aa 0 -lw 1e-6 |
        awk '{ print "traced", "point", $4, 0.02 * $4 }' >"$scratch/radiance"
    awk '$1 == "traced" && $2 != "average" { print $1, "point", $3, $4 }' "$scratch/skyline" \
        >"$scratch/traced"
    check "by Radiance it has the same light" agree "$scratch/traced" "$scratch/radiance" 0.06
else
    skip "by Radiance it has the same light" "Radiance is not on PATH"
fi
tap_done
