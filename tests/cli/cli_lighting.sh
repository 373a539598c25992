#!/bin/sh
# Electric light saved by daylight: controls, recalculated from the hourly illuminances; schedules
# for thermal simulation; limits; wrong options.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# make_epw NAME RECORDS FEBRUARY: a year at Brussels with this number of records an hour. The light
# changes from day to day, and within each hour like that of passing clouds.
make_epw() {
    awk -v n="$2" -v february="$3" 'BEGIN {
        print "LOCATION,Brussels,-,BEL,made up,064510,50.90,4.53,1.0,58.0"
        printf "HOLIDAYS/DAYLIGHT SAVINGS,%s,0,0,0\n", february == 29 ? "Yes" : "No"
        printf "DATA PERIODS,1,%d,Data,Sunday,1/1,12/31\n", n
        split("31 " february " 31 30 31 30 31 31 30 31 30 31", days, " ")
        for (m = 1; m <= 12; m++)
            for (d = 1; d <= days[m]; d++)
                for (h = 1; h <= 24; h++)
                    for (k = 1; k <= n; k++) {
                        lit = h > 7 && h <= 17
                        cloud = (37 * d + 11 * h + 29 * k) % 17 / 16
                        printf "%d,%d,%d,%d,%d,?,10,7.5,84,101000,0,0,315,9999,%d,%d,0,0,0\n",
                            2004 - (february == 28), m, d, h, k == n ? 0 : k * 60 / n,
                            lit ? 500 * cloud * (k % 2) : 0, lit ? 20 + 200 * cloud : 0
                    }
    }' >"$scratch/$1.epw"
}
make_epw year 1 28
make_epw leap 1 29
make_epw quarters 4 28
sed 's|</room>|<point x="1.5" y="2"/><point x="1.5" y="6"/></room>|; /<line/d; /<grid/d' \
    "$deep" >"$scratch/room.xml"
room=$scratch/room.xml
annual="annual -q --samples 4 --patches 145"
on_off="--lighting on-off,at=1,target=1000,differential=400,power=100W"
stepped="--lighting stepped,steps=3,at=2,power=100W"
dimmed="--lighting dimmed,residual-light=0.1,residual-power=0.2,end=off,power=100W"
manual="--lighting manual,power=100W"

# figure NAME: the values of this figure in the JSON output, one for each control.
figure() {
    awk -v name="\"$1\":" '$1 == name { sub(/,$/, "", $4); print $4 }' "$scratch/out"
}

# recount: energy in kWh used by each of the four controls, from an hourly CSV file. Its
# illuminances are rounded to 0.01 lx.
recount() {
    awk -F, 'NR == 1 { on = 1; next }
        {
            E1 = $9; E2 = $10 + 0; dark = E1 < E2 ? E1 + 0 : E2
            on = E1 < (on ? 1400 : 1000)
            kwh[1] += $8 * on
            kwh[2] += $8 * ((E2 < 100) + (E2 < 200) + (E2 < 300)) / 3
            light = 1 - dark / 300
            kwh[3] += $8 * (light <= 0.1 ? 0 : 0.2 + 0.8 * (light - 0.1) / 0.9)
            if ($8 > 0 && $1 "/" $2 != day) {
                day = $1 "/" $2
                x = dark > 0 ? log(dark) / log(10) : 0
                people = x <= 0.843 ? 1 : x >= 2.818 ? 0 : -0.0175 + 1.0361 / (1 + exp(4.0835 * (x - 1.8223)))
            }
            kwh[4] += $8 * people
        }
        END { for (i = 1; i <= 4; i++) print kwh[i] / 10 }' "$1"
}

# agree TOLERANCE NUMBERS NUMBERS: two lists of four numbers agree, none of which is trivial.
agree() {
    echo "$2" $3 | tr '\n' ' ' | awk -v most="$1" '{
        for (i = 1; i <= 4; i++)
            good += NF == 8 && $i > 5 && $i < 360 && ($i - $(i + 4))^2 <= most^2
        print }
        END { exit good != 4 }'
}

for records in year quarters; do
    run $annual -w "$scratch/$records.epw" -f json --hourly "$scratch/hours.csv" $on_off $stepped \
        $dimmed $manual "$room"
    check "hour by hour, the energy is that of the hourly file: $records" agree 0.05 \
        "$(figure used-kwh)" "$(recount "$scratch/hours.csv")"
done
check "hourly means misjudge on-off switching under clouds" \
    test "$(figure misjudged-by-hourly-means | awk 'NR == 1 { print ($1 > 3 || $1 < -3) }')" = 1

# A schedule has a line of headings and a fraction for each hour.
schedule="--schedule $scratch/schedule.csv"
run $annual -w "$scratch/quarters.epw" -f json $stepped $schedule --hours 9-16 --days mon-fri "$room"
used=$(figure used-kwh)
check "8760 fractions also for short records" test "$(wc -l <"$scratch/schedule.csv")" -eq 8761
check "its heading says what it is" grep -q "^\"lighting 1: fraction of the installed power" \
    "$scratch/schedule.csv"
