#!/bin/sh
# A site with many rooms: states, the table of a site, profiles, rejected input.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
LC_ALL=C
export LC_ALL
site=$(cd "$srcdir/examples/sites" && pwd)/corner-house.xml

# column N ROW: the Nth field from the end of the row of the table that contains this text.
column() {
    grep -F -- "$2" "$scratch/out" | awk -v n="$1" '{ print $(NF - n) }' | head -n 1
}
# is NUMBER NUMBER TOLERANCE: the numbers agree.
is() {
    awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; exit !(d <= t && -d <= t) }' ||
        { echo "$1, not $2"; return 1; }
}

check "the table of a site" gives assess --by-hand --for uk-planning --table "$site"
check "fits in 80 columns" nothing "$(too_wide)"
sed 's/ not met$/ not-met/' "$scratch/out" >"$scratch/table" && mv "$scratch/table" "$scratch/out"
before=$(column 4 "W3, south") now=$(column 3 "W3, south") ratio=$(column 1 "W3, south")
check "a ratio is that of its sky components" is "$ratio" \
    "$(awk -v a="$now" -v b="$before" 'BEGIN { print a / b }')" 6e-4
check "a bathroom's window is in it for no criterion" nothing "$(grep W6 "$scratch/out")"
check "a workshop is no room of a dwelling" nothing "$(grep '^  0.03 .* lx' "$scratch/out")"
check "a lone dwelling" gives assess --by-hand --for uk-dwellings --table "$site"
check "a living room with a kitchen is a kitchen" grep -q "^  0.01 *kitchen: 200" "$scratch/out"
check "and nothing else" nothing "$(grep '^  0.01 *[bl][a-z ]*: 1' "$scratch/out")"

for state in existing proposed; do
    check "--state $state" gives assess --by-hand -c vsc --table --state $state "$site"
    sed 's/ not met$/ not-met/' "$scratch/out" >"$scratch/$state"
done
cp "$scratch/existing" "$scratch/out"
check "as existing it has the sky before" is "$(column 1 "W3, south")" "$before" 0
cp "$scratch/proposed" "$scratch/out"
check "as proposed the sky now" is "$(column 1 "W3, south")" "$now" 0
check "from standard input the same" sh -c "
    '$pepperpot' assess --by-hand --for uk-planning --table - <'$site' |
        grep -qE 'W3, south.* $before +$now '"
check "a window has the name of the file" sh -c "
    sed 's/name=\"W3\"/name=\"Fenster\"/' '$site' |
        '$pepperpot' assess --by-hand -c former-sky --table - | grep -qE '^  Study.* Fenster, south'"
check "as JSON" shows '"format": "pepperpot-site-1"' \
    assess --by-hand -c vsc,former-sky,nsl --table -f json "$site"
check "with both states" grep -qE '"W5, south".*"label": "W5".*"existing": [0-9.]+, "proposed"' \
    "$scratch/out"
check "as CSV" shows "Bedroom,1.01,bedroom,former-sky," assess --by-hand -c former-sky -f csv "$site"
check "a sheet a room has what was before" shows "% before" \
    assess --by-hand -c former-sky --room Bedroom "$site"

# Rights of light: a row for each room, with the same figures as the findings, and the total.
rights="assess --for rights-of-light --table"
check "rights of light in one table" gives $rights "$site"
check "which fits in 80 columns" nothing "$(too_wide)"
check "nothing else is in it" nothing "$(grep 'All else' "$scratch/out")"
check "the sum has no verdict" nothing "$(grep '^ *sum.*met' "$scratch/out")"
lost=$(awk '/^ *sum / && ++n == 2 { print $2 }' "$scratch/out")
check "what is lost is what was there before without what is there now" is "$lost" \
    "$(awk '/^ *sum / && ++n == 1 { print $3 - $4 }' "$scratch/out")" 0.011
check "zones count 3/2, 1, 1/2 and 1/4 of first zone" is \
    "$(awk '/^ *sum / && ++n == 2 { print 1.5 * $3 + $4 + $5 / 2 + $6 / 4 - $7 }' "$scratch/out")" 0 0.011
