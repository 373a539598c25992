#!/bin/sh
# Neighbours from mesh files: the same figures as with a block of the same shape, a street of
# 100,000 triangles, rejected files.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
LC_ALL=C
export LC_ALL

# room ELEMENTS: the room with these elements outside.
room() {
    printf '%s\n' '<room version="1" name="Office">' \
        '<plan width="4.1" depth="6.2" height="2.7"/>' \
        '<window wall="south" left="0.9" sill="0.8" width="2.4" height="1.5"/>' \
        "$1" '<point x="2.1" y="1.3"/><point x="1.1" y="3.4"/></room>'
}
# houses COUNT: houses with five faces of two triangles each, in rows of 200.
houses() {
    awk -v count="$1" 'BEGIN {
        for (i = 0; i < count; i++) {
            x = i % 200 * 2 - 200; y = -20 - int(i / 200) * 3; h = 3 + i * 7 % 90 / 10
            for (k = 0; k < 8; k++)
                print "v", x + 1.6 * (k % 4 == 1 || k % 4 == 2), y - 1.9 * (k % 4 > 1),
                    h * (k > 3)
            print "f -8 -7 -3 -4\nf -7 -6 -2 -3\nf -6 -5 -1 -2\nf -5 -8 -4 -1\nf -4 -3 -2 -1"
        }
    }'
}
# figures METHOD WORDS: lines with the value and, if it exists, the standard error by the method,
# for all components, points and the average.
figures() {
    method=$1
    shift
    "$pepperpot" df --format json --methods exact "$@" 2>"$scratch/err" |
        grep -o "\"$method\": { \"value\": [^,}]*\(, \"se\": [^,}]*\)*" |
        sed 's/[^:]*: { "value": //; s/, "se": / /'
}
# near FILE FILE: the values agree to 1e-8 per cent, the precision of ten digits and of cuts
# between two triangles of a side; there are some values.
near() {
    paste "$1" "$2" | awk '
        NF != 2 { bad = 1 }
        { d = $1 - $2; if (d > 1e-8 || -d > 1e-8) bad = 1 }
        END { exit bad || NR < 6 }'
}
# within FILE FILE: the values agree within 3 standard errors; there are some values.
within() {
    paste "$1" "$2" | awk '
        NF != 4 { bad = 1 }
        { d = $1 - $3; e = 3 * sqrt($2 * $2 + $4 * $4); if (d > e || -d > e) bad = 1 }
        END { exit bad || NR < 6 }'
}
# differs COMMAND: succeeds if the command fails.
differs() {
    ! "$@"
}

printf 'v -4100 -14200 0\nv 5900 -14200 0\nv 5900 -8200 0\nv -4100 -8200 0
v -4100 -14200 8300\nv 5900 -14200 8300\nv 5900 -8200 8300\nv -4100 -8200 8300
f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 7 8\n' >"$scratch/box.obj"
room '<block x="-4.1" y="-14.2" width="10" depth="6" height="8.3"/>' >"$scratch/block.xml"
room '<mesh file="box.obj" scale="0.001"/>' >"$scratch/mesh.xml"
room '' >"$scratch/open.xml"
# The same mesh with y up, another origin, and rotated by a right angle.
awk '/^v/ { print "v", $3, $4, $2; next } 1' "$scratch/box.obj" >"$scratch/up.obj"
room '<mesh file="up.obj" up="y" scale="0.001" rotate="90"/>' >"$scratch/up.xml"

for of in block mesh up open; do
    figures exact "$scratch/$of.xml" >"$scratch/$of"
done
check "a box of a file has the exact figures of the block" near "$scratch/block" "$scratch/mesh"
check "whatever its axes" near "$scratch/block" "$scratch/up"
check "and not those of the open sky" differs near "$scratch/block" "$scratch/open"
seed=1
for of in block mesh open; do
    figures traced --simulate --error 2% --seed $seed "$scratch/$of.xml" >"$scratch/$of"
    seed=$((seed + 1))
done
check "traced it is the block within 3 errors" within "$scratch/block" "$scratch/mesh"
check "and not the open sky" differs within "$scratch/block" "$scratch/open"

check "JSON says how many triangles" shows '"mesh-triangles": 10' df -m exact -f json "$scratch/mesh.xml"
check "and meshes" grep -q '"meshes": 1,' "$scratch/out"
check "of a block none" shows '"mesh-triangles": 0' df -m exact -f json "$scratch/block.xml"

# A sized room written to another folder still finds its mesh.
mkdir "$scratch/sized" "$scratch/sized/deep" "$scratch/R&D's"
ln -s sized/deep "$scratch/link"
room '<mesh file="../box.obj" scale="0.001"/>' >"$scratch/R&D's/own.xml"
# sizes FILE FILE: sizes a room, writes it to the second file, and prints its figures.
sizes() {
    "$pepperpot" size --target 1% --by-hand -q "$1" -w "$2" >/dev/null && figures exact "$2"
}
sizes "$scratch/mesh.xml" "$scratch/here.xml" >"$scratch/here"
check "a sized room has figures" test "$(wc -l <"$scratch/here")" -ge 6
check "beside the other its mesh is named as before" grep -q 'file="box.obj"' "$scratch/here.xml"
for of in sized/there.xml sized/deep/there.xml link/again.xml "R&D's/there.xml"; do
    sizes "$scratch/mesh.xml" "$scratch/$of" >"$scratch/there"
    check "in another folder it has the same: $of" same "$scratch/here" "$scratch/there"
