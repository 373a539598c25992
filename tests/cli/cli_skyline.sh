#!/bin/sh
# A skyline with a distance is the long block in its place: daylight factors, criteria, exports.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/streets.sh"

for kind in skyline block; do
    street $kind south 8.3 50 0.3 8 >"$scratch/$kind.xml"
    factors path,radiosity 1% "$scratch/$kind.xml" >"$scratch/$kind"
    street $kind east 8.3 50 0.3 - '<site latitude="51"/>' >"$scratch/$kind-aside.xml"
    "$pepperpot" assess --against vertical-sky,sun-exposure --format csv \
        "$scratch/$kind-aside.xml" 2>"$scratch/err" |
        awk -F, 'NR > 1 { print $2, $3, $4, $5, $6 }' >"$scratch/$kind-aside"
done
check "two points and the average, each by two engines" test "$(wc -l <"$scratch/skyline")" -eq 6
check "in a street daylight factors are those with a block" \
    agree "$scratch/skyline" "$scratch/block" 0.04
tap_done
