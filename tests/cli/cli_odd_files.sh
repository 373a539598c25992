#!/bin/sh
# Valid but unusual files, and malicious ones: read correctly, or rejected with a message.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# Radiance scenes.
printf '\357\273\277void plastic w 0 0 5 .5 .5 .5 0 0\nw sphere s 0 0 4 0 0 0 1\n' >"$scratch/ball.rad"
check "a byte order mark is passed over" shows "spheres           1" \
    import --summary "$scratch/ball.rad"
check "a command stands for a file" shows "from              2 -1 -1" \
    import --summary "!xform -t 3 0 0 $scratch/ball.rad"
check "which is not executed" refuses 1 "external programs are not run" \
    import --summary "!touch $scratch/made"
check "indeed" test ! -e "$scratch/made"
cat >"$scratch/sides.rad" <<'RAD'
void plastic w 0 0 5 .5 .5 .5 0 0
void plastic b 0 0 5 .2 .2 .2 0 0
void mixfunc wb 4 w b "if(Rdot, 1, 0)" . 0 0
wb polygon p 0 0 9 0 0 0 1 0 0 0 1 0
RAD
check "a word in quotes holds blanks" shows "polygons          1" import --summary "$scratch/sides.rad"
sed 's/0)"/0)/' "$scratch/sides.rad" >"$scratch/wrong.rad"
check "one that does not end" refuses 1 "wrong.rad:3: a quoted word" \
    import --summary "$scratch/wrong.rad"
printf 'void plastic "" 0 0 5 .5 .5 .5 0 0\n' >"$scratch/wrong.rad"
check "one with nothing in it" refuses 1 "a quoted word is empty" \
    import --summary "$scratch/wrong.rad"
printf 'void plastic pink 0 0 5 .5 .5 .5 0 0\nvoid mirror m 1 pink 0 3 .9 .9 .9\n' >"$scratch/wrong.rad"
check "a mirror for lamps alone is named" refuses 1 'the alternate material "pink"' \
    import --summary "$scratch/wrong.rad"
printf 'secret:x:0\n' >"$scratch/private"
printf '!xform %s\n' "$scratch/private" >"$scratch/wrong.rad"
check "a file that is no scene" refuses 1 "is not a Radiance scene" \
    import --summary "$scratch/wrong.rad"
check "is not quoted" test -z "$(grep secret "$scratch/err")"
check "a scene without a primitive" refuses 1 "the scene is empty" import --summary /dev/null

# Room files.
box='<plan width="4" depth="6" height="2.8"/><window wall="south" left="1" sill="0.8" width="2" height="1.5"/>'
echo "<building version=\"1\">
<room name=\"A\" x=\"0\" y=\"0\">$box</room>
<room name=\"B\" x=\"2\" y=\"1\" rotate=\"20\">$box</room></building>" >"$scratch/overlap.xml"
check "two rooms that overlap" refuses 1 '"A" and the room "B" on line 3 overlap' df "$scratch/overlap.xml"
check "are told so once" test "$(grep -c overlap, "$scratch/err")" -eq 1
echo "<building version=\"1\"><room name=\"=1+1\" x=\"0\" y=\"0\">$box<point x=\"2\" y=\"2\"/></room></building>" \
    >"$scratch/formula.xml"
check "a name that a spreadsheet would run is marked" shows ",'=1+1,point," \
    df -m exact -f csv "$scratch/formula.xml"
# A single process started by srun runs normally; several need the module.
check "a single rank" sh -c "PMI_RANK=0 PMI_SIZE=1 '$pepperpot' --version >/dev/null"
check "a file that may not grow is an error" sh -c \
    "ulimit -f 1; '$pepperpot' df -m all -f csv '$examples/office.xml' -o '$scratch/big.csv' 2>'$scratch/said'; test \$? -eq 3"
check "with nothing left of it" test ! -e "$scratch/big.csv"
# Files named in a file: reading a pipe would wait for ever.
mkfifo "$scratch/pipe.hdr" "$scratch/pipe.rad"
echo "<room version=\"1\"><sky type=\"picture\" file=\"pipe.hdr\"/>$box<point x=\"2\" y=\"2\"/></room>" \
    >"$scratch/piped.xml"
check "a sky that is a pipe" refuses 1 "pipe.hdr: this is not a regular file" df "$scratch/piped.xml"
echo "<room version=\"1\">$box<rooflight x=\"1\" y=\"1\" width=\"1\" depth=\"1\" glazing-file=\"pipe.hdr\"/></room>" \
    >"$scratch/piped.xml"
check "a pane that is a pipe" refuses 1 "pipe.hdr: this is not a regular file" df "$scratch/piped.xml"
echo "!xform $scratch/pipe.rad" >"$scratch/piped.rad"
check "a scene that is a pipe" refuses 1 "pipe.rad: this is not a regular file" import --summary "$scratch/piped.rad"
# An atlas grows in its file; if nothing could be written, no file is left.
check "an atlas on a full disk is an error" sh -c \
    "ulimit -f 0; '$pepperpot' atlas -n 1 -o '$scratch/atlas.csv' 2>/dev/null; test \$? -eq 3"
check "with no empty file left of it" test ! -e "$scratch/atlas.csv"
tap_done
