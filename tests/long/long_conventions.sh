#!/bin/sh
# Sixty rooms that say reveal, frame-factor, facade, skyline, overhang, fin, balcony and ground,
# against the same rooms written out in polygons, by light paths; every sixth by records of
# irradiance and photons, too. CONVENTIONS="3 9": these of them.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/streets.sh"

for number in ${CONVENTIONS:-$(seq 60)}; do
    engines=path
    [ $((number % 6)) -ne 0 ] || engines=path,cache,photons
    for written in no yes; do
        awk -v number="$number" -v written=$written -f "$srcdir/tests/lib/conventions.awk" \
            >"$scratch/$written.xml"
        factors $engines 0.2% "$scratch/$written.xml" >"$scratch/$written"
    done
    check "room $number is the one written out in polygons" \
        agree "$scratch/no" "$scratch/yes" 0.01
done
tap_done
