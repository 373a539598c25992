#!/bin/sh
# Sixty rooms that say reveal, frame-factor, facade, skyline, overhang, fin, balcony and ground,
# against the same rooms written out in polygons, by light paths; every sixth by records of
# irradiance and photons, too. CONVENTIONS="3 9": these of them.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/streets.sh"

# traced ENGINES ERROR: the factors of both ways to write the room.
traced() {
    for written in no yes; do
        awk -v number="$number" -v written=$written -f "$srcdir/tests/lib/conventions.awk" \
            >"$scratch/$written.xml"
        factors "$1" "$2" "$scratch/$written.xml" >"$scratch/$written"
    done
}

# same ENGINES: do both agree? Of so many values one in some hundred is off by chance: what
# differs at 0.2 % has to agree at 0.1 %.
same() {
    traced "$1" 0.2%
    agree "$scratch/no" "$scratch/yes" 0.01 && return
    traced "$1" 0.1%
    agree "$scratch/no" "$scratch/yes" 0.01
}

for number in ${CONVENTIONS:-$(seq 60)}; do
    engines=path
    [ $((number % 6)) -ne 0 ] || engines=path,cache,photons
    check "room $number is the one written out in polygons" same $engines
done
tap_done
