#!/bin/sh
# The documents are about this program: every cited work is listed and every listed one
# cited; every element, attribute, glazing and finish of room files, every method,
# command, option and chart stands in the manual, every option in the man page; every
# folder of the sources in ARCHITECTURE.md.
build=$(pwd)
. "$srcdir/tests/lib/tap.sh"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$srcdir" || exit 1

# A key is capitals and then a year or a number, [MS42], or any that the list has.
key='\[[A-Z][A-Z]*[0-9][0-9][0-9]*[A-Za-z]*\]'
sed -n 's/^- \*\*\(\[.*\]\)\*\*.*/\1/p' docs/SOURCES.md >"$scratch/order"
LC_ALL=C sort -u "$scratch/order" >"$scratch/listed"
folders="model formats methods simulate studies charts reports api cli"
{
    find $folders tests bench -name '*.[ch]' -exec cat {} +
    cat tables/*.csv docs/manual.md docs/theory.md README.md ARCHITECTURE.md
} 2>/dev/null >"$scratch/text"
{
    grep -o "$key" "$scratch/text"
    grep -oF -f "$scratch/listed" "$scratch/text"
    # A method names its source without brackets.
    find methods -name '*.c' -exec sed -n 's/^ *\.source = "\(.*\)",/[\1]/p' {} +
} | LC_ALL=C sort -u >"$scratch/cited"

check "every cited work is listed" \
    nothing "$(LC_ALL=C comm -23 "$scratch/cited" "$scratch/listed")"
check "every listed work is cited" \
    nothing "$(LC_ALL=C comm -13 "$scratch/cited" "$scratch/listed")"
check "the list is in order of its keys, each once" \
    nothing "$(tr -d '[]' <"$scratch/order" | LC_ALL=C sort -uc 2>&1)"

# not_in FILE: those of the words on standard input that FILE does not have; of the
# manual and ARCHITECTURE.md counts what stands there as `code` or in a heading.
not_in() {
    case $1 in
    *.md) grep -o -e '`[^`]*`' -e '^#.*' "$1" ;;
    *) sed 's/\\f[BIRP]//g; s/\\//g' "$1" ;;
    esac >"$scratch/said"
    while read -r word; do
        grep -Eq -- "(^|[^A-Za-z0-9_-])$word([^A-Za-z0-9_-]|\$)" "$scratch/said" ||
            echo "$word is not in $1"
    done
}

names_of() {
    sed -n "s/.*<$1 name=\"\([a-z-]*\)\".*/\1/p" docs/room.rng | sort -u
}

first_column() {
    grep -v '^#' "$1" | sed '1d; s/,.*//'
}

check "every element of a room file is in the manual" \
    nothing "$(names_of element | not_in docs/manual.md)"
check "every attribute of a room file is in the manual" \
    nothing "$(names_of attribute | not_in docs/manual.md)"
check "every glazing is in the manual" \
    nothing "$(first_column tables/glazings.csv | not_in docs/manual.md)"
check "every finish is in the manual" \
    nothing "$(first_column tables/finishes.csv | not_in docs/manual.md)"
check "every frame is in the manual" \
    nothing "$(first_column tables/frames.csv | not_in docs/manual.md)"
check "every sort of curtains is in the manual" \
    nothing "$(first_column tables/curtains.csv | not_in docs/manual.md)"

program=$build/pepperpot
find methods -name '*.c' -exec sed -n 's/^ *\.name = "\(.*\)",/\1/p' {} + >"$scratch/methods"
check "every method is in the manual" nothing "$(not_in docs/manual.md <"$scratch/methods")"
check "every method is in the man page" \
    nothing "$(not_in docs/pepperpot.1 <"$scratch/methods")"

"$program" --help | sed -n 's/^  \([a-z][a-z]*\)  *[A-Za-z].*/\1/p' >"$scratch/commands"
check "the program has commands" test -s "$scratch/commands"
check "every command is in the manual" nothing "$(not_in docs/manual.md <"$scratch/commands")"
check "every command is in the man page" nothing "$(not_in docs/pepperpot.1 <"$scratch/commands")"
while read -r command; do
    "$program" "$command" --help | sed -n 's/^  .*\(--[a-z][a-z-]*\).*/\1/p'
done <"$scratch/commands" | sort -u | grep -v -- --help >"$scratch/options"
check "every option is in the manual" nothing "$(not_in docs/manual.md <"$scratch/options")"
check "every option is in the man page" \
    nothing "$(not_in docs/pepperpot.1 <"$scratch/options")"
"$program" chart --list | sed -n 's/^  \([a-z][a-z-]*\) .*/\1/p' >"$scratch/charts"
check "every chart is in the manual" nothing "$(not_in docs/manual.md <"$scratch/charts")"

reference() {
    ${AWK:-awk} -f docs/reference.awk pepperpot.h | cmp - docs/reference.md
}
check "docs/reference.md is what make reference makes of pepperpot.h" reference
check "every folder of the sources is in ARCHITECTURE.md" \
    nothing "$(find $folders -type d | sed 's|.*/||; s|$|/|' | not_in ARCHITECTURE.md)"
tap_done
