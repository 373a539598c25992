#!/bin/sh
# year_methods.sh PROGRAM FOLDER [EPW ...] - errors of the hand methods for the year against the
# simulated year, in 12 rooms of four orientations each: rooms 1 to 8 for fits, 9 to 12 held out.
# Writes FOLDER/year.csv, a line for each point, target and method, and prints the tables of
# docs/methods/year-by-hand.md and the constants of the rule; FOLDER/ranges.csv has the rows of
# tables/year_ranges.csv. Seven minutes of processor time. With FOLDER/year.csv in place only the
# tables are made.
set -eu
LC_ALL=C
export LC_ALL

if [ $# -lt 2 ]; then
    echo "usage: year_methods.sh PROGRAM FOLDER [EPW ...]" >&2
    exit 2
fi
pepperpot=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
folder=$2
here=$(cd "$(dirname "$0")" && pwd)
shift 2
mkdir -p "$folder"

# One room, as its number determines it, turned so that its window wall faces `bearing`.
room() {
    ${AWK:-awk} -v room="$1" -v bearing="$2" 'function chance() {
        state = state * 16807 % 2147483647
        return state / 2147483647
    }
    function between(low, high) { return low + (high - low) * chance() }
    BEGIN {
        state = 7919 * room + 1
        for (i = 0; i < 9; i++) chance()
        w = between(2.8, 7); d = between(4, 9); h = between(2.6, 3.4); s = between(.4, 1.1)
        ww = w * between(.35, .95); wh = (h - s) * between(.6, .95)
        printf "<room version=\"1\" name=\"%d\" north=\"%g\"><site ground-reflectance=\"%.2f\"/>\n",
            room, (bearing + 180) % 360, between(.1, .3)
        printf "<plan width=\"%.2f\" depth=\"%.2f\" height=\"%.2f\"/>\n", w, d, h
        printf "<finishes floor=\"%.2f\" walls=\"%.2f\" ceiling=\"%.2f\"/>\n", between(.1, .4),
            between(.3, .7), between(.6, .85)
        printf "<window wall=\"south\" left=\"%.2f\" sill=\"%.2f\" width=\"%.2f\" height=\"%.2f\" ",
            (w - ww) / 2, s, ww, wh
        printf "transmittance=\"%.2f\" maintenance=\"%.2f\"/>\n", between(.55, .85), between(.8, 1)
        if (chance() < .4)
            printf "<skyline wall=\"south\" angle=\"%.0f\" reflectance=\"%.2f\"/>\n", between(10, 30),
                between(.15, .4)
        printf "<working-plane height=\"0.8\"/>\n<line from=\"%.3f %.3f\" to=\"%.3f %.3f\" points=\"8\"/></room>\n",
            w * .47, d / 16, w * .47, d * 15 / 16
    }'
}

# Lines of the weather file $1 with the number $2: hours outside, then all rooms.
year() {
    room 1 180 >"$folder/room.$2.xml"
    "$pepperpot" annual -q --samples 16 --points 1,1 -w "$1" --hourly "$folder/hours.$2.csv" \
        -o "$folder/unused.$2.txt" "$folder/room.$2.xml"
    number=0
    while [ $number -lt 12 ]; do
        number=$((number + 1))
        for bearing in 180 90 0 270; do
            room $number $bearing >"$folder/room.$2.xml"
            nice -n 10 "$pepperpot" annual -q -j 1 --samples 32 -m all -i 200,300,500,750 -w "$1" \
                -f csv "$folder/room.$2.xml" | ${AWK:-awk} -F, -v climate="$2" -v bearing=$bearing '
                NR == 1 { for (i = 1; i <= NF; i++) { sub("\r", "", $i); name[i] = $i; at[$i] = i }; next }
                $3 == "point" {
                    for (i in name)
                        if (name[i] ~ /\.da[0-9]+$/) {
                            m = name[i]; target = m
                            sub(/\.da[0-9]+$/, "", m); sub(/.*\.da/, "", target)
                            printf "%s,%d,%s,%d,%s,%s,%s,%.4f,%.4f,%.4f,%.4f,%.1f,%.1f\n", climate, $2,
                                bearing, NR - 1, $at["df"], target, m, $i, $at["da" target],
                                $at[m ".udi-good"], $at["udi-good"], $at[m ".mean-lux"], $at["mean-lux"]
                        }
                }'
        done
    done >"$folder/part.$2.csv"
}

if [ ! -f "$folder/year.csv" ]; then
    climate=0
    for epw; do
        climate=$((climate + 1))
        year "$epw" $climate &
        [ $((climate % 2)) -ne 0 ] || wait
    done
    wait
    { echo "climate,room,bearing,point,df,target,method,hand,true,udi,true_udi,mean,true_mean"
      cat "$folder"/part.*.csv; } >"$folder/year.tmp"
    mv "$folder/year.tmp" "$folder/year.csv"
fi
for part in ranges tables; do
    ${AWK:-awk} -v part=$part -f "$here/year_methods.awk" "$folder"/hours.[123].csv \
        "$folder/year.csv" >"$folder/$part.csv"
done
cat "$folder/tables.csv"
