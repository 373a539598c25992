#!/bin/sh
# long_size_holds.sh [PROGRAM [ROOM ...]] - if size reports that its window meets a criterion,
# assess confirms it. Tests 20 of the ordinary rooms (tests/lib/ordinary_rooms.awk), or the rooms
# with these numbers, each for three requirements. Prints every size that is not confirmed, and the
# number of sizes found. About 15 minutes.
set -eu
LC_ALL=C
export LC_ALL
here=$(cd "$(dirname "$0")" && pwd)
pepperpot=${1:-./pepperpot}
[ $# -eq 0 ] || shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
[ $# -gt 0 ] || set -- 2 17 32 47 62 77 92 107 122 137 152 167 182 197 212 227 242 257 272 287
${AWK:-awk} -v folder="$scratch" -f "$here/../lib/ordinary_rooms.awk"

tried=0 reached=0 bad=0
for room; do
    # A place in London, for the median illuminance that the criteria need.
    sed 's/<site/<site latitude="51.5" longitude="-0.1" country="GB"/' \
        "$scratch/$room.xml" >"$scratch/room.xml"
    grep -q '<site' "$scratch/room.xml" ||
        sed -i 's/<plan/<site latitude="51.5" longitude="-0.1" country="GB"\/><plan/' \
            "$scratch/room.xml"
    for wanted in "uk-annex:bedroom" "uk-annex:living room" "en17037:minimum: 300"; do
        tried=$((tried + 1))
        rm -f "$scratch/sized.xml"
        "$pepperpot" size -q --for "$wanted" --write "$scratch/sized.xml" \
            "$scratch/room.xml" >"$scratch/said" 2>&1 || true
        [ -f "$scratch/sized.xml" ] || continue
        reached=$((reached + 1))
        "$pepperpot" assess -q -c "${wanted%%:*}" --format csv "$scratch/sized.xml" |
            grep ",${wanted#*:}" >"$scratch/found"
        if ! grep -q ',least,met,' "$scratch/found"; then
            bad=$((bad + 1))
            echo "room $room, $wanted: size says it is reached; assess:"
            cat "$scratch/found"
        fi
    done
done
echo "sizes asked for: $tried, reached: $reached, not met by assess: $bad"
[ "$reached" -gt 0 ] && [ "$bad" -eq 0 ]
