#!/bin/sh
# A room in a short form gives output identical to its long form: roofs compared with envelopes,
# furniture with surfaces.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

cat >"$scratch/short.xml" <<'EOF'
<room version="1" name="Attic">
  <plan width="6" depth="8" height="2" roof="gable" ridge="width" pitch="45"/>
  <window wall="roof-south" left="1" sill="1" width="1.2" height="1.5"/>
  <furniture x="1" y="6" width="2" depth="0.75" height="0.75" reflectance="0.4"/>
</room>
EOF
cat >"$scratch/long.xml" <<'EOF'
<room version="1" name="Attic">
  <envelope>
    <face role="floor" name="floor"><vertex x="0" y="0" z="0"/><vertex x="6" y="0" z="0"/>
      <vertex x="6" y="8" z="0"/><vertex x="0" y="8" z="0"/></face>
    <face role="wall" name="south"><vertex x="6" y="0" z="0"/><vertex x="0" y="0" z="0"/>
      <vertex x="0" y="0" z="2"/><vertex x="6" y="0" z="2"/></face>
    <face role="wall" name="north"><vertex x="0" y="8" z="0"/><vertex x="6" y="8" z="0"/>
      <vertex x="6" y="8" z="2"/><vertex x="0" y="8" z="2"/></face>
    <face role="wall" name="east"><vertex x="6" y="8" z="0"/><vertex x="6" y="0" z="0"/>
      <vertex x="6" y="0" z="2"/><vertex x="6" y="4" z="6"/><vertex x="6" y="8" z="2"/></face>
    <face role="wall" name="west"><vertex x="0" y="0" z="0"/><vertex x="0" y="8" z="0"/>
      <vertex x="0" y="8" z="2"/><vertex x="0" y="4" z="6"/><vertex x="0" y="0" z="2"/></face>
    <face role="ceiling" name="roof-south"><vertex x="6" y="0" z="2"/><vertex x="0" y="0" z="2"/>
      <vertex x="0" y="4" z="6"/><vertex x="6" y="4" z="6"/></face>
    <face role="ceiling" name="roof-north"><vertex x="0" y="8" z="2"/><vertex x="6" y="8" z="2"/>
      <vertex x="6" y="4" z="6"/><vertex x="0" y="4" z="6"/></face>
  </envelope>
  <window wall="roof-south" left="1" sill="1" width="1.2" height="1.5"/>
  <surface reflectance="0.4"><vertex x="1" y="6" z="0"/><vertex x="3" y="6" z="0"/>
    <vertex x="3" y="6" z="0.75"/><vertex x="1" y="6" z="0.75"/></surface>
  <surface reflectance="0.4"><vertex x="3" y="6" z="0"/><vertex x="3" y="6.75" z="0"/>
    <vertex x="3" y="6.75" z="0.75"/><vertex x="3" y="6" z="0.75"/></surface>
  <surface reflectance="0.4"><vertex x="3" y="6.75" z="0"/><vertex x="1" y="6.75" z="0"/>
    <vertex x="1" y="6.75" z="0.75"/><vertex x="3" y="6.75" z="0.75"/></surface>
  <surface reflectance="0.4"><vertex x="1" y="6.75" z="0"/><vertex x="1" y="6" z="0"/>
    <vertex x="1" y="6" z="0.75"/><vertex x="1" y="6.75" z="0.75"/></surface>
  <surface reflectance="0.4"><vertex x="1" y="6" z="0.75"/><vertex x="3" y="6" z="0.75"/>
    <vertex x="3" y="6.75" z="0.75"/><vertex x="1" y="6.75" z="0.75"/></surface>
</room>
EOF
# figures FILE WORDS: all figures, without the name and line numbers of the file.
figures() {
    file=$1
    shift
    "$pepperpot" df -f csv -p "1,1 3,4 5,7,0.8" "$@" "$file" | cut -d, -f2- |
        sed 's/line [0-9]*/line/g; s/\(point,\)[0-9]*,/\1/'
}
# Formulae count both sides of a free surface, but only the outer side of furniture.
for form in short long; do
    figures "$scratch/$form.xml" --simulate --error 5% -m exact >"$scratch/$form.furnished"
    sed '/<furniture/d; /<surface/,/<\/surface>/d' "$scratch/$form.xml" >"$scratch/bare.xml"
    figures "$scratch/bare.xml" --simulate --error 5% -m exact,split-flux,average-df,arndt \
        >"$scratch/$form.bare"
done
check "there are figures" test "$(wc -l <"$scratch/short.bare")" -gt 15
check "a roof has the bytes of an envelope" cmp "$scratch/short.bare" "$scratch/long.bare"
check "furniture has the bytes of surfaces" cmp "$scratch/short.furnished" "$scratch/long.furnished"

