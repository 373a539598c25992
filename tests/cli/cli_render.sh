#!/bin/sh
# render: pictures of rooms in every format and from every view; rejected options.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

small="--size 48x32 --samples 2 --engine path"

# draws FILE WORDS: status 0, no messages, and the file exists.
draws() {
    file=$scratch/$1
    shift
    rm -f "$file"
    quietly render "$@" -o "$file" && { [ -s "$file" ] || told; }
}

# begins FILE TEXT: the file begins with this text.
begins() {
    head -c 8 "$scratch/$1" | grep -aqF -- "$2"
}

for format in hdr pfm png pdf svg; do
    check "a picture as $format" draws "a.$format" $small "$deep"
done
check "a Radiance picture begins as one" begins a.hdr '#?RADIAN'
check "and names its view" grep -aq '^VIEW= -vtv -vp 1\.[0-9]* 8\.' "$scratch/a.hdr"
check "and its exposure" grep -aqx 'EXPOSURE= 1.000000000e+00' "$scratch/a.hdr"
check "and its size" grep -aqx -- '-Y 32 +X 48' "$scratch/a.hdr"
check "a float map begins as one" begins a.pfm PF
check "windows are aimed at" draws aimed.hdr $small --windows aimed "$deep"
check "or found by chance" draws chance.hdr $small --windows chance "$deep"
check "which is another picture" sh -c "! cmp -s '$scratch/aimed.hdr' '$scratch/chance.hdr'"
check "and no otherwise" refuses 2 "stored, aimed or chance" \
    render $small --windows open "$deep" -o "$scratch/x.hdr"
check "a PNG begins as one" begins a.png PNG
check "a PDF begins as one" begins a.pdf '%PDF'
check "an SVG is one" grep -q '<svg ' "$scratch/a.svg"

for view in perspective plan section hemispherical angular; do
    check "view $view" draws "$view.png" $small --view $view "$deep"
done
check "a parallel view" draws p.png $small --view parallel --from 1.5,5,1 \
    --direction 0,-1,0 --across 3 "$deep"
check "a view from and towards" draws v.png $small --from 1,2 --towards 2,0,1.5 "$deep"
for quantity in luminance illuminance df; do
    check "quantity $quantity" draws "q-$quantity.hdr" $small --quantity $quantity "$deep"
done
check "a picture of daylight factors says so" grep -aqx 'QUANTITY= df' "$scratch/q-df.hdr"
check "one of luminances says nothing" \
    nothing "$(grep -a QUANTITY "$scratch/q-luminance.hdr")"

for how in auto human 500; do
    check "exposure $how" draws e.png $small --exposure $how "$deep"
done
check "false colour on a sheet" draws f.png $small --false-colour --dpi 30 "$deep"
check "false colour with a scale of one's own" draws f.svg $small --false-colour \
    --quantity df --range 0.1,20 --levels 1,2,5 --paper a5 "$deep"
check "false colour, linear, without lines" \
    draws f.pdf $small --false-colour --linear --no-contours "$deep"
check "a fisheye with its grid" \
    draws g.svg --size 40x40 --samples 1 --engine path --view angular --grid "$deep"

cat >"$scratch/dark.xml" <<'END'
<room version="1"><plan width="3" depth="5" height="2.5"/></room>
END
run render $small "$scratch/dark.xml" -o "$scratch/dark.png"
check "a room without light is black, and it is said" eval \
    '[ $status -eq 0 ] && [ -s "$scratch/dark.png" ] &&
     grep -q "the picture is black" "$scratch/err" || told'

run render $small --from 1.5,-3 --towards 1.5,4 "$deep" -o "$scratch/front.png"
check "an eye outside the room is said" eval \
    '[ $status -eq 0 ] && grep -q "the eye is outside the room" "$scratch/err" || told'
run render $small "$deep" -o "$scratch/inside.png"
check "an eye in the room is not" test ! -s "$scratch/err"

