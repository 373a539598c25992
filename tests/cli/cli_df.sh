#!/bin/sh
# df: its results and layout; test_df_json tests its JSON.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

check "a room's text has its name" shows "Deep office" df "$deep"
check "and says what was assumed" grep -q "sill 0.80 m" "$scratch/out"
check "and has a row for the average" grep -q "^  average" "$scratch/out"
run df --no-bands "$deep"
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
check "a sum is set out step by step" shows "value of one square" \
    df --explain --points 1.5,1 --methods waldram+bre "$deep"
cp "$scratch/out" "$scratch/explained"
check "in 80 columns" nothing "$(too_wide)"
check "in JSON too" shows '"unit": "%"' \
    df --explain --points 1.5,1 --methods waldram+bre --format json "$deep"
check "of one point, not of 17" refuses 2 "--points" df --explain "$deep"
cat >"$scratch/french.xml" <<EOF
<room version="1"><plan width="4" depth="5" height="2.6"/><finishes floor="0.15"/>
<window wall="south" left="0.5" sill="0.1" width="3" height="2.3"/><point x="2" y="2"/></room>
EOF
check "glass below the working plane counts by way of the floor: 3 (1.55 + 0.15 * 0.75)" \
    shows "4.987" df --explain --methods average-df "$scratch/french.xml"
check "by a formula that says so" grep -q "W = (a_u + [^ ]*_f a_l) B" "$scratch/out"
check "sloping rooflights have an average daylight factor" shows "180 - beta" \
    df --explain --methods average-df --points 2,2 --format json "$examples/studio.xml"
check "not in CSV" refuses 2 "CSV" df --explain --points 1.5,1 --format csv "$deep"
check "its formulae stand on lines of their own" grep -q '^      SC = sc M G B$' "$scratch/explained"
check "what the figures contain is said" grep -q 'published figures \[[A-Z0-9]*\]: clear single glass' "$scratch/explained"
check "lux stand beside per cent" shows "lux, for 5000 outside" \
    df --external 5000 --points 1.5,2 "$deep"
check "3.031 % of 5000 lx is 152 lx" grep -qE "^  average .* 152$" "$scratch/out"
check "in JSON too" shows '"lux": 151.54' df --external 5000 --format json "$deep"
check "and in CSV as one more field" shows ',151.54' df --external 5000 --format csv "$deep"
check "on every line" nothing "$(grep -v '"' "$scratch/out" | awk -F, 'NF != 16')"
for wrong in 0 -5000 5e9 nan 5klx ""; do
    check "an external illuminance of \"$wrong\" is refused" refuses 2 "--external" \
        df --external "$wrong" "$deep"
done
check "the plane is summed up" shows "plane at the 30 points" df "$deep"
check "its uniformity has four digits" grep -qE '^  exact\+bre .* 0\.2928 ' "$scratch/out"
check "a grid lies like the plan" shows "    0.94 |" df "$examples/office.xml"
check "an array of one room" shows '[' df --array -f json "$deep"
check "is of JSON" refuses 2 "json" df --array "$deep"
check "if bre does not cover the room, exact+split-flux replaces it" \
    shows "exact+split-flux replaces exact+bre" df "$examples/studio.xml"
check "with figures" grep -qE '^ +1.57 .* 12.56( |$)' "$scratch/out"
check "and no columns of dashes" nothing "$(grep -- ' - .* - ' "$scratch/out")"
check "in JSON the others say why, and it has values" \
    shows '"stand-in": "exact+split-flux replaces' df -f json "$examples/studio.xml"
check "what is asked for by name is what is shown" nothing \
    "$("$pepperpot" df -m exact+bre "$examples/studio.xml" | grep split-flux | grep -v "for other skies")"
check "where no method answers, one is named that does" \
    shows "exact+split-flux for other skies" df --methods exact+bre "$examples/studio.xml"
check "but not where one does" nothing \
    "$("$pepperpot" df "$deep" | grep "split-flux")"
check "the largest error that can be asked for" shows "traced" \
    df --simulate --error 100% --points 1.5,4.5 "$deep"
check "another sky than the file's" shows "uniform" df --sky uniform "$deep"
check "a sky with a sun" shows "type 12, sun 30 deg high, bearing 180" \
    df --sky iso-12,30,180 --methods exact "$deep"
check "one room of a building" shows "Kitchen" df --room Kitchen "$examples/building.xml"
check "and no other" nothing "$(grep Bedroom "$scratch/out")"
# Warnings that hand figures are unreliable.
check "a method with another ground is named" \
    shows "bre, average-df: assumed ground reflectance" df --methods exact+bre,average-df "$deep"
