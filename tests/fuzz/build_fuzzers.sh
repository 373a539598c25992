#!/bin/sh
# build_fuzzers.sh SOURCE ... - builds the libFuzzer targets tests/fuzz/fuzz_*.c with the given
# sources of the program, and a corpus of seeds for each, in tests/fuzz/built of the build
# folder. `make fuzz` calls it; FLAGS, LIBS, SERVER_LIBS, FUZZ_CC and srcdir come from there.
set -eu
built=tests/fuzz/built
flags="-g -O1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all $FLAGS"
mkdir -p "$built/objects"

# Compiles with all processors; file names are unique.
for file in "$@"; do
    case $file in *.c) printf '%s\n' "$file" ;; esac
done | FLAGS=$flags xargs -P "$(getconf _NPROCESSORS_ONLN)" -I FILE sh -c '
    object=$0/objects/$(basename "$1" .c).o
    [ "$object" -nt "$srcdir/$1" ] || exec $FUZZ_CC $FLAGS -c -o "$object" "$srcdir/$1"
' "$built" FILE

# corpus NAME: prints the folder of this corpus.
corpus() {
    mkdir -p "$built/corpus-$1"
    echo "$built/corpus-$1"
}

rooms=$(corpus room)
cp "$srcdir"/examples/*.xml "$rooms"
./tests/model/room/read/test_wrong_rooms --write-all "$rooms"
cp "$srcdir"/tests/formats/epw/*.epw "$(corpus epw)"
cp "$srcdir"/tests/fuzz/*.gbxml "$(corpus gbxml)"
scenes=$(corpus rad)
cp "$srcdir"/tests/formats/radiance/*.rad "$scenes"
printf '%s\n' 'void plastic g 0 0 5 .5 .5 .5 0 0' \
    '!genbox g b 1 1 1 -r .1 | xform -a 9 -t 1 0 0 -i 2 | xform -I -m g -a 9 -ry 9' \
    '!xform -a 9 -t 1 0 0 a b' '!gensky 6 21 12 +s | xform -a 3 -rz 9 | xform -a 3' \
    '!xform -a 9 -t 1 0 0 a' '!xform -n b -I a | xform -a 2' \
    'g polygon p 0 0 9 0 0 0 1 0 0 0 1 0' >"$scenes/nested"
bsdfs=$(corpus bsdf)
for data in 'Columns 1,.1,.1 .1,2,.1 .1,.1,2' 'TensorTree4 {{.1}{.2}{.3}{.4}{.1}{.1}{.1}{.1}{.1}{.1}{.1}{.1}{.1}{.1}{.1}{.1}}' \
    'TensorTree3 {.1 .2 .1 .2 .1 .2 .1 .2}' 'Rows 1,2,-3,4e-1 0.1 .1,.1,.1 .2'; do
    printf '%s' '<WindowElement><Optical><Layer><DataDefinition><IncidentDataStructure>' \
        "${data%% *}" '</IncidentDataStructure><AngleBasis><AngleBasisName>b</AngleBasisName>' \
        '<AngleBasisBlock><nPhis>1</nPhis><ThetaBounds><LowerTheta>0</LowerTheta>' \
        '<UpperTheta>30</UpperTheta></ThetaBounds></AngleBasisBlock><AngleBasisBlock><nPhis>2' \
        '</nPhis><ThetaBounds><LowerTheta>30</LowerTheta><UpperTheta>90</UpperTheta>' \
        '</ThetaBounds></AngleBasisBlock></AngleBasis></DataDefinition><WavelengthData>' \
        '<Wavelength>Visible</Wavelength><WavelengthDataBlock><WavelengthDataDirection>' \
        'Transmission Front</WavelengthDataDirection><ColumnAngleBasis>b</ColumnAngleBasis>' \
        '<RowAngleBasis>b</RowAngleBasis><ScatteringData>' "${data#* }" \
        '</ScatteringData></WavelengthDataBlock></WavelengthData></Layer></Optical>' \
        '</WindowElement>' >"$bsdfs/${data%% *}"
done
meshes=$(corpus mesh)
printf '%s\n' 'ov 0 0 0' 'v 1 0 0' 'v 1 1 0' 'v 0 1 2' 'f 1 2 3 4' 'f -3//1 -2/1 -1/1/1' \
    >"$meshes/faces.obj"
printf '%s\n' 'd  0' SECTION 2 HEADER 9 '$INSUNITS' 70 4 0 ENDSEC 0 SECTION 2 ENTITIES \
    0 3DFACE 10 0 20 0 30 0 11 1 21 0 31 0 12 1 22 1 32 0 13 0 23 1 33 0 \
    0 LWPOLYLINE 90 3 70 1 39 3 10 0 20 0 10 1 20 0 10 1 20 1 0 ENDSEC 0 EOF \
    >"$meshes/face.dxf"
{
    head -c 48 /dev/zero
    printf '\1\1\1\1'
    head -c 4903 /dev/zero
    printf '\1'
} >"$(corpus checkpoint)/all-tiles-done"

cp "$srcdir"/tests/methods/lumen/*.csv "$(corpus lumen)"
printf '%s\n' '# sky iso, turbid' room,point,df 0,0,1.5 0,-1,1.2 1,0,, 1,-1,2 \
    >"$(corpus atlas)/two-rooms"
values=$(corpus values)
printf '%s\n' x,y,z,df_percent 1,2,.85,3.1 >"$values/commas"
printf '%s\n' 'x [m];y [m];e [lx]' '1,5;2;310,5' >"$values/semicolons"
printf '%s\n' 3.1 2.9 1e-3 >"$values/bare"
printf '1.5,0.5 1.5,2;-3,1e-3,.85' >"$(corpus points)/three"
options=$(corpus options)
printf '%s\n' -p 1,2 --sky=iso-12,30,90 --set window.W1.width=1.4 --sweep plan.depth=3:9:.5 \
    -s --error 2% -j 2 --seed=7 --spacing 0.25,.5 --cut x=2 -o out.json file.xml >"$options/many"
printf '%s\n' --time 500ms -sqm exact+bre --sweep window.sill=.8,1 --room A --state existing -- -x \
    >"$options/short"
printf '0.85 W / (A (1 - R_fw)) (1 + 5 sin(theta)) + min(W, 2) / A' >"$(corpus formula)/sum"
requests=$(corpus request)
# request NAME PATH BODY [HEADER ...]: writes a seed.
request() {
    name=$1
    body=$3
    first="POST $2"
    shift 3
    printf '%s\n' "$first" 'Content-Type: application/json' 'X-Pepperpot-Page: a' "$@" '' "$body" >"$requests/$name"
}
office=$(tr '"\n' "' " <"$srcdir/examples/deep-office.xml")
cell='<room version=\"1\"><plan width=\"3\" depth=\"4\" height=\"3\"/><window wall=\"south\" left=\"1\" sill=\"1\" width=\"1\" height=\"1\"/></room>'
for path in df plan check; do
    request "$path" "/api/$path" "{\"room\":\"$office\"}"
done
request df-options /api/df "{\"room\":\"$cell\",\"options\":{\"methods\":\"exact+bre,protractor+bre\",\"points\":[[1.5,3],[1,1,0.8]],\"sky\":\"iso-12,40,180\",\"format\":\"csv\"}}"
request df-explain /api/df "{\"room\":\"$cell\",\"options\":{\"points\":[[1,1]],\"explain\":true,\"formula\":\"irc = 0.8 W / A\",\"room\":\"a\"}}"
request plan-tolerance /api/plan "{\"room\":\"$cell\",\"options\":{\"tolerance\":0.1,\"methods\":\"exact+bre\"}}"
request trace /api/trace "{\"room\":\"$cell\",\"options\":{\"error\":20,\"samples\":16,\"seed\":2}}"
request chart /api/chart/waldram "{\"room\":\"$cell\",\"options\":{\"format\":\"pdf\",\"points\":[[1,1]]}}"
request annual /api/annual "{\"room\":\"$cell\",\"options\":{\"weather\":\"0\",\"error\":5,\"lighting\":[\"dimmed\",\"manual\"]}}"
request render /api/render "{\"room\":\"$cell\",\"options\":{\"size\":\"64x48\",\"from\":[1,1,1]}}"
request report /api/report "{\"room\":\"$cell\",\"options\":{\"by-hand\":true}}" 'Accept: text/html'
request import /api/import '{"gbxml":"<gbXML/>"}'
request wrong /api/check '{"room":"<room version=\"1\"><plan width=\"x\"/><widow/></room>"}'
printf '%s\n' 'POST /api/weather' 'Content-Type: application/octet-stream' '' \
    'LOCATION,Brussels,-,BEL' >"$requests/weather"
printf '%s\n' 'GET /api/room' 'Authorization: Bearer k' 'Sec-Fetch-Site: same-origin' >"$requests/room"
printf '%s\n' 'GET /index.html' 'Origin: http://127.0.0.1' >"$requests/page"
printf '%s\n' 'GET /api/jobs/0123456789abcdef0123456789abcde' >"$requests/job"
printf '%s\n' 'GET /..%2f..%2fetc/passwd?a=b&c' 'Host: [::1]:80' 'Cookie: a=b' >"$requests/path"

# An archive: each target links only the objects that it needs.
rm -f "$built/objects.a"
${AR:-ar} rcs "$built/objects.a" "$built"/objects/*.o

for source in "$srcdir"/tests/fuzz/fuzz_*.c; do
    name=$(basename "$source" .c)
    kind=${name#fuzz_}
    seeds=$(corpus "$kind")
    wrap=
    own_libs=$LIBS
    # These readers open files; the fuzzer replaces the function that reads them.
    case $kind in
    rad) wrap=-Wl,--wrap=pp_read_file_regular ;;
    values | atlas) wrap=-Wl,--wrap=pp_read_file ;;
    request)
        own_libs=$SERVER_LIBS
        [ -f "$built/objects/http_request.o" ] || continue # built without libmicrohttpd
        ;;
    esac
    # shellcheck disable=SC2086 # words
    $FUZZ_CC $flags -fsanitize=fuzzer $wrap -o "$built/$name" "$source" "$built/objects.a" $own_libs
    words=
    [ ! -f "$srcdir/tests/fuzz/$name.dict" ] || words="-dict=$srcdir/tests/fuzz/$name.dict"
    echo "run it: $built/$name -max_total_time=600 -max_len=24000 $words $seeds"
done
