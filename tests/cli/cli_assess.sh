#!/bin/sh
# assess: its layout, options and rejected input; test_assess_examples recalculates its verdicts.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
LC_ALL=C
export LC_ALL

for example in "$examples"/*.xml; do
    name=$(basename "$example")
    check "$name is assessed" gives assess --by-hand "$example"
    check "$name is tidy in 80 columns" nothing "$(untidy)"
done
check "simulated, with illuminances, too" \
    gives assess --simulate --error 4% --spacing largest --external 5000 "$examples/building.xml"
check "it fits in 80 columns" nothing "$(too_wide)"
check "a room of a building each has its sum of verdicts" \
    test "$(grep -cE '^  [0-9]+ met' "$scratch/out")" -eq 4
check "a verdict has its probability" grep -q "met: certain" "$scratch/out"
check "illuminances stand beside" grep -qE "% +[0-9]+ lx +>=" "$scratch/out"
check "the median outside is named" sh -c "
    tr -s ' \\n' ' ' <'$scratch/out' | grep -q '13900 lx: Berlin'"

check "a grid of too many points is refused in words" shows "more than 20000 points" \
    assess --by-hand -c en17037 --median-diffuse 14000 --spacing 0.02 "$examples/office.xml"

check "in UTF-8 it fits too" sh -c "
    LC_ALL=C.UTF-8 '$pepperpot' assess -s --error 4% --spacing largest --external 5000 '$deep' |
        grep -vF '$examples/' | LC_ALL=C.UTF-8 sed -n '/^.\{81\}/p' |
        grep -c . | grep -qx 0"

check "verdicts do not make the status" shows "not met" assess --error 4% --spacing largest "$deep"
check "it simulates unless told otherwise" grep -q "^  Simulated figures" "$scratch/out"
cp "$scratch/out" "$scratch/simulated"
check "--simulate says the same" sh -c "
    '$pepperpot' assess --simulate --error 4% --spacing largest '$deep' | cmp - '$scratch/simulated'"
check "by hand it says so" shows "by exact+bre, not simulated" assess --by-hand "$deep"
check "100 lx over 95 % is met by hand" \
    grep -qE "100 lx over.* +met\$" "$scratch/out"
check "and is not by simulation" grep -qE "minimum: 100 lx.* (not met|undecided): " "$scratch/simulated"
check "--by-hand and --simulate do not go together" refuses 2 "--by-hand" \
    assess --by-hand --simulate "$deep"
check "nor --by-hand and what ends a simulation" refuses 2 "--time" \
    assess --by-hand --time 1s "$deep"
check "standard input is a room" sh -c \
    "'$pepperpot' assess --by-hand - <'$deep' | grep -q '(standard input)'"
check "one criterion by itself" shows "Limiting depth" assess -c limiting-depth "$deep"
check "is by itself" nothing "$(grep -i 'glazing over floor' "$scratch/out")"
check "one room of a building" shows "Kitchen" \
    assess --by-hand --room Kitchen "$examples/building.xml"
check "and no other" nothing "$(grep Bedroom "$scratch/out")"
check "criteria have their short names too" shows "Vertical sky component" \
    assess --by-hand -c vsc,nsl,adf "$deep"
check "one of which is the no-sky line" grep -q "^  No-sky line" "$scratch/out"
check "and one the average" grep -q "^  Average daylight factor" "$scratch/out"
check "of a name that is none they are told" refuses 2 'no criterion "vsk"' assess -c vsk "$deep"
# A skyline of 26 degrees leaves a vertical sky component of 26.7 %, less than 27 %.
cat >"$scratch/near.xml" <<EOF
<room version="1"><plan width="3" depth="4" height="2.5"/>
<window wall="south" left="1" sill="0.9" width="1.2" height="1.2"/>
<skyline wall="south" angle="26"/></room>
EOF
check "an obstruction of more than 25 degrees is no failure" \
    shows "only a first check" assess -c obstruction,vsc "$scratch/near.xml"
check "nor is it counted" grep -qx "  1 not met" "$scratch/out"
check "nor by itself" shows "no verdicts" assess -c obstruction "$scratch/near.xml"
sed 's/<plan/<site country="UK"\/><plan/' "$scratch/near.xml" >"$scratch/uk.xml"
check "UK is no country code" refuses 1 'did you mean "GB"' assess --by-hand "$scratch/uk.xml"
for altitude in 0 -3 50 high; do
    check "no least altitude of $altitude" refuses 2 "above 0 and up to 45 degrees" \
        assess --least-altitude=$altitude "$deep"
done
check "the sun's least altitude" shows "hours with the sun above 11 degrees" \
    assess --by-hand -c sun-exposure --least-altitude 11 "$deep"
check "where the table is not known a south window meets it all the same" \
    shows "with the sun above 20 degrees" assess --by-hand -c sun-exposure "$deep"
check "in JSON it says which decides" shows '"decided_by": "vertical-sky"' \
    assess -c obstruction --format json "$scratch/near.xml"
check "another capital" shows "12100 lx" assess --by-hand --place stockholm "$deep"
sed 's/<site /<site country="IT" /' "$deep" >"$scratch/italy.xml"
check "a nation's capital" shows "19200 lx: Rome" \
    assess --by-hand "$scratch/italy.xml"
check "without a country the nearest, with a warning" sh -c "
    '$pepperpot' assess --by-hand '$deep' | tr -s ' \n' ' ' | grep -q 'site has no country'"
sed 's/<site /<site country="it" /' "$deep" >"$scratch/small.xml"
check "a country in small letters is refused" refuses 1 "expected two capital letters" \
    assess "$scratch/small.xml"
check "an illuminance of one's own" shows "9999 lx: as given" \
    assess --by-hand --median-diffuse 9999 "$deep"
"$pepperpot" assess --by-hand --format json "$deep" -o "$scratch/out.json"
check "a file instead of standard output" \
    grep -q '"format": "pepperpot-assess-1"' "$scratch/out.json"
check "3 threads give the same bytes as 1 by hand" same_by_threads "1 3" \
    assess --by-hand -c view-out --format json "$deep"
check "3 threads give the same bytes as 1" same_by_threads "1 3" \
    assess --simulate --spacing largest --samples 16 --format json "$deep"
interrupted assess --simulate --error 0.01% -c average,uniformity --format json "$deep"
check "an interrupted run says so" sh -c "
    grep -q '\"finished\": false' '$scratch/out' && grep -q interrupted '$scratch/err'"
check "and has what there is" grep -q '"se"' "$scratch/out"
check "--time stops" shows "stopped at the --time limit" assess -s --spacing largest --time 200ms "$deep"

# The previous state: the obstructed office is the deep office with a building opposite.
blocked=$examples/deep-office-obstructed.xml
check "the room before" shows "area lost" assess --by-hand --before "$deep" "$blocked"
check "its windows are compared" grep -q "39.6 % before" "$scratch/out"
check "its area that sees sky too" grep -q "27.00 m2 before" "$scratch/out"
check "without it nothing is" nothing "$("$pepperpot" assess --by-hand "$blocked" | grep -i before)"
check "nothing is lost to itself" shows "0.00" assess --by-hand --before "$deep" "$deep"
check "a building's rooms are found by name" shows "area lost" \
    assess --by-hand --before "$examples/building.xml" --room Study "$examples/building.xml"
check "another room is refused" refuses 1 "a different shape" \
    assess --before "$examples/office.xml" "$deep"
check "with its name" grep -q "office.xml: " "$scratch/err"
check "a room that is not in the building too" refuses 1 'no room named "Deep office"' \
    assess --before "$examples/building.xml" "$deep"
check "and a file that is not there" refuses 1 "nowhere.xml" \
    assess --before "$scratch/nowhere.xml" "$deep"
check "standard input is one file" refuses 2 "standard input" \
    assess --before - - <"$deep"

sed 's/latitude="51.5" longitude="-0.1"//' "$deep" >"$scratch/nowhere-room.xml"
sed 's/<plan /<sky type="uniform"\/><plan /' "$scratch/nowhere-room.xml" > "$scratch/uniform-room.xml"
check "under another sky that is the reason, which no place can help" \
    shows "criterion is for an overcast sky" assess -c en17037 "$scratch/uniform-room.xml"
check "without a latitude EN 17037 is not judged" \
    shows "has no latitude" assess --by-hand "$scratch/nowhere-room.xml"
check "but the rest is" grep -q "^  No-sky line" "$scratch/out"

check "withdrawn standards are not assessed by default" sh -c "
    '$pepperpot' assess --by-hand '$deep' | grep -q BREEAM && exit 1; true"
check "but with --withdrawn, marked" shows "Uniformity  [BREEAM14]  (withdrawn)" \
    assess --by-hand --withdrawn "$deep"
check "or by name" shows "replaced it" assess --by-hand -c average "$deep"
check "JSON has the reason" shows '"withdrawn": "later versions of BREEAM' \
    assess --by-hand -c uniformity -f json "$deep"
check "no other standard is marked" nothing \
    "$("$pepperpot" assess --by-hand -f json "$deep" | grep withdrawn)"

check "a room is needed" refuses 2 "expected a room file" assess
check "a criterion by its name" refuses 2 "did you mean en17037?" \
    assess --criteria en17073 "$deep"
check "nothing is not a criterion" refuses 2 "there is no criterion" \
    assess --criteria "uniformity," "$deep"
check "and not without the room it needs" refuses 2 "expected --before" \
    assess --criteria former-sky "$deep"
check "a capital by its name" refuses 2 "did you mean London?" assess --place Lodnon "$deep"
check "or one of those there are" refuses 2 "Nicosia" assess --place Atlantis "$deep"
check "one place only" refuses 2 "both set the median" \
    assess --place London --median-diffuse 9000 "$deep"
for lux in 0 -5 1e9 bright nan; do
    check "no illuminance of $lux" refuses 2 "1 to 200000 lx" assess --external=$lux "$deep"
    check "no median of $lux" refuses 2 "1 to 200000 lx" \
        assess --median-diffuse=$lux "$deep"
done
check "criteria that judge by no daylight factor have none simulated" gives \
    assess --simulate --criteria glazing-ratio,vertical-sky "$deep"
check "and say nothing of it" nothing "$(grep simulation "$scratch/out")"
# A flat in a street, in a file without the rest of its house: in a wall that continues around its
# window it has half as much light, and no verdict that depends on this is certain.
flat() {
    cat <<EOF
<room version="1"><site latitude="51.5" longitude="-0.1" ground-level="-0.5"/>
  <plan width="4" depth="5" height="2.7"/><finishes floor="0.3" walls="0.7" ceiling="0.85"/>
  <window wall="south" left="0.85" sill="0.8" width="2.3" height="1.5" glazing="clear-double"
    frame-factor="0.8" maintenance="0.8"/>$1
  <block x="-60" y="-22" width="124" depth="12" height="18" reflectance="0.3"/></room>
EOF
}
flat "" > "$scratch/alone.xml"
flat '<facade wall="south" left="30" right="30" up="15" down="0.5"/>' > "$scratch/house.xml"
flat '<facade wall="south"/>' > "$scratch/hut.xml"
# verdict FILE: the line of the bedroom in uk-annex, and the lines below it.
verdict() {
    "$pepperpot" assess -q --error 2% -c uk-annex "$scratch/$1" | grep -A 3 'bedroom: 100 lx'
}
turns() {
    verdict alone.xml > "$scratch/alone"
    grep -q ' met$' "$scratch/alone" && grep -q 'the value would be' "$scratch/alone" &&
        grep -q '(not met)' "$scratch/alone"
}
check "a verdict that the house beside the room would turn is not certain" turns
check "with the house in the file it is known" sh -c "
    '$pepperpot' assess -q --error 2% -c uk-annex '$scratch/house.xml' > '$scratch/house'
    grep 'bedroom: 100 lx' '$scratch/house' | grep -q 'not met: certain' &&
    ! grep -q 'the value would be' '$scratch/house'"
check "and where the file says that there is none" sh -c "
    '$pepperpot' assess -q --error 2% -c uk-annex '$scratch/hut.xml' > '$scratch/hut'
    grep 'bedroom: 100 lx' '$scratch/hut' | grep -qE ' met: (certain|99)' &&
    ! grep -q 'the value would be' '$scratch/hut'"
check "in JSON it has no confidence, and a note" sh -c "
    '$pepperpot' assess -q --error 2% -c uk-annex --format json '$scratch/alone.xml' |
    grep 'bedroom: 100 lx' | grep 'if the window walls were larger' | grep -vq confidence"
# An overhang hides sky whatever is opposite: without the overhang the window has the sky of the
# same wall without one.
cat >"$scratch/plain.xml" <<'END'
<room version="1" name="plain"><plan width="4" depth="5" height="2.7"/>
<window wall="south" left="1" sill="0.9" width="2" height="1.4">
</window><block x="-6" y="-14" width="16" depth="4" height="9"/></room>
END
sed 's|^</window>|<overhang depth="1.5" left="1" right="1"/></window>|' "$scratch/plain.xml" >"$scratch/over.xml"
vsc() {
    "$pepperpot" assess -c vsc --by-hand "$1" | grep -o '[0-9.]* % *[^ ]* 27' | sed 's/ .*//'
}
bare=$(vsc "$scratch/plain.xml")
check "a window under an overhang has less sky" \
    sh -c "awk 'BEGIN { exit !($(vsc "$scratch/over.xml") < $bare - 5) }'"
