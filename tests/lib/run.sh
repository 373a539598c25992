#!/bin/sh
# run.sh PROGRAM ... - runs a cmocka program with TAP output. A skipped test becomes "ok
# N # SKIP", as TAP has it: cmocka up to 1.1.7 says "not ok", which counts as a failure.

# Of a build with AddressSanitizer, pointers into functions that have returned are looked for,
# too: not among the paths of the simulation's own tests, which would take three times as long.
case " $* " in
*/tests/simulate/*) ;;
*)
    ASAN_OPTIONS="detect_stack_use_after_return=1:${ASAN_OPTIONS-}"
    export ASAN_OPTIONS
    ;;
esac

said=$(CMOCKA_MESSAGE_OUTPUT=TAP "$@")
status=$?
printf '%s\n' "$said" | sed 's/^not ok \([0-9]*\) # SKIP/ok \1 # SKIP/'
exit $status
