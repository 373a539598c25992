#!/bin/sh
# run.sh PROGRAM ... - runs a test program with TAP output. cmocka numbers the tests of each file
# from 1, and up to version 1.1.7 reports a skipped test as "not ok". This script numbers all tests
# consecutively and reports a skipped test as "ok N # SKIP", as TAP requires.
said=$(CMOCKA_MESSAGE_OUTPUT=TAP "$@")
status=$?
printf '%s\n' "$said" | awk '
    /^1\.\.[0-9]+$/ { planned += substr($0, 4); next }
    /^(not )?ok [0-9]+/ {
        ok = /^not ok [0-9]+ # SKIP/ ? "ok" : /^not/ ? "not ok" : "ok"
        sub(/^(not )?ok [0-9]+/, "")
        print ok " " ++count $0
        next
    }
    { print }
    END { print "1.." planned + 0 }'
exit $status