check "what it has without it is said, too" \
    shows "$(printf %.1f "$bare") % without the overhangs" assess -c vsc --by-hand "$scratch/over.xml"
sed 's/height="9"/height="2"/' "$scratch/over.xml" >"$scratch/over_before.xml"
check "and the share of before" shows " without the overhangs and balconies" \
    assess -c former-sky --by-hand --before "$scratch/over_before.xml" "$scratch/over.xml"

# average-df gives 1.71 % for the Bedroom of the flat; the target is 2 % and the simulated value
# 2.66 %. The likely range begins above 2 %.
check "an average that is not met, with its bound between it and the band, is open" sh -c "
    '$pepperpot' assess --by-hand -c average --room Bedroom '$examples/building.xml' |
    grep -A 5 'kitchen ' | tr -s ' \n' ' ' | grep -q 'hand figures cannot decide'"
check "its verdict is undecided, and counted as that" sh -c "
    '$pepperpot' assess --by-hand -c average --room Bedroom '$examples/building.xml' >'$scratch/open' &&
    grep -q 'kitchen .*undecided' '$scratch/open' && grep -q '1 undecided' '$scratch/open'"
check "but not where it is met" sh -c "
    '$pepperpot' assess --by-hand -c average --room Bedroom '$examples/building.xml' |
    grep -A 1 'bedroom ' | grep -vq 'cannot decide'"
