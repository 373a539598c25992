#!/bin/sh
# The documentation agrees with the program: every cited work is listed and every listed work
# cited; every element, attribute, glazing and finish of room files and every method, command,
# option and chart is in its chapter; every option is in the man page; every folder of the sources
# is in ARCHITECTURE.md; and no formula of the overcast sky is repeated.
build=$(pwd)
. "$srcdir/tests/lib/tap.sh"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$srcdir" || exit 1

# A key consists of capitals and a year or number, such as [MS42], or is any other key in the list.
key='\[[A-Z][A-Z]*[0-9][0-9][0-9]*[A-Za-z]*\]'
sed -n 's/^- \*\*\(\[.*\]\)\*\*.*/\1/p' docs/SOURCES.md >"$scratch/order"
LC_ALL=C sort -u "$scratch/order" >"$scratch/listed"
folders="model formats methods simulate studies charts reports api serve cli"
{
    find $folders tests bench -name '*.[ch]' -exec cat {} +
    cat tables/*.csv README.md ARCHITECTURE.md
    find docs -name '*.md' ! -name SOURCES.md -exec cat {} +
} 2>/dev/null >"$scratch/text"
{
    grep -o "$key" "$scratch/text"
    grep -oF -f "$scratch/listed" "$scratch/text"
    # A method names its source without brackets.
    find methods -name '*.c' -exec sed -n 's/^ *\.source = "\([^",]*\)[,"].*/[\1]/p' {} +
} | LC_ALL=C sort -u >"$scratch/cited"

check "every cited work is listed" \
    nothing "$(LC_ALL=C comm -23 "$scratch/cited" "$scratch/listed")"
check "every listed work is cited" \
    nothing "$(LC_ALL=C comm -13 "$scratch/cited" "$scratch/listed")"
check "the list is in order of its keys, each once" \
    nothing "$(tr -d '[]' <"$scratch/order" | LC_ALL=C sort -uc 2>&1)"

# not_in FILE: the words on standard input that FILE, or a folder of pages, does not contain; in
# Markdown only `code` and headings count.
not_in() {
    case $1 in
    */elements | */commands | */methods) grep -ho -e '`[^`]*`' -e '^#.*' "$1"/*.md ;;
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

check "every element of a room file is in docs/elements" \
    nothing "$(names_of element | not_in docs/elements)"
check "every attribute of a room file is in docs/elements" \
    nothing "$(names_of attribute | not_in docs/elements)"
check "every glazing is in docs/elements" \
    nothing "$(first_column tables/glazings.csv | not_in docs/elements)"
check "every finish is in docs/elements" \
    nothing "$(first_column tables/finishes.csv | not_in docs/elements)"
check "every frame is in docs/elements" \
    nothing "$(first_column tables/frames.csv | not_in docs/elements)"
check "every sort of curtains is in docs/elements" \
    nothing "$(first_column tables/curtains.csv | not_in docs/elements)"

program=$build/pepperpot
find methods -name '*.c' -exec sed -n 's/^ *\.name = "\(.*\)",/\1/p' {} + >"$scratch/methods"
check "every method is in docs/methods" nothing "$(not_in docs/methods <"$scratch/methods")"
check "every method is in the man page" \
    nothing "$(not_in docs/pepperpot.1 <"$scratch/methods")"

"$program" --help | sed -n 's/^  \([a-z][a-z]*\)  *[A-Za-z].*/\1/p' >"$scratch/commands"
check "the program has commands" test -s "$scratch/commands"
check "every command is in docs/commands" nothing "$(not_in docs/commands <"$scratch/commands")"
check "every command is in the man page" nothing "$(not_in docs/pepperpot.1 <"$scratch/commands")"
while read -r command; do
    "$program" "$command" --help | sed -n 's/^  .*\(--[a-z][a-z-]*\).*/\1/p'
done <"$scratch/commands" | sort -u | grep -v -- --help >"$scratch/options"
check "every option is in docs/commands" nothing "$(not_in docs/commands <"$scratch/options")"
check "every option is in the man page" \
    nothing "$(not_in docs/pepperpot.1 <"$scratch/options")"
"$program" chart --list | sed -n 's/^  \([a-z][a-z-]*\) .*/\1/p' >"$scratch/charts"
check "every chart is in docs/commands" nothing "$(not_in docs/commands <"$scratch/charts")"

