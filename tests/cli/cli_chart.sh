#!/bin/sh
# chart: every chart in every format, and its contents.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

check "the kinds are listed" shows "section" chart --list
check "with a kind too" shows "plan" chart plan --list
check "and then the options" grep -q -- "--viewing-distance" "$scratch/out"
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

# starts_with BYTES FILE: the file begins with these bytes.
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

# The title of a plan names the methods shown, and only they are drawn.
sums= again=
for methods in exact exact+bre exact+split-flux brs-table brs-table+bre protractor+bre; do
    check "a plan by $methods" quietly chart plan -m $methods -o "$scratch/m.svg" "$deep"
    sums="$sums $(cksum <"$scratch/m.svg" | tr ' ' -)"
done
check "differs from those by others" \
    test "$(printf '%s\n' $sums | sort -u | wc -l)" -eq 6
check "a plan has one figure" \
    refuses 2 "expected one method or pair" chart plan -m all -o x.svg "$deep"
check "no average of the room" refuses 2 "pair" chart plan -m average-df -o x.svg "$deep"
check "no internally reflected component" \
    refuses 2 "pair" chart plan -m bre -o x.svg "$deep"
check "no counts" refuses 2 "steps" chart plan -m pepper-pot+bre -o x.svg "$deep"
check "not a method's and traced" \
    refuses 2 "not both" chart plan -s -m exact+bre -o x.svg "$deep"
check "none that does not cover the room" \
    refuses 1 "--simulate" chart plan -m exact+bre -o x.svg "$examples/studio.xml"
check "a fill is one of three" refuses 2 "grey" chart plan --fill red -o x.svg "$deep"
for fill in none colour grey; do
    check "fill $fill" quietly chart plan --fill $fill -o "$scratch/$fill.svg" "$deep"
done
differ() {
    ! cmp -s "$1" "$2"
}
check "colours are drawn" differ "$scratch/none.svg" "$scratch/colour.svg"
# A cupboard and a column intersect the working plane, a desk is below it.
sed 's|</room>|<furniture x="0.2" y="4" width="0.8" depth="0.5" height="2"/>\
<furniture x="1.4" y="4" width="0.8" depth="0.5" height="0.7"/>\
<column x="2" y="3" diameter="0.3"/></room>|' "$deep" >"$scratch/furnished.xml"
# They are filled by the even-odd rule; labels have white boxes, too, whose number depends on
# the font.
blanks() {
    "$pepperpot" chart plan --fill colour -o "$scratch/blanks.svg" "$1"
    grep -c 'fill-rule:evenodd;fill:rgb(100%,100%,100%)' "$scratch/blanks.svg"
}
check "what stands through the plane has no colour" \
    test "$(blanks "$scratch/furnished.xml")" -eq "$(($(blanks "$deep") + 2))"
check "and greys" differ "$scratch/colour.svg" "$scratch/grey.svg"
for seed in 1 1 2; do
    check "a traced plan" quietly chart plan --simulate --error 20% --seed $seed \
        -o "$scratch/traced$seed$again.svg" "$examples/office.xml"
    again=again
done
check "is the same with the same seed" \
    same "$scratch/traced1.svg" "$scratch/traced1again.svg"
check "and another with another" \
    differ "$scratch/traced1.svg" "$scratch/traced2again.svg"
check "a section of nothing is refused" \
    refuses 1 "no daylight factor" chart section -m exact+bre -o x.svg "$examples/studio.xml"
check "and one of a part" refuses 1 "pair" chart section -m bre -o x.svg "$deep"
check "a scale is one" refuses 2 "cannot be combined" chart section --log --linear -o x.svg "$deep"
check "the section has its own pair too" quietly chart section -o "$scratch/s.svg" \
    "$examples/studio.xml"

