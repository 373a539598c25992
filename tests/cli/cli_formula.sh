#!/bin/sh
# --formula and --list-formulas: a variant of a formula next to the published one, and errors in
# formulae.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

office=$examples/office.xml

# value COLUMN COMPONENT [PLACE]: value of the average, or of a point, in the last CSV.
value() {
    awk -F, -v c="$1" -v k="$2" -v at="${3:-average}" '$3 == at && $10 == k && $11 == c { print $12 }' \
        "$scratch/out"
}

# ratio A B WANTED: A/B equals the number to the printed digits.
ratio() {
    awk -v a="$1" -v b="$2" -v w="$3" 'BEGIN { r = a / b
        if (!(a > 0 && r > w - 1e-8 && r < w + 1e-8)) { print a " / " b " is " r; exit 1 } }'
}

lighter='irc = 0.83 W / (A (1 - R)) (C R_fw + 5 R_cw)'
check "a variant is computed" gives df --formula "$lighter" --format csv "$office"
check "and is 83/85 of the published formula" \
    ratio "$(value bre-variant irc)" "$(value bre irc)" 0.97647058824
check "with exact's direct component it makes a daylight factor" \
    ratio "$(value exact+bre-variant df)" \
    "$(awk "BEGIN { printf \"%.10g\", $(value exact sc) + $(value exact erc) + $(value bre-variant irc) }")" 1
check "the published text as a variant gives the published figure" \
    gives df --formula 'irc = 0.85 W / (A (1 - R)) (C R_fw + 5 R_cw)' --format csv "$office"
check "to the bit" test "$(value bre-variant irc)" = "$(value bre irc)"
check "two variants have columns of their own" gives df --formula "$lighter" \
    --formula 'bre: irc = 2 * 0.85 W / (A (1 - R)) (C R_fw + 5 R_cw)' --format csv "$office"
check "the second is double" ratio "$(value bre-variant-2 irc)" "$(value bre irc)" 2
check "a method that was not asked for stands beside its variant" \
    gives df -m average-df --format csv "$office" \
    --formula 'split-flux: irc = 1.1 tau Ag / (1 - rho_u rho_l) (rho_u C_g / A_u + rho_u rho_l C / A_l)'
check "by 1.1" ratio "$(value split-flux-variant irc)" "$(value split-flux irc)" 1.1
check "quantities alone tell the method" gives df -m average-df --format csv "$office" \
    --formula 'irc = 3 tau Ag / (A (1 - R)) (rho_u C_g + rho_l C)'
check "which is sphere" ratio "$(value sphere-variant irc)" "$(value sphere irc)" 3
check "a step on the way can be replaced" gives df --format csv "$office" \
    --formula 'theta = 0.5 max(theta_h - alpha, 0)'
check "and halves what it leads to" \
    ratio "$(value average-df-variant df)" "$(value average-df df)" 0.5
check "a table's arithmetic, too" gives df --format csv --points 1.4,1.5 "$office" \
    --formula 'sc = 0.9 (H - S)'
check "at a point" ratio "$(value brs-table-variant sc point)" \
    "$(value brs-table sc point)" 0.9

check "the text report says what the variant is" \
    shows 'bre-variant: bre with irc = 0.83 W' df --formula "$lighter" "$office"
check "JSON names the column" shows '"column": "bre-variant"' \
    df --formula "$lighter" --format json "$office"
check "and the formula" grep -q '"formula": "irc = 0.83 W' "$scratch/out"
check "--explain prints the variant's sum" shows 'irc = 0.83 W / (A (1 - R))' \
    df --explain --points 1.4,1.5 --formula "$lighter" "$office"
check "validate holds it against the simulation" shows 'bre-variant' \
    validate --formula "$lighter" --samples 2 --quiet --format csv "$office"
check "validate without a room has no use for one" refuses 2 '--formula' \
    validate --formula "$lighter"

check "a formula that divides by zero in a room has no value" \
    shows 'divides by zero, in column 15' \
    df --formula 'irc = W C / A / (R - R)' --format json "$office"
check "one for panes that the room has not says so" shows "does not apply to any of the room's" \
    df --formula 'split-flux: irc = u C' -m split-flux "$office"

# refused TEXT COLUMN WORDS: the formula is rejected at this column.
refused() {
    check "\"$1\" is refused in column $2" refuses 2 "--formula, column $2: " \
        df --formula "$1" "$office"
    check "which says: $3" grep -qF -- "$3" "$scratch/err"
}
refused 'irc = 0.83 W / (A (1 - R) (C R_fw + 5 R_cw)' 44 'expected ")"'
refused 'irc = Q' 7 'there is no quantity "Q"'
refused 'irc = W + R' 11 'expected an area'
refused 'irc = C + R_fw' 11 'expected a percentage'
refused 'irc = C / (2 - 2)' 11 'this divisor is 0'
refused 'irc = W' 7 'an area'
refused 'irc W' 5 'expected "="'
refused 'Q = 3' 1 'expected sc'
refused 'no-such: irc = 3' 1 'unknown method'
refused 'waldram: sc = 2 n w' 10 'can be replaced'
refused 'irc = system(3)' 7 'one of the functions'
refused '' 1 'expected the symbol'
check "the place is shown by a caret" grep -q '^ *^$' "$scratch/err"
long=$(printf '%0250d' 1)
check "a text without an end is refused" refuses 2 '200 characters' \
    df --formula "irc = $long" "$office"
run df --formula "$(printf 'irc = \033[31m')" "$office"
check "control characters are not repeated" \
    nothing "$(LC_ALL=C tr -d '\n[:print:]' <"$scratch/err")"

check "all formulae are listed" shows '  irc = 0.85 W / (A (1 - R)) (C R_fw + 5 R_cw)  [BRE310]' \
    df --list-formulas
check "with their quantities" grep -q '^      R_fw    -    mean reflectance' "$scratch/out"
check "and sources" grep -q '\[GEEBELEN, eq. 12\]' "$scratch/out"
check "without a room" refuses 2 'expected no file' df --list-formulas "$office"
tap_done
