#!/bin/sh
# Exterior parts of placed rooms obstruct the other rooms like elements written out by hand.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
LC_ALL=C
export LC_ALL

below='<plan width="4.2" depth="5.3" height="2.7"/>
  <window name="W1" wall="south" left="0.9" sill="0.8" width="2.4" height="1.5"/>'
above='<plan width="4.2" depth="5.3" height="2.7"/>
  <window name="W2" wall="south" left="0.9" sill="0" width="2.4" height="2.1">
    <balcony depth="1.4" left="0.5" right="0.7" parapet="1.2"/>
  </window>'
cat >"$scratch/flats.xml" <<EOF
<building version="1" name="Flats">
<room name="Below" x="7" y="-2" z="0.4">$below</room>
<room name="Above" x="7" y="-2" z="3.5">$above
  <facade wall="south" left="3" right="2" up="6" down="0.4"/></room>
<room name="Opposite" x="13" y="-13" rotate="180">$below
  <facade wall="south" left="1.1" right="2.3" up="5.2" depth="0.35"/></room>
</building>
EOF
# In the axes of the lower room: the rooms as blocks, the part of the upper façade between the
# storeys and the part around it as two plates.
plate() {
    printf '<surface>'
    for corner; do
        printf '<vertex x="%s" y="%s" z="%s"/>' $(echo "$corner" | tr , ' ')
    done
    echo '</surface>'
}
{
    echo "<room version='1' name='Below'><site ground-level='-0.4'/>$below"
    echo '<block x="0" y="0" base="3.1" width="4.2" depth="5.3" height="2.7"/>'
    echo '<block x="1.8" y="-16.3" base="-0.4" width="4.2" depth="5.3" height="2.7"/>'
    plate -0.5,-10.65,-0.4 7.1,-10.65,-0.4 7.1,-10.65,7.5 -0.5,-10.65,7.5
    plate 0.4,0,3.1 4,0,3.1 4,-1.4,3.1 0.4,-1.4,3.1
    plate 0.4,0,3.1 0.4,-1.4,3.1 0.4,-1.4,4.3 0.4,0,4.3
    plate 0.4,-1.4,3.1 4,-1.4,3.1 4,-1.4,4.3 0.4,-1.4,4.3
    plate 4,-1.4,3.1 4,0,3.1 4,0,4.3 4,-1.4,4.3
    echo '</room>'
} >"$scratch/alone.xml"
factors() {
    "$pepperpot" df -m exact+bre -f csv --points "0.7,0.9 1.8,3.7" "$@" |
        sed 1d | tr ',' '\n' | grep -E '^[0-9]+\.[0-9]{4,}$'
}
factors --room Below "$scratch/flats.xml" >"$scratch/a"
factors "$scratch/alone.xml" >"$scratch/b"
check "a room below a balcony has the figures of its plates written out" sh -c "
    paste '$scratch/a' '$scratch/b' |
        awk '{ d = \$1 - \$2; if (d > 1e-8 || -d > 1e-8) bad = 1; n++ } END { exit bad || n < 4 }'"
check "with and without the balcony" shows "without the overhangs and balconies of the window's own building" \
    assess --by-hand -c vsc --room Below "$scratch/flats.xml"
check "JSON has the figure without as a number" shows '"now-unshaded": ' \
    assess --by-hand -c vsc --room Below -f json "$scratch/flats.xml"
check "the room opposite has none of its own" gives assess --by-hand -c vsc --room Opposite "$scratch/flats.xml"
check "and no figure without" nothing "$(grep 'without the overhangs' "$scratch/out")"
check "simulation has them" gives df --simulate --error 10% -q --room Below "$scratch/flats.xml"
check "an exported scene has them" sh -c "
    '$pepperpot' export --to radiance --room Below '$scratch/flats.xml' -o '$scratch/scene' &&
        test \"\$(cat '$scratch'/scene/Below/outside.rad | grep -c polygon)\" -ge 20"
check "a plan of the site has them" sh -c "
    '$pepperpot' chart site '$scratch/flats.xml' -o '$scratch/site.svg' && test -s '$scratch/site.svg'"
sed 's/right="0.7"/right="7"/; s/x="13" y="-13" rotate="180"/x="12" y="-3" z="3.2"/' \
    "$scratch/flats.xml" >"$scratch/through.xml"
check "a balcony that goes through a room" refuses 1 'balcony: intersects a' \
    df "$scratch/through.xml"

# Light from the house opposite, reduced where its window is darker than its wall.
sed 's/name="Flats"/& glass-reflectance="0.2"/' "$scratch/flats.xml" >"$scratch/same.xml"
sed 's/name="Flats"/& glass-reflectance="0.05"/; s/right="2.3" up="5.2" depth="0.35"/reflectance="0.2"/' \
    "$scratch/flats.xml" >"$scratch/dark.xml"
sed 's/"0.05"/"0.2"/' "$scratch/dark.xml" >"$scratch/wall.xml"
factors --room Below "$scratch/same.xml" >"$scratch/b"
check "panes like the wall are the wall" sh -c "
    paste '$scratch/a' '$scratch/b' |
        awk '{ d = \$1 - \$2; if (d > 1e-7 || -d > 1e-7) bad = 1; n++ } END { exit bad || n < 4 }'"
reflected() {
    "$pepperpot" df -m exact -f csv --points 2.1,0.7 --room Below "$1" |
        sed -n 's/.*,erc,exact,\([0-9.]*\),.*/\1/p' | head -n 1
}
check "dark ones give less light, but not none" sh -c '
    awk -v d="$1" -v w="$2" "BEGIN { exit !(d < w - 1e-4 && d > 0) }"' sh \
    "$(reflected "$scratch/dark.xml")" "$(reflected "$scratch/wall.xml")"
echo '<building version="1" glass-reflectance="2"/>' >"$scratch/bright.xml"
check "more than all is refused" refuses 1 'glass-reflectance is "2"' df "$scratch/bright.xml"
tap_done
