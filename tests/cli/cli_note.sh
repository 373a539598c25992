#!/bin/sh
# The typeset note of a point has the same formulae and figures as df --explain.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# Formulae without characters that are typeset differently (blanks, underscores, powers, stars),
# and values with their units, one per line.
plain='
    function bare(text) { gsub(/[ _^,]|\303\227|\*/, "", text); return text }
    function is_value(text) { return text ~ /^-?[0-9]+(\.[0-9]+)?( %| m| m²| lx|°)?$/ }'

explained() {
    ${AWK:-awk} "$plain"'
        /^  [a-z].* by [a-z0-9+-]*$/ { steps = 1; next }
        /^  - / { steps = 0 }
        /^  [^ ]/ { steps = 0 }
        !steps { next }
        /^    [^ ]/ || /^$/ { next }
        formula && /^          [^ ]/ && !/^           / { formula = formula $0; next }
        { if (formula) print bare(formula); formula = "" }
        /^      [^ ].* = |^      = / { formula = $0; next }
        match($0, /  -?[0-9]+(\.[0-9]+)?( %| m| m²| lx|°)?$/) {
            value = substr($0, RSTART); sub(/^ */, "", value); print value }
    ' "$scratch/out"
}

# In the order of the note: a formula, the same with values inserted (skipped here), the result,
# then its meaning.
noted() {
    pdftotext -raw "$1" - | ${AWK:-awk} "$plain"'
        / by [a-z0-9+-]*(, of the room)?$/ { steps = 1; next }
        /^Result$/ { exit }
        !steps || /^Opening on line|^cross is opp|^Plan 1:|^Section 1:/ { next }
        is_value($0) { if (formula) print bare(formula); formula = ""; print; put = 0; next }
        / = |^= [^0-9(]/ && !/^= [0-9]/ && !formula { formula = $0; put = 0; next }
        /^= / { put = 1; next }
        formula && !put { formula = formula $0; next }
        put { next }
        { value = $0; sub(/^[^ ]* /, "", value) }
        is_value(value) && NF <= 3 { print value }
    '
}

agrees() {
    room=$1 point=$2 methods=$3
    shift 3
    LC_ALL=C.UTF-8 run df --points "$point" -m "$methods" --explain "$room" || return
    explained >"$scratch/explained"
    run chart note --points "$point" -m "$methods" "$room" -o "$scratch/note.pdf" "$@"
    [ $status -eq 0 ] || { told; return; }
    noted "$scratch/note.pdf" >"$scratch/noted"
    [ "$(wc -l <"$scratch/explained")" -gt 10 ] &&
        diff "$scratch/explained" "$scratch/noted" >"$scratch/differ" ||
        { head -n 20 "$scratch/differ"; return 1; }
}

if command -v pdftotext >/dev/null; then
    check "a sum by table and formula" agrees "$examples/office.xml" 1.5,2 brs-table+bre
    check "by closed form, and of the room" \
        agrees "$examples/office.xml" 1.5,2 exact+split-flux,average-df
    check "on the smallest paper" \
        agrees "$examples/deep-office-obstructed.xml" 1.5,2 protractor+bre --paper a5
    check "on the largest" agrees "$examples/l-shaped.xml" 2,2 waldram+sphere --paper a2
    check "the note names its works" sh -c \
        "pdftotext '$scratch/note.pdf' - | tr '\n' ' ' | grep -q 'Petherbridge\|Hopkinson\|Walsh\|Waldram'"
    values() {
        run chart note --points 1.5,2 -m bre "$examples/office.xml" -o "$scratch/bre.pdf"
        pdftotext -raw "$scratch/bre.pdf" - | grep -qF "$1"
    }
    check "values stand in their symbols' places" values \
        '= 0.85 × 1.560 / (100.512 × (1 − 0.5221)) × (31.0000 × 0.4056 + 5 × 0.6922)'
    # 0.85 x 1.56 / (100.512 x 0.4779) x (12.5736 + 3.461), calculated by hand.
    check "and come to what is printed" values '0.4426 %'
else
    skip "the note and --explain agree" "no pdftotext here"
fi

check "several points have a note each" \
    quietly chart note -p 1.5,2 -p 1.5,3 -m bre "$examples/office.xml" -o "$scratch/two.pdf"
check "but in a PDF only" refuses 1 "only a PDF can hold" chart note -p 1.5,2 -p 1.5,3 -m bre \
    "$examples/office.xml" -o "$scratch/two.svg"
check "a long note is not cut" refuses 1 "several sheets" chart note -p 1.5,2 \
    -m exact+bre "$examples/office.xml" -o "$scratch/long.png"
check "a short one is a picture too" quietly chart note -p 1.5,2 -m bre \
    "$examples/deep-office.xml" -o "$scratch/short.png" --dpi 50
check "a grid is too many points" refuses 1 "1 to 12 points" chart note -m bre \
    "$examples/classroom.xml" -o "$scratch/grid.pdf"
check "traced light has no sum" refuses 2 "hand methods" chart note -s -p 1.5,2 \
    "$examples/office.xml" -o "$scratch/x.pdf"
check "nothing is left over" test -z "$(leftovers)"

tap_done
