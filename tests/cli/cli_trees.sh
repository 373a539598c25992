#!/bin/sh
# Trees and light shelves: four engines agree, hand methods give values or reasons, and
# exports and drawings show the crowns.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

room() {
    cat <<END
<room version="1"><site><tree x="2" y="-4" height="9" crown-base="2" crown-width="6"
transmittance="0.25" winter-transmittance="0.6"/></site>
<plan width="4" depth="5" height="2.8"/>
<window wall="south" left="0.9" sill="0.8" width="2.2" height="1.5" glazing="none"/>
<point x="2" y="1"/><point x="2" y="3.5"/></room>
END
}
room >"$scratch/tree.xml"

# engine NAME: daylight factors and standard errors of the points.
engine() {
    "$pepperpot" df --quiet --simulate --engine "$1" --samples "$2" --format csv \
        "$scratch/tree.xml" | awk -F, '$2 != "room" && $10 == "df" && $12 != "" && $3 == "point" { print $12, $13 }'
}
engines_agree() {
    engine path 512 >"$scratch/path"
    [ "$(wc -l <"$scratch/path")" -eq 2 ] || return 1
    for name in plain cache photons; do
        engine $name 512 >"$scratch/other"
        paste -d' ' "$scratch/path" "$scratch/other" | awk '
            { d = $1 - $3; s = sqrt($2 ^ 2 + $4 ^ 2 + (0.004 * $1) ^ 2) }
            d > 4 * s || d < -4 * s || NF != 4 { print; wrong = 1 }
            END { exit wrong || NR != 2 }' || return 1
    done
}
hand_methods_refuse() {
    run df "$scratch/tree.xml"
    [ $status -eq 0 ] && grep -q 'does not cover trees' "$scratch/out" &&
        grep -q '1 tree, with leaves' "$scratch/out" || told
}
exported() {
    run export --to radiance -o "$scratch/rad" "$scratch/tree.xml"
    [ $status -eq 0 ] && [ "$(grep -c '^tree polygon' "$scratch/rad/outside.rad")" -eq 14 ] || told
}

# A shelf as deep as the room hides the window above it: a point below has the sky
# component of the lower window.
shelf_room() {
    cat <<END
<room version="1"><plan width="4" depth="5" height="2.8"/>
<window wall="south" left="0.9" sill="0.8" width="2.2" height="$1" glazing="none">$2</window>
<point x="2" y="1"/><point x="2" y="2.5"/></room>
END
}
sky_components() {
    "$pepperpot" df --quiet -m exact --format csv "$1" |
        awk -F, '$10 == "sc" && $3 == "point" { printf "%.6f ", $12 }'
}
shelf_hides() {
    shelf_room 1.7 '<shelf height="1.1" depth="0" inside="4.9" left="0.8" right="0.8"/>' \
        >"$scratch/shelf.xml"
    shelf_room 1.1 '' >"$scratch/low.xml"
    [ "$(sky_components "$scratch/shelf.xml")" = "$(sky_components "$scratch/low.xml")" ] &&
        [ "$(sky_components "$scratch/low.xml")" = "10.052985 1.214537 " ]
}

left_out() {
    run assess --by-hand "$scratch/tree.xml"
    tr '\n' ' ' <"$scratch/out" | tr -s ' ' | grep -q \
        'Trees are left out of: Vertical sky component;.*The tree in line 1 rises to 82.*W1, south' ||
        told
}
left_out_json() {
    run assess --by-hand -c vsc,nsl,average -f json "$scratch/tree.xml"
    tr -d ' \n' <"$scratch/out" | grep -q \
        '"trees_left_out":{"criteria":\["vertical-sky","no-sky-line"\],"line":1,"altitude":82.3' || told
}
not_left_out() {
    run assess --by-hand -c average "$scratch/tree.xml"
    [ $status -eq 0 ] && ! grep -q 'left out' "$scratch/out" || told
}

left_out_table() {
    {
        echo '<building version="1">'
        sed 's/ version="1"/ name="Den"/' "$scratch/tree.xml"
        echo '<room name="Hall" x="9"><plan width="3" depth="3" height="2.6"/>' \
            '<window wall="south" left="1" sill="1" width="1" height="1"/></room></building>'
    } >"$scratch/two.xml"
    run assess --by-hand --table "$scratch/two.xml"
    tr '\n' ' ' <"$scratch/out" | tr -s ' ' | grep -q \
        'Trees are left out of: .*The tree in line 2 rises to 82 .*W1, south, of the room Den' ||
        told
    run assess --by-hand --table -f json "$scratch/two.xml"
    tr -d ' \n' <"$scratch/out" | grep -q '"room":"Den","line":2,"altitude":82.3' || told
}

check "assess names the criteria that leave trees out" left_out
check "in JSON, too" left_out_json
check "a table names the room" left_out_table
check "no criterion that takes account of trees" not_left_out
check "four engines agree on the light through a crown" engines_agree
check "hand methods state why they give no value" hand_methods_refuse
check "radiosity refuses trees" refuses 1 "the site has trees" \
    df --simulate --engine radiosity "$scratch/tree.xml"
check "an export has the faces of the crown" exported
check "a section shows the crown" quietly chart section --quiet --simulate --samples 16 \
    -o "$scratch/s.svg" "$scratch/tree.xml"
check "an inner shelf hides the window above it" shelf_hides

tap_done
