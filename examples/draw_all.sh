#!/bin/sh
# draw_all.sh PROGRAM OUT FORMAT ... - every chart of the rooms beside this script, into
# the folder OUT, in each of the formats pdf, svg, png. CHART_OPTIONS may hold more
# options of the chart command.
set -eu
program=$1
out=$2
shift 2
mkdir -p "$out"

for room in "$(dirname "$0")"/*.xml; do
    for kind in section plan; do
        for format; do
            "$program" chart "$kind" --simulate --quiet ${CHART_OPTIONS-} "$room" \
                -o "$out/$(basename "$room" .xml)-$kind.$format"
        done
    done
done
