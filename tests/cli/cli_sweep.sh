#!/bin/sh
# --set changes attributes of room files; --sweep makes one table of many runs.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
LC_ALL=C
export LC_ALL

office=$examples/office.xml
site=$examples/sites/corner-house.xml

# With --set the output is identical to that of a file with the value.
sed 's/depth="5.4"/depth="6.1"/; s/walls="0.6"/walls="0.45"/' "$office" >"$scratch/edited.xml"
gives df -f csv --set plan.depth=6.1 --set finishes.walls=0.45 "$office" >/dev/null
sed "s|^[^,]*,|file,|" "$scratch/out" >"$scratch/by_set"
gives df -f csv "$scratch/edited.xml" >/dev/null
sed "s|^[^,]*,|file,|" "$scratch/out" >"$scratch/by_file"
check "--set gives the results of a file with that value" \
    same "$scratch/by_set" "$scratch/by_file"
check "a sized room is written with the value that was set" \
    gives size -t 2% --by-hand --set plan.depth=6.1 --write "$scratch/sized.xml" "$office"
check "and has it" grep -q 'depth="6.1"' "$scratch/sized.xml"

check "a sweep is one table" shows "window.width" df --sweep window.width=0.8:1.4:0.3 "$office"
check "with a row for each value" test "$(grep -cE '^ +(0\.8|1\.1|1\.4) ' "$scratch/out")" -eq 3
check "and is tidy" nothing "$(untidy)"
gives df -f csv --sweep window.width=0.8:1.4:0.3 "$office" >/dev/null
grep '^1.1,' "$scratch/out" | cut -d, -f2- >"$scratch/by_sweep"
gives df -f csv --set window.width=1.1 "$office" >/dev/null
sed 1d "$scratch/out" >"$scratch/alone"
check "a run of a sweep gives the results of that value alone" \
    same "$scratch/by_sweep" "$scratch/alone"
gives df -s --samples 200 -f csv --sweep window.width=0.8:1.4:0.3 --sweep window.glazing=none,clear-single \
    "$office" >/dev/null
check "two sweeps are combined" \
    test "$(sed 1d "$scratch/out" | cut -d, -f1,2 | uniq | tr '\n' ' ')" = \
    "0.8,none 0.8,clear-single 1.1,none 1.1,clear-single 1.4,none 1.4,clear-single "
check "the head names the addresses" \
    grep -q '^window.width,window.glazing,file,room,' "$scratch/out"
gives df --sweep window.width=0.8:1.4:0.3 --points 2,2 "$office" >/dev/null
check "points have rows of their own" grep -qE '^ +0\.8 +2, 2 ' "$scratch/out"
check "JSON has each run with its values" shows '"window.width": 1.1' \
    df -f json --sweep window.width=0.8:1.4:0.3 "$office"

# With a higher tower a window has less sky.
check "assess has a row for each finding" shows "block.Tower.height" \
    assess --by-hand -c vertical-sky,former-sky --sweep block.Tower.height=10:20:5 "$site"
check "in which the sky falls with the height" awk '/vertical-sky +W3/ {
        gsub(/[*?]/, "")
        exit !($(NF - 2) > $(NF - 1) && $(NF - 1) > $NF) }' "$scratch/out"
check "and which is tidy" nothing "$(untidy)"
check "CSV of assess has the value before each finding" shows "20,$site,Study" \
    assess --by-hand -c former-sky -f csv --sweep block.Tower.height=10:20:5 "$site"
check "former rooms are taken from --before, where parts of the new one may be missing" \
    gives assess --by-hand -c former-sky --before "$office" \
    --set skyline.south.reflectance=0.2 --set room.name=Office "$office"

check "size has a row for each run" shows "plan.depth" \
    size -t 2% --by-hand --sweep plan.depth=4:6:1 "$office"
check "in which a deeper room needs a wider window" awk '$1 ~ /^[456]$/ {
        if ($2 <= last) exit 1; last = $2; n++ } END { exit n != 3 }' "$scratch/out"
check "sizes as CSV" shows "plan.depth,file,room,method,change" \
    size -t 2% --by-hand --sweep plan.depth=4:6:1 -f csv "$office"

# Bad input.
check "an unknown attribute is refused" refuses 1 "did you mean width?" \
    df --set window.1.widht=1 "$office"
check "an unknown part is refused with those there are" refuses 1 "did you mean window.W1?" \
    df --set window.W9.width=1 "$site"
check "a room that is not there is refused" refuses 1 "did you mean room.Study?" \
    df --set room.Studi.plan.depth=4 "$site"
check "a part with an ambiguous address is refused" refuses 1 "5 parts have this address" \
    df --set window.1.width=1 "$site"
check "a wrong value is a mistake of the file" refuses 1 "expected a number of metres" \
    df --set plan.depth=deep "$office"
check "also within a sweep, before anything is computed" refuses 1 "did you mean \"clear-single\"?" \
    df --sweep window.glazing=clear-double,clear-singel "$office"
check "--set needs a part and a value" refuses 2 "expected PART.ATTRIBUTE=VALUE" \
    df --set depth=4 "$office"
for range in 1:2 1:2:0 1:2:-1 1:2:x 0:1:1e-9 1,,2 ''; do
    check "--sweep of \"$range\" is refused" refuses 2 "expected PART.ATTRIBUTE=FROM:TO:STEP" \
        df --sweep "plan.depth=$range" "$office"
done
check "too many runs are refused" refuses 2 "more than 1000 runs" \
    df --sweep plan.depth=4:6:0.02 --sweep plan.width=4:6:0.1 "$office"
check "--explain is for a single run" refuses 2 "--explain is for a single run" \
    df --sweep plan.depth=4,5 --explain --points 2,2 "$office"
check "--write is for a single run" refuses 2 "--write is for a single run" \
    size -t 2% --sweep plan.depth=4,5 --write "$scratch/none.xml" "$office"
check "--table is for a single run" refuses 2 "--table is for a single run" \
    assess --table --sweep plan.depth=4,5 "$office"
check "--obstruction is for a single run" refuses 2 "--obstruction is for a single run" \
    size --obstruction Tower --sweep block.Mill.height=4,5 "$site"
check "and can be used with --set" gives size --obstruction Tower --set block.Mill.height=5 "$site"

tap_done