for kind in waldram pepper-pot; do
    for format in pdf svg png; do
        file="$scratch/a $kind.$format"
        check "a blank $kind becomes $format" quietly chart $kind -o "$file"
        run chart $kind --format $format
        check "blank $kind as $format is the same again" same "$file" "$scratch/out"
        check "$kind from a point becomes $format" \
            quietly chart $kind --points 1,1.5 -o "$file" "$deep"
    done
    for paper in $(some a5 a4 a2 a3); do
        check "$kind on $paper" quietly chart $kind --paper $paper \
            --orientation portrait -p 2,2 -o "$file" "$examples/l-shaped.xml"
    done
    check "$kind without glass" quietly chart $kind --glazed no --sky uniform -o "$file"
    check "$kind of a sky that changes with azimuth" \
        refuses 1 "" chart $kind --sky iso-12,30,180 -o "$file"
    check "$kind from 17 points" refuses 2 "--points" chart $kind -o "$file" "$deep"
    case $kind in
    waldram)
        check "$kind of glass that slopes" refuses 1 "rooflight RL1" \
            chart $kind -p 3,3 -o "$file" "$examples/studio.xml"
        ;;
    pepper-pot)
        check "$kind of glass that slopes" \
            quietly chart $kind -p 3,3 -o "$file" "$examples/studio.xml"
        check "$kind of a clear sky, unsolved" quietly chart $kind --unsolved \
            --sky iso-12,30,180 -p 3,3 -o "$scratch/x.pdf" "$examples/studio.xml"
        ;;
    esac
    check "$kind of a point outside" \
        refuses 1 "free space" chart $kind -p 3,-3 -o "$file" "$deep"
    check "a blank $kind has no points" \
        refuses 2 "--points" chart $kind -p 1,1 -o "$file"
    check "$kind is not simulated" \
        refuses 2 "--simulate" chart $kind --simulate -p 1,1 -o "$file" "$deep"
    check "a room has its own glass" \
        refuses 2 "--glazed" chart $kind --glazed no -p 1,1 -o "$file" "$deep"
    check "glass is there or not" refuses 2 "yes or no" chart $kind --glazed maybe -o "$file"
done
check "a fine pepper-pot from afar" quietly chart pepper-pot --fine --receiver vertical \
    --viewing-distance 60 -o "$scratch/fine.pdf"
check "a viewing distance of none" \
    refuses 2 "from 5 to 200" chart pepper-pot --viewing-distance 1 -o "$scratch/x.pdf"
check "a receiver that is neither" \
    refuses 2 "horizontal" chart pepper-pot --receiver up -o "$scratch/x.pdf"
check "Waldram's squares are not fine" \
    refuses 2 "--fine" chart waldram --fine -o "$scratch/x.pdf"
printf '<room version="1"><plan width="4" depth="5" height="2.7"/>%s</room>' \
    '<rooflight x="1" y="1" width="1" depth="1"/>' >"$scratch/lit_from_above.xml"
for kind in vertical-sky skylight-indicator; do
    for format in pdf svg png; do
        file="$scratch/a $kind.$format"
        check "a blank $kind becomes $format" quietly chart $kind -o "$file"
        run chart $kind --format $format
        check "blank $kind as $format is the same again" same "$file" "$scratch/out"
        check "$kind of a window becomes $format" \
            quietly chart $kind --window south -o "$file" "$deep"
    done
    for paper in $(some a5 a4 a2 a3); do
        check "$kind on $paper" quietly chart $kind --paper $paper --dpi 60 \
            --orientation portrait -o "$scratch/x.png" "$examples/l-shaped.xml"
    done
    check "$kind under a uniform sky" quietly chart $kind --sky uniform -o "$file"
    check "$kind of a sky that changes with azimuth" \
        refuses 1 "azimuth" chart $kind --sky iso-12,30,180 -o "$file"
    check "a window has the overcast sky" \
        refuses 2 "--sky" chart $kind --sky uniform -o "$file" "$deep"
    sed 's/<window /<window name="W1" /' "$deep" >"$scratch/named.xml"
    run chart $kind --window south -o "$scratch/by_wall.svg" "$scratch/named.xml"
    run chart $kind --window W1 --format svg "$scratch/named.xml"
    check "$kind of a window by its name or by its wall" same "$scratch/by_wall.svg" "$scratch/out"
    check "a window that is not there" \
        refuses 1 "line number of a window" chart $kind --window 3 -o "$file" "$deep"
    check "a blank $kind has no window" refuses 2 "--window" chart $kind --window 9 -o "$file"
    check "a rooflight faces no wall's sky" \
        refuses 1 "needs a vertical window" chart $kind -o "$file" "$scratch/lit_from_above.xml"
