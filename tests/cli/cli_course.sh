#!/bin/sh
# The answers to the exercises in docs/course.md are the results of the program for their rooms,
# and their commands draw the sheets.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

course=$srcdir/docs/course.md
rooms=$srcdir/examples/situations
sed -n '/^<!-- /{s/^<!-- \(.*\) -->/\1/;N;s/\n.* \([0-9.]*\) %$/|\1/;p;}' "$course" >"$scratch/answers"
check "each exercise has an answer" test "$(wc -l <"$scratch/answers")" -eq 13
check "there are six exercises" test "$(grep -c '^## [1-6]\. ' "$course")" -eq 6

# found WORDS: the figure of the last run, and its standard error.
found() {
    case $1 in
    figure) sed -n 's/.*"figure": \([0-9.]*\), "unit": "%".*/\1 0/p' "$scratch/out" ;;
    *)
        ${AWK:-awk} -F, -v words="$1" '
            BEGIN { split(words, want, " ") }
            $3 == want[1] && $10 == want[2] && $11 == want[3] { print $12, $13 + 0; exit }
        ' "$scratch/out"
        ;;
    esac
}

# is_near TOLD FIGURE ERROR: equal as printed, or within four standard errors.
is_near() {
    ${AWK:-awk} -v told="$1" -v figure="$2" -v error="$3" 'BEGIN {
        off = told - figure
        exit figure == "" || (off < 0 ? -off : off) > 0.00501 + 4 * error }'
}

while IFS='|' read -r asked told; do
    words=${asked##*: } line=${asked%: *}
    room=${line##* } line=${line% *}
    form=csv
    case $line in assess*) form=json ;; esac
    # shellcheck disable=SC2086 # the line is words
    run $line --quiet --format $form "$rooms/$room.xml"
    # shellcheck disable=SC2046 # figure and error
    check "$room: $words is $told %" is_near "$told" $(found "$words")
done <"$scratch/answers"

# drawn WORDS: draws a sheet for a room in the folder of situations.
drawn() {
    (cd "$rooms" && "$pepperpot" chart "$@" -o "$scratch/sheet.pdf" 2>"$scratch/err") &&
        test -s "$scratch/sheet.pdf"
}
sed -n 's/^    pepperpot chart \(.*\) -o .*/\1/p' "$course" >"$scratch/sheets"
check "the sheets are made by commands" test "$(wc -l <"$scratch/sheets")" -eq 8
while read -r line; do
    # shellcheck disable=SC2086 # the line is words
    check "$line" drawn $line
done <"$scratch/sheets"
tap_done
