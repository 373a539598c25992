#!/bin/sh
# compare: another program's values as CSV, errors in them, and the causes of a difference.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# A room that can be simulated quickly.
cat >"$scratch/room.xml" <<'XML'
<room version="1" name="Small"><site ground-reflectance="0"/><plan width="3.1" depth="4.3" height="2.7"/>
<finishes floor="0.15" walls="0.3" ceiling="0.5"/>
<window wall="south" left="0.7" sill="0.9" width="1.9" height="1.3" maintenance="0.8"/>
<working-plane height="0.8"/><grid spacing="1.5" margin="0.3"/></room>
XML
room=$scratch/room.xml
other=$scratch/other.csv

# values WORDS: the values of a variant of the room, as CSV on standard output.
values() {
    echo x,y,z,df_percent
    "$pepperpot" compare --error 3% --seed 9 --format json --as-if "$1" "$room" |
        sed -n 's/.*"x": \([0-9.]*\), "y": \([0-9.]*\), "z": \([0-9.]*\), "ours": \([0-9.]*\),.*/\1,\2,\3,\4/p'
}

# ---- output ----

check "ours as if, beside ours as they are" \
    shows "Our values use the switches low." compare --error 5% --as-if low "$room"
check "tidy" nothing "$(untidy)"
check "another room for another switch" \
    shows "as it is" compare --error 5% --as-if glass=none,dirt=none "$room"
check "the presets are in the help" shows "rtrace-defaults" compare --help

values bounces=1 >"$other"
check "a difference is explained" \
    shows "bounces=1: calculation limited to one reflection" compare --error 5% "$room" "$other"
check "and what to set right is said" grep -q "allow more bounces" "$scratch/out"
check "six points do not tell noise from a mistake" grep -q "too few points" "$scratch/out"
check "in a tidy way" nothing "$(untidy)"
check "as JSON, the same with any number of threads" \
    same_by_threads "1 3" compare --error 5% --format json "$room" "$other"
check "with the cause" grep -q '"switch": "bounces=1"' "$scratch/out"
check "of its own format" grep -q '"format": "pepperpot-compare-1"' "$scratch/out"

# The same values in another format: with other headings, in lux, in the order of the room's
# points.
sed '1s/.*/Label,,,Lux/; s/,.*,/;/; 2,$s/^[0-9.]*/"a"/' "$other" |
    awk -F';' -v OFS=';' 'NR > 1 { $2 *= 100 } { print }' >"$scratch/lux.csv"
check "in lux, by semicolons, without places" \
    shows "bounces=1: " compare --error 5% --external 10000 "$room" "$scratch/lux.csv"

values plane=0 >"$scratch/floor.csv"
check "with noise that is stated a cause is sure" \
    shows "sure     plane=0" compare --error 5% --noise 3% "$room" "$scratch/floor.csv"
check "what can look like a cause is said" grep -q "reflectances of surfaces" "$scratch/out"
awk -F, -v OFS=, 'NR > 1 { $4 *= NR % 2 ? 1.2 : 0.8 } { print }' "$scratch/floor.csv" \
    >"$scratch/uneven.csv"
check "with less noise than is left nothing is" \
    shows "is larger than the other" compare --error 5% --noise 3% "$room" "$scratch/uneven.csv"
check "and none is called sure" nothing "$(grep '^ *sure ' "$scratch/out")"

# Values of another tracer: four reflections, and a ground of 0.4 instead of 0.2.
cat >"$scratch/yard.xml" <<'XML'
<room version="1" name="Yard"><site ground-reflectance="0.2"/><plan width="4.4" depth="6" height="2.8"/>
<finishes floor="0.3" walls="0.55" ceiling="0.75"/>
<window wall="south" left="0.6" sill="0.9" width="1.4" height="1.5" glazing="clear-double" frame-factor="0.75" maintenance="0.85"/>
<window wall="south" left="2.4" sill="0.9" width="1.4" height="1.5" glazing="clear-double" frame-factor="0.75" maintenance="0.85"/>
<facade wall="south" left="6" right="6" up="5" reflectance="0.4"/>
<block x="-10" y="-20" width="24" depth="8" height="8" reflectance="0.35"/></room>
XML
# yard COLUMN: x, y and this column of values.
yard() {
    echo x,y,df_percent
    awk -v column="$1" '{ print $1 "," $2 "," $column }' <<'VALUES'
0.8 0.7 7.244455 7.725683
0.8 1.6 2.777192 3.225493
0.8 2.6 1.116022 1.484214
0.8 3.7 0.524436 0.809769
0.8 4.8 0.368970 0.592555
0.8 5.5 0.328157 0.514901
2.2 0.7 8.246158 8.834898
2.2 1.6 3.390137 3.881942
2.2 2.6 1.203481 1.631845
2.2 3.7 0.569545 0.869146
2.2 4.8 0.402928 0.645497
2.2 5.5 0.358883 0.556171
3.6 0.7 7.260412 7.721959
3.6 1.6 2.776865 3.238295
3.6 2.6 1.103203 1.491092
3.6 3.7 0.530148 0.810125
3.6 4.8 0.371321 0.576810
3.6 5.5 0.331822 0.515156
VALUES
}
yard 3 >"$scratch/bounces.csv"
yard 4 >"$scratch/ground.csv"
check "four reflections, the ground's among them" shows "ab=5: calculation limited to four" \
    compare --error 3% "$scratch/yard.xml" "$scratch/bounces.csv"
