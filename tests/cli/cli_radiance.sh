#!/bin/sh
# Export to Radiance, import of its scenes, and validate --against radiance.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

files="materials.rad room.rad glazing.rad outside.rad sky.rad"
out=$scratch/export

export_to() {
    "$pepperpot" export --to radiance "$@" >"$scratch/out" 2>"$scratch/err"
}

check "a room becomes a directory" export_to -o "$out" "$deep"
check "with all its files" test "$(ls "$out" | tr '\n' ' ')" = \
    "daylight_factors.sh glazing.rad materials.rad outside.rad pepperpot.cal points.pts room.rad sky.rad "
check "and nothing beside it" nothing "$(leftovers)"
check "a script that a shell understands" sh -n "$out/daylight_factors.sh"
check "which can be run" test -x "$out/daylight_factors.sh"
check "its 17 points" test "$(wc -l <"$out/points.pts")" -eq 17
check "a directory that is not empty is left alone" refuses 3 "not empty" \
    export --to radiance -o "$out" "$deep"
check "but by --force" export_to --force -o "$out" --points 1.5,2 "$deep"
check "which replaces it" test "$(wc -l <"$out/points.pts")" -eq 1
echo mine >"$out/mine.txt"
check "not where there is anything else" refuses 3 "mine.txt" \
    export --to radiance --force -o "$out" "$deep"
check "and that is still there" grep -q mine "$out/mine.txt"
rm "$out/mine.txt"
check "a file in its place is left alone" refuses 3 "not a directory" \
    export --to radiance -o "$out/room.rad" "$deep"
check "a building is a directory of directories" \
    export_to -o "$scratch/building" "$examples/building.xml"
check "one a room" test "$(ls "$scratch/building" | tr '\n' ' ')" = \
    "Bedroom Kitchen Living-room Study "
# Names of rooms as names of folders: at most 60 bytes, no character cut in two (59 letters and an
# e with acute accent, two bytes), no duplicates, and no name that begins with a dot or a dash.
long=xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
room='<plan width="3" depth="4" height="2.7"/><point x="1" y="1"/></room>'
{
    echo '<building version="1" name="b">'
    for name in "${long}é" "${long}x" "${long}x" "A-5" "A" "A" "../up" "-rf" " k ü/c|h " ""; do
        echo "<room name=\"$name\">$room"
    done
    echo '</building>'
} >"$scratch/names.xml"
check "rooms of any names" export_to -q -o "$scratch/names" "$scratch/names.xml"
check "become folders" test "$(cd "$scratch/names" && printf '%s\n' * | LC_ALL=C sort | tr '\n' ' ')" = \
    "A A-5 A-6 k-ü-c-h room-10 room-7 room-8 $long ${long}x ${long}x-3 "

check "colour and gloss that are left out are said" \
    export_to -o "$scratch/matt" "$examples/l-shaped.xml"
check "with the option that writes them" grep -q "l-shaped.xml: .*--gloss" "$scratch/err"
check "matt, the floor is grey" grep -q "^5 0.2[0-9]* \(0.2[0-9]*\) \1 0 0$" \
    "$scratch/matt/materials.rad"
check "--gloss writes them" export_to --gloss -o "$scratch/gloss" "$examples/l-shaped.xml"
check "and nothing is left out" nothing "$(cat "$scratch/err")"
check "the floor is oak" grep -q "^5 0.297[0-9]* 0.208[0-9]* 0.125[0-9]* 0.03 0.1$" \
    "$scratch/gloss/materials.rad"

check "the ground is a disc" grep -A 3 "^ground ring" "$out/outside.rad"
check "whose cells oconv is told" grep -q "^oconv -r [0-9]* materials.rad" \
    "$out/daylight_factors.sh"
