#!/bin/sh
# Rooms with physically rough and patterned materials: df, render, export.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

room=$scratch/copper.xml
cat >"$room" <<'END'
<room version="1" name="Copper">
  <material name="copper" n="0.21 1.04 1.18" k="3.67 2.59 2.40" roughness="0.28"
            correlation-length="1.77"/>
  <plan width="4" depth="6" height="3"/>
  <finishes floor="#copper"/>
  <window wall="south" left="0.5" sill="0.9" width="3" height="1.8" glazing="none"/>
  <point x="2" y="5"/>
</room>
END
check "df prints a material and its loss" shows \
    "copper reflects 0.641, and loses 8.7 % by roughness" df "$room"
sed 's/#copper/0.6407/' "$room" >"$scratch/matt.xml"
hand() { "$pepperpot" df --format csv "$1" | grep ',df,exact+bre' | cut -d, -f4-; }
check "hand methods take its diffuse reflectance" sh -c \
    "test '$(hand "$room" | cut -c-12)' = '$(hand "$scratch/matt.xml" | cut -c-12)'"

# The floor reflects the light of the window towards the back of the room, unlike a matt floor:
# cache and photons agree with the path tracer within 6 %.
check "df simulates it with three engines" gives df -s --engine path,cache,photons \
    --error 2% --format csv "$room"
cp "$scratch/out" "$scratch/rough"
factors() { awk -F, -v m="$1" '$3 == "point" && $10 == "df" && $11 == m { print $12 }' "$2"; }
"$pepperpot" df -s --error 2% --format csv "$scratch/matt.xml" >"$scratch/matt"
check "which agree" sh -c "echo '$(factors traced "$scratch/rough") $(factors cached "$scratch/rough") $(factors photons "$scratch/rough")' |
    awk '{ exit !(\$2 > 0.94 * \$1 && \$2 < 1.06 * \$1 && \$3 > 0.94 * \$1 && \$3 < 1.06 * \$1) }'"
check "and are brighter than a matt floor" sh -c "echo '$(factors traced "$scratch/rough") $(factors traced "$scratch/matt")' |
    awk '{ exit !(\$1 > 1.05 * \$2) }'"
check "any number of threads gives the same" same_by_threads "1 2" \
    df -s --samples 16 --format csv "$room"
check "render draws it" quietly render --size 40x30 --samples 4 "$room" -o "$scratch/copper.hdr"
check "--gloss exports it as metal" "$pepperpot" export --to radiance --gloss \
    -o "$scratch/gloss" "$room"
check "with the slopes of its facets as roughness" \
    grep -q "^5 [0-9. ]* 1 0.316" "$scratch/gloss/materials.rad"
check "and a comment" grep -q "# A gloss in place of a physically rough surface" \
    "$scratch/gloss/materials.rad"
"$pepperpot" export --to radiance --gloss --force -o "$scratch/gloss" "$room" 2>"$scratch/err"
check "losses are reported" grep -q "its spike, and the change" "$scratch/err"
sed -e 's/n="0.21 1.04 1.18" k="3.67 2.59 2.40"/n="1.5" diffuse="0.9"/' "$room" \
    >"$scratch/varnish.xml"
check "--gloss exports varnish on paint as plastic" "$pepperpot" export --to radiance \
    --gloss --force -o "$scratch/gloss" "$scratch/varnish.xml"
check "whose colour is at most 1" sh -c "grep -A 3 ' plastic floor' '$scratch/gloss/materials.rad' |
    awk 'NR == 4 { found = \$2 > 0.9 && \$2 <= 1 && \$5 > 0 && \$5 < 0.1 } END { exit !found }'"
