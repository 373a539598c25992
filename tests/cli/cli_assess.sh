#!/bin/sh
# assess: its layout, options and refusals; test_assess_examples recomputes its verdicts.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
LC_ALL=C
export LC_ALL

for example in "$examples"/*.xml; do
    name=$(basename "$example")
    check "$name is assessed" gives assess "$example"
    check "$name is tidy in 80 columns" nothing "$(untidy)"
done
check "simulated, with illuminances, too" \
    gives assess --simulate --error 4% --external 5000 "$examples/building.xml"
check "it fits in 80 columns" nothing "$(too_wide)"
check "a room of a building each has its sum of verdicts" \
    test "$(grep -cE '^  [0-9]+ met' "$scratch/out")" -eq 4
check "a verdict has its probability" grep -q "met: certain" "$scratch/out"
check "illuminances stand beside" grep -qE "% +[0-9]+ lx +>=" "$scratch/out"
check "the median outside is named" grep -q "13900 lx: Berlin" "$scratch/out"

check "in UTF-8 it fits too" sh -c "
    LC_ALL=C.UTF-8 '$pepperpot' assess -s --error 4% --external 5000 '$deep' |
        grep -vF '$examples/' | LC_ALL=C.UTF-8 sed -n '/^.\{81\}/p' |
        grep -c . | grep -qx 0"

check "verdicts do not make the status" shows "not met" assess "$deep"
check "without simulation it says so" \
    grep -q "by exact+bre, not simulated" "$scratch/out"
check "standard input is a room" sh -c \
    "'$pepperpot' assess - <'$deep' | grep -q '(standard input)'"
check "one criterion by itself" shows "Limiting depth" assess -c limiting-depth "$deep"
check "is by itself" nothing "$(grep -i 'glazing over floor' "$scratch/out")"
check "one room of a building" shows "Kitchen" \
    assess --room Kitchen "$examples/building.xml"
check "and no other" nothing "$(grep Bedroom "$scratch/out")"
check "another capital" shows "12100 lx" assess --place stockholm "$deep"
check "an illuminance of one's own" shows "9999 lx: as given" \
    assess --median-diffuse 9999 "$deep"
"$pepperpot" assess --format json "$deep" -o "$scratch/out.json"
check "a file instead of standard output" \
    grep -q '"format": "pepperpot-assess-1"' "$scratch/out.json"
check "3 threads give the same bytes as 1" same_by_threads "1 3" \
    assess --simulate --samples 16 --format json "$deep"
interrupted assess --simulate --error 0.01% -c average,uniformity --format json "$deep"
check "an interrupted run says so" sh -c "
    grep -q '\"finished\": false' '$scratch/out' && grep -q interrupted '$scratch/err'"
check "and has what there is" grep -q '"se"' "$scratch/out"
check "--time stops" shows "stopped by the clock" assess -s --time 200ms "$deep"

# The room before: the obstructed office is the deep one with a building opposite.
blocked=$examples/deep-office-obstructed.xml
check "the room before" shows "area lost" assess --before "$deep" "$blocked"
check "its windows are compared" grep -q "39.6 % before" "$scratch/out"
check "its area that sees sky too" grep -q "27.00 m2 before" "$scratch/out"
check "without it nothing is" nothing "$("$pepperpot" assess "$blocked" | grep -i before)"
check "nothing is lost to itself" shows "0.00" assess --before "$deep" "$deep"
check "a building's rooms are found by name" shows "area lost" \
    assess --before "$examples/building.xml" --room Study "$examples/building.xml"
check "another room is refused" refuses 1 "another shape" \
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
    shows "asked under an overcast sky" assess -c en17037 "$scratch/uniform-room.xml"
check "without a latitude EN 17037 is not judged" \
    shows "gives no latitude" assess "$scratch/nowhere-room.xml"
check "but the rest is" grep -q "^  No-sky line" "$scratch/out"

check "a room is needed" refuses 2 "expected a room file" assess
check "a criterion by its name" refuses 2 "did you mean en17037?" \
    assess --criteria en17073 "$deep"
check "nothing is not a criterion" refuses 2 "there is no criterion" \
    assess --criteria "uniformity," "$deep"
check "and not without the room it needs" refuses 2 "needs --before" \
    assess --criteria former-sky "$deep"
check "a capital by its name" refuses 2 "did you mean London?" assess --place Lodnon "$deep"
check "or one of those there are" refuses 2 "Nicosia" assess --place Atlantis "$deep"
check "one place only" refuses 2 "two ways" \
    assess --place London --median-diffuse 9000 "$deep"
for lux in 0 -5 1e9 bright nan; do
    check "no illuminance of $lux" refuses 2 "1 to 200000 lx" assess --external=$lux "$deep"
    check "no median of $lux" refuses 2 "1 to 200000 lx" \
        assess --median-diffuse=$lux "$deep"
done
check "--error needs a simulation" refuses 2 "--simulate" assess --error 1% "$deep"
check "criteria that judge by no daylight factor have none simulated" gives \
    assess --simulate --criteria glazing-ratio,vertical-sky "$deep"
check "and say nothing of it" nothing "$(grep simulation "$scratch/out")"
check "no CSV" refuses 2 "text or json" assess --format csv "$deep"
check "the help has every criterion" sh -c "
    '$pepperpot' assess --help | grep -qE '^  rights-of-light '"
tap_done
