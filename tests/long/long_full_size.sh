#!/bin/sh
# The test programs with --full: every test, and the statistical ones at full size.
. "$srcdir/tests/lib/tap.sh"

# passes PROGRAM: all of its tests pass; prints those that do not.
passes() {
    log=$(mktemp)
    sh "$srcdir/tests/lib/run.sh" "$1" --full >"$log" 2>&1
    status=$?
    grep '^not ok' -A 5 "$log"
    count=$(grep -c '^ok' "$log")
    rm -f "$log"
    return $status
}

for program in tests/*/*_tests; do
    count=$("$program" --full --list | wc -l)
    check "all $count tests of $program" passes "./$program"
done
tap_done
