#!/bin/sh
# Stored daylight coefficients: their matrix for Radiance, their use in other runs, and interrupted
# runs.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

# Two years with the same hours of light; `other` has less direct and more diffuse light.
awk -f "$srcdir/tests/lib/clear_year.awk" >"$scratch/year.epw"
awk -v direct=100 -v diffuse=220 -f "$srcdir/tests/lib/clear_year.awk" >"$scratch/other.epw"
cat >"$scratch/room.xml" <<'XML'
<room version="1" name="Study"><site ground-reflectance="0.3" ground="open"/>
<plan width="3.4" depth="4.6" height="2.7"/>
<window wall="south" left="0.4" sill="0.8" width="1.5" height="1.6"/>
<window wall="west" left="1.1" sill="0.9" width="1.2" height="1.3" glazing="none"/>
<point x="1.2" y="0.9"/><point x="2.3" y="3.7"/></room>
XML
room=$scratch/room.xml
matrix=$scratch/study.mtx
annual="annual -q -f csv --hourly $scratch/hours.csv"

# kept NAME WORDS: runs the command and keeps the results under this name.
kept() { # NAME WORDS
    kept_name=$1
    shift
    run $annual "$@"
    [ $status -eq 0 ] || told
    cp "$scratch/out" "$scratch/$kept_name.csv"
    cp "$scratch/hours.csv" "$scratch/$kept_name.hours"
}
# equal A B: both results are identical.
equal() {
    cmp "$scratch/$1.csv" "$scratch/$2.csv" && cmp "$scratch/$1.hours" "$scratch/$2.hours"
}

# ---- the matrix ----

kept direct --samples 64 -w "$scratch/year.epw" "$room"
check "coefficients are stored" kept stored --samples 64 -w "$scratch/year.epw" \
    --coefficients "$matrix" "$room"
check "which changes no result" equal direct stored
# Radiance's dctimestep accepts only matrices of three components.
check "the matrix has three components" grep -qx "NCOMP=3" "$matrix"
check "it names the room" grep -qx "ROOM=Study" "$matrix"
check "and the light paths" grep -qx "SAMPLES=64" "$matrix"
sed '1,/^$/d' "$matrix" >"$scratch/rows"
check "two rows of 3 x 578 numbers" test \
    "$(awk '{ printf "%d ", NF }' "$scratch/rows")" = "1734 1734 "
check "equal components" awk '{ for (i = 1; i < NF; i += 3)
    if ($i != $(i + 1) || $i != $(i + 2)) exit 1 }' "$scratch/rows"
# A sky of 1 cd/m2 lights open ground with pi lx, which then has 0.3 cd/m2.
run df --simulate --error 0.3% --sky uniform -q -f csv "$room"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
    $column["place"] == "point" && $column["method"] == "traced" && $column["component"] == "df" {
        print $column["value_percent"] }' "$scratch/out" >"$scratch/factors"
awk '{ E = 0.3 * $1; for (i = 4; i < NF; i += 3) E += $i; print 100 * E / 3.14159265 }' \
    "$scratch/rows" >"$scratch/sums"
check "its sums are the daylight factors of a uniform sky" sh -c "
    paste '$scratch/factors' '$scratch/sums' | awk '{ n++; off = \$1 / \$2 - 1 }
        off > 0.02 || off < -0.02 { exit 1 } END { exit n != 2 }'"

# ---- stored coefficients ----

check "they are read back" kept read -w "$scratch/year.epw" --coefficients-from "$matrix" \
    "$room"
check "with the same results" equal direct read
kept other --samples 64 -w "$scratch/other.epw" --hours 9-17 "$room"
check "other weather and hours" kept reused -w "$scratch/other.epw" --hours 9-17 \
    --coefficients-from "$matrix.randomisations" "$room"
check "give the results of a run without them" equal other reused

from="$annual -w $scratch/year.epw --coefficients-from $matrix"
changed() { # TEXT EDIT
    sed "$2" "$room" >"$scratch/changed.xml"
    refuses 1 "$1" $from "$scratch/changed.xml"
}
check "another room" changed 'those of the room "Study"; expected "Hall"' 's/Study/Hall/'
check "other materials" changed "geometry or materials" 's/height="2.7"/height="2.8"/'
check "another window" changed "geometry or materials" 's/1.3" glazing="none"/1.3"/'
check "another bearing" changed "bearing" 's/name=/north="10" name=/'
check "another ground" changed "ground reflectance" 's/"0.3" g/"0.25" g/'
check "other points" changed "other points" 's/x="1.2"/x="1.3"/'
check "another number of patches" refuses 1 "577 sky patches; expected 145" $from \
    --patches 145 "$room"
check "another seed" refuses 1 "the seed 1; expected 2" $from --seed 2 "$room"
check "another number of paths" refuses 1 "64 paths per point; expected 128" $from \
    --samples 128 "$room"
check "a target error" refuses 2 "--error does not apply" $from --error 1% "$room"
check "no stored coefficients" refuses 1 "is not a file of daylight coefficients" \
    $annual -w "$scratch/year.epw" --coefficients-from "$room" "$room"
check "no file" refuses 1 "No such file" $annual -w "$scratch/year.epw" \
    --coefficients-from "$scratch/none" "$room"
check "no sky without patches" refuses 2 "--exact-sky" $from --exact-sky "$room"
check "only one room" refuses 1 "--coefficients-from is for one room" \
    annual -w "$scratch/year.epw" --coefficients-from "$matrix" "$examples/building.xml"
cp "$matrix.randomisations" "$scratch/damaged"
printf x | dd of="$scratch/damaged" bs=1 seek=20000 conv=notrunc 2>/dev/null
check "a damaged file" refuses 1 "damaged" $annual -w "$scratch/year.epw" \
    --coefficients-from "$scratch/damaged" "$room"
