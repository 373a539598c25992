#!/bin/sh
# sky_sampling.sh PROGRAM [SAMPLES | PICTURES] - three ways to find the light of a photographed sky: by
# chance, as a cube of lamps, and by its bright parts. Two points and the working plane of a room
# of 4 x 6 m are simulated under two skies, an overcast one and a clear one with a measured sun,
# with SAMPLES paths (4096) in each of 16 randomisations on one processor. Prints, for each way,
# the daylight factors with their standard errors, the time, and the time for the standard error
# of the bright parts on the plane, relative to theirs. Two minutes of processor time. With
# PICTURES, a folder, it draws the room in the three ways instead, with 16 paths a pixel.
set -eu
LC_ALL=C
export LC_ALL

if [ $# -lt 1 ]; then
    echo "usage: sky_sampling.sh PROGRAM [SAMPLES | PICTURES]" >&2
    exit 2
fi
pepperpot=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
samples=${2:-4096}
pictures=
[ ! -d "$samples" ] || pictures=$(cd "$samples" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

cat >room.xml <<'ROOM'
<room version="1" name="Room under a photographed sky">
  <plan width="4" depth="6" height="3"/>
  <window wall="south" left="0.5" sill="0.9" width="3" height="1.8"/>
</room>
ROOM

# photograph FILE SKY: a fisheye picture of the open sky from high above the room.
photograph() {
    "$pepperpot" render --plain --samples 1 --from 2,3,400 --direction 0,0,1 --up 0,1,0 \
        --view angular --size 1024x1024 --sky "$2" -o "$1" room.xml >/dev/null 2>&1
}

# seconds: processor time that finished children have used so far.
seconds() {
    times >times
    awk -F'[ms ]' 'NR == 2 { print $1 * 60 + $2 }' times
}

# row NAME OPTIONS: simulates the room, and prints a line of the table.
row() {
    seconds >before
    "$pepperpot" df -s --samples "$samples" --threads 1 -m exact --points "1,1 3,5" \
        --format csv --sky "picture,$sky,sampling=$2" room.xml >row.csv 2>/dev/null
    seconds >after
    awk -F, -v name="$1" -v time="$(cat after)" -v before="$(cat before)" -v base="${base:-0}" '
        $10 == "df" && $11 == "traced" {
            value[$3 $5] = sprintf("%6.2f +- %4.2f", $12, $13)
            error = $3 == "average" ? $13 : error
        }
        END {
            seconds = time - before
            work = seconds * error ^ 2
            printf "%-24s %15s %15s %15s %7.1f %9.1f\n", name, value["point1"],
                value["point5"], value["average"], seconds, (base > 0 ? work / base : 1)
            print work >"work"
        }' row.csv
}

# table TITLE
table() {
    printf '\n%s\n%-24s %15s %15s %15s %7s %9s\n' "$1" "way" "DF at 1, 1 m, %" "at 3, 5 m" \
        "on the plane" "seconds" "relative"
    base=
    row "bright parts" bright
    base=$(cat work)
    row "4 lamps along an edge" lamps,lamps=4
    row "16 lamps along an edge" lamps,lamps=16
    row "64 lamps along an edge" lamps,lamps=64
    row "by chance" chance
}

photograph clear.hdr iso-12,35,170
if [ -n "$pictures" ]; then
    for way in chance lamps bright; do
        "$pepperpot" render --samples 16 --size 300x225 --exposure 6000 --quiet \
            --sky "picture,clear.hdr,illuminance=48000,sun-illuminance=60000,sun-altitude=35,\
sun-bearing=200,sampling=$way" -o "$pictures/sky-$way.png" room.xml
    done
    exit 0
fi
photograph overcast.hdr overcast
sky=overcast.hdr
table "overcast sky"
sky=clear.hdr,illuminance=14000
table "clear sky without its sun"
sky=clear.hdr,illuminance=48000,sun-illuminance=60000,sun-altitude=35,sun-bearing=170
table "clear sky with a measured sun"