done
for kind in waldram pepper-pot protractor; do
    for format in pdf svg png; do
        check "an exercise for $kind becomes $format" quietly chart $kind --unsolved \
            -p 1,1.5 -o "$scratch/exercise.$format" "$deep"
    done
    for paper in $(some a5 a4 a2 a3); do
        check "an exercise for $kind on $paper" quietly chart $kind --unsolved --dpi 50 \
            --paper $paper -p 1,3.5 -o "$scratch/x.png" "$deep"
    done
    check "without a room there is no exercise" \
        refuses 2 "--unsolved" chart $kind --unsolved -o "$scratch/x.pdf"
    run chart $kind -p 1,1.5 --unsolved -o "$scratch/exercise.pdf" "$deep"
    pages=$(grep -ac '/Type /Page[^s]' "$scratch/exercise.pdf")
    if [ "$pages" -gt 0 ]; then
        check "the blank $kind diagram follows the exercise" test "$pages" -eq 2
    else
        skip "the blank $kind diagram follows" "this cairo compresses the PDF's page list"
    fi
done
check "elevations that do not fit are not made smaller" refuses 1 "larger --paper" \
    chart pepper-pot --unsolved --paper a5 -p 2,0.8 -o "$scratch/x.pdf" "$examples/office.xml"
check "Waldram's diagram is of a point" \
    refuses 2 "--window" chart waldram --window south -p 1,1.5 -o "$scratch/x.pdf" "$deep"
run chart vertical-sky -o "$scratch/facing.pdf" "$examples/deep-office-obstructed.xml"
"$pepperpot" assess -c vsc "$examples/deep-office-obstructed.xml" >"$scratch/vsc"
said=$(sed -n 's/.*W1, south *\([0-9]*\.[0-9]\)[0-9]* %.*/\1/p' "$scratch/vsc")
check "the criterion has a figure" test -n "$said"
check_words "its squares are the criterion's component" "$scratch/facing.pdf" \
    "Vertical sky component $said"
for format in pdf svg png; do
    file="$scratch/a protractor.$format"
    check "a blank protractor becomes $format" quietly chart protractor -o "$file"
    run chart protractor --format $format
    check "a blank protractor as $format is the same again" same "$file" "$scratch/out"
    check "a worked protractor becomes $format" \
        quietly chart protractor -p 1,1.5 -o "$file" "$deep"
done
for number in $(some 1 2 3 4 5 6 7 8 9 10); do
    check "protractor $number" quietly chart protractor --number $number -o "$file"
done
for paper in $(some a5 a4 a2 a3); do
    check "a worked protractor on $paper" quietly chart protractor --paper $paper -p 2,2 \
        --orientation landscape -o "$file" "$examples/l-shaped.xml"
done
check "a protractor that was never sold" quietly chart protractor --glazing clear-double \
    --slope 45 --sky iso-3 -o "$file"
check "there is no protractor 11" \
    refuses 2 "from 1 to 10" chart protractor --number 11 -o "$file"
check "a numbered protractor has its slope" \
    refuses 2 "selects a protractor" chart protractor --number 3 --slope 20 -o "$file"
check "a glazing that is not in the table" \
    refuses 2 "table" chart protractor --glazing milk -o "$file"
check "a protractor of a sky that changes with azimuth" \
    refuses 2 "azimuth" chart protractor --sky iso-12,30,180 -o "$file"
check "a room has its own protractor" \
    refuses 2 "blank" chart protractor --number 2 -p 1,1 -o "$file" "$deep"
check "no protractor for glass at such a slope" \
    refuses 1 "rooflight RL1" chart protractor -p 3,3 -o "$file" "$examples/studio.xml"
check "Waldram's diagram has no number" \
    refuses 2 "--number" chart waldram --number 2 -o "$file"
for which in average minimum rooflight; do
    for format in pdf svg png; do
        file="$scratch/a nomogram.$format"
        check "a blank nomogram of the $which becomes $format" \
            quietly chart nomogram --which $which -o "$file"
        run chart nomogram --which $which --format $format
        check "and is the same again" same "$file" "$scratch/out"
    done
