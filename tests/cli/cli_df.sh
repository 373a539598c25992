#!/bin/sh
# What df computes and how it is laid out; its JSON is looked at by test_df_json.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

check "a room's text has its name" shows "Deep office" df "$deep"
check "and says what was assumed" grep -q "sill 0.80 m" "$scratch/out"
check "and has a row for the average" grep -q "^  average" "$scratch/out"
check "and one for each of its 17 points" \
    test "$(grep -cE '^ +[0-9]+\.[05]0 ' "$scratch/out")" -eq 17
check "and is tidy in 80 columns" nothing "$(untidy)"
gives df --methods all "$deep" >/dev/null
check "all methods fit in 80 columns too" nothing "$(too_wide)"

for example in "$examples"/*.xml; do
    check "$(basename "$example") is computed by all methods" \
        gives df --methods all "$example"
    check "$(basename "$example") holds no nan" \
        nothing "$(grep -inE '(^|[^a-z])-?(nan|inf)([^a-z]|$)' "$scratch/out")"
done

check "points from the command line replace the file's" \
    gives df --points "1.5,1 1.5,2.25" -p 1,3,0.5 --format csv "$deep"
check "and are all there" test "$(grep -c ',point,' "$scratch/out")" -eq \
    $((3 * $(grep -c '^[^,]*,[^,]*,point,1.5,1,' "$scratch/out")))
check "one with its own height" grep -q ',point,1,3,0.5,' "$scratch/out"
check "a sum is set out step by step" shows "a square of the diagram is worth" \
    df --explain --points 1.5,1 --methods waldram+bre "$deep"
cp "$scratch/out" "$scratch/explained"
check "in 80 columns" nothing "$(too_wide)"
check "in JSON too" shows '"unit": "%"' \
    df --explain --points 1.5,1 --methods waldram+bre --format json "$deep"
check "of one point, not of 17" refuses 2 "--points" df --explain "$deep"
check "not in CSV" refuses 2 "CSV" df --explain --points 1.5,1 --format csv "$deep"
check "its formulae stand on lines of their own" grep -q '^      SC = sc M G B$' "$scratch/explained"
check "what the figures contain is said" grep -q 'its figures contain clear single glass' "$scratch/explained"
check "lux stand beside per cent" shows "lux, of 5000 outside" \
    df --external 5000 --points 1.5,2 "$deep"
check "3.114 % of 5000 lx is 156 lx" grep -qE '^  average .* 156$' "$scratch/out"
check "in JSON too" shows '"lux": 155.69' df --external 5000 --format json "$deep"
check "and in CSV as one more field" shows ',155.69' df --external 5000 --format csv "$deep"
check "on every line" nothing "$(grep -v '"' "$scratch/out" | awk -F, 'NF != 16')"
for wrong in 0 -5000 5e9 nan 5klx ""; do
    check "an external illuminance of \"$wrong\" is refused" refuses 2 "--external" \
        df --external "$wrong" "$deep"
done
check "where no method answers, one is named that does" \
    shows "--methods exact+split-flux" df "$examples/studio.xml"
check "but not where one does" nothing \
    "$("$pepperpot" df "$deep" | grep "split-flux")"
check "another sky than the file's" shows "uniform" df --sky uniform "$deep"
check "a sky with a sun" shows "type 12, sun 30 deg high, bearing 180" \
    df --sky iso-12,30,180 --methods exact "$deep"
check "one room of a building" shows "Kitchen" df --room Kitchen "$examples/building.xml"
check "and no other" nothing "$(grep Bedroom "$scratch/out")"
check "several files" shows "l-shaped.xml" df "$deep" "$examples/l-shaped.xml"

# Corrections: what is assumed stands under the title, what is not counted below.
cat >"$scratch/corrected.xml" <<EOF
<room version="1"><site surroundings="urban" work="dirty"/>
  <plan width="4" depth="5" height="2.8"/><finishes decorations="auto"/>
  <window wall="south" left="0.9" sill="0.8" width="2.2" height="1.5"
          frame-factor="metal" maintenance="auto" curtains="white-thin"/>
  <point x="1.7" y="2.1"/></room>
EOF
check "dirt by work, a frame and curtains by name" \
    shows "frame factor 0.825" df -m bre,bre-min,average-df "$scratch/corrected.xml"
check "are all assumed" grep -q "maintenance 0.7," "$scratch/out"
check "curtains too" grep -q "curtains 0.9" "$scratch/out"
check "and decorations" grep -q "decorations leave 0.6 of" "$scratch/out"
check "which the average daylight factor does not count" \
    grep -q "average-df: the decorations' 0.6" "$scratch/out"
check "a minimum is no average" grep -q "bre-min: it gives the least" "$scratch/out"
check "in 80 columns" nothing "$(too_wide)"
check "each is in the sum" shows "IRC = irc M G K D" \
    df -e -m bre "$scratch/corrected.xml"

# CSV: the same number of fields everywhere, lines that end as RFC 4180 says.
check "CSV has 15 fields a line" gives df --format csv --methods all "$deep"
check "on every line without quotes" \
    nothing "$(grep -v '"' "$scratch/out" | awk -F, 'NF != 15')"
check "and ends lines with CR LF" \
    test "$(tr -dc '\r' <"$scratch/out" | wc -c)" -eq "$(wc -l <"$scratch/out")"

# The simulation: bytes do not depend on threads; the clock is marked.
check "1, 2 and 4 threads give the same bytes" same_by_threads "1 2 4" \
    df --simulate --samples 16 --format json "$deep"
"$pepperpot" df --simulate --samples 16 --seed 2 --format json "$deep" >"$scratch/seed"
check "another seed gives other bytes" \
    sh -c "! cmp -s '$scratch/seed' '$scratch/by_threads'"
check "the traced value stands beside the methods" \
    shows "from traced, %" df --simulate --error 5% "$deep"
check "--time stops" shows "stopped by the clock" df -s --time 300ms "$deep"
check "no progress bar but on a terminal" nothing "$(cat "$scratch/err")"

if script -qec true /dev/null >/dev/null 2>&1 </dev/null; then
    # seen WORDS: what a terminal shows of a run of a second.
    seen() {
        script -qec "'$pepperpot' df $* --simulate --time 1s '$deep' >/dev/null" \
            /dev/null </dev/null
    }
    seen >"$scratch/bar"
    check "on a terminal there is one, with the error and the time left" \
        grep -q 'error .* left' "$scratch/bar"
    seen --quiet >"$scratch/bar"
    check "but not with --quiet" nothing "$(cat "$scratch/bar")"
else
    skip "on a terminal there is one" "there is no script(1) to make one"
fi
tap_done
