#!/bin/sh
# situations.sh PROGRAM SOURCES - prints docs/situations.md with new tables: the results of
# every method and of the simulation in the rooms of examples/situations. For `make
# situations`.
set -eu
program=$1
sources=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for room in "$sources"/examples/situations/*.xml; do
    name=$(basename "$room" .xml)
    "$program" df --quiet --methods all --simulate --format csv "$room" >"$scratch/$name.csv"
    ${AWK:-awk} -f "$sources/docs/situations.awk" "$scratch/$name.csv" >"$scratch/$name.md"
done
while IFS= read -r line; do
    case $line in
    '<!-- situation '*)
        name=${line#<!-- situation }
        printf '%s\n' "$line"
        cat "$scratch/${name% -->}.md"
        while IFS= read -r line && [ "$line" != '<!-- end -->' ]; do :; done
        printf '%s\n' "$line"
        ;;
    *) printf '%s\n' "$line" ;;
    esac
done <"$sources/docs/situations.md"
