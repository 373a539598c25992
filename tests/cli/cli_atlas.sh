#!/bin/sh
# atlas: identical files with any interruptions and number of threads, rooms that can be
# recalculated, new results of methods, and bad input.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

atlas() {
    "$pepperpot" atlas --error 20% --quiet "$@"
}
refuses_atlas() {
    status=$1 text=$2
    shift 2
    refuses "$status" "$text" atlas --error 20% --quiet "$@"
}
# field FILE ROOM POINT COLUMN: the value in this field.
field() {
    awk -F, -v room="$2" -v point="$3" -v name="$4" '
        /^#/ { next }
        !found { for (i = 1; i <= NF; i++) if ($i == name) found = i; next }
        $1 == room && $2 == point { print $found }' "$1"
}

whole=$scratch/whole.csv
check "four rooms" atlas --rooms 4 -j 2 -o "$whole"
check "have nine rows each" test "$(grep -c '^[0-9]' "$whole")" -eq 36
check "in their order" nothing "$(grep '^[0-9]' "$whole" | cut -d, -f1 | sort -nc 2>&1)"
check "one thread" atlas --rooms 4 -j 1 -o "$scratch/one.csv"
check "gives the same bytes" same "$whole" "$scratch/one.csv"
check "with every room there, nothing is traced again" atlas --rooms 4 -o "$scratch/one.csv"
check "and nothing changed" same "$whole" "$scratch/one.csv"

check "two rooms" atlas --rooms 2 -o "$scratch/grown.csv"
check "grow to four" atlas --rooms 4 -o "$scratch/grown.csv"
check "of the same bytes" same "$whole" "$scratch/grown.csv"
size=$(wc -c <"$whole")
for cut in $((size - 1)) $((size * 2 / 3)) 700 40; do
    head -c "$cut" "$whole" >"$scratch/cut.csv"
    check "one that was cut off behind byte $cut goes on" \
        atlas --rooms 4 -o "$scratch/cut.csv"
    check "to the same bytes" same "$whole" "$scratch/cut.csv"
done

killed=$scratch/killed.csv
"$pepperpot" atlas --error 20% --quiet --rooms 400 -o "$killed" &
process=$!
while [ "$({ wc -c <"$killed" || echo 0; } 2>/dev/null)" -lt 9000 ]; do sleep 0.02; done
check "two runs cannot have a file at a time" \
    refuses_atlas 3 "another run is writing" --rooms 4 -o "$killed"
kill -9 "$process"
wait "$process" 2>/dev/null
rooms=$(($(grep -c '^[0-9]*,-1,' "$killed") + 1))
check "one that was killed goes on" atlas --rooms "$rooms" -o "$killed"
check "to what a run has that was not" atlas --rooms "$rooms" -o "$scratch/never.csv"
check "to the byte" same "$scratch/never.csv" "$killed"

# Any room of the file can be recalculated.
check "a room's file" gives atlas --room 3
cp "$scratch/out" "$scratch/room3.xml"
check "is a room file" gives df --methods exact,bre --format csv "$scratch/room3.xml"
say=$(awk -F, '$3 == "point" && $10 == "sc" { print $12; exit }' "$scratch/out")
check "whose sky component at the first point is the atlas's" \
    awk -v a="$say" -v b="$(field "$whole" 3 0 sc.exact)" \
    'BEGIN { exit !(b > 0 && (a - b) ^ 2 < 1e-8 * b ^ 2) }'
check "traced light parts into three" awk -F, '
    /^#/ { next }
    !n { for (i = 1; i <= NF; i++) at[$i] = i; n = 1; next }
    { off = $at["true.sc"] + $at["true.erc"] + $at["true.irc"] - $at["true.df"]
      if (off ^ 2 > (1e-3 * $at["true.df"]) ^ 2) { print; bad = 1 } }
    END { exit bad }' "$whole"
check "iso skies are another sweep" atlas --rooms 1 --sky iso -o "$scratch/iso.csv"
check "whose rooms have a sky" shows '<sky type="iso-' atlas --room 0 --sky iso

