#!/bin/sh
# draw_all.sh PROGRAM OUT FORMAT ... - every chart of the rooms beside this script, into
# the folder OUT, in each of the formats pdf, svg, png. The rooms of a building are pages
# of one PDF, and files of their own in the other formats.
set -eu
program=$1
out=$2
shift 2
examples=$(dirname "$0")
mkdir -p "$out"

for file in "$examples"/*.xml; do
    name=$(basename "$file" .xml)
    for kind in section plan; do
        for format; do
            if [ "$format" != pdf ] && grep -q '<building' "$file"; then
                sed -n 's/.*<room name="\([^"]*\)".*/\1/p' "$file" | while read -r room; do
                    part=$(printf '%s' "$room" | tr 'A-Z ' 'a-z-')
                    "$program" chart "$kind" --simulate --quiet --room "$room" "$file" \
                        -o "$out/$name-$part-$kind.$format"
                done
            else
                "$program" chart "$kind" --simulate --quiet "$file" \
                    -o "$out/$name-$kind.$format"
            fi
        done
    done
done