# ---- identical results ----

"$pepperpot" render $small --threads 1 "$deep" -o "$scratch/one.hdr"
"$pepperpot" render $small --threads 3 "$deep" -o "$scratch/three.hdr"
check "threads do not matter" same "$scratch/one.hdr" "$scratch/three.hdr"
check "nor does where it goes" gives render $small --format hdr "$deep"
check "to the byte" same "$scratch/one.hdr" "$scratch/out"
"$pepperpot" render $small --seed 2 "$deep" -o "$scratch/seed.hdr"
check "the seed does" test "$(cksum <"$scratch/one.hdr")" != "$(cksum <"$scratch/seed.hdr")"
"$pepperpot" render $small --external 20000 "$deep" -o "$scratch/bright.hdr"
check "twice the light outside is another picture" \
    test "$(cksum <"$scratch/one.hdr")" != "$(cksum <"$scratch/bright.hdr")"

# ---- through a cache ----

cached="--size 24x16 --samples 2 -ab 2 -ad 64 -as 0 -aa 0.3"
check "a picture through a cache" \
    draws k1.hdr $cached --threads 1 --cache "$scratch/records" "$deep"
check "which is kept" test -s "$scratch/records"
check "and read again" draws k2.hdr $cached --cache "$scratch/records" "$deep"
check "gives the same picture to the byte" same "$scratch/k1.hdr" "$scratch/k2.hdr"
check "as does one that grows anew on three threads" \
    draws k3.hdr $cached --threads 3 "$deep"
check "to the byte" same "$scratch/k1.hdr" "$scratch/k3.hdr"
check "daylight factors with the records on them" \
    draws k.svg $cached --quantity df --false-colour --records "$deep"
check "a cache of another sky" refuses 1 "records" render $cached --sky uniform \
    --cache "$scratch/records" "$deep" -o "$scratch/x.hdr"
check "a constant of paths" refuses 2 "--engine cache" \
    render $small -av 0.1 "$deep" -o "$scratch/x.png"
check "records of paths" refuses 2 "--engine cache" \
    render $small --records "$deep" -o "$scratch/x.png"

check "a sheet of a bright room" draws words.pdf $small --sky iso-1 --external 60000 \
    --false-colour --range 10,10000 "$deep"
check_words "has its words and its figures in full" "$scratch/words.pdf" \
    "under an ISO 15469 sky" 10000

# ---- from an existing picture ----

check "a picture shown again" draws s.png --from-picture "$scratch/one.hdr"
check "has the size it had" \
    test "$(od -An -tx1 -j16 -N8 "$scratch/s.png" | tr -d ' ')" = 0000003000000020
check "in false colours" \
    draws s.svg --from-picture "$scratch/q-df.hdr" --false-colour
check "as a float map" draws s.pfm --from-picture "$scratch/one.hdr"
check "a picture of another quantity" refuses 1 "a picture of df, not of illuminance" \
    render --from-picture "$scratch/q-df.hdr" --quantity illuminance -o "$scratch/x.png"
head -c 200 "$scratch/one.hdr" >"$scratch/cut.hdr"
check "a picture that is cut off" refuses 1 "cut.hdr: " \
    render --from-picture "$scratch/cut.hdr" -o "$scratch/x.png"
check "a picture that is none" refuses 1 "not a Radiance picture" \
    render --from-picture "$deep" -o "$scratch/x.png"
check "a picture that is not there" refuses 1 "missing.hdr" \
    render --from-picture "$scratch/missing.hdr" -o "$scratch/x.png"
check "none of these left a file" test ! -e "$scratch/x.png"

# ---- standard errors ----

# noisy SEED: a picture of 32 x 24 pixels by paths, with its errors.
noisy() {
    draws "p$1.pfm" --size 32x24 --engine path --samples 16 --seed "$1" \
        --errors "$scratch/e$1.pfm" "$deep"
}