cat >"$scratch/same.sh" <<'EOF'
row=$(grep 'Bathroom' "$2" | head -n 1 | awk '{ print $4, $5, $6 }')
found=$("$1" assess --for rights-of-light --room Bathroom -f csv "$3" | awk -F, '
    $6 ~ /before/ { was = $10 } $6 ~ /contour/ { now = $10 } $6 ~ /share/ { share = $10 }
    END { printf "%.2f %.2f %.1f", was, now, share }')
[ "$row" = "$found" ] || { echo "$row, not $found"; exit 1; }
EOF
check "a row is the room's findings" sh "$scratch/same.sh" "$pepperpot" "$scratch/out" "$site"
check "as CSV a line a room and one of the sum" gives $rights -f csv "$site"
check "whose sums are those of the lines" awk -F, 'NR == 1 { next } $2 == "sum" {
    for (i = 5; i <= 14; i++) if (i != 8 && (sum[i] - $i) ^ 2 > 1e-12) exit 1
    seen = 1; next } { for (i = 5; i <= 14; i++) sum[i] += $i } END { exit !(seen && NR == 7) }' \
    "$scratch/out"
check "as JSON rooms and sum" shows '"sum": { "area": 100.5, "existing": 76.5' $rights -f json "$site"
check "without a site as it was nothing is lost" gives $rights --state proposed "$site"
check "nor said to be" nothing "$(grep -E 'existing|lost|nan' "$scratch/out")"
check "in CSV neither" gives $rights --state proposed -f csv "$site"
check "of the sum" grep -qE '^,sum,,,100.5,,66.6[0-9]*,66.2[0-9]*,,,,,,,,' "$scratch/out"
check "with other criteria CSV has a finding a line" shows "share of the room" \
    assess --by-hand -c rights-of-light,vsc --table -f csv "$site"
cat >"$scratch/low.xml" <<'EOF'
<building version="1" name="Cellar"><room name="Hole" x="0" y="0">
  <plan width="4" depth="6" height="0.6"/><working-plane height="0.3"/></room>
  <room name="Over" x="0" y="9"><plan width="4" depth="6" height="2.6"/>
  <window wall="south" left="1" sill="0.9" width="2" height="1.2"/></room></building>
EOF
check "a room that is not judged is in the table" gives $rights "$scratch/low.xml"
check "without figures" grep -qE '^  Hole +- +- +- +not applicable' "$scratch/out"
check "the sum is the other's" grep -qE '^  sum +24.00 ' "$scratch/out"

# The study as a single room, with all other parts of the building moved by hand.
cat >"$scratch/study.xml" <<'EOF'
<room version="1" name="Study" north="10">
  <site latitude="51.5" longitude="-0.1" ground-level="-0.5"/>
  <plan width="3.5" depth="4.5" height="2.7"/>
  <window wall="south" left="0.9" sill="0.8" width="1.6" height="1.5"/>
  <block x="-9.2" y="-24" width="30" depth="8" height="7" roof="gable" pitch="35"
         reflectance="0.3"/>
  <block x="-5.2" height="11">
    <vertex x="-22" y="-20"/> <vertex x="-12" y="-24"/>
    <vertex x="-12" y="-6"/> <vertex x="-22" y="-4"/>
  </block>
  <block x="-1.2" y="-15" width="10" depth="5" height="19"/>
  <block x="-5.2" y="0" width="5" depth="4.5" base="0" height="2.7"/>
  <block x="3.7" y="-6" width="4" depth="6" base="0" height="2.7"/>
  <block x="-5.2" y="0" width="5" depth="4.5" base="3" height="2.6"/>
  <block x="0" y="0" width="3.5" depth="4.5" base="3" height="2.6"/>