sed 's|<site |<site ground="open" |' "$deep" >"$scratch/open.xml"
check "or an open one is" export_to -o "$scratch/open" "$scratch/open.xml"
check "a glow alone" nothing "$(grep ring "$scratch/open"/*.rad)"
check "in a scene like any other" grep -q "^oconv materials.rad" \
    "$scratch/open/daylight_factors.sh"

panes=$(cd "$srcdir/examples/glazing" && pwd)/prismatic-office.xml
check "a measured pane has its data beside it" export_to -o "$scratch/panes" "$panes"
check "as aBSDF" grep -q "^5 pane_1.xml" "$scratch/panes/materials.rad"
read_back() {
    (cd "$scratch/panes" && "$pepperpot" import --points-file points.pts --error 2% -q \
        materials.rad room.rad glazing.rad outside.rad sky.rad) >"$scratch/read" &&
        awk '$2 == "2.500" { found = 1; exit !($6 > 4.2 && $6 < 4.9) } END { exit !found }' \
            "$scratch/read"
}
check "and reads back with the same light" read_back

check "without --to it is refused" refuses 2 "--to" export -o "$scratch/x" "$deep"
check "and for other programs" refuses 2 "radiance" export --to dxf -o "$scratch/x" "$deep"
check "without -o" refuses 2 "-o DIR" export --to radiance "$deep"
check "to standard output" refuses 2 "directory" export --to radiance -o - "$deep"
check "into what is not there" refuses 3 "cannot be written" \
    export --to radiance -o "$scratch/no/such" "$deep"
sed 's|<working|<surface reflectance="0.2" exitance="0.1"><vertex x="1" y="1" z="1"/><vertex x="2" y="1" z="1"/><vertex x="2" y="2" z="1"/></surface><working|' \
    "$deep" >"$scratch/lit.xml"
check "what Radiance can't say is refused by its line" refuses 1 "line " \
    export --to radiance -o "$scratch/lit" "$scratch/lit.xml"
check "and nothing is written" test ! -e "$scratch/lit"

full() {
    on_full_disk 0 export --to radiance -o "$scratch/full" "$deep"
    test $status -eq 3 && test ! -e "$scratch/full" && nothing "$(leftovers)"
}
check "a full disk leaves nothing behind" full

full_again() {
    cat "$scratch/matt"/* >"$scratch/before"
    on_full_disk 0 export --to radiance --force -o "$scratch/matt" "$deep"
    test $status -eq 3 && cat "$scratch/matt"/* | cmp - "$scratch/before" &&
        nothing "$(leftovers)"
}
check "and an export that was to be replaced as it was" full_again

# If the export is stopped at any moment, all 8 files of all 8 rooms exist, or none.
{
    echo '<building version="1" name="b">'
    for i in 1 2 3 4 5 6 7 8; do
        echo "<room name=\"$i\"><plan width=\"30\" depth=\"40\" height=\"2.7\"/><grid spacing=\"0.5\"/></room>"
    done
    echo '</building>'
} >"$scratch/large.xml"
whole_or_nothing() {
    for wait in 0.01 0.02 0.05 0.1 0.2; do
        "$pepperpot" export --to radiance -q -o "$scratch/large" "$scratch/large.xml" \
            2>/dev/null &
        sleep $wait
        kill -TERM $! 2>/dev/null
        wait $!
        test ! -e "$scratch/large" -o "$(ls "$scratch/large"/*/* 2>/dev/null | wc -l)" -eq 64 ||
            return 1
        nothing "$(leftovers)" || return 1
        rm -rf "$scratch/large"
    done
}
check "one that is stopped is there whole or not at all" whole_or_nothing

