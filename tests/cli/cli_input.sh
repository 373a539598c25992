#!/bin/sh
# Room files from various programs and with errors: all mistakes are reported, and nothing is
# calculated.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

check "a file that is not there" refuses 1 "missing.xml" df "$scratch/missing.xml"
check "a directory is no room" refuses 1 "$scratch" df "$scratch"
check "a device is no room" refuses 1 "/dev/zero: this is a device; expected a file" \
    df /dev/zero
check "nor one without an end a scene" refuses 1 "/dev/zero: this is a device" import /dev/zero
check "standard input that never ends" sh -c "
    '$pepperpot' import - </dev/zero 2>'$scratch/err'
    [ \$? -eq 1 ] && grep -qF 'larger than 512 MiB' '$scratch/err'"
check "an empty file" refuses 1 "standard input" df -
twice="standard input can be read only once"
check "standard input is not two rooms" refuses 2 "$twice" df - -
check "nor room and weather of a plan" refuses 2 "--weather and FILE are both -" \
    chart plan --when "2023-03-21 12:00" -w - -o "$scratch/x.svg" -
check "nor those of a year" refuses 2 "$twice" annual -w - -
check "nor those of an hour" refuses 2 "$twice" df --when "2023-03-21 12:00" -w - -
check "nor of LEED" refuses 2 "$twice" assess --for leed-v4.1 -w - -
check "nor a room before and after" refuses 2 "--before and FILE" assess --before - -
check "nor its weather and its former state" refuses 2 "--weather and --before" \
    assess --before - -w - "$deep"
check "nor a scene and its points" refuses 2 "$twice" import --points-file - -
check "a kind of chart is no file" refuses 2 "there is no chart" chart - -o "$scratch/x.svg" -

cat >"$scratch/wrong.xml" <<'XML'
<room version="1">
  <plan width="3" depth="4" height="2.7"/>
  <window wall="south" left="0.5" sill="0.8" width="22" height="1.5"/>
  <windoww/>
</room>
XML
check "a mistake names file and line" refuses 1 "$scratch/wrong.xml:3: " \
    df "$scratch/wrong.xml"
check "all mistakes are named at once" refuses 1 "$scratch/wrong.xml:4: " \
    df "$scratch/wrong.xml"
check "a wrong file among right ones stops all of them" refuses 1 "wrong.xml:3: " \
    df "$deep" "$scratch/wrong.xml"
check "mistakes of all files are named" refuses 1 "missing.xml" \
    df "$scratch/missing.xml" "$scratch/wrong.xml"
check "the second of two wrong files is named too" grep -q "wrong.xml:3: " "$scratch/err"
check "a chart of a wrong file" refuses 1 "wrong.xml:3: " \
    chart plan -o "$scratch/none.pdf" "$scratch/wrong.xml"
check "leaves no file behind" test ! -e "$scratch/none.pdf"

if [ "$(id -u)" -ne 0 ]; then
    cp "$deep" "$scratch/locked.xml"
    chmod 0 "$scratch/locked.xml"
    check "a file that may not be read" refuses 3 "locked.xml" df "$scratch/locked.xml"
else
    skip "a file that may not be read" "root may read everything"
fi

mkdir "$scratch/Büro mit Räumen"
cp "$deep" "$scratch/Büro mit Räumen/tief & hell.xml"
check "paths with blanks and UTF-8" shows "tief & hell.xml" \
    df "$scratch/Büro mit Räumen/tief & hell.xml"

"$pepperpot" df --format csv "$deep" | sed 's/^[^,]*,//' >"$scratch/named"
"$pepperpot" df --format csv - <"$deep" | sed 's/^[^,]*,//' >"$scratch/piped"
check "standard input gives the same numbers" same "$scratch/named" "$scratch/piped"
cp "$deep" "$scratch/--methods"
check "a file whose name is an option, behind --" \
    sh -c "cd '$scratch' && '$pepperpot' df -- --methods >out"

# gapped GAP: a room described by its faces, whose street wall ends this far from the corner.
gapped() {
    cat <<XML
<room version="1" name="gap"><envelope>
$(face floor floor "0 0 0" "3.1 0 0" "3.1 5.3 0" "0 5.3 0")
$(face ceiling ceiling "0 0 2.7" "0 5.3 2.7" "3.1 5.3 2.7" "3.1 0 2.7")
$(face wall street "$1 0 0" "0 0 0" "0 0 2.7" "$1 0 2.7")
$(face wall garden "0 5.3 0" "3.1 5.3 0" "3.1 5.3 2.7" "0 5.3 2.7")
$(face wall right "3.1 5.3 0" "3.1 0 0" "3.1 0 2.7" "3.1 5.3 2.7")
$(face wall left "0 0 0" "0 5.3 0" "0 5.3 2.7" "0 0 2.7")
</envelope>
<window wall="street" left="0.5" sill="0.8" width="1" height="1.5"/>
<point x="1.5" y="2.1"/></room>
XML
}

# face ROLE NAME "X Y Z"...: a face with these corners.
face() {
    printf '<face role="%s" name="%s">' "$1" "$2"
    shift 2
    for corner; do
        echo "$corner" | sed 's|\(.*\) \(.*\) \(.*\)|<vertex x="\1" y="\2" z="\3"/>|'
    done
    echo '</face>'
}
gapped 3.1 >"$scratch/gap.xml"
"$pepperpot" df --methods exact --format csv "$scratch/gap.xml" >"$scratch/shut"
gapped 3.0992 >"$scratch/gap.xml"
check "a gap of less than a millimetre in an envelope is closed" sh -c "
    '$pepperpot' df --methods exact --format csv '$scratch/gap.xml' |
        cmp - '$scratch/shut'"
gapped 3.099 >"$scratch/gap.xml"
check "one of a millimetre is open, however it rounds" \
    refuses 1 "the envelope is open" df "$scratch/gap.xml"
gapped 3.101 >"$scratch/gap.xml"
check "on either side" refuses 1 "the envelope is open" df "$scratch/gap.xml"

# Text from files and arguments is escaped before it reaches a terminal.
escape=$(printf '\033[31m')
check "a message with a control character" refuses 1 '\x1b[31m' df "no${escape}such"
check "shows it in letters" nothing "$(grep -F "$escape" "$scratch/err")"

# A room without windows has no daylight: a warning, not a mistake.
printf '<room version="1" name="a,&quot;b"><plan width="3" depth="4" height="2.7"/>%s</room>' \
    '<point x="1" y="1"/>' >"$scratch/closed.xml"
run df "$scratch/closed.xml"
check "a closed room is computed" grep -qF 'a,"b' "$scratch/out"
check "with a warning" grep -q 'has no window' "$scratch/err"
check "with no light" grep -qE '^ +1.00 +1.00 +0.00 ' "$scratch/out"
sed 's|glazing="[^"]*"|glazing="stained" transmittance="0.5"|' "$deep" >"$scratch/two.xml"
check "two mistakes of one glass are both told" refuses 1 'glazing is "stained"' \
    df "$scratch/two.xml"
check "the second one too" grep -qF "are both given" "$scratch/err"
tap_done
