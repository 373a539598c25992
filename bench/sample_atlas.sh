#!/bin/sh
# sample_atlas.sh PEPPERPOT ATLAS.csv [EVERY [FROM]] - writes the complete rooms of an atlas as a
# file of traced rooms (tests/lib/traced_rooms.h) for fit_formulae: the room file and the points of
# every EVERYth room from number FROM on (default: all rooms).
pepperpot=$1
# A room is complete if it has the row of its average. Values in an atlas are in per cent.
awk -F, -v every="${3:-1}" -v from="${4:-0}" '
    /^#/ { next }
    !columns { for (i = 1; i <= NF; i++) at[$i] = i; columns = NF; next }
    NF != columns || $1 % every != from % every || $1 < from { next }
    { rows = rows "\n" sprintf("%s %.5g %.2g %.5g", $at["point"], $at["true.irc"] / 100,
                               $at["se.irc"] / 100, $at["true.df"] / 100) }
    $at["point"] == -1 { print $1 rows "\n"; rows = "" }' "$2" |
    while read -r number rest; do
        if [ -n "$rest" ]; then
            echo "$number $rest"
        elif [ -n "$number" ]; then
            echo "room $number"
            "$pepperpot" atlas --room "$number" || exit
        fi
    done
