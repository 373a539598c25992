#!/bin/sh
# annual: from a weather file to figures and charts, and wrong input.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

awk -f "$srcdir/tests/lib/clear_year.awk" >"$scratch/year.epw"
sed 's|</room>|<point x="1.5" y="1"/><point x="1.5" y="6"/></room>|; /<line/d; /<grid/d' \
    "$deep" >"$scratch/room.xml"
room=$scratch/room.xml
annual="annual -w $scratch/year.epw --samples 16"

# cell TEXT WORDS: the CSV contains a record with this text.
cell() {
    text=$1
    shift
    gives $annual --format csv "$@" && { grep -q -- "$text" "$scratch/out" || told; }
}

check "text" shows "sDA300/50" $annual "$room"
check "it names its assumptions" shows "LM-83-12" $annual "$room"
check "the error of patches is said" shows "discretisation" $annual "$room"
check "and is in JSON" shows '"sky_rms_percent"' $annual -f json "$room"
check "it says that points do not form a grid" shows "no grid" $annual "$room"
check "so that LEED has no result" grep -q \
    "LEED v4.1 *option 1: no result, because the points do not form a grid" "$scratch/out"
# lacks TEXT WORDS: the output does not contain this text.
lacks() {
    text=$1
    shift
    run "$@"
    [ $status -eq 0 ] && ! grep -q -- "$text" "$scratch/out" || told
}

check "without blinds there is no sDA" lacks "sDA300/50  " $annual --blinds none "$room"
check "JSON" shows '"pepperpot-annual-1"' $annual -f json "$room"
check "all of the day's 2555 hours" shows '"occupied_h": 2555' $annual -f json \
    --hours 9-16 "$room"
# From 22 to 24 h it is dark: the autonomy is 0 %, all hours have less than 100 lx.
check "a night shift has no autonomy" \
    cell 'point,1.5,1,0.85,0,0,0,0,0,0,0,0,100,0,' --hours 22-24 "$room"
check "no record of 29 February" lacks "29 February" $annual "$room"
check "any illuminance" shows "DA 450" $annual -i 450 "$room"
check "the shift is said" shows "sun shift 30 minutes" $annual --sun-shift 30 "$room"
check "hours as CSV" gives $annual --hourly "$scratch/hours.csv" "$room"
check "8760 lines and a heading" test "$(wc -l <"$scratch/hours.csv")" -eq 8761
check "hours as DAYSIM has them" \
    gives $annual --hourly "$scratch/hours.ill" "$room"
check "a line an hour" test "$(wc -l <"$scratch/hours.ill")" -eq 8760
check "hours as NumPy has them" \
    gives $annual --hourly "$scratch/hours.npy" "$room"
check "128 bytes and 2 x 8760 numbers" \
    test "$(wc -c <"$scratch/hours.npy")" -eq $((128 + 4 * 2 * 8760))
