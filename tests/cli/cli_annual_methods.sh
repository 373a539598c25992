#!/bin/sh
# Hand methods for the year compared with the simulation, their explanations, and wrong options.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# A year at Brussels: sun from 9 to 16 h, hazy in the morning and clear in the afternoon, with a
# cloud cover of 7 and 2 tenths; dark otherwise.
awk 'BEGIN {
    print "LOCATION,Brussels,-,BEL,made up,064510,50.90,4.53,1.0,58.0"
    print "HOLIDAYS/DAYLIGHT SAVINGS,No,3/26,10/28,0"
    print "DATA PERIODS,1,1,Data,Sunday,1/1,12/31"
    split("31 28 31 30 31 30 31 31 30 31 30 31", days, " ")
    for (m = 1; m <= 12; m++)
        for (d = 1; d <= days[m]; d++)
            for (h = 1; h <= 24; h++) {
                lit = h > 9 && h <= 16
                haze = lit && h <= 12
                printf "%d,%d,%d,%d,0,?,10,7.5,84,101000,0,0,315,%d,%d,%d,0,0,0,0,0,0,%d\n",
                    2001 + m % 2, m, d, h, lit ? 9999 : 0, lit ? (haze ? 60 : 500) : 0,
                    lit ? 150 : 0, haze ? 7 : 2
            }
}' >"$scratch/year.epw"
sed 's|</room>|<point x="1.5" y="1"/><point x="1.5" y="6"/></room>|; /<line/d; /<grid/d' \
    "$deep" >"$scratch/room.xml"
room=$scratch/room.xml
annual="annual -q -w $scratch/year.epw --samples 16"

check "all methods" shows "classes-scaled" $annual -m all "$room"
check "with their assumptions" shows "classes of this program" $annual -m all "$room"
check "one of them" shows "doe2 " $annual -m doe2 "$room"

# lacks TEXT WORDS: the output does not contain this text.
lacks() {
    text=$1
    shift
    run "$@"
    [ $status -eq 0 ] && ! grep -q -- "$text" "$scratch/out" || told
}
check "and no other" lacks "adeline" $annual -m doe2 "$room"
check "none by default" lacks "Hand methods" $annual "$room"
check "JSON" shows '"methods-factors"' $annual -m df-global -f json "$room"
check "likely ranges" shows "of 100 simulated figures" $annual -m df-global "$room"
check "in JSON" shows '"da300-range"' $annual -m df-global -f json "$room"
check "none for other hours" shows "no likely ranges: they are known for 8 to 18 h" $annual \
    --hours 9-17 -m df-global "$room"
check "CSV" shows 'df-global.da300' $annual -m df-global -f csv "$room"
check "a line has as many fields as the heading" \
    sh -c "awk -F, 'NR == 1 { n = NF } NF != n { exit 1 }' '$scratch/out'"

# The methods use the daylight factor that df calculates by hand.
run df -q -m exact+bre --no-bands -f csv "$room"
by_hand=$(awk -F, '$3 == "point" && $10 == "df" && !seen++ { printf "%.6f", $12 }' "$scratch/out")
run $annual -m df-diffuse --df exact+bre -f csv "$room"
used=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i }
    $c["place"] == "point" && !seen++ { printf "%.6f", $c["df"] }' "$scratch/out")
check "daylight factors by hand" test "$by_hand" = "$used"
check "their origin is said" shows "by exact+bre" $annual -m df-diffuse --df exact+bre "$room"
check "type 1 of ISO 15469" shows "ISO 15469 type 1" $annual -m df-diffuse --df iso-1 "$room"

explain="$annual -m all -e --points 1.5,1"
check "the year explained" shows "the year by four-skies" $explain "$room"
check "an hour explained" shows "illuminance by classes, 3 May, 14 to 15 h" $explain \
    --when '2010-05-03 14:20' "$room"
check "in JSON" shows '"when": "3 May' $explain --when '2010-05-03 14:20' -f json "$room"
check "an hour at night" refuses 1 "no daylight" $explain --when '2010-05-03 02:00' "$room"
check "several points" refuses 2 "one point only" $annual -m all -e "$room"
check "CSV of an explanation" refuses 2 "cannot write CSV" $explain -f csv "$room"
check "a wrong name" refuses 2 "did you mean doe2" $annual -m doe3 "$room"
check "an empty name" refuses 2 "expected all" $annual -m "doe2,," "$room"
check "the lumen method, with its reason" refuses 2 \
    "do not give the coefficients of the lumen method for every hour" $annual -m lumen "$room"
check "two daylight factors" refuses 1 "expected one" $annual -m doe2 \
    --df exact+bre,exact+split-flux "$room"
check "a wrong daylight factor" refuses 2 "exact" $annual -m doe2 --df exactly "$room"
check "--df alone" refuses 2 "expected --methods" $annual --df iso-1 "$room"
check "--when alone" refuses 2 "expected --explain" $annual -m doe2 \
    --when '2010-05-03 14:20' "$room"
sed 's|</room>|<rooflight x="1" y="3" width="1" depth="1"/></room>|' "$room" >"$scratch/rooflight.xml"
check "no orientation factor for a rooflight" shows "Not applicable: orientation factors" \
    $annual -m df-orientation --points 1.5,2 "$scratch/rooflight.xml"

sed 's/,[27]$/,99/' "$scratch/year.epw" >"$scratch/clouds.epw"
check "no cloud cover" shows "no total sky cover" annual -q -w "$scratch/clouds.epw" \
    --samples 16 -m doe2,df-diffuse "$room"
run $annual -m all -f csv "$room"
cp "$scratch/out" "$scratch/first"
run $annual -m all --threads 3 -f csv "$room"
check "any number of threads gives the same bytes" same "$scratch/first" "$scratch/out"
tap_done
