#!/bin/sh
# compare_causes_radiance.sh PROGRAM - the causes that `PROGRAM compare` names for values by
# Radiance's rtrace with poor settings in one room, and the part of the difference that disappears
# when the settings are corrected, as lines of Markdown. Takes some minutes. If Radiance is not on
# PATH, it only prints a note.
set -eu
LC_ALL=C
export LC_ALL

if [ $# -lt 1 ]; then
    echo "usage: compare_causes_radiance.sh PROGRAM" >&2
    exit 2
fi
pepperpot=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
if ! command -v rtrace >/dev/null || ! command -v oconv >/dev/null ||
    ! command -v gensky >/dev/null; then
    echo "Radiance's oconv, rtrace and gensky are not on PATH: nothing is compared with them."
    exit 0
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
RAYPATH=.${RAYPATH:+:$RAYPATH}
export RAYPATH

cat >"$scratch/room.xml" <<'XML'
<room version="1" name="Single"><site ground-reflectance="0.3"/>
<plan width="3.6" depth="5.4" height="2.8"/>
<finishes floor="0.3" walls="0.6" ceiling="0.8"/>
<window wall="south" left="0.6" sill="0.9" width="2.4" height="1.5" glazing="clear-single"/>
<block x="-20" y="-22" width="44" depth="10" height="9" reflectance="0.3"/>
<working-plane height="0.8"/><grid spacing="0.9" margin="0.4"/></room>
XML
"$pepperpot" export --to radiance -q -o "$scratch/scene" "$scratch/room.xml"
cd "$scratch/scene"
horizontal=$(sed -n 's/^horizontal=\([0-9.]*\).*/\1/p' daylight_factors.sh)

# The scene as front ends write it: a glass by its transmissivity, a sky by gensky, a ground
# that glows.
pane() {
    printf 'void glass front_pane 0 0 3 %s %s %s\nfront_pane polygon front_glass 0 0 12\n' \
        "$1" "$1" "$1"
    echo '3 0 .9  .6 0 .9  .6 0 2.4  3 0 2.4'
}
sky() {
    echo "!gensky 3 21 12 $1 -B $horizontal -g 0.3"
    echo 'skyfunc glow front_sky 0 0 4 1 1 1 0'
    echo 'front_sky source front_above 0 0 4 0 0 1 180'
    echo 'front_sky source front_below 0 0 4 0 0 -1 180'
}
pane 0.9802 >right_glass.rad # transmittance 0.90
pane 0.9000 >wrong_glass.rad # the transmittance in place of the transmissivity
sky -c >gensky.rad
sky -u >uniform.rad
awk '/^ground /{ exit } { print }' outside.rad >blocks.rad
awk '{ $3 = 0.0005; print }' points.pts >floor.pts

# values OPTIONS POINTS FILES: values by rtrace as CSV, at the points of the working plane.
values() {
    options=$1
    points=$2
    shift 2
    oconv -r 131072 materials.rad room.rad "$@" >scene.oct
    echo x,y,z,df_percent
    # shellcheck disable=SC2086 # options are several words
    rtrace -h -w -I -dt 0 -lr 0 -as 0 -aa 0 -lw 1e-6 -ad 4096 $options scene.oct <"$points" |
        awk -v h="$horizontal" '{ print 100 * (0.265 * $1 + 0.670 * $2 + 0.065 * $3) / h }' |
        paste -d' ' points.pts - | awk '{ print $1 "," $2 "," $3 "," $7 }'
}

# number KEY: this number of the last comparison.
number() {
    sed -n "s/^ *\"$1\": \([-0-9.e]*\),*/\1/p" found.json
}

# The difference that remains with correct settings.
values "-ab 12" points.pts right_glass.rad outside.rad sky.rad >right.csv
"$pepperpot" compare -q -f json "$scratch/room.xml" right.csv >found.json
right=$(number difference-rms)

echo "| rtrace | off ours, % | named | left when it is taken in, % | left when it is set right, % |"
echo "| --- | --- | --- | --- | --- |"
# poor WHAT OPTIONS POINTS FILES
poor() {
    what=$1
    shift
    values "$@" >poor.csv
    "$pepperpot" compare -q -f json "$scratch/room.xml" poor.csv >found.json
    named=$(sed -n 's/"switches": ""/"switches": "nothing"/; s/.*"switches": "\([^"]*\)", "probability": \([0-9.]*\).*/\1 \2/p' \
        found.json | head -n 2 | awk '{ printf "%s%s (%.2f)", (NR > 1 ? ", or " : ""), $1, $2 }')
    printf '| %s | %.1f | %s | %.1f | %.1f |\n' "$what" "$(number difference-rms)" "$named" \
        "$(number left-rms)" "$right"
}
poor "-ab 2" "-ab 2" points.pts right_glass.rad outside.rad sky.rad
poor "-ab 3" "-ab 3" points.pts right_glass.rad outside.rad sky.rad
poor "transmittance as transmissivity" "-ab 12" points.pts wrong_glass.rad outside.rad sky.rad
poor "both" "-ab 3" points.pts wrong_glass.rad outside.rad sky.rad
poor "gensky -c with its ground" "-ab 12" points.pts right_glass.rad blocks.rad gensky.rad
poor "the same, -ab 3" "-ab 3" points.pts right_glass.rad blocks.rad gensky.rad
poor "gensky -u with its ground" "-ab 12" points.pts right_glass.rad blocks.rad uniform.rad
poor "points on the floor, -ab 4" "-ab 4" floor.pts right_glass.rad outside.rad sky.rad
poor "nothing outside" "-ab 12" points.pts right_glass.rad sky.rad
poor "-ad 64" "-ab 12 -ad 64" points.pts right_glass.rad outside.rad sky.rad
