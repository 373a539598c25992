#!/bin/sh
# The likely ranges of hand figures hold for rooms from which they were not derived: 95 of 100 true
# values of 300 ordinary rooms are within them, and the methods that --advise recommends are close
# to the true values.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# invalid: a line for each room that is rejected or causes a message other than a warning.
invalid() {
    ${AWK:-awk} -v folder="$scratch" -f "$srcdir/tests/lib/ordinary_rooms.awk" || echo "no rooms"
    number=0
    while [ $number -lt 300 ]; do
        number=$((number + 1))
        "$pepperpot" validate -q -m exact --error 100% -o "$scratch/validated" \
            "$scratch/$number.xml" 2>"$scratch/warned" || echo "room $number: status $?"
        grep -v ': warning: ' "$scratch/warned"
    done
}
check "300 ordinary rooms are valid" nothing "$(invalid)"

sh "$srcdir/bench/band_coverage.sh" "$pepperpot" >"$scratch/tables" 2>"$scratch/said"
check "the figures of 300 rooms are compared" grep -q '^300 ordinary rooms' "$scratch/tables"
check "nothing goes wrong" nothing "$(grep -v ': warning: ' "$scratch/said")"

# Shares of about 280 rooms have a standard error of 100 sqrt(0.0475 / rooms), 1.3 %; the limits
# are wider by this.

# pooled PLACES: 93 to 97 % of the true values are in their ranges, for all methods together.
pooled() {
    grep "^pooled, $1: " "$scratch/tables"
    awk -v start="pooled, $1:" '
        $1 == "all" && $2 > rooms { rooms = $2 }
        index($0, start) == 1 {
            slack = 100 * sqrt(0.0475 / rooms)
            good = $3 >= 93 - slack && $3 <= 97 + slack
        }
        END { exit !good }' "$scratch/tables"
}
# outside TITLE: methods outside 92 to 98 % in the table with this title. Averages of the sky
# component have no upper limit: their ranges include the noise of an atlas simulated to 2 %.
outside() {
    awk -v title="$1" '$0 == title { inside = 1 } inside && /^left out/ { exit }
        inside && $3 + 0 > 0 {
            slack = 100 * sqrt(0.0475 / $3)
            no_upper = $1 == "sc" && title ~ /^Averages/
            if ($5 < 92 - slack || ($5 > 98 + slack && !no_upper))
                print
        }' "$scratch/tables"
}
check "95 % of the truths at points are in the ranges, give or take 2 %" pooled points
check "95 % of the true averages are in the ranges, give or take 2 %" pooled averages
check "every method has 92 to 98 % at points" nothing "$(outside 'At points')"
check "every method has 92 to 98 % of the averages" \
    nothing "$(outside 'Averages over the working plane')"

# near MEAN NINTH: the errors of the recommended average, after correction, are at most these, in
# per cent.
near() {
    grep '^average, ' "$scratch/tables"
    awk -v mean="$1" -v ninth="$2" '/^average, corrected/ {
            good = $3 > 100 && $4 <= mean && $8 <= ninth
        }
        END { exit !good }' "$scratch/tables"
}
check "the advised averages, corrected, err by 4 % at most, nine in ten by 7 %" near 4 7
tap_done