done
for paper in $(some a5 a4 a2 a3); do
    check "a worked nomogram on $paper" quietly chart nomogram --paper $paper \
        --which minimum --orientation landscape -o "$file" "$examples/l-shaped.xml"
done
check "a nomogram of a top-lit room" \
    quietly chart nomogram --which rooflight -o "$file" "$examples/studio.xml"
check "windows are not rooflights" \
    refuses 1 "the room has no rooflight" chart nomogram --which rooflight -o "$file" "$deep"
check "a nomogram under another sky" \
    refuses 2 "overcast" chart nomogram --sky uniform -o "$file" "$deep"
check "a blank nomogram under another sky" \
    refuses 2 "overcast" chart nomogram --sky uniform -o "$file"
check "a nomogram is for the whole room" \
    refuses 2 "--points" chart nomogram -p 1,1 -o "$file" "$deep"
check "there are three nomograms" \
    refuses 2 "average, minimum or rooflight" chart nomogram --which most -o "$file"
cat >"$scratch/gallery.xml" <<'END'
<room version="1"><plan width="9" depth="36" height="6"/>
<finishes floor="0.2" walls="0.3" ceiling="0.5"/>
<window wall="south" left="3" sill="1" width="3" height="3"/></room>
END
for format in pdf svg png; do
    file="$scratch/position.$format"
    check "a blank nomogram by position becomes $format" quietly chart position-nomogram -o "$file"
    check "with a room's point, too" \
        quietly chart position-nomogram -p 1.5,6 -o "$file" "$deep"
done
run chart position-nomogram -p 1.5,6 -o "$scratch/position.pdf" "$deep"
check_words "with what is read" "$scratch/position.pdf" "at the point 0.49 %"
check "it is for one point" refuses 2 "shows one point" chart position-nomogram -o "$file" "$deep"
check "and solved" refuses 2 "--unsolved" \
    chart position-nomogram -p 1.5,6 --unsolved -o "$file" "$deep"
check "under the overcast sky" refuses 2 "overcast" \
    chart position-nomogram --sky uniform -o "$file"
check "a point whose factor leaves the scale is refused with its window" \
    refuses 1 "window W1 gives a factor outside scale F" \
    chart position-nomogram -p 1.5,35 -o "$file" "$scratch/gallery.xml"
check "a plan has none of them" refuses 2 "--which" chart waldram --which average -o "$file"
run chart nomogram -o "$scratch/nomogram.pdf" "$deep"
check_words "rule and reading stand on the sheet, as text" "$scratch/nomogram.pdf" "k = 1.5"
run chart waldram --points 1,1.5 -o "$scratch/waldram.pdf" "$deep"
check_words "the sum is written below, as text" "$scratch/waldram.pdf" \
    "Sky component .*together"
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

# If df warns that hand figures are unreliable, drawings of them contain the same warning.
well="$examples/situations/light-well.xml"
for kind in section plan; do
    run chart $kind -o "$scratch/doubt.pdf" "$well"
    check_words "a $kind says where hand figures fail" "$scratch/doubt.pdf" \
        "Do not rely on"
done
run chart plan --simulate --samples 8 -o "$scratch/doubt.pdf" "$well"
lacks() {
    ! has_words "$2" "$1"
}
if command -v pdftotext >/dev/null; then
    check "a traced plan has none of them" lacks "relied on" "$scratch/doubt.pdf"
fi

# wing: a room with a wing south of y = 4, with a low bed and a high cupboard.
wing() {
    cat <<EOF
<room version="1"><plan height="2.7">
  <vertex x="0" y="0"/><vertex x="7" y="0"/><vertex x="7" y="4"/>
  <vertex x="3" y="4"/><vertex x="3" y="8"/><vertex x="0" y="8"/></plan>
  <window wall="3" left="1" sill="0.8" width="1.6" height="1.4"/>
  <window wall="4" left="1" sill="0.8" width="1.6" height="1.4"/>
  <furniture x="0.5" y="1" width="1" depth="2" height="$1"/>
  <line from="0.5 6" to="2.5 6" points="3"/></room>
EOF
}
wing 0.5 >"$scratch/bed.xml"
wing 1.9 >"$scratch/cupboard.xml"
run chart plan -o "$scratch/cupboard.pdf" "$scratch/cupboard.xml"
check_words "the key of a plan has what stands in the room" "$scratch/cupboard.pdf" \
    "furniture and partitions"
