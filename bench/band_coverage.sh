#!/bin/sh
# band_coverage.sh PROGRAM [ROOM ...] - how often the true value, from `df --simulate`, is in the
# likely ranges of hand figures, in the 300 ordinary rooms of tests/lib/ordinary_rooms.awk or in the
# rooms with these numbers: for every method, at points and for averages, by regimes; and the errors
# of the methods that `df --advise` names. Takes about two minutes. ERROR=0.4%: target error of the
# true values at the points. TRACE=FILE: writes every figure that is counted, one per line.
set -eu
LC_ALL=C
export LC_ALL

if [ $# -lt 1 ]; then
    echo "usage: band_coverage.sh PROGRAM [ROOM ...]" >&2
    exit 2
fi
pepperpot=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
shift
error=${ERROR:-0.4%}
trace=${TRACE:-}
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

${AWK:-awk} -v folder="$scratch" -f "$here/../tests/lib/ordinary_rooms.awk"
[ $# -gt 0 ] || set -- $(sed '1d; s/,.*//' "$scratch/rooms.csv")

# figures NUMBER ROOM ...: calculates every $workers-th room of the list, beginning with the
# NUMBER-th.
figures() {
    number=$1
    shift
    for room; do
        number=$((number - 1))
        [ $((number % workers)) -eq 0 ] || continue
        "$pepperpot" df -q -j 1 -m all --bands --simulate --error "$error" --format csv \
            -o "$scratch/$room.csv" "$scratch/$room.xml"
        "$pepperpot" df -q -j 1 -m exact --no-bands --advise --format json \
            -o "$scratch/$room.json" "$scratch/$room.xml"
    done
}

workers=$(getconf _NPROCESSORS_ONLN)
worker=0
while [ $worker -lt "$workers" ]; do
    worker=$((worker + 1))
    figures $worker "$@" &
done
wait
for room; do
    printf '%s\n' "$scratch/$room.csv" "$scratch/$room.json"
done | xargs ${AWK:-awk} -v error="$error" -v trace="$trace" -f "$here/band_coverage.awk" \
    "$scratch/rooms.csv"
