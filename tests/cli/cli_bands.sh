#!/bin/sh
# Likely ranges of hand figures, advice derived from them, and the table with their bands.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

office=$examples/office.xml

# within EXPRESSION: true of f, the daylight factor by exact+bre in JSON, and a and b, the limits
# of its range.
within() {
    tr -d '\n ' <"$scratch/out" | grep -o '"df":{"exact+bre":{[^}]*}' | head -n 1 |
        sed 's/.*"value":\([0-9.]*\),"band":\[\([0-9.]*\),\([0-9.]*\)\].*/\1 \2 \3/' |
        awk '{ f = $1; a = $2; b = $3; exit !('"$1"') }'
}

# Near the window, where most light comes from the sky, the range is narrow; at the back, where an
# average represents reflected light, it is wide and below the figure.
run df -m exact+bre -p 2.1,1 -f json "$office"
check "a band holds the figure near the window, within a quarter" \
    within 'a < f && f < b && b < 1.25 * f && a > 0.75 * f'
run df -m exact+bre -p 2.1,5 -f json "$office"
check "and at the back its middle is below the figure" \
    within 'a > 0 && (a + b) / 2 < 0.9 * f'
check "text has them in columns" shows '95 % band' df "$office"
run df --no-bands "$office"
check "and not without" nothing "$(grep '95 % band' "$scratch/out")"
check "under a uniform sky there are none, and why" \
    shows 'the sky is neither' df --sky uniform "$office"
check "under a clear sky they are those of the second sweep" \
    shows '95 % band' df -m exact+split-flux --sky iso-12,35,150 -p 2.1,3 "$office"
check "of methods that know such a sky" \
    shows 'use exact+' df --advise --sky iso-12,35,150 "$office"
check "and under iso-1, which is overcast, those of the first" \
    shows '95 % band' df -m exact+split-flux --sky iso-1 -p 2.1,3 "$office"
check "nor in a plan with a recess" shows 'the plan is not' df "$examples/l-shaped.xml"
check "CSV has them when asked" shows 'band_low_percent' df --bands -f csv "$office"

check "a component that is practically zero has no band" nothing "$(
    "$pepperpot" df -f json -m brs-table -q "$office" | sed -n 's/.*"band": \[ [^,]*, \([0-9.e-]*\) .*/\1/p' |
        awk '$1 < 0.005')"
check "a method is advised for the average" shows 'for the average' df --advise "$office"
check "in JSON, too" shows '"use"' df --advise -f json "$office"
check "not in CSV" refuses 2 "CSV" df --advise -f csv "$office"

check "assess has bands in brackets" shows 'Figures in brackets' assess --by-hand -c average "$office"
check "size says the band of what it found" \
    shows 'band  ' size --by-hand --target 2% "$office"

# An atlas for one method with errors of a tenth: the bands from one half of its rooms contain
# those of the other half.
awk 'BEGIN {
    srand(7)
    print "# made\nroom,point,ground,true.df,df.exact+bre"
    for (room = 0; room < 1400; room++) {
        printf "%d,0,0.2,%.5g,2\n", room, 1.8 + 0.4 * rand()
        printf "%d,-1,0.2,%.5g,2\n", room, 1.8 + 0.4 * rand()
    }
}' >"$scratch/made.csv"
check "bands are fitted to an atlas" gives atlas --bands "$scratch/made.csv"
check "they lie where its figures are" \
    sh -c 'awk -F, "/^point,df/ { exit !(\$5 > 0.895 && \$5 < 0.92 && \$7 > 1.08 && \$7 < 1.105) }" "$1"' \
    sh "$scratch/out"
check "of the overcast sky" grep -q '^# atlas_bands.csv.*' "$scratch/out"
sed '1s/.*/# sky iso, error 2 %, seed 1/' "$scratch/made.csv" >"$scratch/iso.csv"
check "or of the others, as the atlas says" gives atlas --bands "$scratch/iso.csv"
check "for a table of their own" \
    grep -q '^# source: .* under the skies of ISO 15469$' "$scratch/out"
check "and hold on rooms held out" gives atlas --try "$scratch/made.csv"
head -n 40 "$scratch/made.csv" >"$scratch/short.csv"
check "too few rooms are refused" refuses 1 "rooms are too few for bands" \
    atlas --bands "$scratch/short.csv"

tap_done
