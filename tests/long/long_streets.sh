#!/bin/sh
# Twelve streets, each as a skyline with a distance and as the long block in its place, by path
# tracer, irradiance cache, photons and radiosity; and by Radiance, if installed, with the exported
# skyline. STREETS="1 5": only these streets of the list.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/streets.sh"

# wall, distance, angle, reflectance, height of the room's own façade above it, further elements
list="
south 4.2 65 0.30 9 <site ground-reflectance='0.15'/>
south 6.5 55 0.70 12 <site ground-reflectance='0.3'/>
south 8.0 50 0.20 8
south 9.3 20 0.40 -
south 12.0 30 0.30 -
south 14.5 42 0.10 11 <site ground-level='-3.2'/>
south 18.0 15 0.50 4 <sky type='uniform'/>
south 25.0 35 0.25 15 <sky type='iso-12' sun-altitude='40' sun-bearing='140'/>
south 60.0 25 0.35 20
east 5.0 60 0.60 9
east 11.0 45 0.20 -
west 17.0 30 0.80 6 <sky type='iso-12' sun-altitude='25' sun-bearing='250'/>
"

if command -v rtrace >/dev/null && command -v oconv >/dev/null; then
    radiance=yes
else
    radiance=no
fi

# by_radiance FILE: the factors of the points as lines of `factors` named traced, each from 16
# runs.
by_radiance() {
    rm -rf "$scratch/scene"
    "$pepperpot" export -q --to radiance -o "$scratch/scene" "$1" || return 1
    awk '{ for (i = 0; i < 16; i++) print }' "$scratch/scene/points.pts" >"$scratch/points"
    mv "$scratch/points" "$scratch/scene/points.pts"
    "$scratch/scene/daylight_factors.sh" -ab 22 -lr 0 -ad 8192 -as 0 -aa 0 -lw 1e-7 |
        awk '{ sum += $4; squares += $4 * $4 }
        NR % 16 == 0 {
            mean = sum / 16
            print "traced", "point", mean, sqrt((squares / 16 - mean * mean) / 15)
            sum = squares = 0
        }'
}

number=0
printf '%s\n' "$list" | sed '/^$/d' >"$scratch/list"
while read -r wall distance angle reflectance up more; do
    number=$((number + 1))
    case " ${STREETS:-$number} " in *" $number "*) ;; *) continue ;; esac
    for kind in skyline block; do
        street $kind "$wall" "$distance" "$angle" "$reflectance" "$up" "$more" \
            >"$scratch/$kind.xml"
        factors path,cache,photons,radiosity 0.5% "$scratch/$kind.xml" >"$scratch/$kind"
    done
    what="$number, $wall window, $distance m, $angle degrees"
    check "$what: the skyline is the block in its place, by four engines" \
        agree "$scratch/skyline" "$scratch/block" 0.02
    if [ $radiance = no ]; then
        skip "$what: Radiance has the same" "Radiance is not installed"
        continue
    fi
    awk '$1 == "traced" && $2 != "average" { $2 = "point"; print }' "$scratch/skyline" \
        >"$scratch/points-traced"
    by_radiance "$scratch/skyline.xml" >"$scratch/points-radiance"
    check "$what: Radiance has the same" \
        agree "$scratch/points-traced" "$scratch/points-radiance" 0.02
done <"$scratch/list"
tap_done
