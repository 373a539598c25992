#!/bin/sh
# Runs commands on valid but unusual rooms (odd_rooms.awk) for two minutes: each ends with a
# result, or with a message; none crashes, takes more than two minutes, or prints "nan".
# tests/long/long_sanitizers.sh runs the same under clang's sanitizers. To create a room again:
#    awk -v folder=. -v room=17 -f tests/long/odd_rooms.awk
# SECONDS_MOST: duration; FIRST_ROOM: first room of the series.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

seconds=${SECONDS_MOST:-120}
room=${FIRST_ROOM:-1}
charts="plan section site elevation note waldram pepper-pot protractor nomogram brs-table
    vertical-sky skylight-indicator sun-path slats model-net availability"
kinds=$(echo "$charts" | wc -w)

# The commands, one per line; ROOM, OUT, POINT and YEAR are replaced by the room's file, an
# output without its extension, a point, and a weather file. Each room has another chart.
commands() {
    chart=$(echo $charts | cut -d ' ' -f $((1 + room % kinds)))
    of_point=
    case $chart in note | waldram | pepper-pot | protractor | brs-table) of_point="-p POINT" ;; esac
    cat <<LIST
df -m all -f json ROOM
df -m all -f csv ROOM
df -s --samples 2 -f csv ROOM
df --explain -p POINT ROOM
assess --by-hand -f json ROOM
assess --by-hand -f csv ROOM
chart $chart $of_point ROOM -o OUT.pdf
size --by-hand --target 2% -f json ROOM
validate -m exact+bre --samples 2 -f csv ROOM
export --to radiance ROOM -o OUT
availability --latitude 51 --illuminance 300 -f csv ROOM
LIST
    [ $((room % 4)) != 0 ] || echo "render --samples 1 --size 24x24 ROOM -o OUT.png
report --by-hand ROOM -o OUT.html
glare --samples 16 --sky overcast,20000 --view POINT,0 -f json ROOM"
    [ $((room % 4)) != 2 ] || echo "annual --weather YEAR --samples 2 --patches 145 -f csv -p POINT ROOM
chart year --weather YEAR --samples 2 ROOM -o OUT.pdf
chart en17037 --weather YEAR ROOM -o OUT.pdf"
}

# fault WORDS: runs a command; prints its fault, if any.
fault() {
    rm -rf "$scratch"/result*
    timeout 120 "$pepperpot" "$@" >"$scratch/out" 2>"$scratch/err" </dev/null
    status=$?
    case $status in
    0) grep -liE '(^|[^a-z])nan([^a-z]|$)' "$scratch/out" $(find "$scratch" -name 'result*' \
        -type f ! -name '*.png') | sed 's/.*/contains nan/' | head -n 1 ;;
    1) [ -s "$scratch/err" ] || echo "status 1 without a message" ;;
    2) grep -q 'expected --room NAME' "$scratch/err" || # of a building, for a picture
        echo "status 2: $(tail -n 1 "$scratch/err")" ;;
    124) echo "takes more than two minutes" ;;
    *) echo "status $status: $(tail -n 1 "$scratch/err")" ;;
    esac
}

# sweep: runs all commands on one room after another; prints faults. Sets valid and room.
sweep() {
    end=$(($(date +%s) + seconds))
    valid=0
    while [ "$(date +%s)" -lt $end ]; do
        point=$(awk -v folder="$scratch" -v room=$room -f "$srcdir/tests/long/odd_rooms.awk")
        "$pepperpot" df -m bre "$scratch/$room.xml" >/dev/null 2>&1 && valid=$((valid + 1))
        commands | sed "s|ROOM|$scratch/$room.xml|; s|OUT|$scratch/result|; s|POINT|$point|; s|YEAR|$scratch/year.epw|" \
            >"$scratch/commands"
        while read -r line && [ "$(date +%s)" -lt $end ]; do
            # shellcheck disable=SC2086 # words
            found=$(fault $line)
            [ -z "$found" ] || echo "room $room: ${line%% "$scratch"*}: $found"
        done <"$scratch/commands"
        rm -f "$scratch/$room.xml" "$scratch/$room-"*.obj
        room=$((room + 1))
    done
}

awk -f "$srcdir/tests/lib/clear_year.awk" >"$scratch/year.epw"
first=$room
sweep >"$scratch/faults"
check "no command fails on $((room - first)) rooms" nothing "$(cat "$scratch/faults")"
check "half of them are valid" test $((2 * valid)) -ge $((room - first))
tap_done
