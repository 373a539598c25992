#!/bin/sh
# assess --for and --rules: rules of countries and schemes, their skies and rejected input.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

tables=$(cd "$srcdir/tables" && pwd)
cd "$scratch" || exit 1
LC_ALL=C
export LC_ALL
# room SKY PLANE: an office with this sky and height of the working plane.
room() {
    cat <<END
<room version="1" name="Made up" use="office">
  <site latitude="52"/>
  <plan width="4.3" depth="5.1" height="2.9"/>
  <window wall="south" left="0.6" sill="0.9" width="2.9" height="1.6"/>
  <sky type="$1"/><working-plane height="$2"/>
  <point x="2" y="3"/>
</room>
END
}
room overcast 0.85 >overcast.xml
room uniform 0.85 >uniform.xml

check "rules are listed" gives assess --rules
check "a rule has its number, state, certainty and source" sh -c \
    "grep -A9 '^no-tek17 ' out | tr -s ' \\n' ' ' |
     grep -q 'mean daylight factor, overcast sky >= 2 %.*judged; seen: dibk.no'"
check "a recalled rule is not established" sh -c \
    "grep -A4 '^at-oib-3' out | grep -q 'not established; recalled-hi'"
check "the list fits in 80 columns" nothing "$(too_wide)"
check "as CSV it has a line for each row" sh -c \
    "'$pepperpot' assess --rules -f csv | grep -c , | grep -qx $(grep -vc '^#' "$tables/rules.csv")"
check "as JSON it is valid" sh -c "'$pepperpot' assess --rules -f json | grep -q '\"format\": \"pepperpot-rules-1\"'"
check "conditions of the sun are listed" sh -c \
    "grep -A3 '^sk-stn-734301' out | tr -s ' \\n' ' ' |
     grep -q 'above 5 degrees, 25 degrees or more to the glass'"
check "a share without a bound is stated" sh -c "grep -A4 '^green-star ' out | grep -q ' stated; seen'"
check "as CSV it has them, too" sh -c \
    "'$pepperpot' assess --rules -f csv | grep '^sk-stn' | grep -q ',1.2,0.3,,,25,,.\$'"
check "the list can be a file" quietly assess --rules -o rules.txt
check "which has it all" sh -c "'$pepperpot' assess --rules | cmp - rules.txt"

# A rule for a uniform sky is assessed with it, for any sky in the room file.
figures() {
    "$pepperpot" assess --for "$1" --by-hand -q -f json "$2" |
        grep -o '"figure": [0-9.]*' | tr '\n' ' '
}
check "the uniform sky of BESS replaces the room's" \
    test "$(figures bess-non-residential overcast.xml)" = "$(figures bess-non-residential uniform.xml)"
check "and the overcast sky of TEK17" \
    test "$(figures no-tek17 overcast.xml)" = "$(figures no-tek17 uniform.xml)"
check "the sky is named" shows "uniform sky" assess --for bess-non-residential --by-hand overcast.xml
check "beside the edition" grep -q "version 7" out
check "and the room is described with it" grep -q "sky  *uniform" out
by_df=$("$pepperpot" df -m average-df -q -f json overcast.xml |
    sed -n 's/.*"df": { "average-df": { "value": \([0-9.]*\).*/\1/p')
by_rule=$("$pepperpot" assess --for no-tek17 --by-hand -q -f json overcast.xml |
    sed -n 's/.*"figure": \([0-9.]*\).*/\1/p' | head -n 1)
check "the mean is that of df: $by_df, $by_rule" test "$by_df" = "$by_rule"
room overcast 0.72 >low.xml
check "the height of the working plane is the rule's" \
    test "$(figures green-star overcast.xml)" = "$(figures green-star low.xml)"
check "and is stated" shows "working plane 0.72 m above the floor" \
    assess --for green-star --by-hand overcast.xml
check "a strict bound is printed" shows "> 2 %" assess --for de-asr-a3.4 --by-hand overcast.xml
check "points are those of the file" shows "lowest of 1 points, at 2.00, 3.00, 0.85 m" \
    assess --for de-asr-a3.4 --by-hand overcast.xml
check "a table has them, too" shows "ASR A3.4" \
    assess --for de-asr-a3.4 --by-hand --table overcast.xml
check "simulated, too" shows "by simulation" \
    assess --for de-asr-a3.4 --error 5% overcast.xml
sed 's/office/bathroom/' overcast.xml >bathroom.xml
check "a room of another use is not judged" shows "no row of these rules applies" \
    assess --for no-tek17 --by-hand bathroom.xml
check "a report has the rules" quietly report --for no-tek17 --by-hand -q -o report.html overcast.xml
check "with their title" grep -q "TEK17 section 13-7" report.html

check "an unknown name lists the profiles" refuses 2 "expected a profile (uk-planning, " \
    assess --for nothing-like-it overcast.xml
check "and says how to list the rules" grep -q "assess --rules" err
run assess --rules
check "rules without verdicts are marked" grep -q "Bbl with NEN 2057, NEN 2057 (listed only" out
check "a near one is suggested" refuses 2 "did you mean no-tek17?" assess --for no-tek7 overcast.xml
check "what is not established is refused" refuses 2 "not established" \
    assess --for at-oib-3 overcast.xml
check "a year needs weather" refuses 2 "breeam-4b-office needs weather data" \
    assess --for breeam-4b-office overcast.xml
check "rules and criteria exclude each other" refuses 2 "--criteria and --for" \
    assess --for no-tek17 -c vsc overcast.xml
check "an alternative of a year is left open without weather" shows "expected --weather" \
    assess --for dk-br18 --by-hand overcast.xml
sed '/site/d; s/office/living-room/' overcast.xml >nowhere.xml
check "hours of sun need a place" shows "(site)" assess --for nl-tno-light nowhere.xml
tap_done
