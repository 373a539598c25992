#!/bin/sh
# Drawings of a site: areas lit now and before, its plan, its elevations, sun paths.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
LC_ALL=C
export LC_ALL
site=$(cd "$srcdir/examples/sites" && pwd)/corner-house.xml

check "what is lit now and before" quietly chart plan --before existing --room Study "$site" \
    -o "$scratch/lit.pdf"
check "says the area that assess finds" says "$scratch/lit.pdf" "12.52 m"
check "and that before" says "$scratch/lit.pdf" "Before: 14.62 m"
awk '/<site /{ sub("/>", "><tree x=\"1\" y=\"-6\" height=\"7\" crown-width=\"4\" " \
    "transmittance=\"0.2\" state=\"existing\"/></site>") } 1' "$site" >"$scratch/tree.xml"
for kind in site elevation; do
    check "a $kind with a tree" quietly chart $kind "$scratch/tree.xml" --state existing \
        -o "$scratch/tree-$kind.pdf"
    check "explains its crown" says "$scratch/tree-$kind.pdf" "Crowns of trees are hatched"
done
check "a removed tree" quietly chart site --before existing "$scratch/tree.xml" -o "$scratch/tree.pdf"
check "is a dashed outline" says "$scratch/tree.pdf" "former trees are dashed outlines"
check "and in no elevation" quietly chart elevation --before existing "$scratch/tree.xml" \
    -o "$scratch/no-tree.pdf"
check "nor explained there" sh -c "! pdftotext '$scratch/no-tree.pdf' - 2>/dev/null |
    grep -q Crowns"
run chart site --before existing "$site" -o "$scratch/site.svg"
check "one dashed outline of the demolished shed, and its key" \
    sh -c "[ \$(grep -c stroke-dasharray '$scratch/site.svg') = 2 ]"
check "the sky factor's line too" quietly chart plan --before existing --line sky-factor \
    --room Study "$site" -o "$scratch/factor.pdf"
check "with its zones" says "$scratch/factor.pdf" "equivalent first zone 1.50 m"
check "the zones are in the criterion" shows "lost, as equivalent first zone" \
    assess --by-hand -c rights-of-light --room Study "$site"
check "a line without anything before" quietly chart plan --line sky-factor "$deep" \
    -o "$scratch/alone.pdf"
check "says no loss" sh -c "! command -v pdftotext >/dev/null ||
    ! pdftotext '$scratch/alone.pdf' - | grep -q -i 'before'"
sed '/name="Tower"/d; s/ state="existing"//' "$site" >"$scratch/old.xml"
check "before from another file the same" sh -c '
    "$1" chart plan --before "$3" --room Study "$2" -f svg >"$4/a" &&
    "$1" chart plan --before existing --room Study "$2" -f svg | cmp - "$4/a"' sh \
    "$pepperpot" "$site" "$scratch/old.xml" "$scratch"

for kind in site elevation; do
    for format in svg png pdf; do
        check "chart $kind as $format" quietly chart $kind "$site" -o "$scratch/$kind.$format"
    done
    check "$kind: one sheet for all rooms" test ! -e "$scratch/$kind-1.svg"
    check "of one room by itself" quietly chart $kind "$deep" -o "$scratch/one-$kind.svg"
done
check "each window's component" says "$scratch/elevation.pdf" "17.2"
check "and what it was" says "$scratch/elevation.pdf" "27.1"
check "what stands there, with its height" says "$scratch/site.pdf" "Tower, proposed"
for word in "W1" "Living room" "Study"; do
    check "the elevation names $word" says "$scratch/elevation.pdf" "$word"
    check "and the plan" says "$scratch/site.pdf" "$word"
