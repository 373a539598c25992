#!/bin/sh
# Weather files for annual: southern, polar, from time zones with half hours, of a leap year, with
# four records an hour, and with unreasonable values.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# make_epw NAME LATITUDE LONGITUDE ZONE RECORDS FEBRUARY DIRECT: a year with sun from 10 to 14 h,
# with this number of records an hour and of days in February.
make_epw() {
    awk -v latitude="$2" -v longitude="$3" -v zone="$4" -v n="$5" -v february="$6" \
        -v direct="$7" 'BEGIN {
        printf "LOCATION,Place,-,XXX,made up,0,%s,%s,%s,10\n", latitude, longitude, zone
        printf "HOLIDAYS/DAYLIGHT SAVINGS,%s,0,0,0\n", february == 29 ? "Yes" : "No"
        printf "DATA PERIODS,1,%d,Data,Sunday,1/1,12/31\n", n
        split("31 " february " 31 30 31 30 31 31 30 31 30 31", days, " ")
        for (m = 1; m <= 12; m++)
            for (d = 1; d <= days[m]; d++)
                for (h = 1; h <= 24; h++)
                    for (k = 1; k <= n; k++) {
                        lit = h > 10 && h <= 14
                        printf "%d,%d,%d,%d,%d,?,10,7.5,84,101000,0,0,315,%d,%s,%d,0,0,0\n",
                            2004 - (february == 28), m, d, h, k == n ? 0 : k * 60 / n,
                            lit ? 9999 : 0, lit ? direct : 0, lit ? 150 : 0
                    }
    }' >"$scratch/$1.epw"
}
make_epw south -33.9 151.2 10 1 28 400
make_epw polar 78.2 15.6 1 1 28 0
make_epw delhi 28.6 77.2 5.5 1 28 400
make_epw leap 50.9 4.5 1 1 29 400
make_epw quarters 50.9 4.5 1 4 28 400
make_epw absurd 50.9 4.5 1 1 28 -55
make_epw huge 50.9 4.5 1 1 28 1e9
sed 's|</room>|<point x="1.5" y="1"/><point x="1.5" y="6"/></room>|; /<line/d; /<grid/d' \
    "$deep" >"$scratch/room.xml"
room=$scratch/room.xml
annual="annual --samples 16"

# sun NAME TIME: altitude and bearing of the sun in the record of this time, in degrees.
sun() {
    run df --samples 4 -w "$scratch/$1.epw" --when "$2" "$room"
    sed -n 's/.*sun \([-0-9.]*\) degrees high, bearing \([0-9.]*\).*/\1 \2/p' "$scratch/out"
}

# near ALTITUDE BEARING TEXT: altitude and bearing of the sun are within 0.7 degrees of these.
near() {
    echo "$3" | awk -v h="$1" -v b="$2" '{
        good = NF == 2 && ($1 - h)^2 + ($2 - b)^2 < 0.5 }
        END { exit !good }'
}

# By the Astronomical Almanac, for the middle of the record.
check "at Sydney the sun is in the north" near 76.8 319.8 "$(sun south '2003-12-21 12:00')"
check "in June it is low there" near 32.1 351.0 "$(sun south '2003-06-21 12:00')"
check "half an hour of the zone counts" near 61.5 180.8 "$(sun delhi '2003-03-21 12:00')"
check "a record of 15 minutes has its own sun" near 38.5 166.6 "$(sun quarters '2003-03-21 12:00')"
check "and the last of the hour another" near 39.3 181.0 "$(sun quarters '2003-03-21 12:50')"
check "in the polar night the sky alone gives light" near -11.8 188.1 "$(sun polar '2003-12-21 12:00')"

check "a year with little light is said" shows "a quarter of the year" \
    $annual -w "$scratch/polar.epw" "$room"
check "no sun below the horizon" shows '"sun-hours": { "value": 0' \
    $annual -w "$scratch/polar.epw" -f json "$room"
check "29 February is left out" shows "24 records of 29 February ignored" \
    $annual -w "$scratch/leap.epw" "$room"
check "of 3650 hours" shows '"occupied_h": 3650' $annual -w "$scratch/leap.epw" -f json "$room"
check "or kept" shows '"occupied_h": 3660' $annual -w "$scratch/leap.epw" --leap-day -f json "$room"
check "quarters are parts of hours" shows '"occupied_h": 3650' \
    $annual -w "$scratch/quarters.epw" -f json "$room"
check "in 35040 records" shows "35040 records of 0.25 h" $annual -w "$scratch/quarters.epw" "$room"

# sun_hours NAME: the largest number of hours with direct sun at a point.
sun_hours() {
    run $annual -w "$scratch/$1.epw" -f csv "$room"
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "sun-hours") at = i }
        $3 == "point" && $at > most { most = $at } END { print most + 0 }' "$scratch/out"
}
quarters=$(sun_hours quarters)
hours=$(sun_hours leap)
check "hours of sun are hours, not records" \
    awk -v a="$quarters" -v b="$hours" 'BEGIN { exit !(a > 0 && b > 0 && a <= 1460 && (a - b)^2 < 90^2) }'
check "a negative irradiance is located" refuses 1 'absurd.epw:14: direct normal irradiance' \
    $annual -w "$scratch/absurd.epw" "$room"
check "beyond the sun's own it is missing" refuses 1 "neither direct nor diffuse" \
    $annual -w "$scratch/huge.epw" "$room"

# Warnings about place and weather are errors with --strict. The room is at 51.5 degrees north.
check "a room far from its weather" shows "the room is at latitude 51.5" \
    $annual -w "$scratch/south.epw" "$room"
far="Deep office: the room is at latitude 51.5"
check "is refused with --strict" refuses 1 "$far" $annual --strict -w "$scratch/south.epw" "$room"
for hour in "df --samples 16" "chart plan --samples 16 -o $scratch/x.svg"; do
    # shellcheck disable=SC2086
    check "so is an hour of ${hour%% *}" refuses 1 "$far" $hour --strict \
        -w "$scratch/south.epw" --when "2023-03-21 12:00" "$room"
done
check "so is a chart of its year" refuses 1 "$far" \
    chart year --strict -w "$scratch/south.epw" -o "$scratch/x.svg" "$room"

# ASE counts direct sun. Without any in the file, 0 % would look like a good result.
awk -v direct=0 -f "$srcdir/tests/lib/clear_year.awk" >"$scratch/sunless.epw"
sed '/<line/d; s|</room>|<grid spacing="1" margin="0"/></room>|' "$deep" >"$scratch/grid.xml"
sunless="-w $scratch/sunless.epw $scratch/grid.xml"
# shellcheck disable=SC2086
{
    check "without direct sun ASE is not known" \
        shows '"value": null, "why": "the weather has no direct sun"' annual --samples 16 -f json $sunless
    check "and the user is warned" shows "no direct sun, so ASE is not known" \
        annual --samples 16 $sunless
    check "LEED is not assessed" shows "the weather has no direct sun, so ASE is not known" \
        assess --for leed-v4.1 $sunless
    check "and --strict refuses the file" refuses 1 "the weather has no direct sun" \
        annual --strict $sunless
}

tap_done