cd "$out" || exit 1
case $pepperpot in /*) ;; *) pepperpot=$OLDPWD/$pepperpot ;; esac
# shellcheck disable=SC2086
check "the export is read back" gives import $files
check "with its polygons" grep -q "polygons          7, with 34 corners" "$scratch/out"
check "and its sky" grep -q "10000 lx" "$scratch/out"
# shellcheck disable=SC2086
check "points in it are simulated" \
    gives import $files --points-file points.pts --samples 2048 --format csv
cp "$scratch/out" "$scratch/one"
# df --simulate gives 5.57 % at 2 m from this window; sampling causes an error of some per cent.
check "the daylight factor is the room's" \
    awk -F, 'NR == 2 { exit !($15 > 5.57 - 4 * $16 && $15 < 5.57 + 4 * $16 && $16 < .3) }' "$scratch/one"
# shellcheck disable=SC2086
gives import $files --points-file points.pts --samples 2048 --format csv --threads 3 >/dev/null
check "to the digit with any number of threads" cmp "$scratch/out" "$scratch/one"
# shellcheck disable=SC2086
check "as JSON" gives import $files --points-file points.pts --samples 64 --summary \
    --format json
check "with its format" grep -q '"format": "pepperpot-import-1"' "$scratch/out"
# shellcheck disable=SC2086
check "in time" gives import $files --points-file points.pts --time 100ms
check "which is said" grep -q -- "--time" "$scratch/out"
cat materials.rad room.rad sky.rad >"$scratch/all.rad"
check "from standard input" sh -c \
    '"$1" import - <"$2" >"$3"' sh "$pepperpot" "$scratch/all.rad" "$scratch/out"
check "which can be read once" refuses 2 "once" import - --points-file -

printf 'void plastic a 0 0 5 .5 .5 .5 0 0\n\na polygon p 0 0 8 0 0 0 1 0 0 0 1\n' >"$scratch/bad.rad"
# A square lamp above a plane: E = 179 x 4 (a/s) atan(a/s) lx, a = 0.35 m, s^2 = a^2 + 2.3^2.
cat >"$scratch/lamp.rad" <<'END'
void light lum
0
0
3 1 1 1
lum polygon lamp
0
0
12 -0.35 -0.35 2.3  -0.35 0.35 2.3  0.35 0.35 2.3  0.35 -0.35 2.3
END
echo "0 0 0 0 0 1" >"$scratch/lamp.pts"
# lamp_within ERRORS SHARE OPTIONS: the value is within this number of standard errors of E, and
# the standard error is at most this share of the value.
lamp_within() {
    errors=$1
    share=$2
    shift 2
    gives import "$scratch/lamp.rad" --points-file "$scratch/lamp.pts" -f json "$@" || return 1
    sed -n 's/.*"lux": { "value": \([0-9.]*\), "se": \([0-9.e-]*\) }.*/\1 \2/p' "$scratch/out" |
        awk -v n="$errors" -v share="$share" '{
            off = $1 - 16.0844; if (off < 0) off = -off
            exit !($2 < share * $1 && off < n * $2 + 5e-5) }'
}
check "a lamp is aimed at" lamp_within 4 1e-5
check "or found by chance, with noise" lamp_within 4 0.02 --lamps chance --samples 4096
check "or in no other way" refuses 2 "aimed or chance" import --lamps sometimes "$scratch/lamp.rad"

check "a bad scene is refused by file and line" refuses 1 "bad.rad:3: " import "$scratch/bad.rad"
printf '!rm -rf /\n' >"$scratch/bad.rad"
check "no program is run" refuses 1 "external programs are not run" import "$scratch/bad.rad"
printf 'a polygon p 0 0 9 0 0 0 1 0 0 0 1 0\n' >"$scratch/bad.rad"
check "nor made of nothing" refuses 1 "bad.rad:1: " import "$scratch/bad.rad"
check "a scene that is not there" refuses 1 "none.rad" import "$scratch/none.rad"
printf '# points\n\n1 1 1 0 0\n' >"$scratch/bad.pts"
check "so is a bad point" refuses 1 "bad.pts:3: " import sky.rad --points-file "$scratch/bad.pts"
printf '1 1 1 0 0 0\n' >"$scratch/bad.pts"
check "and one that looks nowhere" refuses 1 "bad.pts:1: " import sky.rad --points-file "$scratch/bad.pts"
: >"$scratch/bad.pts"
check "and none" refuses 1 "no points" import sky.rad --points-file "$scratch/bad.pts"
check "a summary is no table" refuses 2 "CSV" import sky.rad --format csv

