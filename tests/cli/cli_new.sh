#!/bin/sh
# new writes room files that every command accepts; help and FILE.xml are short forms.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

cd "$scratch" || exit 1
for kind in office flat classroom attic; do
    check "new $kind writes a file" quietly new $kind -o "$kind.xml"
    check "whose comments name it" grep -q "pepperpot df $kind.xml" "$kind.xml"
    check "which df takes without a warning" gives df "$kind.xml"
    check "and assess" gives assess --by-hand -q "$kind.xml"
done
check "on standard output" gives new office
check "it is a room" grep -q '<room version="1" name="Office" use="office"' out
check "a file that exists is kept" refuses 2 "exists; expected another name, or --force" \
    new flat -o office.xml
check "unless told otherwise" quietly new flat -o office.xml --force
check "another kind is refused" refuses 2 \
    'there is no room "ofice"; did you mean office?; expected office, flat, classroom or attic' \
    new ofice
check "a kind is needed" refuses 2 "expected one kind of room" new
check "a folder that is not there is the machine's" refuses 3 "none/a.xml" new attic -o none/a.xml

check "a device that exists is written to" quietly new office -o /dev/null
check "it is still a device" test -c /dev/null
mkfifo pipe
into_pipe() {
    cat pipe >piped &
    quietly new attic -o pipe && wait $!
}
check "so is a pipe" into_pipe
check "which gets the whole file" grep -q '^</room>' piped
check "with a name to fill in" grep -q "pepperpot df FILE.xml" piped
check "a folder is refused" refuses 2 "exists; expected another name" new office -o .

# File names that a comment in XML cannot contain.
latin=$(printf 'caf\351.xml')
lines=$(printf 'two\nlines.xml')
for name in "$latin" "$lines" a--b.xml; do
    check "a file with an odd name is written" quietly new office -o "$name"
    check "in UTF-8" sh -c 'iconv -f UTF-8 -t UTF-8 "$1" >utf8' sh "$name"
    check "with another name in its comments" grep -q "pepperpot df FILE.xml" "$name"
    check "and can be read" gives df -m exact "$name"
done
for format in json csv; do
    check "such a name in $format" gives df -m exact --format $format "$latin" "$lines"
    check "is UTF-8" sh -c 'iconv -f UTF-8 -t UTF-8 out >utf8'
done
check "a name in UTF-8 stands in the comments" quietly new office -o café.xml
check "as it is" grep -q "pepperpot df café.xml" café.xml

check "a room file is enough" gives attic.xml
cp out as_file
check "and is df's" gives df attic.xml
check "to the byte" cmp out as_file
check "with options behind it" gives attic.xml -m exact --format csv
check "a file that is not there is named" refuses 1 "none.xml" none.xml

check "help" gives help
check "help of a command" gives help df
cp out as_help
check "is the command's own" sh -c "'$pepperpot' df --help | cmp - as_help"
check "of none" refuses 2 'there is no command "fd"' help fd
check "of two" refuses 2 "expected one" help df chart
tap_done