# numbers FILE: the numbers of a float map of 32 x 24 pixels, one per line.
numbers() {
    tail -c $((32 * 24 * 3 * 4)) "$scratch/$1.pfm" | od -An -v -tf4 -w4
}

check "a picture with its standard errors" noisy 1
check "and another seed's" noisy 2
for file in p1 p2 e1 e2; do numbers $file >"$scratch/$file.txt"; done
check "which differ by what they state (RMS within a tenth of 1)" eval \
    'paste "$scratch/p1.txt" "$scratch/p2.txt" "$scratch/e1.txt" "$scratch/e2.txt" |
     awk "{ z = \$3 > 0 ? (\$1 - \$2)^2 / (\$3^2 + \$4^2) : 0; sum += z; count += \$3 > 0 }
          END { exit !(count == 2304 && sum / count > 0.81 && sum / count < 1.21) }"'

# ---- checkpoints and Ctrl-C ----

long="--size 400x300 --samples 512 --engine path --quiet"
check "interrupted, there is no picture" eval \
    'interrupted render $long "$deep" -o "$scratch/i.hdr"; [ $status -eq 130 ] &&
     [ ! -e "$scratch/i.hdr" ] && grep -q -- "--checkpoint" "$scratch/err" || told'
check "interrupted while the cache grows, nothing is kept, and that is said" eval \
    'interrupted render --size 64x48 --samples 1 -ad 16384 --quiet \
         --checkpoint "$scratch/g" "$deep" -o "$scratch/i.hdr"; [ $status -eq 130 ] &&
     [ ! -e "$scratch/i.hdr" ] && [ ! -e "$scratch/g" ] &&
     grep -q "nothing was saved" "$scratch/err" || told'
check "interrupted with a checkpoint, what is done is kept" eval \
    'interrupted render $long --checkpoint "$scratch/c" "$deep" -o "$scratch/i.hdr";
     [ $status -eq 130 ] && [ ! -e "$scratch/i.hdr" ] && [ -s "$scratch/c" ] || told'
# A picture that takes about 2 s. A machine that completes it before the signal has no checkpoint
# to continue from.
rest="--size 200x150 --samples 64 --engine path --threads 1 --quiet"
interrupted render $rest --checkpoint "$scratch/r" "$deep" -o "$scratch/r.hdr"
if [ $status -eq 130 ] && [ ! -e "$scratch/r.hdr" ]; then
    check "the same command goes on from there" \
        draws r.hdr $rest --checkpoint "$scratch/r" "$deep"
    "$pepperpot" render $rest "$deep" -o "$scratch/w.hdr"
    check "to the picture of one that was never interrupted" \
        same "$scratch/r.hdr" "$scratch/w.hdr"
else
    skip "the same command goes on from there" "it was done too soon"
    skip "to the picture of one that was never interrupted" "it was done too soon"
fi
check "nothing temporary is left" nothing "$(leftovers)"
check "another picture does not go on from it" refuses 1 "another picture" \
    render $small --checkpoint "$scratch/c" "$deep" -o "$scratch/x.hdr"
check "a picture made with a checkpoint" \
    draws c.hdr $small --checkpoint "$scratch/d" "$deep"
check "is the same" same "$scratch/one.hdr" "$scratch/c.hdr"
check "and comes again from the checkpoint" \
    draws c.hdr $small --checkpoint "$scratch/d" "$deep"
check "the same once more" same "$scratch/one.hdr" "$scratch/c.hdr"
check "a picture through a cache, with a checkpoint" \
    draws c.hdr $cached --checkpoint "$scratch/e" "$deep"
check "is the same as without" same "$scratch/k1.hdr" "$scratch/c.hdr"
check "and comes again, with the records that the checkpoint keeps" \
    draws c.hdr $cached --checkpoint "$scratch/e" "$deep"