check "hours in JSON" shows '"average_lux": [ 0,' $annual -f json --hourly json "$room"
# mean_of_hours: the mean of the hours in JSON is the mean of the year.
mean_of_hours() {
    awk '/"occupied_h": \[/ { gsub(/.*\[|\].*/, ""); n = split($0, hours, ", ") }
        /"average_lux": \[/ { gsub(/.*\[|\].*/, ""); split($0, lux, ", ") }
        /"mean-lux":/ && !wanted { wanted = $4 + 0 }
        END {
            for (i = 1; i <= n; i++) { sum += lux[i] * hours[i]; all += hours[i] }
            exit !(n == 8760 && all > 0 && sum / all > wanted - 0.06 && sum / all < wanted + 0.06)
        }' "$scratch/out"
}
check "whose mean is that of the year" mean_of_hours
check "but not in text" refuses 2 "needs --format json" $annual --hourly json "$room"
run $annual --seed 5 -f csv "$room"
cp "$scratch/out" "$scratch/first"
run $annual --seed 5 --threads 3 -f csv "$room"
check "any number of threads gives the same bytes" same "$scratch/first" "$scratch/out"

check "coefficients as Radiance has them" gives $annual --coefficients "$scratch/c.mtx" "$room"
check "their size" grep -q "NCOLS=578" "$scratch/c.mtx"
check "a chart" quietly chart year -w "$scratch/year.epw" -o "$scratch/year.svg" "$room"
check "a chart without weather" refuses 2 "--weather" chart year -o "$scratch/x.svg" "$room"

# The sun shines for 7 hours on 365 days; a window facing south or north has all or none of them.
if command -v pdftotext >/dev/null; then
    sunny() { # NORTH HOURS
        sed -e '/<skyline/d' -e "s/<room /<room north=\"$1\" /" "$room" \
            >"$scratch/turned.xml"
        quietly chart sun-path -w "$scratch/year.epw" -o "$scratch/sun.pdf" \
            "$scratch/turned.xml" &&
            pdftotext "$scratch/sun.pdf" - | tr '\n' ' ' | grep -q "window in $2 of these 2555"
    }
    check "hours with sunshine that reach a window to the south" sunny 0.5 2555
    check "and none to the north" sunny 180.5 0
fi
sed '/<site/d' "$room" >"$scratch/placeless.xml"
check "sun paths without a location" refuses 1 "latitude" chart sun-path -w "$scratch/year.epw" \
    -o "$scratch/x.svg" "$scratch/placeless.xml"

check "paths of a chart of the year" quietly chart year -w "$scratch/year.epw" --samples 16 \
    -o "$scratch/year.svg" "$room"
check "as many as a power of two" refuses 2 "power of two" chart year -w "$scratch/year.epw" \
    --samples 17 -o "$scratch/x.svg" "$room"

# stops WORDS: is ended by a signal during the first seconds, and leaves the old file unchanged.
stops() {
    echo old >"$scratch/old.svg"
    "$pepperpot" "$@" -o "$scratch/old.svg" "$room" 2>"$scratch/err" &
    sleep 1
    kill $!
    wait $!
    case $? in 130 | 143) [ "$(cat "$scratch/old.svg")" = old ] ;; *) false ;; esac
}
check "an interrupted chart of a year leaves the old file" \
    stops chart year -w "$scratch/year.epw" --samples 8192
check "so does a plan of a moment" stops chart plan --sky perez,600,120,35,170 --samples 8192

run annual -w "$scratch/year.epw" -f csv "$room"
cp "$scratch/out" "$scratch/default.csv"
run annual -w "$scratch/year.epw" -f csv --error 1% "$room"
check "the default is a standard error of 1 %" cmp "$scratch/out" "$scratch/default.csv"

# LEED's findings use the figures of annual.
sed '/<line/d; s|</room>|<grid spacing="1" margin="0"/></room>|' "$deep" >"$scratch/grid.xml"
run annual -w "$scratch/year.epw" -f json "$scratch/grid.xml"
sda=$(awk -F'[:,]' '/"sda300/ { printf "%.3g", $3 }' "$scratch/out")
leed="assess --for leed-v4.1 -w $scratch/year.epw"
run $leed "$scratch/grid.xml"
check "a grid that is not that of LM-83" grep -q \
    "grid is not that of LM-83: 0.85 m above the" "$scratch/out"
check "LEED's area is that of annual" grep -q "sDA300/50, 1 point  *$sda %" "$scratch/out"
check "points that are no grid have no verdict" shows "not applicable" $leed "$room"
check "LEED needs weather" refuses 2 "--weather" assess --for leed-v4.1 "$room"
check "LEED by its name" refuses 2 "--weather" assess -c leed-v4.1 "$room"
check "LEED is not by hand" refuses 2 "--by-hand" $leed --by-hand "$room"

sed '/<window/,/>/d; /<line/d' "$room" >"$scratch/windowless.xml"
check "a room without windows is dark" sh -c "
    '$pepperpot' annual -w '$scratch/year.epw' --samples 16 -q '$scratch/windowless.xml' 2>&1 |
        grep -qE '^ *mean +0\.0 +0\.0'"

