#!/bin/sh
# The fast tracer agrees with plain path tracing: in 300 ordinary rooms, the examples, the
# situations and under every sky, the differences of daylight factors divided by their standard
# errors have mean 0 and variance 1, and none exceeds 5.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# differences FILE [OPTION ...]: lines "FILE PLACE z" for one file.
differences() {
    file=$1
    shift
    "$pepperpot" df -q -m exact --no-bands --simulate --engine path,plain --error 2% \
        --format csv "$@" "$file" 2>/dev/null | sed 's/"[^"]*"/-/g; s/\r$//' | awk -F, -v file="$file $*" '
        $10 == "df" && ($11 == "traced" || $11 == "plain") {
            place = $2 " " $4 "," $5 "," $6 "," $7 "," $8 "," $9 " " $10
            if ($11 == "plain" && place in value) {
                error = sqrt(spread[place] * spread[place] + $13 * $13)
                if (error > 0)
                    print file, place, ($12 - value[place]) / error
            }
            value[place] = $12
            spread[place] = $13
        }'
}

# fair LEAST NAME: the differences in the file of this name are distributed as expected, and there
# are at least LEAST.
fair() {
    awk -v least="$1" '
        { n++; sum += $NF; squares += $NF * $NF }
        $NF > 5 || $NF < -5 { print; far = 1 }
        END {
            mean = n ? sum / n : 0
            variance = n ? squares / n - mean * mean : 0
            printf "%d differences: mean %.3f, variance %.3f\n", n, mean, variance
            exit !(n >= least && !far && mean > -0.1 && mean < 0.1 &&
                variance > 0.8 && variance < 1.25)
        }' "$scratch/$2"
}

${AWK:-awk} -v folder="$scratch" -f "$srcdir/tests/lib/ordinary_rooms.awk"
number=0
while [ $number -lt 300 ]; do
    number=$((number + 1))
    differences "$scratch/$number.xml" --seed $number
done >"$scratch/rooms"
check "300 ordinary rooms" fair 2000 rooms

for file in "$srcdir"/examples/*.xml "$srcdir"/examples/situations/*.xml; do
    differences "$file"
done >"$scratch/examples"
check "the examples and situations" fair 500 examples

for sky in overcast uniform $(seq -f 'iso-%.0f,40,150' 15); do
    differences "$srcdir/examples/office.xml" --sky "$sky"
done >"$scratch/skies"
check "a room under every sky" fair 300 skies
tap_done
