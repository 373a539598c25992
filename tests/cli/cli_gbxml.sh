#!/bin/sh
# import of gbXML: room files that other commands accept, and notes on missing data.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# loop X Y Z ...: a PolyLoop of these corners.
loop() {
    echo "<PlanarGeometry><PolyLoop>"
    while [ $# -gt 0 ]; do
        echo "<CartesianPoint><Coordinate>$1</Coordinate><Coordinate>$2</Coordinate><Coordinate>$3</Coordinate></CartesianPoint>"
        shift 3
    done
    echo "</PolyLoop></PlanarGeometry>"
}

# surface TYPE INSIDE X Y Z ...: a Surface with this content and these corners.
surface() {
    echo "<Surface id=\"$1\" surfaceType=\"$1\"><AdjacentSpaceId spaceIdRef=\"sp-1\"/>"
    inside=$2
    shift 2
    loop "$@"
    echo "$inside</Surface>"
}

# A room of 4 x 6 x 3 m with a window facing south; the file begins with a byte order mark.
{
    printf '\357\273\277<?xml version="1.0" encoding="UTF-8"?>\n'
    echo '<gbXML xmlns="http://www.gbxml.org/schema" lengthUnit="Meters" version="6.01">'
    echo '<Campus id="campus"><Location><Latitude>51.5</Latitude><Longitude>-0.1</Longitude></Location>'
    echo '<Building id="b" buildingType="Office"><Space id="sp-1" spaceType="OfficeOpenPlan"><Name>Büro &amp; Flur</Name></Space></Building>'
    surface SlabOnGrade "" 0 0 0 0 6 0 4 6 0 4 0 0
    surface Roof "" 0 0 3 4 0 3 4 6 3 0 6 3
    surface ExteriorWall "<Opening id=\"win-1\" openingType=\"FixedWindow\" windowTypeIdRef=\"g\">$(
        loop 1 0 0.9 2.6 0 0.9 2.6 0 2.1 1 0 2.1)</Opening>" 0 0 0 4 0 0 4 0 3 0 0 3
    surface ExteriorWall "" 4 0 0 4 6 0 4 6 3 4 0 3
    surface ExteriorWall "" 4 6 0 0 6 0 0 6 3 4 6 3
    surface ExteriorWall "" 0 6 0 0 0 0 0 0 3 0 6 3
    echo '</Campus><WindowType id="g"><Transmittance unit="Fraction" type="Visible" surfaceType="Both">0.8</Transmittance></WindowType>'
    echo '</gbXML>'
} >"$scratch/office.gbxml"
cat >"$scratch/hand.xml" <<'END'
<?xml version="1.0" encoding="UTF-8"?>
<building version="1">
<site latitude="51.5" longitude="-0.1"/>
<room name="Büro &amp; Flur" ref="sp-1" use="office" x="0" y="0" z="0">
<plan width="4" depth="6" height="3"/>
<window wall="south" left="1" sill="0.9" width="1.6" height="1.2" transmittance="0.8" name="win-1"/>
</room></building>
END

run import "$scratch/office.gbxml" -o "$scratch/room.xml"
check "a gbXML file is converted to a room file" test $status -eq 0 -a -s "$scratch/room.xml"
check "nothing beside it" nothing "$(leftovers)"
check "what is missing is named with what is taken" \
    grep -q "6 of 6 surfaces have no visible reflectance.*0.2.*0.5.*0.7" "$scratch/err"
check "and what gbXML does not know" grep -q "frame-factor 1, maintenance 1" "$scratch/err"
run import -q "$scratch/office.gbxml"
check "to standard output the same" same "$scratch/room.xml" "$scratch/out"
check "quietly" test ! -s "$scratch/err"
gives df -m all --points 2,3 -f csv "$scratch/hand.xml" >/dev/null
sed 's/^[^,]*//' "$scratch/out" >"$scratch/by_hand"
check "it is computed" gives df -m all --points 2,3 -f csv "$scratch/room.xml"
sed 's/^[^,]*//' "$scratch/out" >"$scratch/by_import"
check "as the same room written by hand, to the byte" \
    same "$scratch/by_hand" "$scratch/by_import"
check "and judged" gives assess --by-hand "$scratch/room.xml"

if command -v iconv >/dev/null; then
    { printf '\377\376' && LC_ALL=C sed 's/UTF-8/UTF-16/; 1s/^...//' "$scratch/office.gbxml" |
        iconv -f UTF-8 -t UTF-16LE; } >"$scratch/wide.xml"
    run import -q "$scratch/wide.xml"
    check "from UTF-16 the same" same "$scratch/room.xml" "$scratch/out"
    { printf '\376\377' && LC_ALL=C sed 's/UTF-8/UTF-16/; 1s/^...//' "$scratch/office.gbxml" |
        iconv -f UTF-8 -t UTF-16BE; } >"$scratch/wide.xml"
    run import -q "$scratch/wide.xml"
    check "from UTF-16 with the high byte first, too" same "$scratch/room.xml" "$scratch/out"
else
    skip "from UTF-16 the same" "iconv"
fi
LC_ALL=C sed '1s/UTF-8/utf-16/; 1s/^...//' "$scratch/office.gbxml" >"$scratch/labelled.xml"
run import -q "$scratch/labelled.xml"
check "from UTF-8 that is declared as UTF-16, too" same "$scratch/room.xml" "$scratch/out"

check "options of scenes are refused" refuses 2 "--points-file is for Radiance" \
    import --points-file "$scratch/room.xml" "$scratch/office.gbxml"
check "it is imported by itself" refuses 2 "expected only the gbXML file" \
    import "$scratch/office.gbxml" "$scratch/office.gbxml"
check "a room file is none" refuses 1 "expected <gbXML>" import "$scratch/room.xml"
sed 's/Meters/Ells/' "$scratch/office.gbxml" >"$scratch/bad.gbxml"
check "a unit that is none is refused by line" refuses 1 "bad.gbxml:2: lengthUnit is \"Ells\"" \
    import "$scratch/bad.gbxml"
head -c 900 "$scratch/office.gbxml" >"$scratch/bad.gbxml"
check "so is a file that breaks off" refuses 1 "the file ends inside" import "$scratch/bad.gbxml"
grep -v 'FixedWindow' "$scratch/office.gbxml" | sed 's/WindowType/Other/g' >"$scratch/bad.gbxml"
cp "$scratch/hand.xml" "$scratch/keep.xml"
run import "$scratch/bad.gbxml" -o "$scratch/keep.xml"
check "of what no room comes, nothing is written" \
    test $status -eq 1 -a "$(cat "$scratch/keep.xml")" = "$(cat "$scratch/hand.xml")"

tap_done