# EN 17037, method 2, uses the shares of annual at the same points.
sed '/<line/d; s|</room>|<grid spacing="1" margin="0.5"/></room>|' "$deep" >"$scratch/inner.xml"
run annual -w "$scratch/year.epw" -f json "$scratch/inner.xml"
share=$(awk -F'[:,]' '/"en17037-300/ { printf "%.0f", $3 }' "$scratch/out")
en17037="assess --for en17037 --spacing 1,0.5 -w $scratch/year.epw"
check "method 2 of EN 17037" shows "EN 17037 daylight provision, method 2" $en17037 "$scratch/inner.xml"
check "its shares are those of annual" sh -c "
    sed -n '/method 2/,\$p' '$scratch/out' | grep -q 'minimum: 300 lx .*over $share %'"
check "without weather it is not applicable" shows "expected --weather" \
    assess --for en17037 --by-hand "$room"

# The sheet of EN 17037.
page="chart en17037 -w $scratch/year.epw --error 8%"
sed 's/<room /<room use="living-room" /; s|</room>|<view x="1.5" y="2" bearing="180"/></room>|' \
    "$room" >"$scratch/lived.xml"
check "a page of EN 17037" quietly $page -o "$scratch/page.pdf" "$scratch/lived.xml"
if command -v pdftotext >/dev/null; then
    pdftotext "$scratch/page.pdf" - >"$scratch/page.txt"
    for part in "Daylight provision 1: daylight factor: " "Daylight provision 2: every hour: " \
        "View out: " "Exposure to sunlight: " "Protection from glare: "; do
        check "it has $part" grep -qE "^$part(none|minimum|medium|high)" "$scratch/page.txt"
    done
    run assess --for en17037 --error 8% -w "$scratch/year.epw" "$scratch/lived.xml"
    lux=$(sed -n '/method 2/,$s/^ *minimum: 300 lx *\([0-9]*\) .*/\1/p' "$scratch/out")
    check "its figures are those of assess: $lux lx" grep -qE "^$lux .*lx" "$scratch/page.txt"
fi
check "it needs weather" refuses 2 "--weather" chart en17037 -o "$scratch/x.svg" "$room"
check "its hours are fixed" refuses 2 "no --hours" $page --hours 9-17 -o "$scratch/x.svg" "$room"
check "and its illuminances" refuses 2 "no --illuminance" $page -i 400 -o "$scratch/x.svg" "$room"
check "it has no methods" refuses 2 "--methods" $page -m exact+bre -o "$scratch/x.svg" "$room"
check "an interrupted page leaves the old file" stops $page --error 0.1%

# A report includes the year if requested.
report="report -q --samples 64 -w $scratch/year.epw --for leed-v4.1 -o $scratch/report.html"
check "a report with the year" quietly $report --year "$scratch/grid.xml"
check "its figures" grep -q "ASE1000,250" "$scratch/report.html"
check "its hours" grep -q "Daylight in every hour of a year" "$scratch/report.html"
check "its electric light" grep -q "on at arrival as observed by Hunt" "$scratch/report.html"
check "its command" grep -q -e "--year" "$scratch/report.html"
for name in One Two Three; do
    sed "s/Deep office/$name/" "$scratch/grid.xml" >"$scratch/$name.xml"
done
run report -q --samples 16 -w "$scratch/year.epw" --year -o "$scratch/short.html" \
    "$scratch/One.xml" "$scratch/Two.xml" "$scratch/Three.xml"
check "a short report has a table of the year" test "$(grep -c "sDA300/50, %" "$scratch/short.html")" -eq 1
check "a year needs weather" refuses 2 "--weather" report --year -o "$scratch/x.html" "$room"
check "a year is not by hand" refuses 2 "--by-hand" $report --year --by-hand "$room"

# A plan of one moment is in lux.
plan="chart plan --samples 16 -q -o $scratch/moment.pdf"
check "a plan of a sky with a sun" quietly $plan --sky perez,600,120,35,170 "$room"
check_words "it names sun and parts" "$scratch/moment.pdf" "35.0° high" "from sunlit surfaces" \
    "direct sunlight" "calculation points, with values in lx"
