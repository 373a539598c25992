#!/bin/sh
# check_long.sh TEST ... - runs long tests one after another: programs with tests/lib/run.sh,
# scripts with the shell. Prints their output, the seconds of each, and the total. Exit status 0 if
# all passed. `make check-long` calls it.
set -u
log=check-long.log
failed=
start=$(date +%s)
passed=0
for test in "$@"; do
    echo "# $test"
    began=$(date +%s)
    case $test in
    *.sh) sh "$srcdir/$test" >"$log" 2>&1 ;;
    *) sh "$srcdir/tests/lib/run.sh" "./$test" >"$log" 2>&1 ;;
    esac || failed="$failed $test"
    cat "$log"
    if grep -q '^not ok' "$log"; then
        case $failed in *"$test") ;; *) failed="$failed $test" ;; esac
    fi
    passed=$((passed + $(grep -c '^ok' "$log")))
    echo "# $test: $(($(date +%s) - began)) s"
done
rm -f "$log"
echo "check-long: $passed passed in $(($(date +%s) - start)) s"
[ -z "$failed" ] || {
    echo "check-long: failed:$failed"
    exit 1
}