done
check "a table has what does not fit its strip: existing" says "$scratch/site.pdf" "27.1"
check "and proposed" says "$scratch/site.pdf" "17.2"
check "elevations have names" says "$scratch/elevation.pdf" "South elevation, 190"
sed 's/name="Tower"/name="Proposed tower"/' "$site" >"$scratch/said.xml"
check "a building called proposed" quietly chart site "$scratch/said.xml" -o "$scratch/said.pdf"
check "is not called so twice" sh -c "! pdftotext '$scratch/said.pdf' - 2>/dev/null | grep -q 'ower, proposed'"
check "but is there" says "$scratch/said.pdf" "Proposed tower, 19 m"
check "two files have two sheets" sh -c '"$1" chart site "$2" "$3" -o "$4/two.svg" &&
    test -s "$4/two-1.svg" && test -s "$4/two-2.svg"' sh "$pepperpot" "$site" "$deep" "$scratch"

check "sun paths of a window" quietly chart sun-path --room Study --before existing "$site" \
    -o "$scratch/sun.pdf"
check "with its hours" says "$scratch/sun.pdf" "36.9 % of the annual"
check "by assess" gives assess --by-hand -c sunlight --room Study "$site"
check "the same" grep -qE 'W3, south, year +36.9 %' "$scratch/out"

sed 's|<room name="Living room"|<garden name="Lawn"><vertex x="0" y="-9"/><vertex x="8" y="-9"/>\
<vertex x="8" y="-1"/><vertex x="0" y="-1"/></garden>&|' "$site" >"$scratch/lawn.xml"
check "a garden in the table" gives assess --by-hand --for uk-planning --table "$scratch/lawn.xml"
check "once" test "$(grep -c '^ *Lawn ' "$scratch/out")" -eq 1
check "with its verdict" grep -qE '^ *Lawn +[0-9.]+ +[0-9.]+ +[0-9.]+ +met' "$scratch/out"
check "in its JSON" shows '"gardens": [' assess --by-hand -c gardens --table -f json \
    "$scratch/lawn.xml"
check "on the plan" quietly chart site "$scratch/lawn.xml" -o "$scratch/lawn.pdf"
check "with its share" says "$scratch/lawn.pdf" "Lawn 84"
check "a room without one has no such criterion" nothing \
    "$("$pepperpot" assess --by-hand "$deep" | grep -i garden)"

# The largest envelope on a plot: the heights in its plan are those of the CSV, and the window that
# limits it has a diagram.
check "an envelope" gives size --envelope Tower --highest 30 -f csv "$site" \
    --draw "$scratch/envelope.pdf"
check "drawn with its heights" says "$scratch/envelope.pdf" \
    "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "height") h = i }
        NR == 2 { printf "%.1f", $h }' "$scratch/out")"
check "on two sheets" sh -c "! command -v pdfinfo >/dev/null ||
    pdfinfo '$scratch/envelope.pdf' | grep -qE '^Pages: +2'"
check "the second of the window that decides" says "$scratch/envelope.pdf" "396 squares"
check "as SVG its plan" gives size --envelope Tower "$site" --draw "$scratch/envelope.svg"
check "with all cells" sh -c "grep -c '<path' '$scratch/envelope.svg' | awk '{ exit \$1 < 50 }'"
check "of a height nothing is drawn" refuses 2 "--draw is for --envelope only" \
    size --obstruction Tower --draw "$scratch/no.svg" "$site"
check "to what is no drawing" refuses 2 ".pdf, .svg or .png" \
    size --envelope Tower --draw "$scratch/no.txt" "$site"
check "a window to be sized has no envelope" refuses 2 "draw" \
    size --target 2% --draw "$scratch/no.svg" "$deep"

check "--before of a chart that compares nothing" refuses 2 "cannot compare two states" \
    chart section --before existing "$site" -o "$scratch/no.svg"
check "--line of another chart" refuses 2 "--line is for a plan only" \
    chart section --line no-sky "$deep" -o "$scratch/no.svg"
check "an unknown line" refuses 2 "no-sky or sky-factor" \
    chart plan --line grumble "$deep" -o "$scratch/no.svg"