# A light pipe: a shaft of mirrors hides no sky, whose luminance depends on the altitude only. A
# reflection loses up to 0.2 %, and the point beside the shaft sees five of them.
pipe() { # walls of the shaft above the rooflight
    cat <<END
<room version="1"><plan width="4" depth="5" height="2.8"/>
<material name="mirror" n="0.01" k="20" roughness="0.001" correlation-length="1"/>
<rooflight x="1.8" y="2.3" width="0.4" depth="0.4" glazing="none"/>
$1<point x="2" y="2.5"/><point x="2" y="1"/></room>
END
}
wall() { # X1 Y1 X2 Y2
    for corner in "$1 $2 2.8" "$3 $4 2.8" "$3 $4 4.8" "$1 $2 4.8"; do
        echo "$corner" | awk '{ printf "<vertex x=\"%s\" y=\"%s\" z=\"%s\"/>", $1, $2, $3 }'
    done | sed 's/^/<surface reflectance="#mirror">/; s/$/<\/surface>/'
}
pipe "" >"$scratch/hole.xml"
pipe "$(wall 1.8 2.3 2.2 2.3 && wall 2.2 2.3 2.2 2.7 && wall 2.2 2.7 1.8 2.7 &&
    wall 1.8 2.7 1.8 2.3)" >"$scratch/pipe.xml"
"$pepperpot" df -s --samples 16 --format csv "$scratch/hole.xml" >"$scratch/hole"
"$pepperpot" df -s --samples 16 --format csv "$scratch/pipe.xml" >"$scratch/pipe"
passes() {
    { factors traced "$scratch/hole"; factors traced "$scratch/pipe"; } | tr '\n' ' ' | awk '
        { print } END { exit !(NF == 4 && $3 > 0.98 * $1 && $3 < 1.003 * $1 &&
            $4 > 0.97 * $2 && $4 < 1.005 * $2) }'
}
check "a shaft of mirrors passes the light of a rooflight" passes
same() { # 40 materials with the same optics; only the name differs
    sed -n 1p "$room"
    for i in $(seq 40); do sed -n 2,3p "$room" | sed "s/\"copper\"/\"m$i\"/"; done
    sed '1,3d; s/#copper/#m1/' "$room"
}
same >"$scratch/many.xml"
check "a file has at most 32 materials" refuses 1 "more than 32 materials" df "$scratch/many.xml"
sed '66,81d' "$scratch/many.xml" >"$scratch/most.xml"
check "and may have 32" shows "m32 reflects 0.641" df "$scratch/most.xml"
check "an unknown material is refused" refuses 1 "or # and the name of a <material>" \
    df --set finishes.floor="#zinc" "$room"
check "a material's attribute can be set" shows "and loses 0.0 % by roughness" \
    df --set material.copper.roughness=0.01 "$room"
# A chequer of 0.2 and 0.6, and a pattern that is 1/2 everywhere, on a matt floor.
patterned() { # PATTERN
    sed -e '/<material/,/>/d' -e "s|<plan|<material name=\"tiles\" diffuse=\"0.6\" pattern=\"$1\"/>&|" \
        -e 's/#copper/#tiles/' "$room"
}
patterned "1 - 2/3 mod(floor(x / 0.5) + floor(y / 0.5), 2)" >"$scratch/tiles.xml"
check "df prints the mean of a pattern" shows "tiles reflects 0.6, 0.4 on average with its pattern" \
    df "$scratch/tiles.xml"
patterned 0.5 >"$scratch/half.xml"
sed 's/#copper/0.3/' "$room" | sed '/<material/,/>/d' >"$scratch/plain.xml"
values() { "$pepperpot" df -s --samples 16 --format csv "$scratch/$1.xml" | cut -d, -f2-; }
values half >"$scratch/half"
values plain >"$scratch/plain"
check "a constant pattern changes nothing" cmp "$scratch/half" "$scratch/plain"
check "render draws a pattern" quietly render --size 40x30 --samples 4 "$scratch/tiles.xml" \
    -o "$scratch/tiles.hdr"
