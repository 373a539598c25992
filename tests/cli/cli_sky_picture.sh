#!/bin/sh
# Photographed skies, from picture to daylight factors. The photographs are rendered skies with a
# formula, seen from high above a room, so that the figures are known.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# photograph FILE WORDS: renders a fisheye picture of the open sky.
photograph() {
    photograph_file=$1
    shift
    run render --plain --samples 1 --from 1.5,4,400 --direction 0,0,1 --up 0,1,0 "$@" \
        --size 256x256 -o "$scratch/$photograph_file" "$deep"
    [ $status -eq 0 ] || told
}

# figure SKY METHOD: the sky component at a point.
figure() {
    run df -m exact --points 1.5,2 --sky "$1" --format csv "$deep"
    awk -F, '$3 == "point" && $10 == "sc" { print $12 }' "$scratch/out"
}

# near A B SHARE: two numbers agree.
near() {
    awk -v a="$1" -v b="$2" -v share="$3" \
        'BEGIN { exit !(a > 0 && (a - b)^2 <= (share * b)^2) }' || echo "$1, not $2"
}

check "an overcast sky is photographed" photograph overcast.hdr -v angular
check "and a clear one" photograph clear.pfm -v angular --sky iso-12,35,150
check "as a hemispherical picture too" photograph flat.hdr -v hemispherical \
    --sky iso-12,35,150

run df -m exact --points 1.5,2 --format csv "$deep"
overcast=$(figure overcast)
clear=$(figure iso-12,35,150)
check "the overcast photograph gives the sky component of the overcast sky" \
    nothing "$(near "$(figure "picture,$scratch/overcast.hdr")" "$overcast" 2e-3)"
check "the clear one that of its own" \
    nothing "$(near "$(figure "picture,$scratch/clear.pfm")" "$clear" 2e-3)"
check "in the other projection too, known by the header" \
    nothing "$(near "$(figure "picture,$scratch/flat.hdr")" "$clear" 5e-3)"
check "turned by a right angle it gives another figure" \
    test -n "$(near "$(figure "picture,$scratch/clear.pfm,top-bearing=90")" "$clear" 0.2)"

check "the sheet names picture and illuminance" \
    shows "photograph overcast.hdr, 8600 lx on a horizontal plane" \
    df -m exact --points 1.5,2 --sky "picture,$scratch/overcast.hdr,illuminance=8600" \
    "$deep"
sed 's|<plan |<sky type="picture" file="clear.pfm" illuminance="9000"/><plan |' \
    "$deep" >"$scratch/room.xml"
check "a room file names one, relative to itself" \
    shows "photograph clear.pfm, 9000 lx" df --points 1.5,2 "$scratch/room.xml"
check "traced, it gives the sky component as the formula does" \
    gives df -m exact --points 1.5,2 -s --error 2% --format csv "$scratch/room.xml"
traced=$(awk -F, '$3 == "point" && $10 == "sc" && $11 == "traced" { print $12 }' \
    "$scratch/out")
check "within its error" nothing "$(near "$traced" "$clear" 0.03)"

# traced OPTIONS: daylight factor and standard error at a point under the clear sky with a sun.
sun=sun-illuminance=60000,sun-altitude=35,sun-bearing=200
traced() {
    run df -m exact --points 1.5,2 -s --samples 256 --threads 2 --format csv "$deep" \
        --sky "picture,$scratch/clear.pfm,illuminance=48000,$sun,$1"
    awk -F, '$3 == "point" && $10 == "df" && $11 == "traced" { print $12, $13 }' "$scratch/out"
}
check "a measured sun is added to the illuminance of the sky" \
    shows "photograph clear.pfm, 48000 lx" df --points 1.5,2 "$deep" \
    --sky "picture,$scratch/clear.pfm,illuminance=48000,$sun"
