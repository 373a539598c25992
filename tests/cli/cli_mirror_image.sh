#!/bin/sh
# A new building compared with the mirror image of the old one at the boundary.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
LC_ALL=C
export LC_ALL

room='<plan width="4.2" depth="5.3" height="2.7"/>
  <window name="W" wall="south" left="0.9" sill="0.8" width="2.4" height="1.5"/>'
site() {
    echo '<building version="1" name="Terrace">'
    echo '<block name="Mill" x="-30" y="-60" width="60" depth="9" height="12"/>'
    cat
    echo "<room name='Low' use='living-room' x='0' y='0'>$room</room>"
    echo "<room name='High' use='bedroom' x='0' y='0' z='2.7'>$room</room>"
    echo '</building>'
}
site >"$scratch/terrace.xml" <<'EOF'
<block name="Shed" state="existing" x="-5" y="-12" width="9" depth="3" height="2.5"/>
<block name="Tower" state="proposed" x="-2" y="-16" width="8" depth="6" height="14"/>
EOF
# The boundary is 5.5 m in front of the façade, so the mirror image is 11 m away.
site >"$scratch/image.xml" <<'EOF'
<block x="0" y="-16.3" width="4.2" depth="5.3" height="5.4"/>
EOF
line=-9,-5.5,20,-5.5
"$pepperpot" assess -c mirror-image -f csv --mirror-image=$line "$scratch/terrace.xml" >"$scratch/mirrored.csv"
"$pepperpot" assess -c vsc,nsl -f csv "$scratch/image.xml" >"$scratch/image.csv"
check "windows have the sky that they have before the image as a block" sh -c "
    sed -n 's/.*,mirror-image,\"W, south\",[0-9]*,[0-9.]*,[0-9.]*,%,,\\([0-9.]*\\),least.*/\\1/p' \
        '$scratch/mirrored.csv' >'$scratch/a'
    sed -n 's/.*,vertical-sky,\"W, south\",[0-9]*,\\([0-9.]*\\),.*/\\1/p' \
        '$scratch/image.csv' >'$scratch/b'
    paste '$scratch/a' '$scratch/b' |
        awk '{ d = \$1 - \$2; if (d > 1e-6 || -d > 1e-6) bad = 1; n++ } END { exit bad || n != 2 }'"
check "a table has it beside the ratio" gives assess --by-hand --for uk-planning --table \
    --mirror-image=$line "$scratch/terrace.xml"
check "fits in 80 columns" nothing "$(too_wide)"
check "under its name" grep -q ' mirror image$' "$scratch/out"
check "with the words of what is judged by it" sh -c "
    tr -s ' \n' ' ' <'$scratch/out' | grep -q 'sky remains with the proposal as with the mirror image \[BR209\]'"
check "the tower takes more than the image would" grep -qE '^  Low .*  not met$' "$scratch/out"
sed 's/height="14"/height="3.5"/' "$scratch/terrace.xml" >"$scratch/lower.xml"
check "a lower one does not" gives assess -c mirror-image --mirror-image=$line "$scratch/lower.xml"
check "all is met" nothing "$(grep 'not met' "$scratch/out")"
check "JSON has both verdicts" shows '"mirror_image_verdict": "met"' \
    assess -c vsc,former-sky,mirror-image --table -f json --mirror-image=$line "$scratch/lower.xml"
check "a sheet names its target" shows "a mirror image of the building at the boundary" \
    assess -c mirror-image --mirror-image=$line --room Low "$scratch/terrace.xml"
check "so does a report" sh -c "
    '$pepperpot' report --by-hand -q --for uk-planning --mirror-image=$line '$scratch/terrace.xml' \
        -o '$scratch/report.html' && grep -q 'mirror image, %' '$scratch/report.html' &&
        grep -q 'mirror-image -9,-5.5,20,-5.5' '$scratch/report.html'"

check "without the option no image" nothing \
    "$("$pepperpot" assess --by-hand --for uk-planning --table "$scratch/terrace.xml" | grep -i mirror)"
check "a point is no line" refuses 2 "expected two different points X1,Y1,X2,Y2" \
    assess --mirror-image 1,2,1,2 "$scratch/terrace.xml"
check "nor are three numbers" refuses 2 "expected two different points X1,Y1,X2,Y2" \
    assess --mirror-image 1,2,3 "$scratch/terrace.xml"
check "a line through the rooms" refuses 1 'crosses the room "Low"' \
    assess --by-hand --mirror-image=-9,1,9,1 "$scratch/terrace.xml"
sed 's/name="High" *use/name="High" use/; s/<room name=.High. \(.*\) y=.0./<room name="High" \1 y="-30"/' \
    "$scratch/terrace.xml" >"$scratch/apart.xml"
check "rooms on both sides" refuses 1 "are on opposite sides of the line" \
    assess --by-hand --mirror-image=$line "$scratch/apart.xml"
sed "s/ x='0' y='0'//; s/ z='2.7'//" "$scratch/terrace.xml" >"$scratch/loose.xml"
check "rooms without a place" refuses 1 "no building to mirror" \
    assess --by-hand --mirror-image=$line "$scratch/loose.xml"
check "a site without states" refuses 1 "no element in the file has a state" \
    assess --by-hand --mirror-image=$line "$scratch/image.xml"
check "not beside another file" refuses 2 "cannot be combined with --before" \
    assess --mirror-image=$line --before "$scratch/image.xml" "$scratch/terrace.xml"
check "the criterion needs the line" refuses 2 "expected --mirror-image" \
    assess -c mirror-image "$scratch/terrace.xml"
tap_done