check "the reflectance of the ground" shows '"switch": "ground=0.' \
    compare --error 3% --format json "$scratch/yard.xml" "$scratch/ground.csv"
check "as large as it is" grep -Eq '"switch": "ground=0.(39|4|41)[0-9]*"' "$scratch/out"
check "for sure" grep -q '"sure": true' "$scratch/out"
check "and what it cannot detect" grep -q '"not-detected"' "$scratch/out"
check "and no more is left than noise" grep -q '"left-exceeds-noise": false' "$scratch/out"

# ---- rejected input ----

# wrong STATUS TEXT OPTIONS: the CSV on standard input is rejected with this status and text.
wrong() {
    expected=$1
    text=$2
    shift 2
    cat >"$scratch/wrong.csv"
    refuses "$expected" "$text" compare --error 5% "$@" "$room" "$scratch/wrong.csv"
}
check "an unknown column" wrong 1 'wrong.csv:1: unknown column "height"' <<'CSV'
x,y,height,df_percent
CSV
check "a column mistyped" wrong 1 "did you mean df_percent?" <<'CSV'
x,y,df_precent
CSV
check "no values" wrong 1 "wrong.csv:1: columns are missing; expected values" <<'CSV'
x,y,z
1,1,0.8
CSV
check "two columns of values" wrong 1 "a second column" <<'CSV'
x,y,df_percent,lux
CSV
check "x without y" wrong 1 "expected both x and y" <<'CSV'
x,df_percent
CSV
check "an empty file" wrong 1 "wrong.csv: there are no values" </dev/null
check "a header alone" wrong 1 "wrong.csv: there are no values" <<'CSV'
x,y,df_percent
CSV
check "a word where a number should be" wrong 1 'wrong.csv:3: found "dark"; expected a number' <<'CSV'
x,y,df_percent
1,1,2.2
1,2,dark
CSV
check "NaN" wrong 1 'wrong.csv:2: found "nan"; expected a number' <<'CSV'
x,y,df_percent
1,1,nan
CSV
check "a negative value" wrong 1 "wrong.csv:2: the value is -0.5" <<'CSV'
x,y,df_percent
1,1,-0.5
CSV
check "a field too few" wrong 1 "wrong.csv:4: the line has 2 fields; expected 3" <<'CSV'
x,y,df_percent
1,1,2.2
# between
1,2
CSV
check "another number of points" wrong 1 "3 values have no x and y; expected 6" <<'CSV'
df_percent
1
2
3
CSV
check "a point outside the room" wrong 1 "wrong.csv:3: the point 1, 7: " <<'CSV'
x,y,df_percent
1,1,2.2
1,7,2.2
CSV
check "a value without a unit" wrong 1 "expected --as percent, fraction or lux" <<'CSV'
x,y,df
1,1,2.2
CSV
check "lux without their sky" wrong 1 "values in lux need the external horizontal illuminance; expected --external LUX" <<'CSV'
x,y,lux
1,1,220
CSV
check "per cent for fractions" wrong 1 "check the unit" --as fraction <<'CSV'
x,y,df
1,1,2.2
CSV
check "two units" wrong 1 "--as and the column name give different units" --as lux --external 9000 <<'CSV'
x,y,df_percent
1,1,2.2
CSV
awk 'BEGIN { print "x,y,df_percent"; for (i = 0; i < 2000; i++) printf "1,1,2,"; print "" }' \
    >"$scratch/long.csv"
check "a huge line" \
    refuses 1 "long.csv:2: the line has " compare "$room" "$scratch/long.csv"
printf 'x,y,df_percent\n1,1,\0002\n' >"$scratch/nul.csv"
check "a character of code 0" \
    refuses 1 "a NUL byte" compare "$room" "$scratch/nul.csv"
