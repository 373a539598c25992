#!/bin/sh
# Output on a terminal of 60 columns, the narrowest for which tables are laid out, and of 200, for a
# room without a name: the progress bar, and tables whose columns leave little space.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

if ! script -qec true /dev/null >/dev/null 2>&1 </dev/null; then
    skip "output on a terminal" "there is no script(1) to make one"
    tap_done
    exit 0
fi
awk -f "$srcdir/tests/lib/clear_year.awk" >"$scratch/year.epw"
sed '/<room/s/ name="[^"]*"//' "$deep" >"$scratch/room.xml"
cd "$scratch" || exit 1

# ends COLUMNS WORDS: on a terminal of that width the command ends with status 0 within a minute.
# Its output is kept without what the progress bar draws and erases.
ends() {
    columns=$1
    shift
    script -qec "stty cols $columns; timeout -s KILL 60 '$pepperpot' $*" /dev/null </dev/null >seen
    status=$?
    tr '\r' '\n' <seen | sed 's/.*\[K//' >out
    [ $status -eq 0 ] && ! grep -q '(null)' out || told
}

while read -r words; do
    for columns in 60 200; do
        check "$words, $columns columns" ends $columns $words room.xml
    done
done <<EOF
df
df --simulate --error 20%
df --explain -p 2,3
df -m all
df --sweep window.width=1,2
assess --by-hand
assess --spacing largest --error 20%
assess --by-hand --for en17037 --table
size --target 2% --by-hand
availability
availability -w year.epw
annual -w year.epw --samples 16
glare -w year.epw --samples 16 --view 2,3,0
EOF
check "rules, 60 columns" ends 60 assess --rules
ends 60 assess --by-hand room.xml
check "a long title is broken over lines" grep -q '^ *minimum: 300' out

tap_done