"$pepperpot" export --to radiance -o "$scratch/tiles" "$scratch/tiles.xml" 2>"$scratch/err"
check "export gives its mean" grep -q "with the mean of its reflectance" "$scratch/err"
check "export gives the mean to Radiance" grep -q "^5 0.\(40\|39\)" "$scratch/tiles/materials.rad"
# A floor with bumps like a saw of slope 0.7, and the same floor with true facets. The model's
# facets are evenly lit, those of a true saw are brighter near their crests.
saw() { # finish of the floor, and SURFACES
    cat <<END
<room version="1"><material name="saw" diffuse="0.8" bump="0.7 mod(y, 0.1)"/>
<plan width="4" depth="6" height="3"/><finishes floor="$1" walls="0.5" ceiling="0.7"/>
<window wall="south" left="0.5" sill="0.9" width="3" height="1.8" glazing="none"/>
$2<point x="2" y="5" z="1"/></room>
END
}
facets=$(awk 'BEGIN { for (k = 0; k < 60; k++) {
    a = k / 10 + 0.0001; b = a + 0.0998; low = 0.001; high = 0.071
    facet(a, low, b, high); facet(b, low, b, high) } }
    function facet(y1, z1, y2, z2) {
        printf "<surface reflectance=\"0.8\">"
        corner(0.001, y1, z1); corner(3.999, y1, z1); corner(3.999, y2, z2); corner(0.001, y2, z2)
        print "</surface>" }
    function corner(x, y, z) { printf "<vertex x=\"%g\" y=\"%g\" z=\"%g\"/>", x, y, z }')
saw "#saw" "" >"$scratch/saw.xml"
saw 0.8 "" >"$scratch/flat.xml"
saw 0.8 "$facets" >"$scratch/facets.xml"
check "df prints the reflectance of bumps for diffuse light" shows \
    "saw reflects 0.8, 0.678 on average with its bumps" df "$scratch/saw.xml"
traced() { "$pepperpot" df -s --error 0.7% --format csv "$scratch/$1.xml" >"$scratch/$1"
    factors traced "$scratch/$1"; }
acts_as_a_saw() {
    echo "$(traced saw) $(traced facets) $(traced flat)" | awk '{ print }
        END { exit !($1 > 0.96 * $2 && $1 < 1.05 * $2 && $3 > 1.12 * $2) }'
}
check "bumps darken the room as a true saw does, within 5 %" acts_as_a_saw
check "three engines simulate bumps" gives df -s --engine path,cache,photons --error 1% \
    --format csv "$scratch/saw.xml"
cp "$scratch/out" "$scratch/engines"
check "and agree" sh -c "echo '$(factors traced "$scratch/engines") $(factors cached "$scratch/engines") $(factors photons "$scratch/engines")' |
    awk '{ exit !(\$2 > 0.96 * \$1 && \$2 < 1.04 * \$1 && \$3 > 0.96 * \$1 && \$3 < 1.04 * \$1) }'"
check "any number of threads gives the same with bumps" same_by_threads "1 2" \
    df -s --samples 16 --format csv "$scratch/saw.xml"
sed 's/0.7 mod(y, 0.1)/7/' "$scratch/saw.xml" >"$scratch/level.xml"
values level >"$scratch/level"
values flat >"$scratch/flat"
mean_of() { awk -F, '$2 == "point" && $9 == "df" && $10 == "traced" { print $11 }' "$1"; }
check "a constant height is a flat surface" sh -c \
    "echo '$(mean_of "$scratch/level") $(mean_of "$scratch/flat")' |
    awk '{ exit !(NF == 2 && \$1 > 0.97 * \$2 && \$1 < 1.03 * \$2) }'"
check "render draws bumps" quietly render --size 40x30 --samples 4 "$scratch/saw.xml" \
    -o "$scratch/saw.hdr"
"$pepperpot" export --to radiance -o "$scratch/saw-rad" "$scratch/saw.xml" 2>"$scratch/err"
check "export states that bumps are lost" \
    grep -q "each surface with a pattern or bumps is even in the scene" "$scratch/err"
check "bumps on a rough material are refused" refuses 1 "expected bumps only on a matt material" \
    df --set material.copper.bump=x "$room"
tap_done
