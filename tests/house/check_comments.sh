#!/bin/sh
# Comments read as plain English: few begin as a fragment of a sentence, with a word such as
# "What", "Of" or "How", or with a pronoun whose noun is in the code.
. "$srcdir/tests/lib/tap.sh"

program="model formats methods simulate studies charts reports api serve cli"
openings="What Of How Which It They This That These Those Its Their"
most=1 # per cent of the comments

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Lines "FILE:LINE: WORDS" with the first line of each comment; the file name at the beginning of a
# file's first comment is omitted.
(cd "$srcdir" && awk '
    FNR == 1 { inside = 0 }
    {
        line = $0
        if (inside) {
            if (!(end = index(line, "*/")))
                next
            line = substr(line, end + 2)
            inside = 0
        }
        gsub(/\\./, "", line)
        gsub(/"[^"]*"/, "", line)
        while ((from = index(line, "/*"))) {
            words = substr(line, from + 2)
            if ((end = index(words, "*/"))) {
                line = substr(words, end + 2)
                words = substr(words, 1, end - 1)
            } else {
                inside = 1
                line = ""
            }
            sub(/^ */, "", words)
            sub(/^[a-z0-9_]+\.[ch] - /, "", words)
            print FILENAME ":" FNR ": " words
        }
    }' $(find $program tests bench -name '*.[ch]' | LC_ALL=C sort) pepperpot.h) \
    >"$scratch/comments"

awk -v words="$openings" '
    BEGIN {
        n = split(words, list, " ")
        for (i = 1; i <= n; i++)
            opens[list[i]] = 1
    }
    {
        first = $2
        sub(/[^A-Za-z].*/, "", first)
        if (first in opens)
            print
    }' "$scratch/comments" >"$scratch/fragments"

all=$(wc -l <"$scratch/comments")
fragments=$(wc -l <"$scratch/fragments")
few() {
    [ $((100 * fragments)) -le $((most * all)) ] || {
        cat "$scratch/fragments"
        return 1
    }
}
check "there are comments to look at" test "$all" -gt 0
check "$((fragments)) of $((all)) comments begin as fragments ($most % at most)" few
tap_done
