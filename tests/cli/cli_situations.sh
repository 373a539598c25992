#!/bin/sh
# docs/situations.md agrees with the program: hand figures to the printed digits, simulated ones
# within four standard errors, and each figure in the text with its table.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

said=$srcdir/docs/situations.md
rooms=$srcdir/examples/situations
sed -n 's/^<!-- situation \(.*\) -->/\1/p' "$said" | LC_ALL=C sort >"$scratch/told"
(cd "$rooms" && ls -- *.xml) | sed 's/\.xml$//' | LC_ALL=C sort >"$scratch/rooms"
check "there are twelve situations" test "$(wc -l <"$scratch/rooms")" -eq 12
check "each of them is told" same "$scratch/told" "$scratch/rooms"

# told ROOM: the table of the room in the page.
told() {
    sed -n "/^<!-- situation $1 -->/,/^<!-- end -->/p" "$said" | sed '1d; $d'
}

# differences: prints the differences between two tables with the same rows. A standard error that
# is not shown is below 0.005.
differences() {
    ${AWK:-awk} -F '|' '
    function number(cell, i) { split(cell, parts, " "); return parts[i] }
    NR == FNR { row[FNR] = $0; rows = FNR; next }
    {
        count = split(row[FNR], old, "|")
        if (row[FNR] == $0)
            next
        if (old[2] != $2 || old[2] !~ /traced/ || count != NF) {
            print "row " FNR ": " row[FNR] " is " $0
            next
        }
        for (i = 3; i < NF; i++) {
            a = number(old[i], 3) + 0; b = number($i, 3) + 0
            if (a == 0) a = 0.005
            if (b == 0) b = 0.005
            off = number(old[i], 1) - number($i, 1)
            if (off * off > 16 * (a * a + b * b) || number(old[i], 1) !~ /^[0-9]/)
                print "traced " row[FNR] " is " $0
        }
    }
    END { if (FNR != rows) print rows " rows are " FNR }' "$1" "$2"
}

while read -r room; do
    told "$room" >"$scratch/table"
    run df --quiet --methods all --simulate --error 4% --format csv "$rooms/$room.xml"
    ${AWK:-awk} -f "$srcdir/docs/situations.awk" "$scratch/out" >"$scratch/found"
    check "$room: the table is what the program finds (make situations)" \
        nothing "$(differences "$scratch/table" "$scratch/found")"
    grep -o '[0-9]*\.[0-9][0-9]' "$scratch/table" >"$scratch/cells"
    sed -n "/^<!-- situation $room -->/,/^## /p" "$said" |
        sed '1,/^<!-- end -->/d' | grep -o '[0-9]*\.[0-9][0-9] %' | sed 's/ %//' >"$scratch/figures"
    check "$room: the text has figures" test -s "$scratch/figures"
    check "$room: and all stand in its table" \
        nothing "$(grep -vxF -f "$scratch/cells" "$scratch/figures")"
done <"$scratch/rooms"
tap_done