run df --samples 16 --sky perez,600,120,35,170 -f csv "$room"
noon=$(awk -F, 'NR == 3 { printf "%.0f", $13 }' "$scratch/out")
check_words "its values are those of df" "$scratch/moment.pdf" "$noon"
check "a plan of an hour" quietly $plan -w "$scratch/year.epw" --when "2023-03-21 12:00" "$room"
check_words "it names the hour" "$scratch/moment.pdf" "2023-03-21 12:00"
run chart plan --samples 16 -w "$scratch/year.epw" --when "2023-03-21 12:00" \
    -o "$scratch/moment.svg" "$room"
check "its description has no daylight factor" grep -q \
    "illuminances and direct sunlight on the plan, 2023-03-21 12:00" "$scratch/moment.svg"
# Coloured parts are filled within an outline of several rectangles.
cat >"$scratch/l.xml" <<'XML'
<room version="1"><plan height="2.7"><vertex x="0" y="0"/><vertex x="6" y="0"/>
<vertex x="6" y="2.6"/><vertex x="2.4" y="2.6"/><vertex x="2.4" y="6.1"/><vertex x="0" y="6.1"/>
</plan><window wall="1" left="0.5" sill="0.8" width="2" height="1.4"/>
<window wall="1" left="3.5" sill="0.8" width="2" height="1.4"/>
<rooflight x="0.7" y="3.2" width="1" depth="0.8"/>
<rooflight x="4.1" y="1.1" width="0.3" depth="0.3"/><point x="1" y="1"/></room>
XML
check "an L-shaped plan as a PNG" quietly chart plan --samples 1 -q --dpi 160 \
    --sky perez,600,120,35,170 -o "$scratch/moment.png" "$scratch/l.xml"
check "a dark hour has no plan" refuses 1 "no daylight" $plan -w "$scratch/year.epw" \
    --when "2023-03-21 02:00" "$room"
check "weather of a plan has a time" refuses 2 "--when" $plan -w "$scratch/year.epw" "$room"
check "a section has no moment" refuses 2 "--when is for a plan" chart section \
    --when "2023-03-21 12:00" -o "$scratch/x.pdf" "$room"
check "no comparison of a moment" refuses 2 "--line is for a plan of daylight factors" $plan \
    --sky perez,600,120,35,170 --line no-sky "$room"

# One hour: lux with sunlight, and no daylight factor. At noon the direct irradiance is 400 W/m2.
hour="df -w $scratch/year.epw --samples 16"
check "an hour" shows "sun-reflected" $hour --when "2023-03-21 12:00" "$room"
check "an hour has no daylight factor" shows '"df": { "value": null, "why"' $hour \
    --when "2023-03-21 12:00" -f json "$room"
check "an hour as CSV" shows "illuminance_se_lx" $hour --when "2023-03-21 12:00" -f csv "$room"
check "a dark hour" refuses 1 "no daylight" $hour --when "2023-03-21 02:00" "$room"
check "no such time" refuses 2 "YYYY-MM-DD" $hour --when "noon" "$room"
check "a time without weather" refuses 2 "--weather" df --when "2023-03-21 12:00" "$room"
check "weather without a time" refuses 2 "--when" $hour "$room"
check "methods have no hour" refuses 2 "--methods" $hour --when "2023-03-21 12:00" \
    -m exact+bre "$room"

# A sky given by its irradiances: the sun's position is given, or that of a time at the site.
perez="df --samples 16 --sky perez,600,120"
check "a Perez sky with a sun" shows "sun 35.0 degrees high, bearing 150.0" $perez,35,150 "$room"
check "its JSON has no time" lacks '"when"' $perez,35,150 -f json "$room"
check "its factor is null" shows '"df": { "value": null, "why"' $perez,35,150 -f json "$room"
check "the sun of a time" shows "sun 38.7 degrees high" $perez --when "2023-03-21 12:00" "$room"
check "clock of a zone" shows "clock 9 h ahead" $perez --when "2023-03-21 21:00+09:00" "$room"
check "a black sky is said" shows "sky is black" df --samples 16 --sky perez,100,0,10,180 "$room"
check "an ISO sky with a sun" shows "12000 lx diffuse horizontal, 70000 lx direct normal" \
    df --samples 16 --sky iso-12,30,180,70000,12000 "$room"
check "its JSON names the sky" shows '"sky": "iso-12"' \
    df --samples 16 --sky iso-12,30,180,70000,12000 -f json "$room"
