#!/bin/sh
# Charts reach their files, in every format.
. "$srcdir/tests/tap.sh"
. "$srcdir/tests/cli.sh"

check "the kinds are listed" shows "section" chart --list
check "with a kind too" shows "plan" chart plan --list
check "no kind" refuses 2 "--list" chart
check "a kind without a room" refuses 2 "room file" chart plan
check "an unknown kind suggests the nearest" \
    refuses 2 "did you mean section?" chart sektion -o x.pdf "$deep"
check "a chart needs a format" refuses 2 "--format" chart plan "$deep"
check "an ending that is no format" refuses 2 "pdf" chart plan -o "$scratch/x.jpg" "$deep"
check "a size of paper that is none" refuses 2 "a4" chart plan --paper b4 -o x.pdf "$deep"
check "a way of paper that is none" \
    refuses 2 "landscape" chart plan --orientation up -o x.pdf "$deep"
check "dots that are too many" refuses 2 "1200" chart plan --dpi 5000 -o x.png "$deep"
check "a PNG has no pages for several rooms" \
    refuses 2 "--room" chart plan --format png "$examples/building.xml"

# starts_with BYTES FILE
starts_with() {
    [ "$(head -c ${#1} "$2")" = "$1" ]
}

for kind in section plan; do
    for format in pdf svg png; do
        file="$scratch/a $kind.$format"
        run chart $kind -o "$file" "$deep"
        check "$kind becomes $format" test $status -eq 0
        case $format in
        pdf) check "$kind.pdf is one" starts_with "%PDF" "$file" ;;
        svg) check "$kind.svg is one" starts_with "<?xml" "$file" ;;
        png) check "$kind.png is one" starts_with "$(printf '\211PNG')" "$file" ;;
        esac
        run chart $kind --format $format "$deep"
        check "$kind as $format to standard output is the same" same "$file" "$scratch/out"
    done
done
for example in "$examples"/*.xml; do
    for kind in section plan; do
        run chart $kind -o "$scratch/example.pdf" "$example"
        check "$kind of $(basename "$example")" test $status -eq 0
    done
done
run chart plan -o "$scratch/building.pdf" "$examples/building.xml"
pages=$(grep -ac '/Type /Page[^s]' "$scratch/building.pdf")
if [ "$pages" -gt 0 ]; then
    check "a building has a page a room" test "$pages" -eq 4
else
    skip "a building has a page a room" "this cairo compresses the PDF's page list"
fi
run chart plan --dpi 50 -o "$scratch/rooms.v1/plan.png" "$examples/building.xml"
check "a directory that is not there" test $status -eq 3
mkdir "$scratch/rooms.v1"
run chart plan --dpi 50 -o "$scratch/rooms.v1/plan.png" "$examples/building.xml"
check "PNGs of a building are numbered" \
    test "$(cd "$scratch/rooms.v1" && echo *)" = "plan-1.png plan-2.png plan-3.png plan-4.png"
run chart section --log --paper a3 --orientation landscape --simulate --samples 16 \
    --methods all -o "$scratch/all.pdf" "$deep"
check "every option at once" test $status -eq 0
if [ -c /dev/full ]; then
    check "a full disk is noticed" \
        refuses 3 "/dev/full" chart plan --format pdf -o /dev/full "$deep"
fi
tap_done