</room>
EOF
numbers() {
    "$pepperpot" df -m exact+bre,brs-table -f csv --points "0.7,0.9 1.8,3.7" "$@" |
        sed 1d | tr ',' '\n' | grep -E '^[0-9]+\.[0-9]{4,}$'
}
check "a room of the site has the figures of the same room by itself" sh -c '
    paste "$1" "$2" | awk "{ d = \$1 - \$2; if (d > 1e-8 || -d > 1e-8) bad = 1; n++ }
        END { exit bad || n < 6 }"' sh "$(numbers --room Study "$site" >"$scratch/a"; echo "$scratch/a")" \
    "$(numbers "$scratch/study.xml" >"$scratch/b"; echo "$scratch/b")"

check "the country chooses" gives assess --by-hand --room Bedroom "$site"
check "in Britain no American code" nothing "$(grep 'IBC21' "$scratch/out")"
sed 's/country="GB"/country="DE"/' "$site" >"$scratch/german.xml"
check "in Germany its own code" shows "MBO02" assess --by-hand --room Bedroom "$scratch/german.xml"
check "and no British one" nothing "$(grep 'BSEN17037\|glass over' "$scratch/out")"
check "who asks for a criterion gets it" shows "living room: 150" \
    assess --by-hand -c uk-annex --room Workroom "$site"
check "of a bathroom nothing is judged" shows "applies to a room with the use bathroom" \
    assess --by-hand --for uk-planning --room Bathroom "$site"

check "how high the tower may be" shows "every window keeps" size --obstruction Tower "$site"
check "fits in 80 columns" nothing "$(too_wide)"
check "one window decides, with 0.8 left" grep -qE "^  Study +W3 .* 0\.8000  \*$" "$scratch/out"
check "as JSON" shows '"verdict": "found"' size --obstruction Tower -f json "$site"
height=$(sed -n 's/^  "height": \([0-9.]*\),/\1/p' "$scratch/out")
sed "s/depth=\"5\" height=\"19\"/depth=\"5\" height=\"$height\"/" "$site" >"$scratch/lower.xml"
check "at that height it has it" gives assess --by-hand -c former-sky --room Study -f csv "$scratch/lower.xml"
check "to 1e-4" is "$(sed -n '2s/.*",29,[0-9.]*,[0-9.]*,\([0-9.]*\),.*/\1/p' "$scratch/out")" 0.8 1e-4
check "of one window alone" shows "W5" size --obstruction Tower --window-name W5 --keep 90% "$site"
check "a block over a footprint too" shows "up to a height of 14.65 m, every window keeps 0.6" \
    size --obstruction Corner --keep 60% "$site"
check "its rooms' lit area" shows '"verdict": "found"' \
    size --obstruction Tower --of lit-area -f json "$site"
check "one room decides" grep -q '"room": "Bathroom",.*"decides": true' "$scratch/out"
height=$(sed -n 's/^  "height": \([0-9.]*\),/\1/p' "$scratch/out")
sed "s/depth=\"5\" height=\"19\"/depth=\"5\" height=\"$height\"/" "$site" >"$scratch/lower.xml"
check "at that height it has it" gives assess --by-hand -c no-sky-line --room Bathroom -f json "$scratch/lower.xml"
check "to 1e-3" is "$(sed -n 's/.*ratio to the former area.*"figure": \([0-9.]*\),.*/\1/p' "$scratch/out")" 0.8 1e-3
check "27 % is enough" shows "or 27 %" size --obstruction Tower --enough 27% --room Study "$site"
check "of a room there is no such share" refuses 2 "a lit area belongs to a room" \
    size --obstruction Tower --of lit-area --enough 27% "$site"
check "vsc or lit-area" refuses 2 "expected vsc or lit-area" size --obstruction Tower --of apsh "$site"
check "what is kept, of a block" refuses 2 "needs --obstruction" size -t 2% --of lit-area "$site"
check "no higher than asked" shows "at a height of 5 m, every window" \
    size --obstruction Tower --highest 5 "$site"

check "what may stand on the tower's plot" shows "m3 can be built while every window keeps" \
    size --envelope Tower "$site"