sed 's/ground-reflectance="0.2"//; s/<site /<site ground-reflectance="0.1" /' "$deep" \
    >"$scratch/dark-ground.xml"
check "where the room's is another" nothing \
    "$("$pepperpot" df "$scratch/dark-ground.xml" | grep "assumed ground reflectance")"
check "and not of a method that takes the room's" nothing \
    "$("$pepperpot" df -m exact+split-flux "$deep" | grep "assumed ground reflectance")"
check "snow is far from the ground of the BRE formula" sh -c "
    sed 's/<site /<site ground-reflectance=\"0.8\" /; s/ground-reflectance=\"0.2\"//2' '$scratch/dark-ground.xml' |
    sed 's/ground-reflectance=\"0.1\"//' | '$pepperpot' df - | tr -s '\\n ' ' ' | grep -q 'the ground reflectance is 0.8'"
check "a bright room under open sky is relied on" nothing \
    "$("$pepperpot" df "$examples/studio.xml" -m exact+split-flux | grep "relied on")"
cat >"$scratch/shaft.xml" <<EOF
<room version="1"><plan width="3" depth="3.6" height="2.5"/>
<window wall="south" left="0.9" sill="0.95" width="1.2" height="1.2"/>
<block x="-3" y="-5" width="9" depth="1" height="11" reflectance="0.7"/>
<block x="-1" y="-4" width="1" depth="4" height="11" reflectance="0.7"/>
<block x="3" y="-4" width="1" depth="4" height="11" reflectance="0.7"/></room>
EOF
check "most of a shaft's light is reflected outside" \
    shows "Do not rely on hand figures" df "$scratch/shaft.xml"
check "in JSON too" shows '"kind": "outside"' df --format json "$scratch/shaft.xml"
check "assess says so by hand" shows "Do not rely on hand figures" assess --by-hand "$scratch/shaft.xml"
check "and size" shows "Do not rely on hand figures" size --by-hand -t 1 "$scratch/shaft.xml"
check "a table that ends at twice the width is named" shows "\"kind\": \"proportions\"" \
    df --methods exact+bre-min --format json "$deep"
check "several files" shows "l-shaped.xml" df "$deep" "$examples/l-shaped.xml"

# Corrections: the assumptions are below the title, losses that are not counted at the end.
cat >"$scratch/corrected.xml" <<EOF
<room version="1"><site surroundings="urban" work="dirty"/>
  <plan width="4" depth="5" height="2.8"/><finishes decorations="auto"/>
  <window wall="south" left="0.9" sill="0.8" width="2.2" height="1.5"
          frame-factor="metal" maintenance="auto" curtains="white-thin"/>
  <point x="1.7" y="2.1"/></room>
EOF
check "dirt by work, a frame and curtains by name" \
    shows "frame factor 0.825" df -m bre,bre-min,average-df "$scratch/corrected.xml"
# on_one_line: the output with line breaks replaced by blanks.
on_one_line() {
    tr -s '\n ' ' ' <"$scratch/out"
}
assumed() {
    on_one_line | grep -q "$1"
}
check "are all assumed" assumed "maintenance 0.7 (BRE309), curtains"
check "curtains too" assumed "curtains transmit 0.9"
check "and decorations" assumed "reflected light multiplied by 0.6 for deterioration of decorations"
check "which the average daylight factor does not count" \
    assumed "average-df: the factor for deterioration of decorations (0.6)"
check "a minimum is no average" grep -q "bre-min: the method gives the minimum" "$scratch/out"
check "in 80 columns" nothing "$(too_wide)"
check "each is in the sum" shows "IRC = irc M G K D" \
    df -e -m bre "$scratch/corrected.xml"
edition() {
    run df "$scratch/cleaner.xml"
    assumed "maintenance 0.92 (BS8206)"
}
sed 's/work="dirty"/dirt="bs-8206"/' "$scratch/corrected.xml" >"$scratch/cleaner.xml"
check "by the later edition there is less dirt, and it is named" \
    edition
sed 's/<site /<site dirt="bs-8206" /' "$scratch/corrected.xml" >"$scratch/unknown.xml"
check "which has no figures for dirty work" \
    refuses 1 "has no figures for industrial surroundings or dirty work" \
    df "$scratch/unknown.xml"

# CSV: the same number of fields in every line, and line ends as in RFC 4180.
check "CSV has 15 fields a line" gives df --format csv --methods all "$deep"
check "on every line without quotes" \
    nothing "$(grep -v '"' "$scratch/out" | awk -F, 'NF != 15')"