run chart section -o "$scratch/wing.pdf" "$scratch/bed.xml"
run chart plan -o "$scratch/bed.pdf" "$scratch/bed.xml"
run chart brs-table -p 5,2 -o "$scratch/behind.pdf" "$scratch/bed.xml"
if command -v pdftotext >/dev/null; then
    check "but not what is below the plane" lacks "furniture and" "$scratch/bed.pdf"
    check "a window of another wing is not in the section" \
        lacks "not cut by the section" "$scratch/wing.pdf"
    check "a window behind the point is not minus so far away" lacks "^W2, .*away" "$scratch/behind.pdf"
    check "but said to be behind it" has_words "$scratch/behind.pdf" "W2: the point is"
fi
# The middle of the window is 1.55 m high, the slab at 2.8 m and 1.5 m deep: atan(1.25 / 1.5) is
# 39.8 degrees. Its parapet, above the slab, hides nothing more.
cat >"$scratch/balcony.xml" <<'EOF'
<room version="1"><plan width="4" depth="5" height="2.6"/>
<window wall="south" left="1" sill="0.8" width="2" height="1.5">
<balcony depth="1.5" level="2.8" left="0.5" right="0.5"/></window></room>
EOF
run chart section -o "$scratch/balcony.pdf" "$scratch/balcony.xml"
check_words "under a balcony the sky ends at its slab" "$scratch/balcony.pdf" \
    "overhang: sky up to 40°" "2.6 m" "W1" "Section A–A"
if command -v pdftotext >/dev/null; then
    check "and no line of sight passes through it" lacks "line of sight" "$scratch/balcony.pdf"
fi
# Every point has its value: on the plan if the values fit, otherwise in a table by x and y.
cat >"$scratch/grid.xml" <<'EOF'
<room version="1" name="Grid"><plan width="7" depth="6" height="3"/>
<window wall="south" left="1" sill="0.9" width="4" height="1.6"/>
<grid spacing="SPACING" margin="0.5"/></room>
EOF
# values FILE.pdf: the number of words that are numbers.
values() {
    pdftotext -layout "$1" - | tr -s ' ÷+' '\n' | grep -cE '^[0-9]+(\.[0-9]+)?$'
}
for spacing in 1 0.4; do
    sed "s/SPACING/$spacing/" "$scratch/grid.xml" >"$scratch/grid-$spacing.xml"
    run chart plan --paper a5 -o "$scratch/grid-$spacing.pdf" "$scratch/grid-$spacing.xml"
done
if command -v pdftotext >/dev/null; then
    check "30 values are at their points" has_words "$scratch/grid-1.pdf" "points, with values"
    check "and all are there" test "$(values "$scratch/grid-1.pdf")" -ge 30
    check "180 values are in a table" has_words "$scratch/grid-0.4.pdf" "values in the table"
    check "and all are there" test "$(values "$scratch/grid-0.4.pdf")" -ge 180
fi
# Opal glass shows no sky, but the plan must not be grey.
sed 's/spacing="SPACING"/spacing="1"/; s/height="1.6"/height="1.6" glazing="opal-acrylic"/' \
    "$scratch/grid.xml" >"$scratch/opal.xml"
run chart plan -m exact+split-flux -o "$scratch/opal.pdf" "$scratch/opal.xml"
check_words "a view of the sky through opal glass is not judged" "$scratch/opal.pdf" \
    "All glass is diffusing"
if command -v pdftotext >/dev/null; then
    check "nor drawn" lacks "no view of the sky" "$scratch/opal.pdf"
