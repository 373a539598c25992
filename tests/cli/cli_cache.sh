#!/bin/sh
# df with the irradiance cache: compared with the path tracer, with any number of threads, and with
# the cache in a file, which must be complete, of the same room and with the same options.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

few="--simulate --engine cache --samples 16 -ad 256 --format csv"
kept=$scratch/kept.cache

check "the cache answers" shows ",cached," df $few "$deep"
cp "$scratch/out" "$scratch/one"
check "without the tracer" nothing "$(grep ',traced,' "$scratch/one")"
check "the same by 1, 2 and 4 threads" same_by_threads "1 2 4" df $few "$deep"
check "to the byte" same "$scratch/one" "$scratch/by_threads"
check "both engines beside each other" \
    shows "cached: through the irradiance cache" df --simulate --engine path,cache \
    --samples 16 -ad 64 --points "1.5,2" "$deep"
check "with their difference" grep -q "from traced, %" "$scratch/out"
check "in standard errors of the difference" grep -q "diff./s.e." "$scratch/out"
check "as in JSON" gives df --simulate --engine cache,path --samples 16 -ad 64 --points "1.5,2" \
    --format json "$deep"
check "which is the difference over the root of the squares of both" \
    sh -c "tr -d ' \\n' <'$scratch/out' | sed 's/\"points\"/\\n/; s/\"average\".*//' |
    tail -n 1 | sed 's/.*\"df\"/\"df\"/; s/[{}]//g; s/[:,]/ /g' | awk '{
        for (i = 1; i <= NF; i++) {
            if (\$i ~ /traced|cached/) of = \$i
            if (\$i ~ /value|se\"|apart/) is[of, \$i] = \$(i + 1)
        }
        t = \"\\\"traced\\\"\"; c = \"\\\"cached\\\"\"; v = \"\\\"value\\\"\"; e = \"\\\"se\\\"\"
        z = (is[c, v] - is[t, v]) / sqrt(is[c, e] ^ 2 + is[t, e] ^ 2)
        d = z - is[c, \"\\\"apart\\\"\"]
        exit !(z != 0 && d * d < 1e-4 && is[t, \"\\\"apart\\\"\"] == \"\")
    }'"
check "an engine twice is refused" refuses 2 "separated by commas" \
    df --simulate --engine path,path "$deep"
check "interpolated at the points, if asked for" gives df $few --interpolate "$deep"
check "what is interpolated has no error" nothing \
    "$(tr -d '\r' <"$scratch/out" | grep -E '^[^,]*,[^,]*,[0-9].*,(irc|df),cached,[^,]*,[0-9]')"
check "as is said" shows "interpolated at the points" \
    df --simulate --engine cache --samples 16 -ad 64 --interpolate "$deep"
check "and never as -0.00" nothing "$(grep -F -- '-0.00' "$scratch/out")"
check "no bounce leaves nothing reflected" gives df $few -ab 0 "$deep"
check "at any point" nothing "$(grep ',irc,cached,' "$scratch/out" | grep -v ',cached,0,')"

check "a cache is written" gives df $few --cache "$kept" "$deep"
check "and changes nothing" same "$scratch/one" "$scratch/out"
cp "$kept" "$scratch/first"
check "read back" gives df $few --cache "$kept" "$deep"
check "it gives the same" same "$scratch/one" "$scratch/out"
check "and stays as it was" same "$scratch/first" "$kept"
check "long words are the short ones" gives df --simulate --engine cache --samples 16 \
    --divisions 256 --format csv --cache "$kept" "$deep"
check "to the byte" same "$scratch/one" "$scratch/out"

check "another accuracy is refused" \
    refuses 1 "was made with other options" df $few -aa 0.2 --cache "$kept" "$deep"
check "another sky is refused" refuses 1 "was made for another sky or ground" \
    df $few --sky uniform --cache "$kept" "$deep"
check "another room is refused" refuses 1 "is the cache of another room" \
    df $few --cache "$kept" "$examples/office.xml"
head -c 3000 "$scratch/first" >"$kept"
check "one that is cut off is refused" \
    refuses 1 "is cut off or damaged" df $few --cache "$kept" "$deep"
check "and not written over" test "$(wc -c <"$kept")" -eq 3000
printf '\003' | cat "$scratch/first" - >"$scratch/longer"
check "one with a byte too many is refused" \
    refuses 1 "is cut off or damaged" df $few --cache "$scratch/longer" "$deep"
cp "$scratch/first" "$kept"
printf '\077' | dd of="$kept" bs=1 seek=16 conv=notrunc 2>/dev/null
check "another version is refused" \
    refuses 1 "is a cache of version 63" df $few --cache "$kept" "$deep"
printf '\0\0\0\0\0\0\0\002' | dd of="$kept" bs=1 seek=16 conv=notrunc 2>/dev/null
check "numbers turned round are refused" \
    refuses 1 "is a cache of version 144115188075855872" df $few --cache "$kept" "$deep"
cp "$scratch/first" "$kept"
printf '\077' | dd of="$kept" bs=1 seek=5000 conv=notrunc 2>/dev/null
check "a byte that is another is refused" \
    refuses 1 "its checksum is wrong" df $few --cache "$kept" "$deep"
: >"$kept"
check "an empty file is no cache" \
    refuses 1 "is not a cache" df $few --cache "$kept" "$deep"
check "a room file is no cache" \
    refuses 1 "is not a cache" df $few --cache "$examples/office.xml" "$deep"
check "nor is a directory" refuses 1 "" df $few --cache "$scratch" "$deep"
check "one room a cache" refuses 2 "--cache stores the records of one room" \
    df $few --cache "$scratch/new" "$examples/building.xml"
check "a directory that is not there is refused" \
    refuses 3 "cannot be written" df $few --cache "$scratch/none/new" "$deep"
# full WORDS: on a full disk the command ends with an error message and status 3.
full() {
    on_full_disk 4 "$@"
    [ $status -eq 3 ] && grep -q "cannot be written" "$scratch/err" || told
}
check "a full disk is refused" full df $few --cache "$scratch/new" "$deep"
check "and leaves no cache" test ! -e "$scratch/new"
check "interrupted, it leaves none either" eval \
    'interrupted df --simulate --engine cache -ad 16384 --error 0.01% \
        --cache "$scratch/new" "$deep"; [ $status -eq 130 ] && [ ! -e "$scratch/new" ] || told'
cp "$scratch/first" "$kept"
chmod 0 "$kept"
if [ -r "$kept" ]; then
    skip "one that may not be read is refused" "root may read all"
else
    check "one that may not be read is refused" \
        refuses 3 "" df $few --cache "$kept" "$deep"
fi
chmod 600 "$kept"
check "no half of a cache is left anywhere" nothing "$(leftovers)"

check "the engine needs a simulation" refuses 2 "expected --simulate" df --engine cache "$deep"
check "the cache needs its engine" \
    refuses 2 "--cache needs --engine cache" df --simulate --cache "$kept" "$deep"
check "so do its bounces" \
    refuses 2 "--bounces needs --engine cache" df --simulate -ab 0 "$deep"
check "and its constant" \
    refuses 2 "--ambient needs --engine cache" df --simulate -av 0.1 "$deep"
check "another engine is refused" \
    refuses 2 "expected path, cache, photons, radiosity or plain, or several of these, separated by commas" \
    df --simulate --engine path,rays "$deep"
check "more rays than a number holds are refused" refuses 2 "expected a whole number" \
    df $few -ad 1e300 "$deep"
check "accuracy 0 is refused" refuses 2 "-aa is \"0\"" df $few -aa 0 "$deep"
check "three bounces and a half are refused" \
    refuses 2 "--bounces is \"3.5\"" df $few --bounces=3.5 "$deep"
check "a short word needs its value" refuses 2 "-ab needs a value" df $few "$deep" -ab
check "two lists of materials are refused" \
    refuses 2 "expected only one of them" df $few -ai floor -ae ceiling "$deep"
check "a material that is not there is refused" \
    refuses 1 'no material "carpet"' df $few -ae carpet "$deep"
tap_done