check "a window in the slope as an opening" sh -c '
    sed "s|<window.*|<opening><vertex x=\"2.2\" y=\"0.70710678118654757\" z=\"2.7071067811865475\"/>\
<vertex x=\"1\" y=\"0.70710678118654757\" z=\"2.7071067811865475\"/>\
<vertex x=\"1\" y=\"1.7677669529663689\" z=\"3.7677669529663689\"/>\
<vertex x=\"2.2\" y=\"1.7677669529663689\" z=\"3.7677669529663689\"/></opening>|" "$1/short.xml" >"$1/opening.xml"
    for room in short opening; do
        "$2" df -m exact -f csv -p "1,1 3,4" "$1/$room.xml" |
            awk -F, "\$3 == \"point\" { print \$12 }" >"$1/$room.values"
    done
    paste "$1/short.values" "$1/opening.values" |
        awk "{ d = \$1 - \$2; if (d > 1e-8 || d < -1e-8) bad = 1; n++ } END { exit bad || n < 4 }"' sh "$scratch" "$pepperpot"

for roof in mono gable hip saw-tooth; do
    sed "s/roof=\"gable\" ridge=\"width\" pitch=\"45\"/roof=\"$roof\" pitch=\"30\"/; s/wall=\"roof-south\" left=\"1\" sill=\"1\" width=\"1.2\" height=\"1.5\"/wall=\"west\" left=\"1\" sill=\"0.5\" width=\"1\" height=\"1\"/" \
        "$scratch/short.xml" >"$scratch/$roof.xml"
    check "$roof: a section" quietly chart section "$scratch/$roof.xml" -o "$scratch/$roof.svg"
    check "$roof: exported" sh -c '"$1" export -q --to radiance -o "$2/$3" "$2/$3.xml"' sh "$pepperpot" "$scratch" $roof
done
sed 's/wall="roof-south"/wall="roof-east"/' "$scratch/short.xml" >"$scratch/no.xml"
check "a slope that is not there" refuses 1 'there is no wall "roof-east"' df "$scratch/no.xml"
# A dado as high as its walls, with a door of the same reflectance, equals the finish of the walls:
# for hand methods except for rounding, for the tracer within 4 standard errors of the difference
# (1 % each).
cat >"$scratch/finish.xml" <<'EOF'
<room version="1"><plan width="4.2" depth="5.3" height="2.7"/>
<finishes floor="0.2" walls="0.3" ceiling="0.8"/>
<window wall="south" left="0.9" sill="0.8" width="2.4" height="1.5"/>
<point x="2.1" y="4.3"/></room>
EOF
sed 's|walls="0.3"|walls="0.6"|; s|<point|<door wall="east" left="1"/><dado height="2.7" reflectance="0.3"/>&|' \
    "$scratch/finish.xml" >"$scratch/dado.xml"
for room in finish dado; do
    "$pepperpot" df -q --simulate --error 1% -m exact+bre,exact+split-flux,average-df,brs-table+bre \
        -f csv "$scratch/$room.xml" >"$scratch/$room.csv"
done
check "a dado of full height is the walls' finish" awk -F, '
    FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    { key = $at["method"] "," $at["component"] "," $at["place"] "," $at["x"]
      value = $at["value_percent"]; error = $at["std_error_percent"] }
    NR == FNR { values[key] = value; errors[key] = error; next }
    value == "" || !(key in values) { next }
    { d = value - values[key]; d = d < 0 ? -d : d
      allowed = error == "" ? 1e-9 : 4 * sqrt(error^2 + errors[key]^2)
      bad += d > allowed; traced += error != "" && error > 0; n++ }
    END { exit bad || n < 10 || !traced }' "$scratch/finish.csv" "$scratch/dado.csv"
check "a door and a dado are drawn in section" quietly chart section "$scratch/dado.xml" -o "$scratch/dado.svg"
"$pepperpot" export -q --to radiance -o "$scratch/dado-rad" "$scratch/dado.xml"
check "and exported" grep -rqi "door" "$scratch/dado-rad"
# Lengths in millimetres.
cat >"$scratch/mm.xml" <<'EOF'
<room version="1" name="Study" units="mm">
  <plan width="4200" depth="5400" height="2800"/>
  <window wall="south" left="900" sill="850" width="2400" height="1500" reveal="150"/>
  <block x="-2000" y="-12000" width="9000" depth="4000" height="6000"/>
  <working-plane height="850"/>
  <line from="2100 500" to="2100 5000" points="10"/>
</room>
EOF
sed 's/ units="mm"//; s/="\(-*[0-9]*\)\([0-9][0-9][0-9]\)"/="\1.\2"/g; s/="\./="0./g; s/-\./-0./g
    s/"2100 500"/"2.1 0.5"/; s/"2100 5000"/"2.1 5"/' "$scratch/mm.xml" >"$scratch/m.xml"
check "the file in metres" grep -q 'width="4.200" depth="5.400"' "$scratch/m.xml"
for file in m mm; do
    "$pepperpot" df --simulate --error 5% -f csv "$scratch/$file.xml" | cut -d, -f2- >"$scratch/$file"
done
check "millimetres have the bytes of metres" cmp "$scratch/m" "$scratch/mm"
check "size answers in the file's units" shows 'width="' size --by-hand --target 3% "$scratch/mm.xml"
check "of the whole line" grep -qE 'left="[0-9]{3,4}(\.[0-9])?" sill="850" width="[0-9]{4}(\.[0-9])?"' "$scratch/out"
sed 's/width="4200"/width="0.42"/' "$scratch/mm.xml" >"$scratch/no.xml"
check "and so do messages" refuses 1 "expected a number of millimetres from 1 to 100000000" \
    df "$scratch/no.xml"
tap_done
