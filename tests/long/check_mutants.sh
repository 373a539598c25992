#!/bin/sh
# check_mutants.sh BUILD - measures how many deliberate errors the tests detect. Applies the
# changes of mutants.txt, and others drawn at random by draw_mutants.awk, one at a time, to the
# copy of the sources for which BUILD was configured. Runs the quick tests until one fails: first
# those that include the header of the changed file, then those of the mirror folder in tests/,
# then all others. Prints for each change the test that detected it. Fails if no test detects more
# than 5 in 100 changes of the list, or more than a third of the drawn ones: some drawn changes do
# not affect results. Also fails if a change of the list does not match exactly one line; a drawn
# change that does not compile does not count. A test that fails without any change is named and
# excluded. Takes hours; make check-mutants makes the copy.
#
# MUTANTS=REGEX: only changes whose line matches. DRAWN=N: N drawn changes (60), 0: none. SEED=N:
# other drawn changes (1). NEAR=yes: only the tests nearest to each change, which takes minutes;
# other tests may detect those that remain.
build=$1 list=$(cd "$(dirname "$0")" && pwd)/mutants.txt
drawn_from="methods simulate model/light studies/criteria formats"
source=$(sed -n "s/^abs_srcdir = //p" "$build/Makefile")
[ -d "$source" ] && [ -r "$list" ] || {
    echo "check_mutants.sh: there is no configured build in $1" >&2
    exit 2
}
cd "$build" || exit 2
make="${MAKE:-make} -s"
$make all >mutant.log 2>&1 || {
    echo "check_mutants.sh: the copy does not build: $(grep -m 1 error mutant.log)" >&2
    exit 2
}
names() { echo "show: ; @echo \$($1)" | $make -f Makefile -f - show; }
# A C test is a file that the program of its folder runs. test_wrong_rooms is a separate program.
programs=$(cd "$source" && find tests -name 'test_*.c' ! -path 'tests/lib/*' | sed 's/\.c$//' | sort)
scripts=$(names dist_check_SCRIPTS | tr ' ' '\n' | grep -v '^tests/house/')
export srcdir="$source"

# near FILE: the tests that are likely to detect a change in this file, or those of the parent
# folders if its own folder has none.
near() {
    header=${1%.c}.h folder=tests/$(dirname "$1")
    for program in $programs; do
        ! grep -q "^#include \"$header\"" "$source/$program.c" || echo "$program"
    done
    while [ "$folder" != tests ]; do
        here=$(echo "$programs $scripts" | tr ' ' '\n' | grep "^$folder/[^/]*\$")
        echo "$here"
        [ -z "$here" ] || break
        folder=$(dirname "$folder")
    done
}

# program_of TEST: the program to be built for this test.
program_of() {
    case $1 in
    *.sh) echo pepperpot ;;
    */test_wrong_rooms) echo "$1" ;;
    *) echo "$1" | sed 's|^tests/\([^/]*\)/.*|tests/\1/\1_tests|' ;;
    esac
}

# fails TEST: succeeds if the test fails or does not end.
fails() {
    case $1 in
    *.sh) run="sh $source/$1" ;;
    */test_wrong_rooms) run="sh $source/tests/lib/run.sh ./$1" ;;
    *) run="sh $source/tests/lib/run.sh ./$(program_of "$1") --filter ${1##*/}" ;;
    esac
    ! (ulimit -v 12000000 && timeout 600 $run) >mutant.log 2>&1 || grep -q '^not ok' mutant.log
}

# once WORD ...: each word once, in the order of its first occurrence.
once() { printf '%s\n' "$@" | awk 'NF && !seen[$0]++'; }

# made TEST ...: builds the programs for these tests.
made() {
    needed=
    for test in "$@"; do
        needed="$needed $(program_of "$test")"
    done
    $make $(once $needed) >mutant.log 2>&1
}

# seen_by TEST ...: prints the first test that fails; "" if none does.
seen_by() {
    made "$@" || {
        echo "not made: $(grep -m 1 error mutant.log)"
        return
    }
    for test in "$@"; do
        if ! grep -q "^$test\$" mutant.unsound && fails "$test"; then
            echo "$test"
            return
        fi
    done
}

# try TEST ...: runs those tests without any change that have not been run yet.
try() {
    for test in "$@"; do
        ! grep -q "^$test\$" mutant.tried || continue
        echo "$test" >>mutant.tried
        if ! made "$test" || fails "$test"; then
            echo "$test" >>mutant.unsound
            echo "without any change: $test fails"
        fi
    done
}

# change_all FILE: applies the changes listed in the file. Sets done, survivors and wrong.
change_all() {
    done=0 survivors=0 wrong=0
    while read -r file change; do
        first=$(once $(near "$file")) rest=
        [ -n "${NEAR:-}" ] || rest=$(once $programs $scripts | grep -vxF "$first")
        try $first
        kept=$source/$file.kept
        cp -p "$source/$file" "$kept" && sed "$change" "$kept" >"$source/$file"
        lines=$(diff "$kept" "$source/$file" | grep -c '^>')
        done=$((done + 1))
        if [ "$lines" = 1 ]; then
            test=$(seen_by $first)
            [ -n "$test" ] || [ -z "$rest" ] || test=$(seen_by $rest)
        else
            test="not made: it changes $lines lines; expected 1"
        fi
        case $test in
        '') survivors=$((survivors + 1)) test='seen by none' ;;
        not*) wrong=$((wrong + 1)) ;;
        esac
        printf '%s: %s %s\n' "$test" "$file" "$change"
        mv "$kept" "$source/$file" && touch "$source/$file"
    done <"$1"
}

: >mutant.tried
: >mutant.unsound
grep -v '^#\|^$' "$list" | grep -- "${MUTANTS:-}" >mutants.listed
(cd "$source" &&
    awk -v count="${DRAWN:-60}" -v seed="${SEED:-1}" -f "$(dirname "$list")/draw_mutants.awk" \
        $(find $drawn_from -name '*.c' | sort)) | grep -- "${MUTANTS:-}" >mutants.drawn
[ -n "${NEAR:-}" ] || try $programs $scripts
failed=0
change_all mutants.listed
echo "of the list: $done changes, $survivors seen by no test, $wrong that cannot be made"
[ $wrong = 0 ] && [ $((100 * survivors)) -le $((5 * done)) ] || failed=1
all=$done
change_all mutants.drawn
echo "drawn: $done changes, $survivors seen by no test, $wrong that do not compile"
[ $((3 * survivors)) -le $done ] || failed=1
[ $((all + done)) -gt 0 ] && [ $failed = 0 ]