check "an overcast sky in lux" shows "Sky overcast with the given diffuse horizontal illuminance" \
    df --samples 16 --sky overcast,20000 "$room"
check "which has no sun" shows "Given sky, without sun" \
    df --samples 16 --sky overcast,20000 "$room"
check "nor in JSON" shows '"sun_altitude_deg": null' \
    df --samples 16 --sky uniform,20000 -f json "$room"
check "no such ISO sky" refuses 2 "iso-1 to iso-15" df --sky iso-16,30,180,70000,12000 "$room"
check "an ISO sky without diffuse light" refuses 2 "iso-1 to iso-15" \
    df --sky iso-12,30,180,70000 "$room"
check "the sun at the horizon" refuses 1 "at the horizon" df --sky iso-12,0,180,70000,12000 "$room"
check "a standard sky has no time" refuses 2 "only one of them" \
    df --sky overcast,20000 --when "2023-03-21 12:00" "$room"
check "no sun" refuses 2 "has no position of the sun" $perez "$room"
check "one irradiance" refuses 2 "perez,DNI,DHI" df --sky perez,600 "$room"
check "more than the sun gives" refuses 2 "1500" df --sky perez,1600,100,35,150 "$room"
check "a sun below the horizon" refuses 2 "0 to 90" df --sky perez,600,100,-3,150 "$room"
check "night" refuses 1 "below the horizon" $perez --when "2023-03-21 02:00" "$room"
check "no light" refuses 1 "no light" df --sky perez,0,0,10,180 "$room"
check "two suns" refuses 2 "one of them" $perez,35,150 --when "2023-03-21 12:00" "$room"
check "two skies" refuses 2 "one of them" $hour --sky perez,600,120 --when "2023-03-21 12:00" "$room"
check "does not have that day" refuses 2 "1800 to 2200" $perez --when "2023-02-29 12:00" "$room"
check "a zone beside a weather file" refuses 2 "standard time" $hour \
    --when "2023-03-21 12:00+01:00" "$room"
sed 's/longitude="[^"]*"//' "$room" >"$scratch/nowhere.xml"
check "no place" refuses 1 "nowhere.xml: the room has no location" $perez \
    --when "2023-03-21 12:00" "$scratch/nowhere.xml"

# Pictures include the sun.
render="render --size 24x18 --samples 4 -q -o $scratch/sun.png"
check "a picture with sun" quietly $render --sky perez,600,120,35,150 "$room"
check "a picture of an hour" quietly $render -w "$scratch/year.epw" --when "2023-03-21 12:00" "$room"
check "no factor with a sun" refuses 2 "has no daylight factor" $render --sky perez,600,120,35,150 \
    --quantity df "$room"
check "no sun by chance" refuses 2 "never hit the sun" $render --sky perez,600,120,35,150 --plain "$room"
check "a black sky has no picture" refuses 1 "gives a black sky" $render --sky perez,100,0,10,180 "$room"
check "a dark hour has no picture" refuses 1 "no daylight" $render -w "$scratch/year.epw" \
    --when "2023-03-21 02:00" "$room"

# Exported Radiance scenes include the sun; after import it is a light source.
export="export --to radiance --force -q -o $scratch/scene"
check "a scene with sun" quietly $export --sky perez,600,120,35,150 "$room"
check "its sun is half a degree" grep -q ' 0.533$' "$scratch/scene/sky.rad"
check "its command of gendaylit" grep -q -- '-ang 35.000 -30.000 -L' "$scratch/scene/sky.rad"
check "its script gives lux" grep -q 'lux' "$scratch/scene/illuminances.sh"
check "no factors with a sun" test ! -e "$scratch/scene/daylight_factors.sh"
head -1 "$scratch/scene/points.pts" >"$scratch/one.pts"
check "it is read back" shows "0.85" import --samples 16 --points-file "$scratch/one.pts" \
    "$scratch/scene/materials.rad" "$scratch/scene/room.rad" "$scratch/scene/glazing.rad" \
    "$scratch/scene/outside.rad" "$scratch/scene/sky.rad"
check "a dark hour has no scene" refuses 1 "no daylight" $export -w "$scratch/year.epw" \
    --when "2023-03-21 02:00" "$room"
