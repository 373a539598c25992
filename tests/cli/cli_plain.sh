#!/bin/sh
# --plain: the plain implementation gives the figures of the fast one, in df, assess and render.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# rows FILE: "PLACE COMPONENT METHOD VALUE ERROR" for df's CSV; - for a missing value.
rows() {
    sed 's/"[^"]*"/-/g; s/\r$//' "$1" | awk -F, 'NR > 1 {
        print $3 $4 ":" $5, $10, $11, $12 == "" ? "-" : $12, $13 == "" ? "-" : $13 }'
}

# same_figures FILE OPTION ...: hand methods with and without --plain: points agree to 1e-6 of the
# open sky (1e-4 %), averages to 1.5 thousandths.
same_figures() {
    file=$1
    shift
    "$pepperpot" df --no-bands --format csv "$@" "$file" >"$scratch/fast.csv" &&
        "$pepperpot" df --no-bands --format csv --plain "$@" "$file" >"$scratch/plain.csv" ||
        return 1
    rows "$scratch/fast.csv" >"$scratch/fast"
    rows "$scratch/plain.csv" | paste -d' ' "$scratch/fast" - | awk '
        $1 != $6 || $2 != $7 || $3 != $8 { print "other rows: " $0; bad = 1; next }
        $4 == "-" || $9 == "-" { if ($4 != $9) { print; bad = 1 } next }
        {
            n++
            off = $4 - $9
            limit = $1 == "average:" ? 0.0015 * $4 + 1e-6 : 1e-4
            if (off > limit || off < -limit) { print; bad = 1 }
        }
        END { exit bad || n < 4 }'
}

for room in $(some office deep-office-obstructed l-shaped studio building workshop); do
    check "figures by hand of $room are the same" \
        same_figures "$examples/$room.xml" -m exact,waldram,pepper-pot,brs-table,bre
done
check "and under a clear sky" same_figures "$examples/office.xml" -m exact \
    --sky iso-12,40,150
check "and through a sloping rooflight" same_figures "$examples/studio.xml" -m exact

here='--points=1.5,2;1.5,7'
check "the simulation" gives df -s -m exact --no-bands --error 2% "$here" --format csv "$deep"
rows "$scratch/out" >"$scratch/fast"
check "runs by the plain tracer, too" gives df -s --plain -m exact --no-bands --error 2% \
    "$here" --format csv "$deep"
rows "$scratch/out" >"$scratch/plain"
near() {
    paste -d' ' "$scratch/fast" "$scratch/plain" | awk '
        $2 == "df" && $3 == "traced" && $5 > 0 {
            n++
            z = ($4 - $9) / sqrt($5 * $5 + $10 * $10)
            print $1, $4, $9, z
            if (z > 4 || z < -4) bad = 1
        }
        END { exit bad || n < 3 }'
}
check "and agrees within four standard errors" near
check "both stand side by side" shows "plain: by plain path tracing" \
    df -s --engine path,plain -m exact+bre --error 3% "$here" "$deep"
check "the plain tracer's figures are the same by 1, 2 and 4 threads" same_by_threads "1 2 4" \
    df -s --engine plain --samples 32 "$here" --format csv "$deep"
check "assess judges by it" gives assess --plain --error 5% --spacing largest "$deep"

check "a picture by it" quietly render --plain -q --samples 4 --size 24x18 \
    -o "$scratch/a.pfm" "$deep"
check "is the same by any number of threads" sh -c \
    "'$pepperpot' render --plain -q -j 3 --samples 4 --size 24x18 -o '$scratch/b.pfm' '$deep' &&
    cmp '$scratch/a.pfm' '$scratch/b.pfm'"
check "daylight factors on surfaces, too" quietly render --plain -q --quantity df \
    --samples 4 --size 24x18 -o "$scratch/c.pfm" "$deep"
check "it needs no records" refuses 2 "--records is for rendering a room with --engine cache" \
    render --plain --records -o "$scratch/d.png" "$deep"
check "and knows no limit of bounces" refuses 2 "--bounces cannot be combined with --plain" \
    render --plain --bounces 2 -o "$scratch/d.png" "$deep"
tap_done
