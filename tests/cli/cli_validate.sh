#!/bin/sh
# validate: cases with known results, and methods compared with the simulation; the figures are
# recalculated from df's output for the same room.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# fails_by STATUS TEXT WORDS: prints its results, and ends with this status and text.
fails_by() {
    wanted=$1 text=$2
    shift 2
    run "$@"
    [ $status -eq "$wanted" ] && [ -s "$scratch/out" ] && grep -q "$text" "$scratch/err" || told
}

check "results are compared with known ones" shows "Comparison of the program with results" validate
check "and all of it is right" grep -qE '^  ([0-9]+) of \1 right' "$scratch/out"
check "none is wrong" nothing "$(grep WRONG "$scratch/out")"
check "the output is tidy in 80 columns" nothing "$(untidy)"
check "in JSON too" shows '"format": "pepperpot-validate-1"' validate --format json
check "with at least 40 answers" test "$(grep -c '"right": true' "$scratch/out")" -ge 40
check "all right" nothing "$(grep '"right": false' "$scratch/out")"
check "in CSV too" shows 'what,by,answer,expected,difference' validate --format csv
check "9 fields a line" nothing \
    "$(sed 's/"[^"]*"/text/g' "$scratch/out" | awk -F, 'NF != 9')"
check "another seed is right too" shows "right:" validate --seed 7

# ---- suites ----

for suite in analytic published; do
    check "suite $suite passes" gives validate $suite --page "$scratch/$suite.html"
    check "all of it" grep -qE '^  ([0-9]+) of \1 right' "$scratch/out"
    check "tidy in 80 columns" nothing "$(untidy)"
    check "its page says so" grep -q 'class="verdict">Passed' "$scratch/$suite.html"
    check "and asks nothing of a network" nothing \
        "$(grep -iE 'https?:|<script|<link|src=|@import' "$scratch/$suite.html")"
    check "and has a row a case" test \
        "$(grep -c '>right</tr>' "$scratch/$suite.html")" -eq \
        "$(grep -cE ' right$' "$scratch/out")"
done
check "every cell of the BRS table is there" test "$(grep -c '^  h/d ' "$scratch/out")" -eq 580
check "a suite in JSON" shows '"suite": "analytic"' validate analytic --format json
check "says that it passes" grep -q '"passes": true' "$scratch/out"
check "3 threads give the same bytes as 1" same_by_threads "1 3" \
    validate analytic --format csv
check "a suite has its own rooms" refuses 2 "no file after it" validate analytic "$deep"
check "and no options of rooms" refuses 2 "--sky is for rooms" \
    validate published --sky uniform
check "rooms want files" refuses 2 "expected room files" validate rooms
check "a page is of a suite" refuses 2 "cie171, rooms, radiance or engines" \
    validate --page "$scratch/x.html" "$deep"
check "radiance wants one" refuses 2 "expected room files" validate radiance
check "a page in the report's file is refused" refuses 2 "are the same file" \
    validate analytic -o "$scratch/x.html" --page "$scratch/x.html"
check "a page where none can be written" refuses 3 "nowhere" \
    validate analytic --page "$scratch/nowhere/x.html"
check "a mistyped suite is asked after" refuses 2 "did you mean analytic?" \
    validate analytics
check "what is like none is a file that is not there" refuses 1 "xylophone" \
    validate xylophone
cp "$deep" "$scratch/analytics"
check "and a file of such a name is a file" gives validate --samples 8 --methods bre \
    "$scratch/analytics"

# ---- the suite of rooms ----

obstructed=$examples/deep-office-obstructed.xml
few="--samples 16 --methods exact+bre,average-df"
check "rooms gives each figure, what is traced, and the verdict" gives \
    validate rooms $few --page "$scratch/rooms.html" "$obstructed" "$examples/l-shaped.xml"
check "tidy in 80 columns" nothing "$(untidy)"
check "by the limits of the bands" grep -qE \
    '^  df at 1.50, 1.50 +[0-9.]+ +[0-9.]+ +-[0-9.]+ +-[0-9.]+ +\+[0-9.]+ +-[0-9.]+ +-[0-9.]+ right$' \
    "$scratch/out"
check "and says why there is none" grep -q 'without a verdict: no likely ranges, because ' "$scratch/out"
check "its page says what passes" grep -q 'class="verdict">Passed' "$scratch/rooms.html"
check "has the reason" grep -q '<li>.*the plan is not convex' "$scratch/rooms.html"
check "draws dots for both parts of the errors" test \
    "$(grep -c '^</figcaption><svg\|</figcaption><svg' "$scratch/rooms.html")" -eq 4
check "and asks nothing of a network" nothing \
    "$(grep -iE 'https?:|<script|<link|src=|@import' "$scratch/rooms.html")"
check "the same in CSV" gives validate rooms $few --format csv "$examples/office.xml"
tr -d '\r' <"$scratch/out" | sed 's/"\([^",]*\),\([^"]*\)"/\1;\2/' >"$scratch/suite"
check "with 15 fields a line" nothing "$(awk -F, 'NF != 15' "$scratch/suite")"
check "differences, parts and verdicts agree" nothing "$(awk -F, '
    function off(a, b) { return (a - b)^2 > 1e-16 }
    NR > 1 && (off($3 - $4, $5) || off($13 + $14, $5) \
               || ($5 >= $12 && $5 <= $6) != ($8 == "yes")) { print }' "$scratch/suite")"
check "in JSON, too" shows '"suite": "rooms"' validate rooms $few --format json "$obstructed"
check "with the limits on both sides" grep -q \
    '"tolerance": .*"right": .*"tolerance-below": -.*"assumption": .*"formula": ' "$scratch/out"
# A single reflected component for the whole deep room is outside its band near the window.
check "the exit status is 1 where more is outside than may" fails_by 1 "outside their limits" \
    validate rooms --samples 64 --methods bre --page "$scratch/bre.html" "$deep"
check "and the page says so" grep -q 'class="verdict bad">Not passed' "$scratch/bre.html"

# Bias, spread and largest difference of a room, recalculated from df's figures with the same
# paths.
methods=exact+bre,brs-table+bre,average-df
gives df --simulate --samples 16 --methods "$methods" --format csv "$deep" >/dev/null
tr -d '\r' <"$scratch/out" >"$scratch/df"
check "a room is compared with what is traced" \
    gives validate --samples 16 --methods "$methods" --format csv "$deep"
tr -d '\r"' <"$scratch/out" >"$scratch/validate"
check "with 26 fields a line" nothing "$(awk -F, 'NF != 26' "$scratch/validate")"
# worked_again METHOD: its bias, spread and largest difference, calculated by this script.
worked_again() {
    awk -F, -v method="$1" '
        $3 == "point" && $10 == "df" && $11 == "traced" { truth[$4 " " $5] = $12; error[$4 " " $5] = $13 }
        $3 == "point" && $10 == "df" && $11 == method { value[$4 " " $5] = $12 }
        END {
            for (at in value) {
                off = value[at] - truth[at]; n++
                sum += off; squares += off^2; noise += error[at]^2
                if (off^2 > worst^2) worst = off
            }
            spread = (squares - noise) / n
            printf "%.6f %.6f %.6f\n", sum / n, sqrt(spread > 0 ? spread : 0), worst
        }' "$scratch/df"
}
said() {
    awk -F, -v method="$1" '
        $3 == "df" && $4 == method { printf "%.6f %.6f %.6f\n", $10, $12, $13 }
        ' "$scratch/validate"
}
for method in exact+bre brs-table+bre; do
    check "$method: bias, spread and worst are those of df's figures" \
        test "$(said $method)" = "$(worked_again $method)"
done
# The error by bre's assumption: df's simulation with bre's ground in the file, minus that with the
# room's own ground. formula: the rest of the bias.
sed 's|<site |<site ground="open" ground-reflectance="0.1" |' "$deep" >"$scratch/own.xml"
check "the deep office has its ground by default" nothing "$(grep ground= "$deep")"
gives df --simulate --samples 16 --methods bre --format csv "$scratch/own.xml" >/dev/null
tr -d '\r' <"$scratch/out" >"$scratch/own"
check "the assumption is what is traced with the method's ground, less the room's" test \
    "$(awk -F, '$3 == "irc" && $4 == "bre" { printf "%.6f %.6f %.6f\n", $19, $21, $23 }' \
        "$scratch/validate")" = \
    "$(awk -F, '
        $10 == "irc" && $11 == "traced" && $3 == "point" { sum += (FNR == NR ? -1 : 1) * $12; n++ }
        $10 == "irc" && $11 == "bre" && $3 == "point" && FNR != NR { bre += $12 }
        $10 == "irc" && $11 == "traced" && $3 == "point" && FNR != NR { own += $12 }
        $10 == "irc" && $11 == "traced" && $3 == "average" { average += (FNR == NR ? -1 : 1) * $12 }
        END { printf "%.6f %.6f %.6f\n", 2 * sum / n, 2 * (bre - own) / n, average }' \
        "$scratch/df" "$scratch/own")"
check "assumption and formula add up to the bias, and to the average's difference" nothing \
    "$(awk -F, '
        function off(a, b) { return (a - b)^2 > 1e-16 }
        NR > 1 && $10 != "" && off($19 + $21, $10) { print }
        NR > 1 && $5 != "" && off($23 + $25, $5 - $6) { print }' "$scratch/validate")"
check "and all columns of the average formula are there" test "$(awk -F, '
    $4 == "average-df" && $19 == "" && $23 < 0 && $24 > 0 && $25 < 0 && $26 > 0' \
    "$scratch/validate" | wc -l)" -eq 1
check "an average formula has its average compared" \
    grep -qE '^[^,]*,Deep office,df,average-df,3\.03[0-9]*,[34]\.' "$scratch/validate"
check "the text names the worst point" \
    shows "at x, y" validate --samples 16 --methods exact+bre "$deep"
check "and fits in 80 columns" nothing "$(too_wide)"
check "it tells the assumption's part of it from the formula's" \
    grep -qE '^  causes +of off, % +of bias$' "$scratch/out"
check "for the components in which the method's world is another" \
    test "$(sed '1,/causes/d' "$scratch/out" | grep -cE '^    (exact|bre) ')" -eq 1
check "bre's ground is too dark for it" \
    grep -qE '^    bre +-[0-9.]+ +[+-][0-9.]+ +[0-9.]+ +-[0-9.]+ +[+-][0-9.]+ +[0-9.]+$' \
    "$scratch/out"
gives validate --samples 16 --methods bre "$scratch/own.xml"
check "where its world is the room's there is nothing to tell" nothing \
    "$(grep -i 'where it comes' "$scratch/out")"
check "what was not traced in time is left out" gives validate --time 1ms \
    --methods exact+bre "$examples/building.xml"
check "and tidily" nothing "$(grep -iE '[^a-z](nan|inf)([^a-z]|$)' "$scratch/out")"
check "a room that methods refuse is said to be" \
    shows "not vertical" validate --samples 16 "$examples/studio.xml"
check "several rooms are summed up" shows "All 2 rooms" \
    validate --samples 16 --methods exact+bre "$deep" "$examples/office.xml"
check "with both parts of the errors" grep -qE '^    exact\+bre +-[0-9.]+ +\+[0-9.]+ +-' \
    "$scratch/out"
check "in JSON" shows '"all": [' \
    validate --samples 16 --methods exact+bre --format json "$deep" "$examples/studio.xml"
check "with the reason where there is nothing" grep -q '"why": "bre: ' "$scratch/out"
check "with both parts of each, and their standard errors" test "$(grep -c \
    '"average-assumption": .*"average-assumption-se": .*"average-formula": .*"average-formula-se": .*"assumption": .*"assumption-se": .*"formula": .*"formula-se": ' \
    "$scratch/out")" -eq 6
check "and of all rooms" grep -q \
    '"average-assumption": .*"average-formula": .*"assumption": .*"formula": ' "$scratch/out"
check "no nan" nothing "$(grep -i '[^a-z]nan' "$scratch/out")"
check "the same bytes with 1 and 2 threads" same_by_threads "1 2" \
    validate --samples 16 "$deep"

check "options of rooms need one" refuses 2 "--methods is for rooms" \
    validate --methods bre
check "a method that there is not" refuses 2 "bre" validate --methods brr "$deep"
check "a file that there is not" refuses 1 "nowhere.xml" validate nowhere.xml
check "a format that there is not" refuses 2 "text, json or csv" validate --format xml
check "--simulate goes without saying" refuses 2 "--simulate" validate --simulate "$deep"
tap_done