check "a moment has its own light" refuses 2 "--external" $export --sky perez,600,120,35,150 \
    --external 5000 "$room"

# The parts of a building's rooms add up to the whole output, to the byte.
parts="$annual -f csv --points 1,1"
run $parts "$examples/building.xml"
cp "$scratch/out" "$scratch/whole.csv"
for k in 1 2; do
    run $parts --part $k/2 "$examples/building.xml"
    cp "$scratch/out" "$scratch/part-$k.csv"
done
check "two parts are the whole" sh -c "cd '$scratch' && test \"\$(sort -u part-1.csv part-2.csv)\" = \
    \"\$(sort -u whole.csv)\""
check "each is less" sh -c "cd '$scratch' && ! cmp -s part-1.csv whole.csv"
check "an empty part" refuses 1 "this part is empty" $annual --part 2/2 "$room"
check "a part of none" refuses 2 "K/N" $annual --part 3/2 "$room"

check "no weather file" refuses 2 "--weather" annual "$room"
check "no room" refuses 2 "room file" $annual
check "a weather file that is none" refuses 1 "EPW" annual -w "$deep" "$room"
check "a weather file of four days" refuses 1 "8760" annual \
    -w "$srcdir/tests/formats/epw/four-days.epw" "$room"
check "a sky" refuses 2 "--sky" $annual --sky overcast "$room"
check "two periods" refuses 2 "--hours" $annual --hours 8-12,13-18 "$room"
check "samples that are no power of two" refuses 2 "power of two" $annual --samples 100 "$room"
check "patches" refuses 2 "145, 577 or 2305" $annual --patches 500 "$room"
check "a shift" refuses 2 "--sun-shift" $annual --sun-shift noon "$room"
check "blinds" refuses 2 "lm83, always, never or none" $annual --blinds white "$room"
check "blinds of two kinds" refuses 2 "--blinds-schedule" $annual --blinds always \
    --blinds-schedule a.csv "$room"
check "a schedule that is missing" refuses 1 "none.csv" $annual \
    --blinds-schedule "$scratch/none.csv" "$room"

# A window with its own blind, closed by the rule, at all hours, and in the afternoon.
cat >"$scratch/blind.xml" <<'END'
<room version="1"><plan width="3" depth="5" height="2.7"/>
  <window wall="south" left="0.5" sill="0.8" width="2" height="1.6"><blind angle="-45"/></window>
  <point x="1.5" y="1"/><point x="1.5" y="3"/>
</room>
END
awk 'BEGIN { print "closed"; for (i = 0; i < 8760; i++) print i "," (i % 24 > 11) }' \
    >"$scratch/afternoon.csv"
check "a blind of its own" shows '"closed_h": 1518' $annual -f json "$scratch/blind.xml"
check "a blind that is always closed" shows '"closed_h": 3650' $annual -f json --blinds always \
    "$scratch/blind.xml"
check "its kind" shows '"device": "blind"' $annual -f json --blinds always "$scratch/blind.xml"
check "no sDA" shows '"blinds-da300/50-area"' $annual -f json --blinds always "$scratch/blind.xml"
check "a blind that is never closed" lacks "with blinds" $annual --blinds never \
    "$scratch/blind.xml"
check "a schedule" shows '"closed_h": 2190' $annual -f json \
    --blinds-schedule "$scratch/afternoon.csv" "$scratch/blind.xml"
head -8760 "$scratch/afternoon.csv" >"$scratch/short.csv"
check "a schedule that is too short" refuses 1 "8759 values; expected 8760" $annual \
    --blinds-schedule "$scratch/short.csv" "$scratch/blind.xml"
echo "1,0.5" >>"$scratch/short.csv"
check "a half-closed blind" refuses 1 'short.csv:8761: the last field is "0.5"' $annual \
    --blinds-schedule "$scratch/short.csv" "$scratch/blind.xml"
check "hours of a building" refuses 1 "--hourly" $annual --hourly "$scratch/h.csv" \
    "$examples/building.xml"
check "a name of hours" refuses 2 ".npy" $annual --hourly hours.txt "$room"

tap_done
