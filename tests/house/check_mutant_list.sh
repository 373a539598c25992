#!/bin/sh
# The deliberate changes of tests/long/mutants.txt can be made: each changes one line of a
# file that is there. Whether a test sees them takes hours (make check-mutants).
. "$srcdir/tests/lib/tap.sh"

list=$srcdir/tests/long/mutants.txt

# What cannot be made, a line each.
stale() {
    grep -v '^#\|^$' "$list" | while read -r file change; do
        if [ ! -f "$srcdir/$file" ]; then
            echo "$file is not there"
            continue
        fi
        lines=$(sed "$change" "$srcdir/$file" | diff "$srcdir/$file" - | grep -c '^>')
        [ "$lines" = 1 ] || echo "$file: $change: it changes $lines lines; expected 1"
    done
}

check "there are a hundred changes" test "$(grep -c '^[a-z]' "$list")" -ge 100
check "each changes one line of a file that is there" nothing "$(stale)"
tap_done