# After Ctrl-C the results so far are printed, and marked as unfinished.
prints_when_interrupted() {
    # shellcheck disable=SC2086
    interrupted import $files --points-file points.pts --error 0.001% --format json
    [ $status -eq 130 ] && grep -q '"finished": false' "$scratch/out" || told
}
check "an interrupt leaves what there is" prints_when_interrupted

# An unobstructed sensor under gensky's overcast sky has 100 %.
printf 'void plastic g 0 0 5 0 0 0 0 0\n!gensky -ang 60 0 -c -b 1\nskyfunc glow s 0 0 4 1 1 1 0\ns source sky 0 0 4 0 0 1 180\ng polygon p 0 0 9 0 0 -9 1 0 -9 0 1 -9\n' >"$scratch/sky.rad"
echo "0 0 1 0 0 1" >"$scratch/up.pts"
gives import "$scratch/sky.rad" --points-file "$scratch/up.pts" --samples 4096 --format csv >/dev/null
check "under the open sky the daylight factor is 100 %" \
    awk -F, 'NR == 2 { exit !($15 > 99.95 && $15 < 100.05) }' "$scratch/out"

# A small luminous surface of 1e6 that 2048 paths do not find: a result of 0 lx is reported as
# uncertain.
printf 'void glow g 0 0 4 1e6 1e6 1e6 0\ng polygon p 0 0 12 -.005 -.005 3 -.005 .005 3 .005 .005 3 .005 -.005 3\n' >"$scratch/glow.rad"
echo "0 0 0 0 0 1" >"$scratch/up.pts"
said_with_its_error() {
    gives import "$scratch/glow.rad" --points-file "$scratch/up.pts" --samples 64 --format csv &&
        # 179 lm/W of 1e6 (0.01/3)^2
        awk -F, 'NR == 2 { off = $13 - 1988.9; exit !(off < 3 * $14 && -off < 3 * $14) }' "$scratch/out"
}
check "what no path found is within the error" said_with_its_error

# An illum replaces the sky behind it: a sky of 1, and another 1 over a third of the hemisphere.
printf 'void glow g 0 0 4 1 1 1 0\ng source s 0 0 4 0 0 1 180\nvoid glass pane 0 0 3 .9 .9 .9\n' >"$scratch/even.rad"
echo "0 0 0 0 0 1" >"$scratch/up.pts"
stands_for_the_sky() {
    printf 'void illum i %s 0 3 1 1 1\ni polygon p 0 0 12 -1 -1 1 -1 1 1 1 1 1 1 -1 1\n' \
        "$1" >"$scratch/illum.rad"
    gives import "$scratch/even.rad" "$scratch/illum.rad" --points-file "$scratch/up.pts" \
        --samples 4096 --format csv &&
        awk -F, 'NR == 2 { exit !($15 > 99.9 && $15 < 100.1) }' "$scratch/out"
}
check "an illum is not added to what is behind it" stands_for_the_sky 0
check "nor to its glass" stands_for_the_sky "1 pane"
printf 'void illum i 1 nosuch 0 3 1 1 1\n' >"$scratch/bad.rad"
check "what it looks like has to be there" refuses 1 'bad.rad:1: there is no material "nosuch"' \
    import "$scratch/bad.rad"
printf 'void glow g 0 0 4 1 1 1 0\nvoid illum i 1 g 0 3 1 1 1\n' >"$scratch/bad.rad"
check "and gives off no light itself" refuses 1 "bad.rad:2: the alternate material of an illum is \"g\"" \
    import "$scratch/bad.rad"

