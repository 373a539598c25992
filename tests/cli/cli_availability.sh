#!/bin/sh
# availability: from a weather file or a latitude to figures and charts.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

days=$(cd "$srcdir/tests/formats/epw" && pwd)/four-days.epw

# cell TEXT WORDS: the CSV contains a record with this text.
cell() {
    text=$1
    shift
    gives availability --format csv "$@" && { grep -q -- "$text" "$scratch/out" || told; }
}

check "a weather file" shows "Nowhere, XXX (four-days.epw)" availability -w "$days" "$deep"
sed '1s/,\([0-9.-]*\),\([0-9.-]*\),\([0-9.-]*\)$/,122.4,-8,\3/' "$days" >"$scratch/west.epw"
run availability -w "$scratch/west.epw" "$deep"
check "a longitude against its time zone is a warning" \
    grep -q "west.epw:1: warning: the longitude of 122.4 degrees is 8.2 h ahead of UT, but the time zone is -8 h" \
    "$scratch/err"
check "and an error with --strict" refuses 1 "west.epw:1: the longitude" \
    availability --strict -w "$scratch/west.epw" "$deep"
check "in the year too" refuses 1 "west.epw:1: the longitude" \
    annual --strict -w "$scratch/west.epw" "$deep"
check "and in a chart" refuses 1 "west.epw:1: the longitude" \
    chart availability --strict -w "$scratch/west.epw" -o "$scratch/x.svg" "$deep"
check "a latitude" shows "overcast sky all year at 51 N" availability --latitude 51 "$deep"
check "the room's own latitude" \
    shows "overcast sky all year" availability "$examples/office.xml"
sed '/<site/d' "$deep" >"$scratch/nowhere.xml"
check "a room that has none" refuses 1 "--latitude DEG" availability "$scratch/nowhere.xml"
check "a median of a year" shows "median diffuse illuminance" availability --latitude 51 "$deep"
check "no median of four days" shows "less than a year" availability -w "$days" "$deep"
check "JSON" shows '"pepperpot-availability-1"' availability -w "$days" -f json "$deep"
check "a building is a list" shows "[" availability --latitude 51 -f json \
    "$examples/building.xml"
check "any method" shows "exact" availability -w "$days" -m exact+split-flux \
    "$examples/studio.xml"
check "a method that does not cover the room says why" \
    shows "  - exact+bre: " availability -w "$days" "$examples/studio.xml"
check "traced daylight factors" cell ",traced," -w "$days" --simulate --samples 8 -p 1,2 "$deep"

# 13.62 % and 300 lx require 2202 lx; field 19 reaches this in 36 of the 40 hours from 8 to 18, and
# in 31 of 32 from 9 to 17.
check "hours are those of the file" \
    cell ',300,2202\.[0-9]*,8-18,90,' -w "$days" -p 1,1 -i 300 "$deep"
check "and of the period" \
    cell ',300,2202\.[0-9]*,9-17,96\.875,' -w "$days" -p 1,1 -i 300 "$deep"
# 15 March 2017 was a Wednesday, the others a Thursday and two Fridays.
run availability -w "$days" --days thu -f json "$deep"
check "days of the week" grep -q '"counted": 10' "$scratch/out"
run availability -w "$days" --summer-time 1/1-12/31 --hours 9-19 -i 300 -f csv "$deep"
sed 's/,9-19,/,8-18,/' "$scratch/out" >"$scratch/summer"
run availability -w "$days" --hours 8-18 -i 300 -f csv "$deep"
check "summer time all year is an hour earlier" same "$scratch/summer" "$scratch/out"
check "the file's summer time" \
    shows "26 March to 28 October" availability -w "$days" --summer-time file -f json "$deep"
"$pepperpot" availability -w - "$deep" <"$days" >"$scratch/piped" 2>&1
run availability -w "$days" "$deep"
sed 's/four-days.epw/standard input/' "$scratch/out" >"$scratch/named"
check "weather from standard input" \
    test "$(tr -s ' \n' ' ' <"$scratch/named")" = "$(tr -s ' \n' ' ' <"$scratch/piped")"

# Errors on the command line.
check "no room" refuses 2 "room file" availability --latitude 51
check "hours that end before they begin" \
    refuses 2 "--hours" availability --hours 17-9 --latitude 51 "$deep"
for hours in 8 8- -8 8-25 8:7-9 8-18, 8-18,x 8-8 ''; do
    check "hours \"$hours\"" \
        refuses 2 "--hours" availability --latitude 51 --hours="$hours" "$deep"
done
check "a day that is none" refuses 2 "--days" availability --latitude 51 --days mon-foo "$deep"
check "an illuminance of none" refuses 2 "lx" availability --latitude 51 -i 0 "$deep"
check "a latitude beyond the pole" refuses 2 "degrees north" availability --latitude 91 "$deep"
check "summer time on no day" \
    refuses 2 "MONTH/DAY" availability --latitude 51 --summer-time 3/32-10/1 "$deep"
check "a file has its own latitude" \
    refuses 2 "--weather" availability --latitude 51 -w "$days" "$deep"
check "summer time of no file" \
    refuses 2 "--weather" availability --latitude 51 --summer-time file "$deep"
check "room and weather from one input" \
    refuses 2 "standard input" availability -w - -

