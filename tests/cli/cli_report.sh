#!/bin/sh
# report: a self-contained HTML page, or the sheets of a PDF, with all rooms of a site.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
LC_ALL=C
export LC_ALL
site=$(cd "$srcdir/examples/sites" && pwd)/corner-house.xml
page=$scratch/report.html

check "a site" quietly report --by-hand --full --for uk-planning "$site" -o "$page"
check "is one page" sh -c "head -n 1 '$page' | grep -q '^<!DOCTYPE html>' &&
    tail -n 1 '$page' | grep -q '^</html>'"
# Except for names of namespaces and its own ids, the page contains no references.
check "that needs no network" nothing \
    "$(grep -oE '(src|href)="[^"#][^"]*"|url\([^#][^)]*\)|<script|@import' "$page" |
        grep -v 'href="data:,"')"
for room in "Living room" Study Workroom Bedroom Bathroom; do
    check "with the $room" grep -q "<h2[^>]*>$room</h2>" "$page"
done
# Two drawings of the site; for each room plan, section and the plan before and now; and sun paths
# for the only room whose windows are assessed for sunlight.
check "with all its drawings" test "$(grep -c '<figure><svg' "$page")" -eq 18
check "the sun's paths where its hours are judged" \
    test "$(grep -c '<figcaption>Sun paths' "$page")" -eq 1
check "what is lit, now and before, of each room" \
    test "$(grep -c '<figcaption>View of the sky, existing and proposed' "$page")" -eq 5