check "no such file" refuses 1 "no.csv" compare "$room" "$scratch/no.csv"
check "no second file" refuses 2 "expected a CSV file with the other program's values" compare "$room"
check "a switch mistyped" refuses 2 "--as-if: there is no switch" compare --as-if bonces=2 "$room"
check "a switch that makes no sense here" \
    refuses 1 "plane=9" compare --as-if plane=9 "$room"
# On the floor below a desk there is no light; the variant that moves points there is not at fault.
sed 's|<grid |<furniture x="0.2" y="1" width="1.2" depth="2" height="0.74"/><grid |' "$room" >"$scratch/desk.xml"
check "points moved under a desk" \
    shows "switches plane=0" compare --error 5% --as-if plane=0 "$scratch/desk.xml"
check "noise of values that are missing" \
    refuses 2 "--noise describes the other program's values" compare --noise 2% --as-if low "$room"
check "noise that is none" refuses 2 "--noise" compare --noise none "$room" "$other"
check "a ground that reflects too much" \
    refuses 2 "ground is \"1.2\"; expected a number from 0 to 1" compare --as-if ground=1.2 "$room"
check "a unit mistyped" refuses 2 "percent, fraction or lux" compare --as per-cent "$room" "$other"

# ---- an imported scene ----

# A uniform sky over infinite coloured ground: a sensor that faces sideways sees half of each. The
# other program's luminance is its green channel.
cat >"$scratch/scene.rad" <<'RAD'
void glow even 0 0 4 1 1 1 0
even source sky 0 0 4 0 0 1 180
void plastic turf 0 0 5 0.1 0.4 0.2 0 0
turf ring ground 0 0 8 0 0 0 0 0 1 0 100000
RAD
awk 'BEGIN {
    print "x,y,z,nx,ny,nz,lux"
    for (i = 0; i <= 8; i++) {
        a = i * 3.14159265358979 / 8
        printf "%d,0,1,%.12f,0,%.12f,%.6f\n", i, sin(a), cos(a), \
            179 * 3.14159265358979 * ((1 + cos(a)) / 2 + 0.4 * (1 - cos(a)) / 2)
    }
}' >"$scratch/scene.csv"
check "a scene, in lux of its own sky" \
    shows "colour=green: the green channel alone" compare --error 2% "$scratch/scene.rad" "$scratch/scene.csv"
check "in a tidy way, too" nothing "$(untidy)"
check "a scene without values" \
    refuses 2 "expected scene files, then" compare "$scratch/scene.rad"
check "a scene has its own sky" \
    refuses 2 "--sky is for room files" compare --sky uniform "$scratch/scene.rad" "$scratch/scene.csv"
check "and its own ground" refuses 1 "in a scene, where it is part of the geometry" \
    compare --as-if ground=0.3 "$scratch/scene.rad" "$scratch/scene.csv"
check "a room has no colours" \
    refuses 1 "a room file has no colours" compare --as-if colour=green "$room"
sed 's/,1,/,/; s/,z,/,/' "$scratch/scene.csv" >"$scratch/flat.csv"
check "a scene has no working plane" \
    refuses 1 "flat.csv:2: x, y and z are missing" compare "$scratch/scene.rad" "$scratch/flat.csv"
printf '"x [m]";"y [m]";"DF [%%]"\n1,5;2;3,25\n' >"$scratch/comma.csv"
printf 'x,y,df_percent\n1.5,2,3.25\n' >"$scratch/point.csv"
gives compare --error 2% "$room" "$scratch/comma.csv" && sed 1d "$scratch/out" >"$scratch/comma"
gives compare --error 2% "$room" "$scratch/point.csv" && sed 1d "$scratch/out" >"$scratch/point"
check "decimal commas between semicolons, and units" same "$scratch/comma" "$scratch/point"
printf '3.25\n' >"$scratch/bare.csv"
cat >"$scratch/one.xml" <<'XML'
<room version="1"><plan width="4" depth="5" height="3"/>
<window wall="south" left="1" sill="1" width="2" height="1.5"/><point x="1.5" y="2"/></room>
XML
check "what rtrace writes has no header" shows "3.250" \
    compare --error 2% --as percent "$scratch/one.xml" "$scratch/bare.csv"
printf '3.25 1\n' >"$scratch/bare.csv"
check "two numbers without one are none" refuses 1 'unknown column "3.25 1"' \
    compare --as percent "$scratch/one.xml" "$scratch/bare.csv"
check "a damaged scene" refuses 1 "scene.csv:1: " compare "$scratch/scene.csv" "$scratch/scene.csv"

tap_done