reference() {
    ${AWK:-awk} -f docs/reference.awk pepperpot.h | cmp - docs/reference.md
}
check "docs/reference.md is what make reference makes of pepperpot.h" reference
"$program" df --list-formulas >"$scratch/formulae"
formulae() {
    for page in docs/methods/*.md; do
        ${AWK:-awk} -f docs/formulae.awk "$scratch/formulae" "$page" | cmp - "$page" || return 1
    done
}
check "formulae in docs/methods are those that the program works out (make formulae)" formulae
sed -n 's/^\([a-z][a-z-]*\)  \[.*/\1/p' "$scratch/formulae" >"$scratch/with_formulae"
check "the program lists formulae" test -s "$scratch/with_formulae"
sed -n 's/^<!-- formulae of \(.*\) -->/\1/p' docs/methods/*.md | sort >"$scratch/shown"
# Pages describe counting and reading scales in words.
check "every method's are in docs/methods" nothing "$(grep -vx -e waldram -e pepper-pot \
    -e protractor -e nomogram "$scratch/with_formulae" | sort | comm -3 - "$scratch/shown")"
find methods -name '*.c' -exec sed -n 's/^ *\.source = "\([A-Z][A-Z0-9]*\)[,"].*/\1/p' {} + |
    LC_ALL=C sort -u >"$scratch/sources"
check "methods name their sources" test -s "$scratch/sources"
check "where.md has a place for each of them" nothing "$(sh docs/where.sh |
    sed -n 's/^| \[\([A-Za-z0-9]*\)\] .*/\1/p' | LC_ALL=C sort -u |
    LC_ALL=C comm -13 - "$scratch/sources")"

# Links to pages, files and headings.
check "no page of the manual has a dead link" nothing "$(
    ${AWK:-awk} -f tests/house/links.awk README.md ARCHITECTURE.md CONTRIBUTING.md \
        docs/*.md docs/*/*.md)"

# Sentences are short, and none begins with "Of", "What" or "How". Titles of works, and the texts
# of benchmarks and of the header, are not tested.
find README.md ARCHITECTURE.md CONTRIBUTING.md docs -name '*.md' ! -name PERFORMANCE.md \
    ! -name SOURCES.md ! -name reference.md >"$scratch/plain"
check "pages have fewer than 18 words a sentence on average" nothing "$(
    LC_ALL=C xargs ${AWK:-awk} -v limit=18 -f tests/house/sentences.awk <"$scratch/plain")"

# once TEXT: a number of a published formula occurs once in the code, apart from comments, so that
# program, --explain and manual always agree.
once() {
    found=$(grep -rnF --include='*.[ch]' -- "$1" methods | grep -v '^[^:]*:[0-9]*: \*')
    [ "$(printf '%s\n' "$found" | grep -c .)" -eq 1 ] || printf '%s: %s\n' "$1" "$found"
}
check "each constant of the BRE formula stands once" \
    nothing "$(once '"5 R_cw"'; once '0.85 W'; once '31 R_fw')"
check "and nowhere as a number of C" nothing "$(grep -rnE '\b0\.05\b|\b5\.0 \*' methods/reflected \
    methods/nomogram --include='*.[ch]' | grep -v '^[^:]*:[0-9]*: \*')"
check "equations 9, 12 and 15 of [GEEBELEN] stand once" nothing "$(
    once '(rho_u C_g / A_u + rho_u rho_l C / A_l)'
    once '(u rho_u / A_u + (1 - u) rho_u rho_l / '
    once '(rho_u C_g + rho_l C)')"

check "every folder of the sources is in ARCHITECTURE.md" \
    nothing "$(find $folders -type d | sed 's|.*/||; s|$|/|' | not_in ARCHITECTURE.md)"

# The gradation of the overcast sky is in graded_sky.h. Other code with a number derived from it (1
# + 2 sin, 3/7, 3/14, 4/(7 pi), 7/9) repeats it. The patterns match the usual ways to write such
# numbers; tests/methods/test_gradation.c shows that all closed forms depend on the gradation.
# Radiance's skies have their own constants.
repeated='7(\.0)? *\* *(PP_PI|3\.14)|14(\.0)? *\* *PP_PI|/ *14(\.0)?([^0-9.]|$)'
repeated="$repeated|(3|7|9)(\\.0)? */ *(3|7|9)\\.0"
repeated="$repeated|1(\\.0)? *\\+ *2(\\.0)? *\\* *(Dz|sin|[a-z]+\\.z|s )"
repeats() {
    grep -rlE --include='*.[ch]' "$repeated" $folders | LC_ALL=C sort | while read -r file; do
        case $file in */graded_sky.[ch] | */scene_description.c | */rad_gensky.c) continue ;; esac
        sed -e ':a' -e 's|/\*.*\*/||' -e '\|/\*|{N' -e 'ba' -e '}' "$file" |
            grep -E "$repeated" | sed "s|^|$file: |"
    done
}
check "the overcast sky's gradation is in one place" nothing "$(repeats)"
# The code in docs/theory.md is that of the program.
theory_code() {
    ${AWK:-awk} -v top=. -f docs/code_blocks.awk docs/theory.md 2>&1 | diff docs/theory.md - | head
}
check "the code in docs/theory.md is that of the sources (make theory)" nothing "$(theory_code)"
tap_done
