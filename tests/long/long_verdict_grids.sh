#!/bin/sh
# long_verdict_grids.sh [PROGRAM [ROOM ...]] - medians, area shares and verdicts of EN 17037 are
# the same on the default grid as on a grid of 0.1 m. Tests 20 of the ordinary rooms
# (tests/lib/ordinary_rooms.awk), or the rooms with these numbers. A figure passes if the two
# differ by at most twice the standard error of their difference, including the errors of both
# grids and the noise; at least 95 % must pass. Every certain verdict must be that of the fine
# grid. Prints all differences, and the share of figures that pass. About 15 minutes.
set -eu
LC_ALL=C
export LC_ALL
here=$(cd "$(dirname "$0")" && pwd)
pepperpot=${1:-./pepperpot}
[ $# -eq 0 ] || shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
[ $# -gt 0 ] || set -- 1 16 31 46 61 76 91 106 121 136 151 166 181 196 211 226 241 256 271 286
${AWK:-awk} -v folder="$scratch" -f "$here/../lib/ordinary_rooms.awk"

# Spacing of the fine grid: 0.1 m, or more if a grid would have more than 20,000 points.
fine_spacing() { # ROOM
    sed -n 's/.*<plan width="\([0-9.]*\)" depth="\([0-9.]*\)".*/\1 \2/p' "$scratch/$1.xml" |
        ${AWK:-awk} '{ print ($1 * $2 > 190 ? 0.2 : 0.1) }'
}

for room; do
    for grid in default 0.1; do
        spacing=
        [ $grid = default ] || spacing="--spacing $(fine_spacing "$room")"
        # $spacing is two words, or none.
        "$pepperpot" assess -q -c en17037 --median-diffuse 14100 $spacing --format csv \
            -o "$scratch/$room.$grid.csv" "$scratch/$room.xml"
    done
done

for room; do
    for grid in default 0.1; do
        sed -n "s/\"[^\"]*\"/text/g; 2,\$s/^/$room,$grid,/p" "$scratch/$room.$grid.csv"
    done
done | tr -d '\r' | ${AWK:-awk} -F, '
# room, grid, then the columns of the file: 12 figure, 14 error, 15 wanted, 17 verdict,
# 18 confidence, 20 error by the grid, 21 share reached, 22 its error
function apart(a, b) { return a > b ? a - b : b - a }
{
    id = $1 "," $2 "," ++row[$1, $2]
    figure[id] = $12; error[id] = $14; wanted[id] = $15; verdict[id] = $17; sure[id] = $18
    over[id] = $21; over_error[id] = $22
    rooms[$1]
}
END {
    for (room in rooms)
        for (i = 1; i <= row[room, "default"]; i++) {
            a = room ",default," i; b = room ",0.1," i
            both = sqrt(error[a] ^ 2 + error[b] ^ 2)
            figures++
            good = apart(figure[a], figure[b]) <= 2 * both
            good_figures += good
            if (!good)
                print "room " room ", " wanted[a] ": " figure[a] " +- " error[a] ", fine " figure[b] " +- " error[b]
            shares++
            good = apart(over[a], over[b]) <= 2 * sqrt(over_error[a] ^ 2 + over_error[b] ^ 2)
            good_shares += good
            if (!good)
                print "room " room ", share over " wanted[a] ": " over[a] " +- " over_error[a] ", fine " over[b]
            if (verdict[a] != "undecided" && sure[a] > 0.99995) {
                certain++
                if (verdict[b] != verdict[a]) {
                    print "room " room ", " wanted[a] ": " verdict[a] ", fine: " verdict[b]
                    wrong++
                }
            }
        }
    printf "levels within the stated error: %d of %d\n", good_figures, figures
    printf "area shares: %d of %d\n", good_shares, shares
    printf "verdicts called certain: %d, others on the fine grid: %d\n", certain, wrong
    exit figures == 0 || good_figures < 0.95 * figures || good_shares < 0.95 * shares || wrong > 0
}'