check "whose ids are all different" nothing \
    "$(grep -oE ' id="[^"]*"' "$page" | sort | uniq -d | head -n 3)"
check "the sky before and after" grep -q "W3, south</td><td>27.08</td><td>17.21</td>" "$page"
check "neighbours have no targets of new dwellings" nothing "$(grep "kitchen: 200 lx" "$page")"
check "how it was made" \
    grep -q "pepperpot report --for uk-planning --full --by-hand .*${site##*/}" "$page"
check "a page of dwellings" gives report --by-hand --for uk-dwellings -f html "$site"
check "what the country asks" grep -q "kitchen: 200 lx over 50 %" "$scratch/out"
check "in one table of all rooms" test \
    "$(grep -c "<h3>EN 17037, UK annex for dwellings" "$scratch/out")" -eq 1
check "with a row for each figure of assess" test \
    "$(grep -c "lx over 50 %</td><td>" "$scratch/out")" -eq \
    "$("$pepperpot" assess --by-hand --for uk-dwellings "$site" | grep -c "[0-9] lx over ")"
check "what the methods' figures contain" grep -q "bre</td>.*\[BRE310\]</td>.*>clear single glass and the frame<" "$scratch/out"
check "and the works that it names" grep -q "\[BR209\]</td><td class=\"w\">Littlefair" "$page"
check "its contents lead to the chapters" test \
    "$(grep -oc '<li><a href="#chapter-' "$page")" -eq "$(grep -c '<h2 id="chapter-' "$page")"
check "and its limits are in words" grep -q "Each window counts once" "$page"
check "windows and rooms are counted once" \
    grep -q 'class="verdict">1 of 5 windows and 4 of 4 rooms meet BR 209' "$page"
"$pepperpot" assess --by-hand --for uk-planning --table "$site" >"$scratch/table"
check "as assess --table counts them" \
    grep -q "$(grep -o '[0-9]* of [0-9]* windows and [0-9]* of [0-9]* rooms' "$page")" "$scratch/table"

# ---- the title block; short and full ----

sed 's|<building[^>]*>|&<project name="Tower" client="A \&amp; B" revision="A" date="1 May"/>|' \
    "$site" >"$scratch/project.xml"
check "a short report" quietly report --by-hand --for uk-planning --revision C \
    "$scratch/project.xml" -o "$page"
check "has the file's facts" grep -q 'client</td><td class="w">A &amp; B<' "$page"
check "and an option in place of one" grep -q 'revision</td><td class="w">C<' "$page"
check "no drawings of rooms" test "$(grep -c '<figure><svg' "$page")" -eq 2
check "and their data in one table" grep -q '>0.01</td><td class="w">living-kitchen</td>' "$page"
sed 's|<building[^>]*>|&<project/><project/>|' "$site" >"$scratch/two.xml"
check "a second project is refused" refuses 1 "project" df "$scratch/two.xml"
sed 's|<room name="Study"[^>]*>|&<project name="Tower"/>|' "$site" >"$scratch/inner.xml"
check "so is one of a room in a building" refuses 1 "project" df "$scratch/inner.xml"
sed 's|<building[^>]*>|&<project cleint="A"/>|' "$site" >"$scratch/client.xml"
check "and an unknown fact" refuses 1 'did you mean "client"?' df "$scratch/client.xml"

check "simulated, with standard errors" \
    gives report --error 5% --room Bedroom -j 1 "$site"
check "by one thread or two the same" sh -c "
    '$pepperpot' report --error 5% --room Bedroom -j 2 '$site' | cmp - '$scratch/out'"
check "traced stands beside methods by hand" grep -q "traced</td><td>[0-9.]*</td><td>0.[0-9]*<" \
    "$scratch/out"
check "what would help" grep -q "Effect of changes" "$scratch/out"
check "by simulation" grep -q "average, %, simulated" "$scratch/out"
check "the plan and section show simulated values" sh -c "
    grep -q 'contours of the simulated daylight factor' '$scratch/out' &&
    grep -q 'simulated daylight factors along the room; hand figures dashed' '$scratch/out'"

sed 's/Corner house/House \&lt;b\&gt; \&amp; co/' "$site" >"$scratch/name.xml"
check "names are text" shows '<h1>House &lt;b&gt; &amp; ' report --by-hand -c vsc --room Bathroom \
    "$scratch/name.xml"
mkdir "$scratch/it's a site"
cp "$scratch/name.xml" "$scratch/it's a site/house.xml"
words="pepperpot report --criteria vsc --median-diffuse 14100 --least-altitude 11 --shortest 5 \
--spacing 0.4,0.5 --room Study --state proposed --samples 64 --seed 7"
check "the words that make it again" shows "$words '$scratch/it'\\''s a site/house.xml'" report -c vsc \
    --median-diffuse 14100 --least-altitude 11 --shortest 5 --spacing 0.4 --room Study \
    --state proposed --samples 64 --seed 7 -j 1 \
    "$scratch/it's a site/house.xml"
check "a room by itself" shows "<h1>Deep office</h1>" report --by-hand "$deep"
cat >"$scratch/cellar.xml" <<'EOF'
<room version="1" name="Cellar"><plan width="3" depth="4" height="2.2"/></room>
EOF
run report --by-hand "$scratch/cellar.xml"
check "a file without windows" grep -q "<h1>Cellar</h1>" "$scratch/out"
check "with its plan and section, and none of a site" \
    test "$(grep -o '<figcaption>[A-Za-z]*' "$scratch/out" | tr '\n' ' ')" = \
    "<figcaption>Plan <figcaption>Section "
check "a picture is no report" refuses 2 "expected a name that ends in .html or .pdf" \
    report "$deep" -o "$scratch/r.svg"
check "nor is what some other program writes" refuses 2 'instead of ".docx"' \
    report "$deep" -o "$scratch/r.docx"
check "a name without an extension is a page" sh -c "
    '$pepperpot' report --by-hand -c vsc '$deep' -o '$scratch/r' && grep -q '^<h1>' '$scratch/r'"

check "but --format says what it is" sh -c "
    '$pepperpot' report --by-hand -c vsc '$deep' --format pdf -o '$scratch/r.report' &&
        head -c 5 '$scratch/r.report' | grep -q '^%PDF-'"
check "--format decides, whatever the extension of the file" sh -c "
    '$pepperpot' report --by-hand -c vsc '$deep' --format html -o '$scratch/html.pdf' &&
        grep -q '^<h1>' '$scratch/html.pdf' && grep -q 'format html' '$scratch/html.pdf'"
check "a PDF on standard output" sh -c "
    '$pepperpot' report --by-hand -c vsc '$deep' --format pdf | head -c 5 | grep -q '^%PDF-'"
check "the refusal names the option" refuses 2 "or --format html or pdf" \
    report "$deep" -o "$scratch/r.docx"
check "it is one of two" refuses 2 "expected html or pdf" report "$deep" --format svg

# ---- as PDF ----

cat >"$scratch/pair.xml" <<'EOF'
<building version="1" name="Mews &amp; yard">
  <site latitude="51.5" longitude="-0.1" country="GB"/>
  <block name="Wall" state="proposed" x="-3" y="-9" width="14" depth="2" height="7"/>
  <room name="Parlour" use="living-room" x="0" y="0">
    <plan width="3.3" depth="3.7" height="2.5"/>
    <window wall="south" left="0.4" sill="0.8" width="1.9" height="1.3"/>
  </room>
  <room name="Scullery" use="kitchen" x="3.6" y="0">
    <plan width="2.3" depth="2.9" height="2.5"/>
    <window wall="south" left="0.4" sill="0.9" width="1.1" height="1.2"/>
  </room>
</building>
EOF
pdf=$scratch/pair.pdf
all=vsc,former-sky,obstruction,apsh,nsl,uk-annex
check "a site as PDF" quietly report --by-hand -c "$all" "$scratch/pair.xml" -o "$pdf"
check_words "of which every sheet is numbered, with the name of the site" "$pdf" "page 1 of 10" \
    "page 10 of 10" "Mews & yard"
check "the contents have the sheet of each chapter" \
    says "$pdf" "Scullery 6 Limits and assumptions 9 How"
check_words "every room has its chapter" "$pdf" "^Parlour$" "^Scullery$"
check_words "verdicts and what they are held against" "$pdf" "0 of 2 windows and 0 of 2 rooms meet BR 209. All verdicts: 2 met, 6 not met." \
    "^Criteria$" "not met" "Sunlight hours \[BR209\]" "≥ 27 %"
check_words "inputs and what is assumed" "$pdf" "floor 0.2, walls 0.5, ceiling 0.7" \
    "frame factor 1, maintenance 1"
check_words "figures by hand, with their bands" "$pdf" "^95 % band$" "exact+bre"
check_words "drawings of the site and its rooms" "$pdf" "^Site plan, with" "^South elevation" \
    "^Daylight factor by exact+bre, on the working plane" "^Daylight factor against distance" \
    "existing and proposed$"
check_words "how it was made" "$pdf" "report --criteria $all --by-hand .*pair.xml" \
    "clear single glass and the frame" "^\[BR209\]$"
if command -v pdfimages >/dev/null; then
    check "the drawings are lines" nothing "$(pdfimages -list "$pdf" | sed 1,2d)"
else
    skip "the drawings are lines" "no pdfimages"
fi
# beyond_margins FILE.pdf: words closer than 14 mm to the edge of a sheet, or 8 mm at its bottom
# (in points).
beyond_margins() {
    pdftotext -bbox "$1" - | sed -n 's/.*<word xMin="\(.*\)" yMin="\(.*\)" xMax="\(.*\)" yMax="\(.*\)">\(.*\)<.*/\1 \2 \3 \4 \5/p' |
        awk '{ words++ } $1 < 39.7 || $2 < 39.7 || $3 > 555.6 || $4 > 819.2
            END { if (words < 500) print words + 0, "words in all" }'
}
if command -v pdftotext >/dev/null; then
    check "nothing that is written lies in the margins" nothing "$(beyond_margins "$pdf")"
else
    skip "nothing that is written lies in the margins" "no pdftotext"
fi
check "the same again" sh -c "
    '$pepperpot' report --by-hand -c '$all' '$scratch/pair.xml' -o '$scratch/again.pdf' &&
        cmp '$pdf' '$scratch/again.pdf'"
check "simulated as PDF" quietly report --error 5% -c average "$scratch/pair.xml" --room Scullery \
    --quiet -o "$scratch/traced.pdf"
check_words "with standard errors and the seed" "$scratch/traced.pdf" "^± standard error$" \
    "^traced$" "seed 1"

# The plan and the table of averages show the same average; the section is at the requested
# position.
if command -v pdftotext >/dev/null; then
    average=$(pdftotext -layout "$scratch/traced.pdf" - | sed -n 's/^traced  *\([0-9.]*\).*/\1/p')
    check "an average in the table" test -n "$average"
    check "is that of the plan" says "$scratch/traced.pdf" "whole plane $average"
fi
check "a section at a place" quietly report --by-hand --cut y=1.5 --room Scullery \
    "$scratch/pair.xml" -o "$scratch/cut.pdf"
check "is in the command that makes the report again" says "$scratch/cut.pdf" "cut y=1.5"
check "a place outside the room" refuses 1 "is outside the room" report --by-hand \
    --cut x=55 --room Scullery "$scratch/pair.xml" -o "$scratch/none.pdf"
check "leaves no report" test ! -e "$scratch/none.pdf"

check "a file is needed" refuses 2 "expected a room file" report
check "a wrong room leaves no page" sh -c "
    echo '<room version=\"1\"/>' >'$scratch/wrong.xml'
    ! '$pepperpot' report '$scratch/wrong.xml' -o '$scratch/wrong.html' 2>/dev/null &&
        [ ! -e '$scratch/wrong.html' ]"
tap_done