check "before of a file without states" refuses 2 "no element in" \
    chart plan --before existing "$deep" -o "$scratch/no.svg"
check "another room before" refuses 1 "expected the same room" \
    chart plan --before "$examples/l-shaped.xml" "$deep" -o "$scratch/no.svg"
cat >"$scratch/top.xml" <<'EOF'
<room version="1"><plan width="4" depth="5" height="3"/>
  <rooflight x="1" y="1" width="1" depth="1"/></room>
EOF
# The name is in the title, but not on a wall that is entirely glazed.
sed '/<window/,/\/>/d; s|</room>|<window wall="south" left="0" sill="0" width="3" height="2.7"/></room>|' \
    "$deep" >"$scratch/glass.xml"
run chart elevation "$scratch/glass.xml" -o "$scratch/glass.pdf"
names() {
    ! command -v pdftotext >/dev/null || [ "$(words "$1" | grep -c "Deep office")" -eq "$2" ]
}
check "a room's name covers no window" names "$scratch/glass.pdf" 1
check "no upright window, no elevation" refuses 1 "the room has no vertical windows" \
    chart elevation "$scratch/top.xml" -o "$scratch/no.svg"
check "a site all the same" quietly chart site "$scratch/top.xml" -o "$scratch/top.svg"
sed 's/ latitude="[0-9.]*" longitude="[-0-9.]*"//' "$site" >"$scratch/nowhere.xml"
check "sun paths of no place" refuses 1 "expected a site with a latitude" \
    chart sun-path --room Study "$scratch/nowhere.xml" -o "$scratch/no.svg"
check "a window that is not there" refuses 1 "expected the name of a window" \
    chart sun-path --room Study --window attic "$site" -o "$scratch/no.svg"
check "nothing was written" test ! -e "$scratch/no.svg"

# Drawings and sizing use 1.6 m for a French window, as assess does.
cat >"$scratch/french.xml" <<'EOF'
<building version="1" name="French">
<block name="Tower" x="-20" y="-14" width="40" depth="5" height="6"/>
<room name="R" x="0" y="0"><plan width="4.3" depth="5.1" height="2.7"/>
<window name="Door" wall="south" left="0.4" sill="0" width="1.5" height="2.1"/>
<window name="W" wall="south" left="2.6" sill="0.9" width="1.1" height="1.3"/></room></building>
EOF
french="--vsc-point-french 1.6"
check "at 1.6 m" shows "27.06954462" assess -c vsc -f csv $french "$scratch/french.xml"
for kind in site elevation vertical-sky; do
    check "chart $kind at 1.6 m" quietly chart $kind $french "$scratch/french.xml" -o "$scratch/$kind.pdf"
    check "has that figure" says "$scratch/$kind.pdf" "27.1"
done
check "and says where" says "$scratch/site.pdf" "1.6 m above the"
check "of an elevation too" says "$scratch/elevation.pdf" "1.6 m above the floor"
check "and of the diagram" says "$scratch/vertical-sky.pdf" "x 1.15, y 0.00, z 1.60"
check "sizing begins there" shows '"now": 27.06954462' \
    size --obstruction Tower -f json $french "$scratch/french.xml"
check "and says so" grep -q '"vsc_point_french": 1.6' "$scratch/out"
check "in words too" shows "full-height windows: at 1.6 m" \
    size --envelope Tower $french "$scratch/french.xml"
check "a lit area has no such point" refuses 2 "--vsc-point-french is for windows" \
    size --obstruction Tower --of lit-area $french "$scratch/french.xml"
check "nor has a window to be sized" refuses 2 "--vsc-point-french needs --obstruction" \
    size --target 2% $french "$scratch/french.xml"
check "nor a plan" refuses 2 "is for a site, an elevation or a diagram" \
    chart plan $french "$scratch/french.xml" -o "$scratch/x.pdf"
tap_done