check "to the byte once more" same "$scratch/k1.hdr" "$scratch/c.hdr"
check "another accuracy does not go on from it" refuses 1 "another picture" \
    render $cached -aa 0.4 --checkpoint "$scratch/e" "$deep" -o "$scratch/x.hdr"
head -c 1000 "$scratch/d" >"$scratch/cut"
check "a checkpoint that is cut off" refuses 1 "cut off or damaged" \
    render $small --checkpoint "$scratch/cut" "$deep" -o "$scratch/x.hdr"
for length in 0 7 8 47 55 56 900; do
    head -c $length "$scratch/d" >"$scratch/cut"
    check "one of $length bytes is no better" refuses 1 "checkpoint" \
        render $small --checkpoint "$scratch/cut" "$deep" -o "$scratch/x.hdr"
done
check "nor is it written over" test "$(wc -c <"$scratch/cut")" -eq 900
for other in "--size 48x33" "--samples 4" "--seed 2" "--quantity df" "--sky uniform" \
    "--filter gauss" "--view plan" "-ab 3" "--engine cache -ad 16 -as 0"; do
    check "a checkpoint of a picture without $other" refuses 1 "another picture" \
        render $small $other --checkpoint "$scratch/d" "$deep" -o "$scratch/x.hdr"
done
check "a checkpoint of another room" refuses 1 "another picture" \
    render $small --checkpoint "$scratch/d" "$examples/office.xml" -o "$scratch/x.hdr"
{ head -c 8 "$scratch/d"; printf '\7'; tail -c +10 "$scratch/d"; } >"$scratch/cut"
check "a checkpoint of another version" refuses 1 "version 7" \
    render $small --checkpoint "$scratch/cut" "$deep" -o "$scratch/x.hdr"
check "a place for no checkpoint is said at once" refuses 3 "nowhere" \
    render $long --checkpoint "$scratch/nowhere/c" "$deep" -o "$scratch/x.hdr"
check "picture and checkpoint in one file" refuses 2 "are the same file" \
    render $small --checkpoint "$scratch/x.hdr" "$deep" -o "$scratch/x.hdr"
# fills WORDS: on a full disk the status is 3, and no part of the picture is left.
fills() {
    on_full_disk 0 render $small "$@" "$deep"
    test $status -eq 3 && nothing "$(leftovers; find "$scratch" -name 'x.*')"
}
for format in hdr pfm png pdf svg; do
    check "a full disk leaves nothing of a $format" fills -o "$scratch/x.$format"
done
check "nor of a checkpoint" fills --checkpoint "$scratch/x.c" -o "$scratch/x.hdr"
check "a file that is no checkpoint" refuses 1 "not a checkpoint" \
    render $small --checkpoint "$examples/office.xml" "$deep" -o "$scratch/x.hdr"

# ---- options that make no sense ----

check "no output" refuses 2 "expected -o FILE.hdr" render "$deep"
check "an ending unknown" refuses 2 "is not clear from its name" render "$deep" -o "$scratch/x.jpg"
check "no room" refuses 2 "expected one room file" render -o "$scratch/x.png"
check "several rooms" refuses 2 "expected --room NAME" \
    render -o "$scratch/x.png" "$examples/building.xml"
check "a view unknown" refuses 2 "hemispherical" \
    render --view top "$deep" -o "$scratch/x.png"
check "a size that is none" refuses 2 "640x480" \
    render --size 0x7 "$deep" -o "$scratch/x.png"
check "a size too large" refuses 2 "65535" \
    render --size 65535x65535 "$deep" -o "$scratch/x.png"
check "an angle of no perspective" refuses 2 "less than 180" \
    render --angle 180 $small "$deep" -o "$scratch/x.png"
check "a picture that is kept but can't be shown" refuses 2 "at most 32767" \
    render --size 1x40000 "$deep" -o "$scratch/x.png"
check "an eye in a wall" refuses 1 "lies in a surface" \
    render --from 0,4,1.2 $small "$deep" -o "$scratch/x.png"
