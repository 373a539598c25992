#!/bin/sh
# Results use the user's names: tables and JSON have an opening's label (its name, or W1), its name
# and its wall; JSON also has the line of the file.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

cd "$scratch" || exit 1
cat >named.xml <<'END'
<room version="1" name="Studio">
  <plan width="4" depth="5" height="3"/>
  <window name="Big window" wall="south" left="1" sill="0.8" width="2" height="1.5"/>
  <window wall="east" left="1" sill="0.8" width="1" height="1.5"/>
  <rooflight x="1" y="3" width="1" depth="1"/>
  <point x="2" y="2"/>
</room>
END
check "df as JSON" gives df -m exact --format json named.xml
check "an opening has its names" grep -qF '"line": 3, "label": "Big window", "name": "Big window",' out
check "its wall and its room" grep -qF '"wall": "south", "room": "Studio", "face": "south"' out
check "without a name it has a label" grep -qF '"line": 4, "label": "W1", "wall": "east"' out
check "so has a rooflight" grep -qF '"line": 5, "label": "RL1", "room": "Studio"' out

check "steps as JSON" gives df -m exact+bre --explain --points 2,2 --format json named.xml
check "a step has its opening's line and names" grep -q \
    '"opening": 3, "label": "Big window", "name": "Big window", "wall": "south"' out
check "a step of the whole room has none" nothing "$(grep '"step"' out | grep -v '"opening"' |
    grep label)"

check "assess as JSON" gives assess --by-hand -q -c vsc --format json named.xml
check "a finding has line and names" grep -qF \
    '"of": "Big window, south", "line": 3, "label": "Big window", "name": "Big window", "wall": "south"' out
check "assess as text" shows "Big window, south" assess --by-hand -q -c vsc named.xml
check "has no line of the file" nothing "$(grep 'line [0-9]' out)"

check "size as JSON" gives size --target 8% --by-hand -q --format json named.xml
check "a changed window has its names" grep -qF '"line": 3, "label": "Big window", "name": "Big window", "wall": "south"' out
tap_done
