#!/bin/sh
# The deliberate errors of tests/long/mutants.txt can be applied: each changes one line of an
# existing file. Whether a test detects them takes hours (make check-mutants).
. "$srcdir/tests/lib/tap.sh"

list=$srcdir/tests/long/mutants.txt

# stale: errors that cannot be applied, one per line.
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