check "an eye that looks at itself" refuses 1 "the position of the eye" \
    render --from 1,4 --towards 1,4 $small "$deep" -o "$scratch/x.png"
check "a view along its own up" refuses 1 "another up" \
    render --direction 0,0,1 --up 0,0,2 $small "$deep" -o "$scratch/x.png"
check "towards and direction" refuses 2 "expected only one of them" \
    render --towards 1,1 --direction 1,0,0 "$deep" -o "$scratch/x.png"
check "an angle of a plan" refuses 2 "--across" \
    render --view plan --angle 60 "$deep" -o "$scratch/x.png"
check "false colour as numbers" refuses 2 "displayed, not stored" \
    render --false-colour "$deep" -o "$scratch/x.hdr"
check "an exposure of numbers" refuses 2 "stored light has no exposure" \
    render --exposure 7 "$deep" -o "$scratch/x.pfm"
check "a scale without false colour" refuses 2 "--range is for the scale" \
    render --range 1,2 "$deep" -o "$scratch/x.png"
check "a range upside down" refuses 2 "LOW < HIGH" \
    render --false-colour --range 2,1 "$deep" -o "$scratch/x.png"
check "levels that fall" refuses 2 "increasing levels" \
    render --false-colour --levels 2,1 "$deep" -o "$scratch/x.png"
check "a grid over no fisheye" refuses 2 "fisheye" \
    render --grid "$deep" -o "$scratch/x.png"
check "the eye's contrast of daylight factors" refuses 2 "--exposure human is for luminance" \
    render --quantity df --exposure human "$deep" -o "$scratch/x.png"
check "a room and a picture" refuses 2 "expected only one of them" \
    render --from-picture "$scratch/one.hdr" "$deep" -o "$scratch/x.png"
for option in --view=plan --from=1,2 --towards=1,2 --direction=0,1,0 --up=0,0,1 \
    --angle=60 --across=3 --size=10x10 --samples=64 --engine=path --windows=aimed \
    --filter=gauss --checkpoint="$scratch/x.kept" --errors="$scratch/x.pfm" --external=5 --sky=uniform --room=A \
    --seed=3; do
    check "a picture that is there has no $option" refuses 2 \
        "${option%%=*} is for rendering" \
        render --from-picture "$scratch/one.hdr" "$option" -o "$scratch/x.png"
done
for option in --paper=a4 --orientation=portrait --dpi=300; do
    check "a plain picture has no $option" refuses 2 "${option%%=*} is for sheets" \
        render "$option" "$deep" -o "$scratch/x.png"
done
check "dots of a PDF" refuses 2 "--dpi is for a PNG sheet" \
    render --dpi 300 "$deep" -o "$scratch/x.pdf"
check "three paths a pixel" refuses 2 "a power of two" \
    render --samples 3 "$deep" -o "$scratch/x.png"
check "daylight factors under so much light" refuses 2 "does not depend on --external" \
    render --quantity df --external 5000 "$deep" -o "$scratch/x.png"
check "a place for no output" refuses 3 "nowhere" \
    render $small "$deep" -o "$scratch/nowhere/x.png"
check "errors that are shown" refuses 2 "ends in .hdr or .pfm" \
    render --errors "$scratch/x.png" "$deep" -o "$scratch/x.hdr"
check "errors of too few paths" refuses 2 "--samples of 4 or more" \
    render --samples 2 --errors "$scratch/x.hdr" "$deep" -o "$scratch/x.pfm"
check "errors in the picture's file" refuses 2 "are the same file" \
    render --errors "$scratch/x.hdr" "$deep" -o "$scratch/x.hdr"
run render $small --format hdr "$deep"
"$pepperpot" render $small --format hdr "$deep" >/dev/full 2>"$scratch/err"
check "a full disk" test $? -eq 3
check "none of these left a file either" nothing "$(ls "$scratch" | grep '^x\.')"
tap_done
