#!/bin/sh
# bench_serve.sh [REQUESTS] - requests per second that a warm server answers one after the other,
# and CPU time for each. Run it in the build folder: srcdir=.. sh ../bench/bench_serve.sh
. "$srcdir/tests/lib/tap.sh" >/dev/null
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/served.sh"
requests=${1:-100}
can_serve || { echo "$why_not"; exit 1; }
serve
ticks() { awk '{ print $14 + $15 }' "/proc/$server/stat"; }
measure() {
    asks "$examples/$2.xml" "$3"
    ask "$1"
    for i in $(seq "$requests"); do
        printf 'url = "%s/api/%s"\noutput = /dev/null\n' "$address" "$1"
    done >"$scratch/urls"
    cpu=$(ticks)
    began=$(date +%s%N)
    curl -s -H "$json" -d @"$scratch/asked" -K "$scratch/urls"
    took=$((($(date +%s%N) - began) / 1000))
    cpu=$(($(ticks) - cpu))
    awk -v n="$requests" -v us="$took" -v cpu="$cpu" -v what="$1 of $2" \
        'BEGIN { printf "%-32s %6.0f a second, %5.1f ms of CPU time\n", what, n / us * 1e6, cpu * 10 / n }'
}
measure df deep-office '{}'
measure df deep-office '{"methods":"exact+bre"}'
measure plan deep-office '{}'
measure plan office '{}'
measure plan classroom '{}'
measure check deep-office '{}'
