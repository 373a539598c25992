#!/bin/sh
# Runs the test programs with --full: every test, and the statistical tests at full size. Runs the
# script of charts with its complete lists (`some` of tests/lib/cli.sh), and that of pages with
# long commands.
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

# whole SCRIPT: tests/cli/SCRIPT.sh passes with FULL_SIZE.
whole() {
    log=$(mktemp)
    FULL_SIZE=yes sh "$srcdir/tests/cli/$1.sh" >"$log" 2>&1
    ! grep '^not ok' -A 5 "$log" && grep -q '^1\.\.' "$log"
    status=$?
    rm -f "$log"
    return $status
}
check "the whole of tests/cli/cli_chart.sh" whole cli_chart
check "the whole of tests/cli/cli_pages.sh" whole cli_pages
tap_done
