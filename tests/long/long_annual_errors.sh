#!/bin/sh
# The standard errors of annual figures are correct: over 60 seeds of three rooms, 64 to 74 % of
# the figures are within one standard error of the true value, and 92 to 97 % within two. The true
# value is that of a run with sixteen times the paths, whose error is included. Prints a table by
# figure.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

seeds=60

# A year at Brussels with a sine for the sun's altitude, and clouds by a linear congruential
# generator; only every fifth day has light, which takes a fifth of the time.
awk 'BEGIN {
    print "LOCATION,Brussels,-,BEL,made up,064510,50.90,4.53,1.0,58.0"
    print "HOLIDAYS/DAYLIGHT SAVINGS,No,3/26,10/28,0"
    print "DATA PERIODS,1,1,Data,Sunday,1/1,12/31"
    split("31 28 31 30 31 30 31 31 30 31 30 31", days, " ")
    n = 1
    for (m = 1; m <= 12; m++)
        for (d = 1; d <= days[m]; d++)
            for (h = 1; h <= 24; h++) {
                n = (n * 1103 + 12345) % 65536
                clear = n / 65536
                up = sin((h - 6.5) * 3.14159265 / 12) * (0.65 - 0.35 * cos((m - 0.5) * 0.5236))
                lit = up > 0.05 && d % 5 == 0
                printf "%d,%d,%d,%d,0,?,10,7.5,84,101000,0,0,315,%d,%d,%d,0,0,0\n", 2001,
                    m, d, h, lit ? 9999 : 0, lit ? 800 * clear * up : 0,
                    lit ? 60 + 300 * (1 - clear) * up : 0
            }
}' >"$scratch/year.epw"

plan='<plan width="4" depth="6" height="3"/>'
points='<point x="0.6" y="0.9"/><point x="2.1" y="2.8"/><point x="3.3" y="5.1"/></room>'
cat >"$scratch/office.xml" <<END
<room version="1" name="office">$plan
<window wall="south" left="0.5" sill="0.9" width="3" height="1.8"/>$points
END
cat >"$scratch/street.xml" <<END
<room version="1" name="street">$plan
<window wall="south" left="0.5" sill="0.9" width="3" height="1.8"/>
<block x="-20" y="-16" width="44" depth="4" height="9"/>$points
END
cat >"$scratch/corner.xml" <<END
<room version="1" name="corner" north="30">$plan
<window wall="south" left="0.5" sill="0.9" width="2" height="1.5" glazing="clear-double"/>
<window wall="west" left="1" sill="1.1" width="1.2" height="1.2"/>$points
END

for room in office street corner; do
    "$pepperpot" annual -q --samples 512 --seed 4242 -f csv -w "$scratch/year.epw" \
        "$scratch/$room.xml" >"$scratch/$room.truth"
    seed=1
    while [ $seed -le $seeds ]; do
        "$pepperpot" annual -q --samples 32 --seed $seed -f csv -w "$scratch/year.epw" \
            "$scratch/$room.xml" | tail -n +2
        seed=$((seed + 1))
    done >"$scratch/$room.csv"
done

# Columns of values are followed by those of their standard errors. Figures without sampling
# (direct sun) are excluded.
for room in office street corner; do
    awk -F, -v room=$room '
        NR == FNR && FNR == 1 { for (i = 7; i < NF; i += 2) name[i] = $i }
        NR == FNR { for (i = 7; i < NF; i++) truth[FNR - 1, i] = $i; lines = FNR - 1; next }
        {
            line = (FNR - 1) % lines + 1
            for (i = 7; i + 1 < NF; i += 2) {
                error = sqrt($(i + 1) ^ 2 + truth[line, i + 1] ^ 2)
                off = $i - truth[line, i]
                if (error == 0)
                    continue
                n[i]++
                one[i] += off * off < error * error
                two[i] += off * off < 4 * error * error
            }
        }
        END {
            for (i = 7; i in name; i += 2)
                if (n[i])
                    printf "%s %s %d %.1f %.1f\n", room, name[i], n[i],
                        100 * one[i] / n[i], 100 * two[i] / n[i]
        }' "$scratch/$room.truth" "$scratch/$room.csv"
done >"$scratch/table"
sed 's/^/# /' "$scratch/table"
awk '{ n += $3; one += $3 * $4; two += $3 * $5 }
    END { printf "%d figures, %.1f %% within one standard error, %.1f %% within two\n", n,
        one / n, two / n }' "$scratch/table" >"$scratch/all"
sed 's/^/# /' "$scratch/all"
check "64 to 74 % within one standard error" \
    awk '{ exit !($3 >= 64 && $3 <= 74) }' "$scratch/all"
check "92 to 97 % within two" awk '{ exit !($9 >= 92 && $9 <= 97) }' "$scratch/all"
tap_done