done
check "the path is relative" grep -q 'file="../../box.obj"' "$scratch/sized/deep/there.xml"
sizes "$scratch/R&D's/own.xml" "$scratch/sized/own.xml" >"$scratch/there"
check "out of a folder whose name XML has to escape" same "$scratch/here" "$scratch/there"
check "which is written so" grep -q "file=\"../R&#38;D&#39;s/../box.obj\"" "$scratch/sized/own.xml"
check "from standard input" sh -c "
    cd '$scratch' && '$pepperpot' size --target 1% --by-hand -q - -w sized/in.xml <mesh.xml >/dev/null &&
        cmp sized/in.xml sized/there.xml"
check "a folder that is not there is refused as ever" refuses 3 "none/there.xml" \
    size --target 1% --by-hand -q "$scratch/mesh.xml" -w "$scratch/none/there.xml" -o "$scratch/text"

houses 10000 >"$scratch/street.obj"
room '<mesh file="street.obj" name="Street"/>' >"$scratch/street.xml"
check "a street of 100,000 triangles is simulated" gives df --simulate --error 5% \
    --methods exact,brs-table "$scratch/street.xml"
check "and told of" grep -q "1 mesh of 100000 triangles" "$scratch/out"
check "the table refuses it in words" grep -q "external meshes" "$scratch/out"
room '<mesh file="street.obj"/><grid spacing="0.3" margin="0"/>' >"$scratch/fine.xml"
check "of too many points the exact method does, too" \
    shows "too many triangles" df --methods exact "$scratch/fine.xml"

houses 300 >"$scratch/few.obj"
room '<site latitude="51.5" longitude="0"/><mesh file="few.obj"/>' |
    awk '/<site/ { site = 1 } 1' >"$scratch/few.xml"
# Each house is one roof with four edges, however many triangles it has.
check "a plan of the site has roofs, not triangles" quietly chart site -o "$scratch/site.svg" "$scratch/street.xml"
check "and is small" test "$(wc -c <"$scratch/site.svg")" -lt 400000
check "sun paths have one outline of the street" sh -c "
    '$pepperpot' chart sun-path -o '$scratch/sun.svg' '$scratch/few.xml' && [ \$(wc -c <'$scratch/sun.svg') -lt 500000 ]"
check "contours over the plane are refused in words" refuses 1 \
    "too many for contours" chart plan "$scratch/street.xml" -o "$scratch/plan.svg"

check "so are elevations" refuses 1 "expected at most 2000" \
    chart elevation "$scratch/street.xml" -o "$scratch/elevation.svg"
check "the line of what sees sky is not judged" shows "too fine for the no-sky line" \
    assess --by-hand -c nsl,rights-of-light "$scratch/street.xml"

# Leaves that hide one another: the sky between them is divided into thousands of pieces. A view is
# cut into these pieces once, not for each of the thousands of directions of an average.
awk 'BEGIN { srand(1)
    for (i = 0; i < 12000; i++) {
        x = 23 * rand() - 10; y = -3 - 17 * rand(); z = 8 * rand()
        for (k = 0; k < 3; k++)
            printf "v %.3f %.3f %.3f\n", x + 0.5 * rand(), y + 0.5 * rand(), z + 0.5 * rand()
        print "f", 3 * i + 1, 3 * i + 2, 3 * i + 3
    } }' >"$scratch/leaves.obj"
room '<mesh file="leaves.obj"/>' >"$scratch/leaves.xml"
check "before leaves there is no average of exact" shows "too many parts; the average" \
    df --methods exact,average-df --explain -p 1.5,2 "$scratch/leaves.xml"

room '<mesh file="none.obj"/>' >"$scratch/wrong.xml"
check "a file that is not there" refuses 1 'wrong.xml:4: mesh: ' df "$scratch/wrong.xml"
room '<mesh file="box.obj" scale="0.001" y="12"/>' >"$scratch/wrong.xml"
check "a mesh in the room" refuses 1 'wrong.xml:4: mesh: intersects a ' df "$scratch/wrong.xml"
room '<mesh file="box.obj" scale="1000"/>' >"$scratch/wrong.xml"
check "a mesh out of scale" refuses 1 'extends more than 100000 m' df "$scratch/wrong.xml"
printf '0\nSECTION\n2\nENTITIES\n0\n' >"$scratch/none"
room '<mesh file="-"/>' >"$scratch/wrong.xml"
check "standard input is no mesh, by its name" refuses 1 'expected .obj or .dxf' \
    df "$scratch/wrong.xml"
room '<mesh file="none"/>' >"$scratch/wrong.xml"
check "nor is a file of another ending" refuses 1 'none: the file type is unknown' \
    df "$scratch/wrong.xml"
mkfifo "$scratch/pipe.obj"
room '<mesh file="pipe.obj"/>' >"$scratch/wrong.xml"
check "a pipe is not waited for" refuses 1 'this is not a regular file' df "$scratch/wrong.xml"
rm "$scratch/pipe.obj"
{ printf '\357\273\277' && cat "$scratch/box.obj"; } >"$scratch/marked.obj"
room '<mesh file="box.obj" scale="0.001"/>' >"$scratch/plain.xml"
room '<mesh file="marked.obj" scale="0.001"/>' >"$scratch/marked.xml"
figures exact "$scratch/plain.xml" >"$scratch/plain"
figures exact "$scratch/marked.xml" >"$scratch/marked"
check "with a byte order mark the same" same "$scratch/plain" "$scratch/marked"
check "from standard input, from where we are" sh -c \
    "cd '$scratch' && '$pepperpot' df --methods exact - <mesh.xml | grep -q '1 mesh of 10 '"
tap_done
