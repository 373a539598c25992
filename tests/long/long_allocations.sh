#!/bin/sh
# If one allocation fails, a command ends with status 3, or with its usual output. Tests the first
# allocations of each command and an even selection of the others.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

if ! ${CC:-cc} -shared -fPIC -O1 -o "$scratch/failing.so" "$srcdir/tests/long/failing_malloc.c" \
    2>"$scratch/err" || ! env LD_PRELOAD="$scratch/failing.so" COUNT_TO="$scratch/count" \
    "$pepperpot" df -m exact "$deep" >"$scratch/out" || [ "$(cat "$scratch/count")" -eq 0 ]; then
    skip "an allocation fails" "no library can take the place of malloc here"
    tap_done
    exit
fi

# with NUMBER WORDS: runs the program; this allocation fails.
with() {
    number=$1
    shift
    FAIL_AT=$number LD_PRELOAD=$scratch/failing.so timeout 120 "$pepperpot" "$@" \
        >"$scratch/out" 2>"$scratch/err" </dev/null
}

# survives WORDS: tests about 60 allocations.
survives() {
    COUNT_TO=$scratch/count LD_PRELOAD=$scratch/failing.so "$pepperpot" "$@" \
        >"$scratch/expected" 2>"$scratch/err" </dev/null || return
    count=$(cat "$scratch/count")
    step=$((count / 40 + 1))
    bad=0
    for number in $(seq 0 19) $(seq 20 $step "$count"); do
        with "$number" "$@"
        status=$?
        [ $status -eq 3 ] && [ -s "$scratch/err" ] && continue
        [ $status -eq 0 ] && cmp "$scratch/expected" "$scratch/out" && continue
        echo "allocation $number of $count: status $status"
        head -n 3 "$scratch/err"
        bad=1
    done
    return $bad
}

office=$examples/office.xml
check "df" survives df -m all --format json "$examples/deep-office-obstructed.xml"
check "df by simulation" survives df -s --samples 8 -p 1,1 "$office"
check "assess" survives assess --by-hand --format json "$office"
check "report" survives report -f pdf "$examples/deep-office.xml"
check "chart section" survives chart section -m exact+bre -f svg "$office"
check "chart plan" survives chart plan -f pdf "$office"
check "availability" survives availability --latitude 51 --illuminance 300 "$office"
check "import of gbXML" survives import "$srcdir/tests/fuzz/office.gbxml" -o -
check "import of a scene" survives import "$srcdir/tests/formats/radiance/every.rad" -o -
check "chart waldram" survives chart waldram -p 1,1.5 -f svg "$examples/deep-office.xml"
check "validate" survives validate -m bre,brs-table --samples 8 -p 1,1 "$examples/deep-office.xml"
check "new" survives new office
tap_done