fi
# An exercise can be solved with its sheet alone: origin and axes, lengths, blocks, a line for the
# name. The ridge is 6 + 4 tan 45 = 10 m above the floor, the wall 10 m away.
cat >"$scratch/lecture.xml" <<'EOF'
<room version="1" name="Lecture"><plan width="6.3" depth="5.1" height="3.2"/>
<window name="Left" wall="south" left="0.7" sill="0.9" width="1.8" height="1.6"/>
<window name="Right" wall="south" left="3.4" sill="0.9" width="1.8" height="1.6"/>
<block name="House" x="-3" y="-18" width="12" depth="8" height="6" roof="gable" pitch="45"/></room>
EOF
run chart waldram --unsolved --points 3,2.5 -o "$scratch/exercise.pdf" "$scratch/lecture.xml"
check_words "an exercise has its data on the sheet" "$scratch/exercise.pdf" \
    "Name, date" "x -3 to 9, y -18 to -10" "eaves 6, ridge 10 m above the floor" \
    "P (3, 2.5)" "6.3 m" "5.1 m" "3.2 m" "^0.7$" "^1.8$" "^0.9$" "Left" "Right" "House"
if command -v pdftotext >/dev/null; then
    check "but no angle" lacks "line of sight" "$scratch/exercise.pdf"
fi
# A title block with the project of the file, in which options replace single entries.
sed 's|<plan|<project client="Smith and Co" revision="A" number="1234"/>&|' \
    "$scratch/lecture.xml" >"$scratch/titled.xml"
for kind in section plan site elevation; do
    run chart $kind --revision "B, final" --author "A. Nother" -o "$scratch/titled.pdf" \
        "$scratch/titled.xml"
    check_words "chart $kind has a title block" "$scratch/titled.pdf" \
        "client" "Smith and Co" "B, final" "1234" "A. Nother"
done
if command -v pdftotext >/dev/null; then
    check "without the fact replaced" lacks "^A$" "$scratch/titled.pdf"
    check "and no block without facts" lacks "client" "$scratch/exercise.pdf"
fi
# Positions of a section: at x, at y, through an opening; the plan shows the section line.
cat >"$scratch/wells.xml" <<'EOF'
<room version="1" name="Wells"><plan width="9.5" depth="6.1" height="3.3"/>
<window name="Low" wall="west" left="1" sill="0.9" width="1.2" height="1"/>
<rooflight name="Well" x="5" y="1.4" width="2" depth="1.5" reveal="0.7"/></room>
EOF
run chart section -o "$scratch/wells.pdf" "$scratch/wells.xml"
check_words "a section passes through the largest opening" "$scratch/wells.pdf" \
    "Well" "9.5 m" "3.3 m"
run chart section --cut x=5.5 -o "$scratch/cut.pdf" "$scratch/wells.xml"
check_words "or is cut at a place" "$scratch/cut.pdf" "Well" "6.1 m"
run chart section --cut Low -o "$scratch/low.pdf" "$scratch/wells.xml"
check_words "or through the opening of a name" "$scratch/low.pdf" "Low" "9.5 m" "sill 0.9 m"
run chart plan --cut y=2 -o "$scratch/marked.pdf" "$scratch/wells.xml"
if command -v pdftotext >/dev/null; then
    pdftotext "$scratch/marked.pdf" - >"$scratch/marked"
    check "a plan has two marks of the section" test "$(grep -cx 'A' "$scratch/marked")" -eq 2
    for word in Low Well west south "9.5 m" "6.1 m"; do
        check "and the name or length $word" grep -q "$word" "$scratch/marked"
    done
fi
check "a place outside the room" refuses 1 "--cut x=9.7 is outside the room; expected 0 to 9.5" \
    chart section --cut x=9.7 -o x.pdf "$scratch/wells.xml"
check "outside for a plan too" refuses 1 "--cut y=-1 is outside the room" \
    chart plan --cut y=-1 -o x.pdf "$scratch/wells.xml"
check "an opening that is not there" refuses 1 "no window is called \"Lo\"" \
    chart section --cut Lo -o x.pdf "$scratch/wells.xml"
check "a place that is no number" refuses 2 "such as x=2.1" \
    chart section --cut x=two -o x.pdf "$scratch/wells.xml"
check "a cut and points" refuses 2 "cannot be combined" \
    chart section --cut x=2 --points 1,1 -o x.pdf "$scratch/wells.xml"
check "a cut of a chart without one" refuses 2 "for a section or a plan" \
    chart site --cut x=2 -o x.pdf "$scratch/wells.xml"
if [ -c /dev/full ]; then
    check "a full disk is noticed" \
        refuses 3 "/dev/full" chart plan --format pdf -o /dev/full "$deep"
fi
tap_done