check "fits in 80 columns" nothing "$(untidy)"
check "one window has just its due" grep -qE "^  Study +W3 .* 0\.8000 +[0-9.]+  \*$" "$scratch/out"
check "its cells as CSV" gives size --envelope Tower -f csv "$site"
tr -d '\r' <"$scratch/out" >"$scratch/cells.csv"
check "are those of 10 m by 5 m" is "$(sed 1d "$scratch/cells.csv" | wc -l)" 50 0
sed -n '2,$p' "$scratch/cells.csv" | awk -F, '{
    printf "<block state=\"proposed\" x=\"%s\" y=\"%s\" width=\"%s\" ", $2, $3, $5
    printf "depth=\"%s\" rotate=\"%s\" height=\"%s\"/>\n", $6, $7, $8 }' >"$scratch/blocks"
sed -e "/name=\"Tower\"/r $scratch/blocks" -e '/name="Tower"/d' "$site" >"$scratch/cells.xml"
check "as blocks they can be judged" gives assess --by-hand -c former-sky --room Study -f csv "$scratch/cells.xml"
check "and leave it that to 1e-4" is "$(sed -n '2s/.*,78,[0-9.]*,[0-9.]*,\([0-9.]*\),.*/\1/p' "$scratch/out")" 0.8 1e-4
check "as JSON" shows '"format": "pepperpot-envelope-1"' size --envelope Tower -f json "$site"
check "an outline is a plot too" shows '"verdict": "none"' size --envelope Corner -f json "$site"
check "an envelope or a height" refuses 2 "and --envelope cannot be combined" \
    size --envelope Tower --obstruction Tower "$site"
check "it is by windows" refuses 2 "expected --of vsc" size --envelope Tower --of lit-area "$site"
check "cells are an envelope's" refuses 2 "CSV is for --envelope only" \
    size --obstruction Tower -f csv "$site"
check "a window has a line of CSV" shows "file,room,method,change" size -t 2% --by-hand -f csv "$site"
check "a height in metres" refuses 2 "expected a height from 1 to 1000 m" \
    size --envelope Tower --highest 0 "$site"
check "nothing higher without a block" refuses 2 "--highest needs --obstruction or --envelope" \
    size -t 2% --highest 9 "$site"
check "a plot by its name" refuses 1 "did you mean Tower?" size --envelope Towr "$site"
check "a block by its name" refuses 1 "did you mean Tower?" size --obstruction Towr "$site"
check "a window by its name" refuses 1 'no vertical window is named "W9"' \
    size --obstruction Tower --window-name W9 "$site"
check "no target with it" refuses 2 "and --obstruction cannot be combined" \
    size --obstruction Tower --target 2% "$site"
check "no share without it" refuses 2 "needs --obstruction" size --target 2% --keep 80% "$site"
check "a file without names" refuses 1 "no block in it has a name" size --obstruction Tower "$deep"
# counts_agree: the heading of the table counts each window once: met by 27 % or by 0.8 of the
# former sky.
counts_agree() {
    "$pepperpot" assess --by-hand --for uk-planning --table -f json "$site" >"$scratch/table.json"
    "$pepperpot" assess --by-hand --for uk-planning -f csv "$site" >"$scratch/all.csv"
    said=$(sed -n 's/.*"windows-met": \([0-9]*\).*/\1/p' "$scratch/table.json")
    met=$(grep ',former-sky,' "$scratch/all.csv" | grep -c ',least,met,')
    windows=$(sed -n 's/.*"windows": \([0-9]*\).*/\1/p' "$scratch/table.json")
    echo "# $said of $windows said, $met counted"
    [ "$said" = "$met" ] && [ "$windows" -eq "$(grep -c ',vertical-sky,' "$scratch/all.csv")" ]
}
check "windows that meet BR 209 are counted once" counts_agree
check "the text says so" shows " windows and " assess --by-hand --for uk-planning --table "$site"
check "planning has the sun, existing and proposed" sh -c "
    '$pepperpot' assess --by-hand --for uk-planning --room Study '$site' |
        grep -qE '[0-9.]+ % now, [0-9.]+ % before'"
check "possible hours are called so" shows "share of possible hours" \
    assess --by-hand -c apsh -f json --room Study "$site"