check "as CSV a finding a line" \
    shows "Deep office,,,vertical-sky,\"W1, south\",10," \
    assess --by-hand -c vsc --format csv "$deep"
# A wall 4 m away and 6 m high, practically infinitely long: the tangent of its altitude is 4.4/4
# from 1.6 m, 4.95/4 from the middle of a French window of 2.1 m, 4.45/4 from that of the other
# window.
cat >"$scratch/french.xml" <<'EOF'
<room version="1"><plan width="4.3" depth="5.1" height="2.7"/>
<window wall="south" left="0.4" sill="0" width="1.5" height="2.1"/>
<window wall="south" left="2.6" sill="0.9" width="1.1" height="1.3"/>
<block x="-20000" y="-5" width="40000" depth="1" height="6"/></room>
EOF
# VSC = 3/(7 pi) times the sum of (1 + 2 sin z) cos2 z cos phi over the visible sky.
vsc_of() {
    awk -v tan="$1" 'BEGIN { pi = atan2(0, -1); n = 400
        for (i = 0; i < n; i++) for (k = 0; k < n; k++) {
            phi = (i + 0.5) / n * pi / 2; z = (k + 0.5) / n * pi / 2
            if (sin(z) / (cos(z) * cos(phi)) > tan)
                sum += (1 + 2 * sin(z)) * cos(z) ^ 2 * cos(phi) }
        printf "%.2f", 100 * 3 / (7 * pi) * 2 * sum * (pi / 2 / n) ^ 2 }'
}
components() {
    "$pepperpot" assess -q -c vsc -f csv "$@" "$scratch/french.xml" >"$scratch/french.csv"
    awk -F, 'FNR == 1 { for (i = 1; i <= NF; i++) if ($i ~ /^figure/) f = i; next }
        { printf "%.2f ", $(f + 1) }' "$scratch/french.csv"
}
near() {
    set -- $(components $3) "$1" "$2"
    echo "# $*"
    awk -v a="$1" -v b="$2" -v c="$3" -v d="$4" \
        'BEGIN { exit !(a - c < 0.05 && c - a < 0.05 && b - d < 0.05 && d - b < 0.05) }'
}
check "a French window is judged at its middle" near "$(vsc_of 1.2375)" "$(vsc_of 1.1125)"
check "or at the height asked for, and others at theirs" \
    near "$(vsc_of 1.1)" "$(vsc_of 1.1125)" "--vsc-point-french 1.6"