check "without Radiance, validate says so" sh -c \
    'PATH=/nowhere "$1" validate --against radiance "$2" 2>&1 | /bin/grep -q "oconv and rtrace on PATH"' \
    sh "$pepperpot" "$deep"
check "of what room it has to be told" refuses 2 "--against" validate --against radiance

# In place of Radiance, two programs that return an irradiance of 1 everywhere: relative to 10000
# lx / 179 of the open ground this is 1.79 %.
mkdir "$scratch/bin" "$scratch/tmp"
printf '#!/bin/sh\n' >"$scratch/bin/oconv"
printf '#!/bin/sh\nwhile read -r line; do echo 1 1 1; done\n' >"$scratch/bin/rtrace"
chmod +x "$scratch/bin/oconv" "$scratch/bin/rtrace"
beside() {
    (PATH=$scratch/bin:$PATH TMPDIR=$scratch/tmp && export TMPDIR && gives validate --against radiance --samples 64 "$@")
}
check "beside another program's" beside --points 1.5,2 "$deep"
check "as a table" grep -q " 1.7900 " "$scratch/out"
check "as CSV" beside --points 1.5,2 --format csv "$deep" "$examples/building.xml"
check "with a line a point" test "$(wc -l <"$scratch/out")" -eq 6
check "as JSON" beside --points 1.5,2 --format json "$deep" "$examples/building.xml"
check "with rooms and both values" awk '
    /"format": "pepperpot-validate-1"/ { format = 1 }
    /"against": "radiance"/ { against = 1 }
    /"room":/ { rooms++ }
    /"x": 1.5, "y": 2, .*"traced": { "value": .*"rtrace": { "value": 1.79, "se": [^ ]* }, "off-by": / { points++ }
    END { exit !(format && against && rooms == 5 && points == 5) }' "$scratch/out"
suite_of() {
    (PATH=$scratch/bin:$PATH TMPDIR=$scratch/tmp && export TMPDIR && run validate radiance --samples 64 "$@"; [ $status -eq 1 ] && grep -q "outside their limits" "$scratch/err" || told)
}
check "as a suite, whose limits 1.79 % everywhere does not keep" suite_of --points 1.5,2 \
    --page "$scratch/radiance.html" "$deep"
check "as it says of the point" grep -qE \
    'df at 1.500, 2.000, 0.850 +0\.0[0-9]+ 0.017900 \+[0-9]e-02 [0-9]e-0[34] WRONG' "$scratch/out"
check "and on its page" grep -q 'class="verdict bad">Not passed: 0 of 1' "$scratch/radiance.html"
check "methods have no part in it" refuses 2 "--methods" \
    validate --against radiance --methods bre "$deep"
printf '#!/bin/sh\necho 1 1 1\n' >"$scratch/bin/rtrace"
fewer() {
    (PATH=$scratch/bin:$PATH TMPDIR=$scratch/tmp && export TMPDIR && refuses 3 "fewer irradiances" validate --against radiance --samples 64 "$deep")
}
check "fewer answers than points are said" fewer
printf '#!/bin/sh\nexit 1\n' >"$scratch/bin/rtrace"
fails() {
    (PATH=$scratch/bin:$PATH TMPDIR=$scratch/tmp && export TMPDIR && refuses 3 "rtrace failed" validate --against radiance --samples 64 "$deep")
}
check "so is that it failed" fails
check "and nothing stays behind" nothing "$(ls "$scratch/tmp")"

# If Radiance is installed, its rtrace agrees.
if command -v rtrace >/dev/null && command -v oconv >/dev/null; then
    check "rtrace has the same daylight factor" sh -c \
        './daylight_factors.sh -ab 6 -ad 4096 -as 0 -aa 0 -lw 1e-5 |
            awk "{ exit !(\$4 > 5.3 && \$4 < 6.0) }"'
else
    skip "rtrace has the same daylight factor" "Radiance is not installed"
fi
tap_done