check "methods asked anew" atlas --by-hand "$whole" -o "$scratch/anew.csv"
check "say the same today" same "$whole" "$scratch/anew.csv"
# As if split-flux were a new method: its column is restored, and the true value in its own world
# is taken from another method with the same world.
awk -F, -v OFS=, '/^#/ { print; next }
    !n { for (i = 1; i <= NF; i++) if ($i ~ /split-flux$/) drop[i] = 1; n = 1 }
    { line = ""; for (i = 1; i <= NF; i++) if (!drop[i]) line = line (line == "" ? "" : OFS) $i
      print line }' "$whole" >"$scratch/less.csv"
check "of an atlas that lacks a method" atlas --by-hand "$scratch/less.csv" -o "$scratch/anew.csv"
check "they make it whole" same "$whole" "$scratch/anew.csv"

# An atlas of 30 rooms in which the method gives 0.5, 1 or 4 times the true value.
made=$scratch/made.csv
awk 'BEGIN {
    print "room,point,depth-width,ground,depth,true.df,se.df,df.exact+bre"
    for (i = 0; i < 30; i++) {
        for (k = 0; k < 3; k++)
            printf "%d,%d,1.1,%g,%g,2,0.02,%g\n", i, k, 0.12 + 0.1 * k, 0.7 + k, k == 2 ? 8 : k + 1
        printf "%d,-1,1.1,0.12,,2,0.02,3\n", i
    }
}' >"$made"
for format in pdf svg png; do
    check "a map by depth as $format" atlas --map depth "$made" -o "$scratch/map.$format"
    check "is drawn" test -s "$scratch/map.$format"
done
check "and one by the ground" atlas --map ground --method exact+bre --paper a5 "$made" \
    -o "$scratch/ground.svg"
check "on the paper asked for" grep -q 'width="210mm" height="148mm"' "$scratch/ground.svg"
check "a method it lacks is named" refuses_atlas 1 'no method "sphere"' \
    --map depth --method sphere "$made" -o "$scratch/none.svg"
check "a map by what it lacks is refused" refuses_atlas 1 "lacks columns" \
    --map erc "$made" -o "$scratch/none.svg"
check "and nothing is drawn" test ! -e "$scratch/none.svg"
check "an unknown map is a mistake" refuses_atlas 2 "depth, erc, ground" --map width "$made"
check "a map to nowhere is" refuses_atlas 2 "expected -o FILE.pdf" --map depth "$made"
check "a map of nothing is" refuses_atlas 2 "expected one file" --map depth -o x.svg

check "another seed does not go on in the file" \
    refuses_atlas 1 "belongs to another atlas" --seed 2 --rooms 4 -o "$whole"
check "nor another sky" refuses_atlas 1 "belongs to another atlas" --sky iso --rooms 4 -o "$whole"
check "nor another error" refuses 1 "belongs to another atlas" atlas --rooms 4 -o "$whole"
cp "$examples/office.xml" "$scratch/office.xml"
check "a room file is not written over" \
    refuses_atlas 1 "belongs to another atlas" --rooms 4 -o "$scratch/office.xml"
check "to the byte" same "$examples/office.xml" "$scratch/office.xml"
check "and is no atlas" refuses_atlas 1 "this is not an atlas" --by-hand "$examples/office.xml"
check "a file that is not there" refuses_atlas 1 "cannot be read" --by-hand "$scratch/none.csv"
sed 's/^2,/7,/' "$whole" >"$scratch/odd.csv"
check "rooms out of order" refuses_atlas 1 "not those of an atlas" --by-hand "$scratch/odd.csv"
sed 's/^\(0,0\),[^,]*/\1,77/' "$whole" >"$scratch/odd.csv"
check "points of elsewhere" refuses_atlas 1 "does not belong to this sweep" --by-hand "$scratch/odd.csv"
check "no use is a mistake" refuses_atlas 2 "expected one of"
check "two uses are" refuses_atlas 2 "expected one of" --rooms 2 --room 1
check "no file is" refuses_atlas 2 "expected -o FILE" --rooms 2
check "a room of its own is" refuses_atlas 2 "has its own rooms" --rooms 2 -o x.csv a.xml
check "half a room is" refuses_atlas 2 "the number of a room" --room 1.5
check "an unknown sky is" refuses_atlas 2 "overcast or iso" --sky blue --room 1
tap_done
