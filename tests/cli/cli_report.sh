#!/bin/sh
# report: a page that needs nothing else, with all rooms of a site.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
LC_ALL=C
export LC_ALL
site=$(cd "$srcdir/examples/sites" && pwd)/corner-house.xml
page=$scratch/report.html

check "a site" quietly report --by-hand --for uk-planning "$site" -o "$page"
check "is one page" sh -c "head -n 1 '$page' | grep -q '^<!DOCTYPE html>' &&
    tail -n 1 '$page' | grep -q '^</html>'"
# Names of namespaces and the program's own ids aside, nothing is referred to.
check "that needs no network" nothing \
    "$(grep -oE '(src|href)="[^"#][^"]*"|url\([^#][^)]*\)|<script|@import' "$page" |
        grep -v 'href="data:,"')"
for room in "Living room" Study Workroom Bedroom Bathroom; do
    check "with the $room" grep -q "<h2>$room</h2>" "$page"
done
check "two drawings a room" test "$(grep -c '<figure><svg' "$page")" -eq 10
check "whose ids are all different" nothing \
    "$(grep -oE ' id="[^"]*"' "$page" | sort | uniq -d | head -n 3)"
check "the sky before and after" grep -q "W3, south, line 29</td><td>27.08</td><td>17.21</td>" "$page"
check "what the country asks" grep -q "kitchen: 200 lx over 50 %" "$page"
check "how it was made" grep -qF "pepperpot report --for uk-planning --by-hand $site" "$page"
check "the same again" sh -c "
    '$pepperpot' report --by-hand --for uk-planning '$site' | cmp - '$page'"
check "simulated, with standard errors" \
    gives report --error 5% --room Bedroom -j 1 "$site"
check "by one thread or two the same" sh -c "
    '$pepperpot' report --error 5% --room Bedroom -j 2 '$site' | cmp - '$scratch/out'"
check "traced stands beside methods by hand" grep -q "traced</td><td>[0-9.]*</td><td>0.[0-9]*<" \
    "$scratch/out"
check "what would help" grep -q "What would help" "$scratch/out"

sed 's/Corner house/House \&lt;b\&gt; \&amp; co/' "$site" >"$scratch/name.xml"
check "names are text" shows '<h1>House &lt;b&gt; &amp; ' report --by-hand -c vsc "$scratch/name.xml"
check "a room by itself" shows "<h1>Deep office</h1>" report --by-hand "$deep"
cat >"$scratch/cellar.xml" <<'EOF'
<room version="1" name="Cellar"><plan width="3" depth="4" height="2.2"/></room>
EOF
check "a file without windows" shows "<h1>Cellar</h1>" report --by-hand "$scratch/cellar.xml"
check "a PDF comes of the browser" refuses 2 "page of HTML" report "$deep" -o "$scratch/r.pdf"
check "a file is needed" refuses 2 "expected a room file" report
check "a wrong room leaves no page" sh -c "
    echo '<room version=\"1\"/>' >'$scratch/wrong.xml'
    ! '$pepperpot' report '$scratch/wrong.xml' -o '$scratch/wrong.html' 2>/dev/null &&
        [ ! -e '$scratch/wrong.html' ]"
tap_done
