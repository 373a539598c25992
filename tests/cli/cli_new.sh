#!/bin/sh
# new writes room files that every command takes; help and FILE.xml are short ways.
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
