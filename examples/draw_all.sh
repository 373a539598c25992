#!/bin/sh
# draw_all.sh PROGRAM OUT FORMAT ... - every chart of the rooms beside this script, into
# the folder OUT, in each of the formats pdf, svg, png; not those that are newer than
# their room and the program. CHART_OPTIONS may hold more options of the chart command.
set -eu
program=$1
out=$2
shift 2
mkdir -p "$out"

# The rooms of a building have a file each, but for PDF: the first stands for all.
is_drawn() {
    for file in "$1.$2" "$1-1.$2"; do
        [ "$file" -nt "$room" ] && [ "$file" -nt "$program" ] && return
    done
    return 1
}

for room in "$(dirname "$0")"/*.xml; do
    for kind in section plan; do
        for format; do
            chart=$out/$(basename "$room" .xml)-$kind
            is_drawn "$chart" "$format" ||
                "$program" chart "$kind" --simulate --quiet ${CHART_OPTIONS-} "$room" \
                    -o "$chart.$format"
        done
    done
done
