#!/bin/sh
# Rooms with hundreds of similar parts are calculated; bench/bench_large_rooms measures the times.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# room PARTS: a room with one point and one window, or with the windows in PARTS.
room() {
    printf '<room version="1"><site latitude="51.5"/>%s%s</room>' "$1" \
        '<point x="1.1" y="0.7"/>'
}
box='<plan width="3.1" depth="9.3" height="2.7"/>'
window='<window wall="south" left="0.35" sill="0.8" width="2.4" height="1.5"/>'

# blocks N: blocks half a metre wide on a field in front of the window.
blocks() {
    awk -v n="$1" 'BEGIN { for (i = 0; i < n; i++)
        printf "<block x=\"%.2f\" y=\"%.2f\" width=\"0.5\" depth=\"0.5\" " \
            "height=\"%.3f\" rotate=\"%d\"/>", -10 + i % 23 * 0.93,
            -6 - int(i / 23) * 0.97, 1 + i * 37 % 101 / 40, i * 13 % 90 }'
}

# ring N INNER PARTS: a plan whose N corners are alternately 10 m and INNER m from its centre; awk
# prints PARTS for each wall w.
ring() {
    awk -v n="$1" -v inner="$2" 'BEGIN {
        printf "<plan height=\"2.7\">"
        for (i = 0; i < n; i++) {
            a = 6.283185307179586 * (i + 0.5) / n
            r = i % 2 ? inner : 10
            printf "<vertex x=\"%.5f\" y=\"%.5f\"/>", r * cos(a), r * sin(a)
        }
        printf "</plan>"
        for (w = 1; w <= n; w++) {
            '"$3"'
        }
    }'
}

room "$box$window$(blocks 500)" >"$scratch/blocks.xml"
check "500 blocks before a window" shows "exact+bre" df "$scratch/blocks.xml"

room "$(ring 500 7 '')<window wall='3' left='0.2' sill='0.8' width='1.2' height='1.5'/>" \
    >"$scratch/star.xml"
check "a star of 500 corners" shows "exact+bre" df "$scratch/star.xml"

room "$(ring 300 10 'printf "<skyline wall=\"%d\" angle=\"%d\"/>", w, 10 + w * 7 % 50')<window wall='3' left='0.05' sill='0.8' width='0.1' height='1.5'/>" \
    >"$scratch/walls.xml"
run df "$scratch/walls.xml"
check "300 walls with a skyline each" grep -q "exact+bre" "$scratch/out"
check "with a warning for each without a window" test "$(grep -c 'has no window' "$scratch/err")" -eq 299

room "<plan width='51' depth='9.3' height='2.7'/>$(awk 'BEGIN { for (i = 0; i < 300; i++)
    printf "<window wall=\"south\" left=\"%.3f\" sill=\"0.9\" width=\"0.1\" height=\"1.3\"/>",
        0.02 + 0.17 * i }')" >"$scratch/windows.xml"
check "300 windows" shows "exact+bre" df "$scratch/windows.xml"

tap_done