check "no latitude, no sun" sh -c "
    sed 's/latitude=\"[0-9.]*\"//' '$site' |
        '$pepperpot' assess --by-hand --room Study -c sunlight,sun-exposure - |
        grep -c 'has no latitude' | grep -qx 2"
check "hours of sun in h" shows '"unit": "h"' \
    assess --by-hand -c sun-exposure -f json --room Study "$site"

"$pepperpot" assess --by-hand --for uk-planning -f csv "$site" >"$scratch/planning.csv"
"$pepperpot" assess --by-hand --for br209-2022 -f csv "$site" >"$scratch/br209.csv"
check "BR 209 of 2022 is the rule of planning" \
    cmp "$scratch/planning.csv" "$scratch/br209.csv"
check "a profile by its name" refuses 2 "did you mean uk-planning?" \
    assess --for uk-planing "$site"
check "--for or --criteria" refuses 2 "expected only one of them" assess --for en17037 -c vsc "$site"
check "--before or --state" refuses 2 "expected only one of them" \
    assess --before "$site" --state existing "$site"
check "two states" refuses 2 "existing, proposed or cumulative" df --state planned "$site"
check "none in a file without" refuses 1 "no element in the file has a state" df --state existing "$deep"
sed 's/<room name/<room state="existing" name/' "$site" >"$scratch/gone.xml"
check "rooms that all go" refuses 1 "the file has no proposed room" df "$scratch/gone.xml"
check "are there before" gives df --state existing -m exact "$scratch/gone.xml"
check "a room that is new has nothing before" sh -c "
    sed 's/<room name=\"Study\"/<room state=\"proposed\" name=\"Study\"/' '$site' |
        '$pepperpot' assess --by-hand -c vsc,former-sky --table - | sed -n '/Windows, proposed rooms/,\$p' | grep -qE '^  Study .*W3, south +[0-9.]+  (not )?met'"

# An overhang gives output identical to the equivalent surface.
cat >"$scratch/overhang.xml" <<'EOF'
<room version="1" name="Shaded">
  <plan width="4.2" depth="5.3" height="2.7"/>
  <window wall="south" left="0.9" sill="0.8" width="2.4" height="1.5">
    <overhang depth="0.8" above="0.1" left="0.3" right="0.2"/>
  </window>
</room>
EOF
cat >"$scratch/surface.xml" <<'EOF'
<room version="1" name="Shaded">
  <plan width="4.2" depth="5.3" height="2.7"/>
  <window wall="south" left="0.9" sill="0.8" width="2.4" height="1.5"/>
  <surface> <vertex x="0.6" y="0" z="2.4"/> <vertex x="3.5" y="0" z="2.4"/>
    <vertex x="3.5" y="-0.8" z="2.4"/> <vertex x="0.6" y="-0.8" z="2.4"/> </surface>
</room>
EOF
check "an overhang" gives df -m exact+bre,brs-table --simulate --error 3% -f json "$scratch/overhang.xml"
cp "$scratch/out" "$scratch/overhang.json"
check "is the surface written out" sh -c "
    '$pepperpot' df -m exact+bre,brs-table --simulate --error 3% -f json '$scratch/surface.xml' |
        cmp - '$scratch/overhang.json'"
check "a sized window keeps it" sh -c "
    '$pepperpot' size --target 2% --by-hand '$scratch/overhang.xml' -w '$scratch/sized.xml' -q >/dev/null &&
        grep -q '<overhang' '$scratch/sized.xml' &&
        '$pepperpot' df -m average-df '$scratch/sized.xml' >/dev/null"
sed 's/width="2.4"/width="0.5"/' "$scratch/overhang.xml" >"$scratch/narrow.xml"
check "three of them have it each" sh -c "
    '$pepperpot' size --target 1.6% --change number --by-hand '$scratch/narrow.xml' \
        -w '$scratch/more.xml' -q >/dev/null &&
        [ \$(grep -c '<overhang' '$scratch/more.xml') -eq 3 ] &&
        [ \$(grep -c '</window>' '$scratch/more.xml') -eq 3 ]"

