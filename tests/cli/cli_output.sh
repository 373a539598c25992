#!/bin/sh
# Output is complete or absent, and the same for every destination.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

"$pepperpot" df "$deep" >"$scratch/expected"
run df -o "$scratch/out file.txt" "$deep"
check "-o writes what standard output would get" \
    same "$scratch/expected" "$scratch/out file.txt"
check "and standard output gets nothing" test ! -s "$scratch/out"
check "-o - is standard output" gives df -o - "$deep"
check "with the same text" same "$scratch/expected" "$scratch/out"

(umask 027 && "$pepperpot" df -o "$scratch/new" "$deep")
check "a new file has the permissions of any new file" \
    test "$(ls -l "$scratch/new" | cut -c 1-10)" = -rw-r-----
echo old >"$scratch/kept"
chmod 606 "$scratch/kept"
"$pepperpot" df -o "$scratch/kept" "$deep"
check "a replaced file keeps its permissions" \
    test "$(ls -l "$scratch/kept" | cut -c 1-10)" = -rw----rw-
check "and has the new text" same "$scratch/expected" "$scratch/kept"

echo old >"$scratch/target"
ln -s target "$scratch/link"
"$pepperpot" df -o "$scratch/link" "$deep"
check "a symbolic link stays one" test -L "$scratch/link"
check "and its file has the new text" same "$scratch/expected" "$scratch/target"
ln -s yet-to-come "$scratch/dangling"
"$pepperpot" df -o "$scratch/dangling" "$deep"
check "a link to a file still to be made makes it" \
    same "$scratch/expected" "$scratch/yet-to-come"
ln -s loop "$scratch/loop"
check "a link to itself" refuses 3 "loop" df -o "$scratch/loop" "$deep"

check "a directory is no output file" refuses 3 "directory" df -o "$scratch" "$deep"
check "a directory that is not there" \
    refuses 3 "nowhere" df -o "$scratch/nowhere/x" "$deep"
echo old >"$scratch/survivor"
run df -o "$scratch/survivor" "$scratch/missing.xml"
check "a failed run leaves the old file" test "$(cat "$scratch/survivor")" = old
check "nothing temporary is left" nothing "$(leftovers)"

if [ "$(id -u)" -ne 0 ]; then
    mkdir "$scratch/locked"
    chmod 555 "$scratch/locked"
    check "a directory that may not be written to" \
        refuses 3 "locked" df -o "$scratch/locked/x" "$deep"
    chmod 755 "$scratch/locked"
else
    skip "a directory that may not be written to" "root may write everywhere"
fi

# full WORDS: status 3 and a message when the output goes to a full disk.
full() {
    "$pepperpot" "$@" >/dev/full 2>"$scratch/err"
    status=$?
    [ $status -eq 3 ] && [ -s "$scratch/err" ] || told
}
closed() {
    "$pepperpot" "$@" 2>"$scratch/err" >&-
    status=$?
    [ $status -eq 3 ] && [ -s "$scratch/err" ] || told
}
if [ -c /dev/full ]; then
    check "a full disk is noticed" full df "$deep"
    check "a full disk is noticed by JSON" full df --format json "$deep"
    check "a full disk is noticed by help" full df --help
    check "a full disk is noticed with -o" refuses 3 "/dev/full" df -o /dev/full "$deep"
    check "and a device stays one" test -c /dev/full
else
    skip "a full disk is noticed" "there is no /dev/full"
fi

# An input file is never overwritten, and no file is written twice, even with different names.
cp "$deep" "$scratch/own.xml"
ln -s own.xml "$scratch/other.xml"
for own in "$scratch/own.xml" "$scratch/../${scratch##*/}/own.xml" "$scratch/other.xml"; do
    check "the room file is not written over as ${own##*/tmp}" \
        refuses 2 "would overwrite the input file" df -o "$own" "$scratch/own.xml"
done
check "and is what it was" same "$deep" "$scratch/own.xml"
check "a cache is not the output" refuses 2 "--cache and --output are the same file" \
    df -s --engine cache --cache "$scratch/two" -o "$scratch/./two" "$deep"
check "nor a picture its checkpoint" refuses 2 "are the same file" \
    render --checkpoint "$scratch/x.png" -o "$scratch/x.png" "$deep"
check "nor a weather file" refuses 2 "--output and --weather are the same file" \
    availability --weather "$scratch/own.xml" -o "$scratch/own.xml" "$deep"
check "a cache is a file" refuses 2 "the name of a file" \
    df -s --engine cache --cache - "$deep"
check "a device may be written twice" \
    sh -c "'$pepperpot' df -o /dev/null '$deep' </dev/null"

check "a closed standard output is noticed" closed df "$deep"
check "a closed standard output is noticed by help" closed --help
check "-o works with everything closed" \
    sh -c "'$pepperpot' df -o '$scratch/alone' '$deep' <&- >&- 2>&-"
check "and writes the same" same "$scratch/expected" "$scratch/alone"
check "a reader that goes away is no drama" \
    sh -c "'$pepperpot' df '$deep' 2>'$scratch/err' | head -n 1 >/dev/null &&
        test ! -s '$scratch/err'"

# Numbers do not depend on the locale or the environment.
locales=C
for name in C.UTF-8 de_DE.UTF-8 fr_FR.UTF-8; do
    LC_ALL=$name locale charmap >/dev/null 2>&1 && locales="$locales $name"
done
for format in json csv; do
    "$pepperpot" df --format $format "$deep" >"$scratch/plain.$format"
    for name in $locales; do
        LC_ALL=$name "$pepperpot" df --format $format "$deep" >"$scratch/local"
        check "$format is the same in locale $name" \
            same "$scratch/plain.$format" "$scratch/local"
    done
done
check "no environment is needed" sh -c "env -i '$pepperpot' df '$deep' >/dev/null"
LC_ALL=C.UTF-8 "$pepperpot" df -s --samples 16 "$deep" >"$scratch/utf8"
LC_ALL=C "$pepperpot" df -s --samples 16 "$deep" >"$scratch/ascii"
check "plus-minus is ASCII where the locale is" \
    nothing "$(LC_ALL=C grep -n '[^ -~]' "$scratch/ascii")"
if LC_ALL=C.UTF-8 locale charmap 2>/dev/null | grep -q UTF-8; then
    check "and one sign where it is UTF-8" grep -q '±' "$scratch/utf8"
else
    skip "and one sign where it is UTF-8" "there is no locale C.UTF-8"
fi
tap_done
