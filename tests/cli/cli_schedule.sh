#!/bin/sh
# assess --schedule: sky, sunlight and lit area of each window, existing and proposed.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
LC_ALL=C
export LC_ALL
site=$examples/sites/corner-house.xml
csv=$scratch/windows.csv

check "a schedule beside the table" gives assess --by-hand --for uk-planning --table \
    --schedule "$csv" "$site"
check "whose sunlight has its own table" grep -q "^  Sunlight hours, possible" "$scratch/out"
check "is a line a window, below a head" test "$(wc -l <"$csv")" -eq 6
check "all with as many fields" test "$(awk -F, '{ print NF }' "$csv" | sort -u | wc -l)" -eq 1
# field COLUMN WINDOW: value of this column in the line of the window.
field() {
    awk -F, -v column="$1" -v window="$2" '
        NR == 1 { for (i = 1; i <= NF; i++) { sub(/\r/, "", $i); if ($i == column) c = i; if ($i == "window") w = i } }
        NR > 1 && $w == window { print $c }' "$csv"
}
"$pepperpot" assess --by-hand -c former-sky -f csv "$site" >"$scratch/findings.csv"
check "the sky is that of the findings" test "$(field vsc_proposed W3)" = \
    "$(awk -F, '/former-sky,"W3/ { print $10 }' "$scratch/findings.csv")"
check "loss and ratio are one" awk -v loss="$(field vsc_loss_percent W3)" \
    -v ratio="$(field vsc_ratio W3)" 'BEGIN { d = loss - 100 * (1 - ratio); exit !(loss > 20 && d * d < 1e-12) }'
check "the year's sun is more than winter's" awk -v year="$(field sun_year_proposed W1)" \
    -v winter="$(field sun_winter_proposed W1)" 'BEGIN { exit !(year > winter && winter > 0) }'
check "findings have their season" shows '"season": "winter"' \
    assess --by-hand -c sunlight -f json "$site"
check "only windows of living rooms have sunlight" test -z "$(field sun_year_proposed W4)"
check "the lit area is that of its room" test -n "$(field lit_area_proposed W3)"
check "hours without a weather file are possible" test "$(field sun_hours W3)" = possible
check "upper floors have their level" test "$(field level_m W5)" = 3.5
check "JSON has the sunlight of each window" shows '"sunlight": [' \
    assess --by-hand --for uk-planning --table -f json "$site"
check "with losses" grep -q '"loss": ' "$scratch/out"

xlsx=$scratch/windows.xlsx
run assess --by-hand --for uk-planning --table --schedule "$xlsx" "$site"
if grep -q "built without libxlsxwriter" "$scratch/err"; then
    skip "a workbook" "no libxlsxwriter"
else
    check "a workbook is a ZIP archive" test "$(head -c 2 "$xlsx")" = PK
    cp "$xlsx" "$scratch/first.xlsx"
    run assess --by-hand --for uk-planning --table --schedule "$xlsx" "$site"
    check "and the same again" same "$scratch/first.xlsx" "$xlsx"
    if command -v unzip >/dev/null; then
        check "with the names of rooms" sh -c "
            unzip -p '$xlsx' xl/sharedStrings.xml | grep -q '<t>Living room</t>'"
        check "and the figures of the CSV" sh -c "
            unzip -p '$xlsx' xl/worksheets/sheet1.xml | grep -qF '<v>$(field vsc_proposed W3 | cut -c 1-8)'"
    else
        skip "with the names of rooms" "no unzip"
    fi
fi
html=$scratch/windows.html
run assess --by-hand --for uk-planning --table --schedule "$html" "$site"
check "a page has the figures of the CSV" grep -q ">$(printf '%.2f' "$(field vsc_proposed W3)")<" "$html"
check "below the floors" test "$(grep -c 'floor at +3.50 m' "$html")" -eq 2
check "it marks losses of 20 % or more" grep -q \
    "<td class=\"bad\">$(printf '%.1f' "$(field vsc_loss_percent W3)")<" "$html"
check "and is whole" grep -q "</html>" "$html"
pdf=$scratch/windows.pdf
run assess --by-hand --for uk-planning --table --schedule "$pdf" "$site"
check "a PDF is of one landscape sheet" awk '/\/MediaBox/ { n++; wide = $4 + 0 > $5 + 0 || wide }
    END { exit n != 1 }' "$pdf"
if command -v pdftotext >/dev/null; then
    pdftotext -layout "$pdf" "$scratch/windows.txt"
    check "with a line a window" test "$(grep -cE ' W[1-5] ' "$scratch/windows.txt")" -eq 5
    check "and the figures of the CSV" grep -qF "$(printf '%.2f' "$(field vsc_proposed W3)")" \
        "$scratch/windows.txt"
else
    skip "with a line a window" "no pdftotext"
fi
run assess --by-hand -c vertical-sky --schedule "$html" "$examples/office.xml"
check "without a former state there are no losses" sh -c "! grep -q 'loss' '$html'"
check "other endings are refused" refuses 2 "ends in .csv, .xlsx, .html or .pdf" \
    assess --by-hand --schedule "$scratch/windows.ods" "$site"
check "a schedule needs sky or sunlight" refuses 1 "no skylight or sunlight at windows was assessed" \
    assess --by-hand -c average --schedule "$scratch/none.csv" "$site"
check "and then is not written" test ! -e "$scratch/none.csv"
check "it is for one run" refuses 2 "--schedule is for a single run" \
    assess --by-hand --schedule "$csv" --sweep block.Tower.height=9,10 "$site"
check "nothing is left over" nothing "$(leftovers; ls /tmp/pepperpot-xlsx-* 2>/dev/null)"

tap_done