bright=$(traced sampling=bright)
lamps=$(traced sampling=lamps,lamps=64)
chance=$(traced sampling=chance)
# agree FIRST SECOND: within four standard errors.
agree() {
    echo "$1 $2" | awk '{ if (!($1 > 0 && ($1 - $3)^2 <= 16 * ($2^2 + $4^2))) print }'
}
check "lamps find the light of the bright parts" nothing "$(agree "$bright" "$lamps")"
check "and chance does" nothing "$(agree "$bright" "$chance")"
check "with more noise" test -n "$(echo "$bright $chance" | awk '$4 > 3 * $2')"
check "a sun without its position" refuses 2 "expected sun-bearing" \
    df --sky "picture,$scratch/clear.pfm,sun-illuminance=60000,sun-altitude=35" "$deep"
check "a sun that is brighter than the measured illuminance" refuses 2 "the sun alone gives" \
    df --sky "picture,$scratch/clear.pfm,illuminance=9000,$sun" "$deep"
check "an odd number of lamps" refuses 2 'lamps is "7"' \
    df --sky "picture,$scratch/clear.pfm,sampling=lamps,lamps=7" "$deep"
check "a way of sampling that there is not" refuses 2 "expected bright, lamps or chance" \
    df --sky "picture,$scratch/clear.pfm,sampling=luck" "$deep"
sed 's|<plan |<sky type="picture" file="clear.pfm" illuminance="48000" sun-illuminance="60000" sun-altitude="35" sun-bearing="200" sampling="lamps" lamps="64"/><plan |' \
    "$deep" >"$scratch/sunny.xml"
run df -m exact --points 1.5,2 -s --samples 256 --format csv "$scratch/sunny.xml"
check "a room file has the same options" test "$lamps" = \
    "$(awk -F, '$3 == "point" && $10 == "df" && $11 == "traced" { print $12, $13 }' "$scratch/out")"

run df -m pepper-pot-sky --points 1.5,2 --sky "picture,$scratch/clear.pfm" \
    --format csv "$deep"
dots=$(awk -F, '$3 == "point" && $10 == "sc" { print $12 }' "$scratch/out")
check "pepper-pot dots laid out for it count to its sky component" \
    nothing "$(near "$dots" "$clear" 0.02)"
check "an overlay has crosses of equal light of it" quietly chart overlay --show dots \
    --sky "picture,$scratch/clear.pfm" -o "$scratch/overlay.svg"
check "which are not those of the overcast sky" quietly chart overlay --show dots \
    -o "$scratch/other.svg"
check "but others" test -n "$(cmp "$scratch/overlay.svg" "$scratch/other.svg" 2>&1)"
check "a protractor can't be drawn for it" refuses 2 "depend on azimuth" \
    chart protractor --sky "picture,$scratch/clear.pfm" -o "$scratch/protractor.svg"
check "a sky without its file" refuses 2 "expected picture,FILE" \
    df --sky picture "$deep"
check "a file that is not there" refuses 2 "none.hdr" \
    df --sky "picture,$scratch/none.hdr" "$deep"
check "a room file for a picture" refuses 2 "expected a Radiance picture" \
    df --sky "picture,$deep" "$deep"
check "an angle that no lens has" refuses 2 "view-angle is \"400\"" \
    df --sky "picture,$scratch/overcast.hdr,view-angle=400" "$deep"
check "an option that there is not" refuses 2 'has no attribute "zoom"' \
    df --sky "picture,$scratch/overcast.hdr,zoom=2" "$deep"
head -c 3000 "$scratch/overcast.hdr" >"$scratch/cut.hdr"
check "a picture that is cut off" refuses 2 "cut.hdr: row" \
    df --sky "picture,$scratch/cut.hdr" "$deep"
sed 's|<plan |<sky file="clear.pfm"/><plan |' "$deep" >"$scratch/bad.xml"
check "a file without the type" refuses 1 "file applies only to photographs" \
    df "$scratch/bad.xml"
sed 's|<plan |<sky type="picture" file="clear.pfm" horizon="95"/><plan |' \
    "$deep" >"$scratch/bad.xml"
check "a horizon that is none" refuses 1 'horizon is "95"' df "$scratch/bad.xml"
check "an export to Radiance, which has no such sky" refuses 1 "photographed sky" \
    export --to radiance "$scratch/room.xml" -o "$scratch/radiance"

tap_done
