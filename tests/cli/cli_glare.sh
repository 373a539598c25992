#!/bin/sh
# Glare of views at a moment and in a year, as text, JSON and CSV, and wrong input.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

awk -f "$srcdir/tests/lib/clear_year.awk" >"$scratch/year.epw"
cat >"$scratch/room.xml" <<'EOF'
<room version="1" name="Corner">
  <site latitude="50.9" longitude="4.5"/>
  <plan width="4" depth="5" height="2.8"/>
  <window wall="south" left="0.5" sill="0.9" width="3" height="1.6" name="Big"/>
  <view name="desk" x="2" y="3" bearing="180"/>
  <view x="2" y="1" z="1.1" bearing="0"/>
</room>
EOF
room=$scratch/room.xml
sed '/<view/d' "$room" >"$scratch/blind.xml"
sed '/<window/d' "$room" >"$scratch/dark.xml"
sky="--sky iso-12,30,180,70000,12000"
glare="glare --samples 64"
year="glare --samples 16 -w $scratch/year.epw"

check "text" shows "DGP 0." $glare $sky "$room"
check "a view by its name" shows "View desk: eye at (2, 3, 1.2) m, looking towards bearing 180" \
    $glare $sky "$room"
check "an opening by its name" shows "    Big " $glare $sky "$room"
check "the threshold is said" shows "Sources have 2000 cd/m2" $glare $sky "$room"
check "another threshold" shows "Sources have 5000 cd/m2" $glare $sky --threshold 5000 "$room"
check "away from the window" shows '"class": "imperceptible"' $glare $sky -f json "$room"
check "JSON" shows '"format": "pepperpot-glare-1"' $glare $sky -f json "$room"
check "CSV" gives $glare $sky -f csv "$room"
check "two views and a heading" test "$(wc -l <"$scratch/out")" -eq 3
check "a view of the command line" shows "eye at (1, 2, 1.2) m, looking towards bearing 90" \
    $glare $sky --view 1,2,90 "$scratch/blind.xml"
check "with a height" shows "eye at (1, 2, 1.7) m" $glare $sky --view 1,2,1.7,90 "$room"
check "in an hour of the weather file" shows "2001-06-21 12:00" \
    $glare -w "$scratch/year.epw" --when "2001-06-21 12:00" "$room"

# A record with direct light only, whose date is reported in a note on the year.
awk -F, -v OFS=, 'NF > 15 && $2 == 12 && $3 == 28 && $4 == 13 { $15 = 300; $16 = 0 } 1' \
    "$scratch/year.epw" >"$scratch/black.epw"
check "also of a file with a black sky" shows "2001-06-21 12:00" \
    $glare -w "$scratch/black.epw" --when "2001-06-21 12:00" "$room"

check "a year" shows "EN 17037: level" $year "$room"
check "its hours" shows "8 to 18 h on all days, 3650 hours" $year "$room"
check "its JSON" shows '"hours_above_0.45"' $year -f json "$room"
# At night there is no glare, so the level is high.
check "a night shift has no glare" shows "EN 17037: level high" $year --hours 20-24 "$room"
check "dark hours are occupied hours" shows '"occupied_hours": 3650' $year -f json "$room"

# With its blind closed, the window is no source above 5000 cd/m2.
sed 's|height="1.6" name="Big"/>|height="1.6" name="Big"><blind angle="-50"/></window>|' "$room" \
    >"$scratch/slats.xml"
check "a blind" shows "no source of 5000 cd/m2 or more" $glare $sky --threshold 5000 \
    "$scratch/slats.xml"
check "is closed" shows "curtains are closed" $glare $sky "$scratch/slats.xml"
check "in all hours of a year" shows "Blinds, screens and curtains" $year "$scratch/slats.xml"
sed 's|angle="-50"|cut-off="yes"|' "$scratch/slats.xml" >"$scratch/turning.xml"
check "slats that follow the sun" shows "DGP 0." $glare $sky "$scratch/turning.xml"
check "but not over a year" refuses 1 "expected slats with an angle, or --when" $year \
    "$scratch/turning.xml"

assess="assess --samples 16 -c glare"
check "a criterion with slats that follow the sun" shows "slats follow the sun" \
    $assess -w "$scratch/year.epw" "$scratch/turning.xml"
check "a criterion with a blind" shows "curtains closed in all hours" \
    $assess -w "$scratch/year.epw" "$scratch/slats.xml"
check "a criterion" shows "desk, minimum: hours with DGP" \
    $assess -w "$scratch/year.epw" "$room"
check "a view into the room meets all levels" shows "view 2, high" \
    $assess -w "$scratch/year.epw" "$room"
check "no verdict without weather" shows "no year was simulated" $assess "$room"
check "no verdict without a view" shows "the room file has no view" \
    $assess -w "$scratch/year.epw" "$scratch/blind.xml"
check "it is a part of EN 17037" shows "protection from glare" assess --by-hand --for en17037 "$room"

run $year -f json "$scratch/dark.xml"
check "no glare without a window" grep -q '"dgp_max": 0,' "$scratch/out"

check "no view" refuses 1 "has no view" $glare $sky "$scratch/blind.xml"
check "no light" refuses 2 "expected --weather" glare "$room"
check "a sky without light" refuses 2 "expected --weather" glare --sky overcast "$room"
check "a view outside" refuses 1 "lies outside the room" $glare $sky --view 9,9,90 "$room"
check "half a view" refuses 2 "X,Y,BEARING" $glare $sky --view 1,2 "$room"
check "a view in words" refuses 2 "X,Y,BEARING" $glare $sky --view desk "$room"
check "a threshold of nothing" refuses 2 "luminance from 1" $glare $sky --threshold 0 "$room"
check "no file" refuses 2 "expected a room file" $glare $sky
for time in "--hours 9-17" "--days mon-fri" "--summer-time 4/1-10/1"; do
    # shellcheck disable=SC2086
    check "no ${time%% *} at a moment" refuses 2 "${time%% *} is for a year" $glare $sky $time "$room"
done
check "--error or --samples" refuses 2 "expected only one of them" $year --error 1% "$room"
sed 's/latitude="50.9"/latitude="40"/' "$room" >"$scratch/far.xml"
check "a room far from its weather" shows "the room is at latitude 40" $year "$scratch/far.xml"
check "is refused with --strict" refuses 1 "the room is at latitude 40" \
    $year --strict "$scratch/far.xml"
check "by the criterion too" refuses 1 "the room is at latitude 40" \
    $assess --strict -w "$scratch/year.epw" "$scratch/far.xml"
# The 40th letter of the name has two bytes.
long=$(printf '%039d' 0)é$(printf '%030d' 0)
sed "s/desk/$long/" "$room" >"$scratch/long.xml"
check "a long name is cut between letters" shows "0é..., minimum: hours with DGP" \
    $assess -f csv -w "$scratch/year.epw" "$scratch/long.xml"
check "two periods" refuses 2 "expected one" $year --hours 8-12,13-17 "$room"
tap_done