# Errors in the weather file.
check "a weather file that is not there" \
    refuses 1 "no.epw: cannot be opened" availability -w "$scratch/no.epw" "$deep"
check "a room for a weather file" \
    refuses 1 "deep-office.xml:1: this is not a weather file" availability -w "$deep" "$deep"
head -n 50 "$days" >"$scratch/cut.epw"
check "a file that is cut off" \
    refuses 1 "cut.epw:50: the file ends here" availability -w "$scratch/cut.epw" "$deep"
sed '20s/,9999,270/,x,270/; 20s/999999,999999,[0-9]*/999999,999999,bright/' "$days" \
    >"$scratch/bad.epw"
check "a number that is none, with its line" \
    refuses 1 'bad.epw:20: diffuse horizontal illuminance (field 19) is "bright"' \
    availability -w "$scratch/bad.epw" "$deep"
awk -F, -v OFS=, 'NF > 30 { $19 = 0 } { print }' "$days" >"$scratch/dark.epw"
check "no illuminance: irradiance, and it is said" \
    shows "luminous efficacy" availability -w "$scratch/dark.epw" "$deep"
awk -F, -v OFS=, 'NF > 30 { $16 = $19 = 0 } { print }' "$days" >"$scratch/night.epw"
check "neither" refuses 1 "field 16" availability -w "$scratch/night.epw" "$deep"
sed 's/Wednesday//' "$days" >"$scratch/undated.epw"
check "days of the week that are not known" \
    refuses 1 "--days" availability --days mon-fri -w "$scratch/undated.epw" "$deep"
sed 's|3/26,10/28|Last Sunday in March,Last Sunday in October|' "$days" >"$scratch/sunday.epw"
sed 's|3/26,10/28|26 March,28 October|' "$days" >"$scratch/words.epw"
check "summer time by words" refuses 1 'words.epw:5: the summer time is "26 March to 28 October"' \
    availability --summer-time file -w "$scratch/words.epw" "$deep"
gives availability --summer-time 3/26-10/29 -f csv -w "$days" "$deep"
sed 's/^[^,]*//' "$scratch/out" >"$scratch/dated"
gives availability --summer-time file -f csv -w "$scratch/sunday.epw" "$deep"
sed 's/^[^,]*//' "$scratch/out" >"$scratch/worded"
check "Sundays are found in the calendar" same "$scratch/dated" "$scratch/worded"
check "which nobody asked for" gives availability -w "$scratch/sunday.epw" "$deep"

# The median for EN 17037.
check "no median of four days for assess" \
    refuses 1 "no usable median illuminance" assess -w "$days" "$deep"
check "a place by two options" \
    refuses 2 "--place" assess -w "$days" --place London "$deep"

# Probable sunlight hours: a year with sun only before noon by the clock, which is solar noon
# within minutes.
{
    sed -n 1,7p "$days"
    echo "DATA PERIODS,1,1,Year,Sunday,1/1,12/31"
    awk 'BEGIN {
        split("31 28 31 30 31 30 31 31 30 31 30 31", days, " ")
        for (m = 1; m <= 12; m++) for (d = 1; d <= days[m]; d++) for (h = 1; h <= 24; h++)
            printf("2017,%d,%d,%d,0,?9,10.0,5.0,71,99000,0,0,300,0,%d,%d,999999,999999,%d\n",
                m, d, h, h <= 12 ? 700 : 0, h > 6 && h < 19 ? 100 : 0, h > 6 && h < 19 ? 12000 : 0)
    }'
} >"$scratch/mornings.epw"
cat >"$scratch/west.xml" <<'EOF'
<room version="1" name="West">
  <site latitude="48.2" longitude="16.4"/>
  <plan width="4" depth="5" height="2.7"/>
  <window wall="west" left="1" sill="0.9" width="2" height="1.4"/>
</room>
EOF
check "the sun by a weather file is probable" shows "of probable hours" \
    assess --by-hand -c sunlight -w "$scratch/mornings.epw" "$scratch/west.xml"
check "of mornings a west window has minutes" grep -qE "year +0\.[0-9] %.*not met" "$scratch/out"
check "of all possible hours half" sh -c "
    '$pepperpot' assess --by-hand -c sunlight '$scratch/west.xml' | grep -qE 'year +50\.0 %'"

# Charts.
for format in pdf svg png; do
    run chart availability -w "$days" -o "$scratch/room.$format" "$deep"
    check "a room's chart as $format" test $status -eq 0
    run chart availability -w "$days" --format $format "$deep"
    check "which is the same again" same "$scratch/room.$format" "$scratch/out"
    run chart availability --latitude 50.9 --hours 6-18,7-17,8-18 -o "$scratch/sky.$format"
    check "the light outside as $format" test $status -eq 0
done
check "a room in no place" refuses 1 "--latitude DEG" \
    chart availability -o "$scratch/x.pdf" "$scratch/nowhere.xml"
check "a chart of nothing" refuses 2 "--weather" chart availability -o "$scratch/x.pdf"
check "a plan has no weather" \
    refuses 2 "needs --when" chart plan -w "$days" -o "$scratch/x.pdf" "$deep"
check "a weather file that is wrong" refuses 1 "cut.epw:50" \
    chart availability -w "$scratch/cut.epw" -o "$scratch/x.pdf" "$deep"
check_words "a room's figures are text" "$scratch/room.pdf" "requires an external"
tap_done