office=$examples/office.xml
check "a window in the opposite wall is advised" shows "same size in the opposite" \
    assess --by-hand "$office"
sed 's/<site /<wall name="north" kind="party"\/><site /' "$office" >"$scratch/party.xml"
check "but not in a party wall" gives assess --by-hand "$scratch/party.xml"
check "nowhere" nothing "$(grep 'opposite wall' "$scratch/out")"
# ---- neighbours and proposed rooms, the cumulative state ----

room() { # NAME ADDRESS USE X Z STATE
    echo "<room name='$1' address='$2' use='$3' x='$4' y='0' z='$5' state='$6'>
<plan width='4' depth='5' height='2.6'/>
<window name='W' wall='south' left='1' sill='0.8' width='1.6' height='1.4'/>
<working-plane height='0.85'/></room>"
}
blocks="<block name='Shed' state='existing' x='2' y='-20' width='14' depth='8' height='4'/>
<block name='Tower' state='proposed' x='2' y='-20' width='14' depth='8' height='14'/>
<block name='Next' state='cumulative' x='-16' y='-20' width='16' depth='8' height='17'/>"
{
    echo "<building version='1'><site latitude='51.5' longitude='-0.1' country='GB'/>"
    echo "$blocks"
    room Living "12 Mill Lane" living-room 0 0.5 both
    room Bedroom "12 Mill Lane" bedroom 0 3.5 both
    room Kitchen "14 Mill Lane" kitchen 5 0.5 both
    room Flat "Tower" living-room -9 0.5 proposed
    echo "</building>"
} >"$scratch/lane.xml"
check "a site with three states" gives assess --by-hand --for uk-planning --table "$scratch/lane.xml"
check "has sums for each floor" grep -q "^  12 Mill Lane, floor at +3.50 m  *[01] of 1  *[01] of 1" "$scratch/out"
check "and for a house" grep -q "^  12 Mill Lane, all floors  *[0-2] of 2" "$scratch/out"
check "proposed rooms have a list of their own" grep -q "^  Other criteria, proposed rooms" "$scratch/out"
check "with targets for dwellings and sun" grep -qE "living room: 150 lx|1.5 h on 21 March" "$scratch/out"
check "neighbours have no such targets" nothing "$(grep 'bedroom: 100' "$scratch/out")"
check "and new windows are not compared" nothing "$(grep -E '^  Flat +W' "$scratch/out")"
cumulative=$("$pepperpot" assess --by-hand --for uk-planning --table -f json "$scratch/lane.xml" |
    sed -n 's/.*"room": "Living".*"former-sky".*"cumulative": \([0-9.]*\).*/\1/p')
vsc_of_living() { # FILE OPTION ...
    "$pepperpot" assess --by-hand -c vsc --room Living -f csv "$@" | awk -F, 'NR == 2 { print $10 }'
}
check "the cumulative sky is that of the state" test "$cumulative" = \
    "$(vsc_of_living --state cumulative "$scratch/lane.xml")"
sed "/name='Shed'/d; s/state='[a-z]*'//" "$scratch/lane.xml" >"$scratch/all.xml"
check "and of a file where all of it stands" test "$cumulative" = "$(vsc_of_living "$scratch/all.xml")"
check "a schedule has a column of it" gives assess --by-hand --for uk-planning \
    --schedule "$scratch/lane.csv" "$scratch/lane.xml"
check "with the same figure" grep -q "$cumulative" "$scratch/lane.csv"
check "a site without that state has none" nothing \
    "$("$pepperpot" assess --by-hand --for uk-planning --table "$site" | grep cumulative)"
check "another state is refused" refuses 2 "expected existing, proposed or cumulative" \
    df --state built "$scratch/lane.xml"
sed "s/state='cumulative'/state='permitted'/" "$scratch/lane.xml" >"$scratch/permitted.xml"
check "in a file, too" refuses 1 'expected "existing", "proposed", "cumulative" or "both"' \
    df "$scratch/permitted.xml"

tap_done