check "fractions from 0 to 1, outside of the hours 0" awk -v used="$used" '
    NR > 1 { h = (NR - 2) % 24; part = $1 + 0 # without the carriage return
        wrong += part < 0 || part > 1 || (part > 0 && (h < 9 || h > 15)); sum += part / 10 }
    END { exit !(wrong == 0 && sum > 20 && (sum - used)^2 < 1e-4) }' "$scratch/schedule.csv"
run $annual -w "$scratch/leap.epw" $dimmed $schedule "$room"
check "no 29 February" test "$(wc -l <"$scratch/schedule.csv")" -eq 8761
run $annual -w "$scratch/leap.epw" --leap-day $dimmed $manual $schedule "$room"
check "29 February on request" test "$(wc -l <"$scratch/schedule.csv")" -eq 8785
check "a column for each control" test "$(awk 'END { n = split($0, a, ","); print n }' \
    "$scratch/schedule.csv")" -eq 2

# Limits. Lamps dimmed to 0 supply the missing light: 1 - min(1, E/target).
weather="$annual -w $scratch/year.epw"
run $weather -f json --hours 20-24 $on_off $stepped $dimmed $manual "$room"
check "at night nothing is saved" test "$(figure saved | sort -u)" = 0
run $weather -f json --hours 10-15 -i 0.1 --lighting on-off,target=1 --lighting stepped,target=1 \
    --lighting dimmed,target=1,end=off "$room"
check "above the target all is saved" test "$(figure saved | sort -u)" = 100
run $weather -f csv --lighting on-off --lighting dimmed "$room"
check "on-off saves the daylight autonomy, dimming the continuous one" awk -F, '
    $3 == "point" || $3 == "average" { n++; good += ($39 - $7)^2 < 1e-12 && ($40 - $8)^2 < 1e-12 &&
        ($45 - $9)^2 < 1e-12 && ($46 - $10)^2 < 1e-12 && $45 > $39 && $39 > 1 && $45 < 99 }
    END { exit !(n == 3 && good == 3) }' "$scratch/out"
run $weather -f csv --methods df-global --lighting dimmed "$room"
check "lines of controls have as many fields as others" test "$(awk -F, '{ print NF }' \
    "$scratch/out" | sort -u | wc -l)" -eq 1
run $weather -f csv --lighting on-off --lighting dimmed "$room"
check "the darkest point is the deeper one" awk -F, '
    $3 == "point" { saved = $45 } $3 == "lighting2" { exit ($45 - saved)^2 > 0.01 }' "$scratch/out"
check "blinds save less light" awk 'NR == 1 { open = $1 } NR == 2 { closed = $1 }
    END { exit !(closed < open && closed > 1) }' <<EOF
$(run $weather -f json --lighting dimmed --lighting dimmed,blinds=lm83 "$room"; figure saved)
EOF
check "any number of threads gives the same bytes" same_by_threads "1 3" $weather -f json $dimmed \
    $manual "$room"

check "text" shows "energy, kWh" $weather $dimmed "$room"
check "its settings" shows "down to 10 % of the light at 20 % of the power" $weather -f json $dimmed "$room"
check "EN 15193 has its place" shows "F_D,C 0.77" $annual -w "$scratch/year.epw" -i 500 \
    --lighting dimmed --points 1,1 "$examples/office.xml"
check "and its limits" shows "38 to 60 degrees north" $annual -w "$scratch/year.epw" -f json \
    --lighting dimmed,target=400 --points 1,1 "$examples/office.xml"
check "text of short records" shows "saved by hourly means" $annual -w "$scratch/quarters.epw" \
    $dimmed --points 1,1 "$room"
check "no power has no energy" shows "no installed power given" $weather -f json --lighting dimmed \
    "$room"
check "an unknown control" refuses 2 "on-off, stepped, dimmed or manual" $weather --lighting off "$room"
check "a key of another control" refuses 2 "where KEY is" $weather --lighting dimmed,steps=2 "$room"
check "a key without a value" refuses 2 "where KEY is" $weather --lighting dimmed,end "$room"
check "an absurd power" refuses 2 "installed power" $weather --lighting dimmed,power=-8 "$room"
check "a target of 0" refuses 2 "target=LX" $weather --lighting dimmed,target=0 "$room"
check "half a step" refuses 2 "steps=N" $weather --lighting stepped,steps=2.5 "$room"
check "a point that there is not" refuses 1 "has 2 points" $weather --lighting dimmed,at=3 "$room"
check "blinds that there are not" refuses 2 "--blinds never" $weather --blinds none \
    --lighting dimmed,blinds=lm83 "$room"
check "nine controls" refuses 2 "at most 8" $weather $dimmed $dimmed $dimmed $dimmed $dimmed $dimmed \
    $dimmed $dimmed $dimmed "$room"
check "a schedule without a control" refuses 2 "--lighting" $weather $schedule "$room"
check "a schedule of a building" refuses 1 "--schedule is for one room" $weather $dimmed $schedule \
    "$examples/building.xml"

tap_done
