#!/bin/sh
# Every work that is cited stands in docs/SOURCES.md, and what stands there is cited.
. "$srcdir/tests/tap.sh"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$srcdir" || exit 1

# A key is capitals and then a year or a number: [MS42], [ISO15469]. One work has none.
key='\[\(GEEBELEN\|[A-Z][A-Z]*[0-9][0-9][0-9]*[A-Za-z]*\)\]'

# Files of the project, in a clone or in an unpacked tarball.
cat model/*.[ch] methods/*.[ch] simulate/*.[ch] charts/*.[ch] cli/*.[ch] tables/*.csv \
    tests/*.[ch] bench/*.[ch] docs/manual.md docs/theory.md README.md ARCHITECTURE.md \
    2>/dev/null | grep -o "$key" | LC_ALL=C sort -u >"$scratch/cited"
sed -n 's/^- \*\*\(\[.*\]\)\*\*.*/\1/p' docs/SOURCES.md >"$scratch/order"
LC_ALL=C sort -u "$scratch/order" >"$scratch/listed"

check "every cited work is listed" \
    nothing "$(LC_ALL=C comm -23 "$scratch/cited" "$scratch/listed")"
check "every listed work is cited" \
    nothing "$(LC_ALL=C comm -13 "$scratch/cited" "$scratch/listed")"
check "the list is in order of its keys, each once" \
    diff "$scratch/order" "$scratch/listed"
tap_done