check "a height of 20 m is none" refuses 2 "a height from 0.1 to 10 m" \
    assess --vsc-point-french 20 "$scratch/french.xml"
# grid_says WORDS FILE [OPTION ...]: the output, on one line, contains the words. The daylight
# factor falls steeply from the only window, so a coarse grid leaves verdicts undecided.
grid_says() {
    words=$1 file=$2
    shift 2
    "$pepperpot" assess -q --by-hand -c en17037 "$@" "$file" | tr -s ' \n' ' ' >"$scratch/out"
    grep -qF "$words" "$scratch/out"
}
check "the grid is named in the verdict" \
    grid_says "a grid of 0.29 x 0.30 m (189 points, 0.5 m from the walls)" "$deep"
check "--spacing chooses it" \
    grid_says "a grid of 0.50 x 0.50 m (64 points, 0.5 m" "$deep" --spacing 0.5
check "and the margin" \
    grid_says "a grid of 0.50 x 0.50 m (85 points, 0.25 m" "$deep" --spacing 0.5,0.25
check "or the largest permitted" \
    grid_says "(30 points, 0.5 m from the walls, the largest permitted)" "$deep" --spacing largest
sed 's/<line .*/<grid spacing="0.4" margin="0.1"\/>/' "$deep" >"$scratch/own-grid.xml"
check "the file's spacing comes before the default one, its margin does not" \
    grid_says "a grid of 0.40 x 0.40 m (100 points, 0.5 m from" "$scratch/own-grid.xml"
check "JSON has the error that the grid makes" shows '"grid-error": ' \
    assess --by-hand -c en17037 --format json "$deep"
for spacing in 0 -1 0.3,x 0.3,0.5,1 20 largest,0.5; do
    check "no spacing of $spacing" refuses 2 "a spacing from 0.01 to 10 m" \
        assess --spacing=$spacing "$deep"
done
check "the help has every criterion" sh -c "
    '$pepperpot' assess --help | grep -qE '^  rights-of-light '"
tap_done