check "and ends lines with CR LF" \
    test "$(tr -dc '\r' <"$scratch/out" | wc -c)" -eq "$(wc -l <"$scratch/out")"

# Simulation: the output does not depend on the number of threads; results limited by time are
# marked.
check "1, 2 and 4 threads give the same bytes" same_by_threads "1 2 4" \
    df --simulate --samples 16 --format json "$deep"
"$pepperpot" df --simulate --samples 16 --seed 2 --format json "$deep" >"$scratch/seed"
check "another seed gives other bytes" \
    sh -c "! cmp -s '$scratch/seed' '$scratch/by_threads'"
# The mean inside a margin of 0.5 m equals that of a fine grid, for the sky component and the
# simulation.
cat >"$scratch/margin.xml" <<'EOF'
<room version="1"><plan width="3" depth="4" height="2.7"/>
  <window wall="south" left="0.4" sill="1" width="2.2" height="1.4"/>
  <grid spacing="0.1" margin="0.5"/></room>
EOF
# mean PLACE COMPONENT METHOD: mean over the lines of a CSV.
mean() {
    awk -F, -v place="$1" -v component="$2" -v method="$3" '
        $3 == place && $10 == component && $11 == method { sum += $12; n++ }
        END { print sum / n }' "$scratch/out"
}
run df --margin -m exact+bre --format csv "$scratch/margin.xml"
check "the average inside the margin is that of a fine grid there" awk \
    -v a="$(mean average-margin sc exact)" -v b="$(mean point sc exact)" \
    'BEGIN { exit !(a > 0.1 && a / b < 1.005 && a / b > 0.995) }'
check "and another than that of the whole plane" awk \
    -v a="$(mean average-margin sc exact)" -v b="$(mean average sc exact)" \
    'BEGIN { exit !(a > 1.01 * b) }'
run df --margin -m exact+bre --simulate --error 1% --format csv "$scratch/margin.xml"
check "traced it is the same" awk \
    -v a="$(mean average-margin sc exact)" -v b="$(mean average-margin sc traced)" \
    'BEGIN { exit !(b > 0.1 && a / b < 1.03 && a / b > 0.97) }'
check "in JSON it stands beside the average" shows '"average-margin": {' \
    df --margin --format json "$deep"
check "in text below the table" shows "plane 0.5 m or more from the walls" df --margin "$deep"
sed 's/width="3"/width="0.9"/; s/left="0.4"/left="0.1"/; s/width="2.2"/width="0.7"/; s/<grid.*\/>/<point x="0.4" y="2"\/>/' \
    "$scratch/margin.xml" >"$scratch/narrow.xml"
check "a room less than a metre wide has nothing there" shows "no part of the working plane is 0.5 m" \
    df --margin --format csv "$scratch/narrow.xml"

check "the traced value stands beside the methods" \
    shows "from traced, %" df --simulate --error 5% "$deep"
check "--time stops" shows "stopped at the --time limit" df -s --time 300ms "$deep"
check "no progress bar but on a terminal" nothing "$(cat "$scratch/err")"

if script -qec true /dev/null >/dev/null 2>&1 </dev/null; then
    # seen WORDS: the output on a terminal during a run of a second.
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

# Behind a block that touches its window a room is dark; ratios with a denominator of zero have no
# value.
cat >"$scratch/closed.xml" <<EOF
<room version="1"><plan width="4" depth="5" height="3"/>
<window wall="south" left="1" sill="1" width="2" height="1.5"/>
<block x="-1" y="-3" width="6" depth="3" height="8"/><point x="2" y="2"/></room>
EOF
check "a dark plane has no uniformity" sh -c "
    '$pepperpot' df -m exact --simulate --samples 4 '$scratch/closed.xml' |
        grep -E '^  traced .* -  +0%  +0%  +0%$'"

# Sunlight scattered by a blind in a black room: the integral of btdf times the sun's illuminance
# over the window is 169.2 lx.
cat >"$scratch/blind.xml" <<EOF
<room version="1"><site ground="open" ground-reflectance="0"/>
<plan width="4" depth="5" height="2.8"/><finishes floor="0" walls="0" ceiling="0"/>
<window wall="south" left="0.9" sill="0.8" width="2.2" height="1.5" glazing="none">
<blind slat-width="0.018" spacing="0.015" angle="-45" reflectance="0.6"/></window>
<point x="2" y="2"/></room>
EOF
check "a blind scatters sunlight into the room" sh -c "
    '$pepperpot' df -q --samples 64 --sky perez,700,150,40,160 --format csv \\
        '$scratch/blind.xml' | awk -F, 'END { exit !(\$11 > 168 && \$11 < 170) }'"
tap_done