head -c 500000 "$matrix.randomisations" >"$scratch/short"
check "an incomplete file" refuses 1 "of the 16 randomisations" $annual \
    -w "$scratch/year.epw" --coefficients-from "$scratch/short" "$room"

# A room with its own blinds also has coefficients for closed windows.
sed 's|height="1.6"/>|height="1.6"><blind slat-width="0.05" spacing="0.04" angle="40"/></window>|' \
    "$room" >"$scratch/blind.xml"
kept blind --samples 32 -w "$scratch/year.epw" --coefficients "$scratch/blind.mtx" \
    "$scratch/blind.xml"
check "blinds are read back" kept reread -w "$scratch/year.epw" \
    --coefficients-from "$scratch/blind.mtx" "$scratch/blind.xml"
check "with the same results" equal blind reread
sed 's/angle="40"/angle="35"/' "$scratch/blind.xml" >"$scratch/slats.xml"
check "other slats are refused" refuses 1 "geometry or materials" annual \
    -w "$scratch/year.epw" --coefficients-from "$scratch/blind.mtx" --blinds always \
    --samples 32 "$scratch/slats.xml"

# One matrix has the light of one season. The open state of the year is that with leaves; the state
# without leaves is stored by checkpoints only, and is calculated anew if it is missing.
tree_room() { # TRANSMITTANCE WINTER-TRANSMITTANCE BARE-FROM
    awk -v leaves="$1" -v bare="$2" -v from="$3" '{ sub("ground=\"open\"/>", "ground=\"open\" " \
        "bare-from=\"" from "\"><tree x=\"1\" y=\"-4\" height=\"8\" crown-width=\"5\" " \
        "transmittance=\"" leaves "\" winter-transmittance=\"" bare "\"/></site>") } 1' "$room" \
        >"$scratch/tree.xml"
}
short="--samples 16 -w $scratch/year.epw"
stored="-w $scratch/year.epw --coefficients-from $scratch/tree.mtx"
tree_room 0.2 0.2 11
kept tree $short --coefficients "$scratch/tree.mtx" "$scratch/tree.xml"
tree_room 0.2 0.2 3
check "months without leaves do not matter" kept months $stored "$scratch/tree.xml"
check "for evergreen trees" equal tree months
tree_room 0.3 0.3 11
check "other crowns are refused" refuses 1 "geometry or materials" annual -q $stored \
    "$scratch/tree.xml"
check "no trees, too" refuses 1 "geometry or materials" annual -q $stored "$room"
tree_room 0.2 0.6 11
kept winter $short --checkpoint "$scratch/seasons" "$scratch/tree.xml"
check "trees that lose their leaves" kept leaves $stored "$scratch/tree.xml"
check "have light paths in winter" equal winter leaves
check "have no matrix" refuses 1 "another transmittance in winter" annual -q $short \
    --coefficients "$scratch/none.mtx" "$scratch/tree.xml"
check "and no file of one" test ! -e "$scratch/none.mtx" -a ! -e "$scratch/none.mtx.randomisations"
stored="-w $scratch/year.epw --coefficients-from $scratch/seasons"
check "a checkpoint has both seasons" kept both $stored "$scratch/tree.xml"
check "with the same results" equal winter both
tree_room 0.2 0.5 11
check "another winter is refused" refuses 1 "geometry or materials" annual -q $stored \
    "$scratch/tree.xml"

# ---- interrupted runs ----

# Only randomisations that are not in the file are calculated and added.
checkpoint="--checkpoint $scratch/short --samples 64 -w $scratch/year.epw"
check "a run continues" kept continued $checkpoint "$room"
check "with the same results" equal direct continued
check "its file is then complete" test "$(wc -c <"$scratch/short")" -eq \
    "$(wc -c <"$matrix.randomisations")"
check "it serves as stored coefficients" kept after -w "$scratch/year.epw" \
    --coefficients-from "$scratch/short" "$room"
check "with the same results, too" equal direct after
sed 's/Study/Hall/' "$room" >"$scratch/hall.xml"
check "it belongs to this room" refuses 1 'expected "Hall"' $annual $checkpoint \
    "$scratch/hall.xml"

# A signal after the first randomisation.
"$pepperpot" $annual --checkpoint "$scratch/stopped" --samples 1024 \
    -w "$scratch/year.epw" "$room" >"$scratch/out" 2>"$scratch/err" &
left=200
while [ $left -gt 0 ] && ! [ "$(find "$scratch/stopped" -size +1k 2>/dev/null)" ]; do
    sleep 0.1
    left=$((left - 1))
done
kill $!
wait $!
status=$?
check "a signal ends the run" test $status -eq 130
check "the file is named" grep -q "continues from $scratch/stopped" "$scratch/err"
kept whole --samples 1024 -w "$scratch/year.epw" "$room"
check "the run continues" kept resumed --samples 1024 -w "$scratch/year.epw" \
    --checkpoint "$scratch/stopped" "$room"
check "to the bytes of a run without interruption" equal whole resumed

# Rooms of a building, some of which are already in the file.
parts="-w $scratch/year.epw --points 1,1 --samples 16 --checkpoint $scratch/building"
run annual -q -f csv $parts --part 1/2 "$examples/building.xml"
check "all rooms after a part of them" gives annual -q -f csv $parts "$examples/building.xml"
cp "$scratch/out" "$scratch/all.csv"
run annual -q -f csv -w "$scratch/year.epw" --points 1,1 --samples 16 "$examples/building.xml"
check "give the results of one run" cmp "$scratch/all.csv" "$scratch/out"

tap_done
