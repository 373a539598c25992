#!/bin/sh
# A room whose external wall continues beyond the room.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

room() {
    echo "<room version='1' name='$1'><site ground-level='-0.5'/>"
    echo "<plan width='4.1' depth='5.3' height='2.7'/>"
    echo "<window wall='south' left='0.9' sill='0.8' width='2.1' height='1.5' reveal='$2'/>$3"
    echo "<line from='2 0.7' to='2 4.5' points='4'/></room>"
}
recessed="<facade wall='south' left='9' right='7' up='12' down='2' depth='0.5' reflectance='0.3'/>"
room Facade 0.2 "$recessed" >"$scratch/facade.xml"
room Facade 0.5 "" >"$scratch/reveal.xml"

check "df says that there is a facade" shows "facade south, reflectance 0.3" df "$scratch/facade.xml"
check "the room's description has it" shows \
    '{ "wall": "south", "left": 9, "right": 7, "up": 12, "down": 0.5, "depth": 0.5, "reflectance": 0.3 }' \
    df --format json "$scratch/facade.xml"

# sky FILE: the points' sky components by the closed form and by the table.
sky() {
    gives df --methods exact+bre,brs-table+bre --format csv "$1" &&
        awk -F, '$3 == "point" && $10 == "sc" && ($11 == "exact" || $11 == "brs-table") {
            printf "%s %s %s %.7f\n", $3, $5, $11, $12 }' "$scratch/out"
}
sky "$scratch/facade.xml" >"$scratch/facade.sky"
sky "$scratch/reveal.xml" >"$scratch/reveal.sky"
check "four points by two methods" test "$(wc -l <"$scratch/facade.sky")" -eq 8
check "the sky is that of a reveal as deep as the facade" same \
    "$scratch/facade.sky" "$scratch/reveal.sky"

# lines FILE: number of paths in an SVG.
lines() {
    grep -c '<path' "$1"
}
for kind in plan section; do
    check "$kind draws it" quietly chart $kind -o "$scratch/$kind.svg" "$scratch/facade.xml"
    check "and not as the room without it" quietly chart $kind -o "$scratch/plain-$kind.svg" \
        "$scratch/reveal.xml"
    check "to be seen" test "$(lines "$scratch/$kind.svg")" -gt "$(lines "$scratch/plain-$kind.svg")"
done

# lacks WORDS FILE: the text of a PDF does not contain the words.
lacks() {
    pdftotext "$2" "$scratch/words.txt" && ! grep "$1" "$scratch/words.txt"
}
quietly chart section -o "$scratch/section.pdf" "$scratch/facade.xml"
if command -v pdftotext >/dev/null; then
    check "nothing stands before the window" lacks "line of sight" "$scratch/section.pdf"
    check "nor has the wall's own thickness an angle" lacks "Obstruction angle" \
        "$scratch/section.pdf"
else
    skip "nothing stands before the window" "no pdftotext"
    skip "nor has the wall's own thickness an angle" "no pdftotext"
fi

export_to() {
    "$pepperpot" export --to radiance "$@" >"$scratch/out" 2>"$scratch/err"
}
check "an export has it" export_to -q -o "$scratch/scene" "$scratch/facade.xml"
check "among what stands outside" grep -q "^facade polygon" "$scratch/scene/outside.rad"
room Facade 0.6 "$recessed" >"$scratch/wrong.xml"
check "a reveal deeper than the facade is a mistake of its line" refuses 1 \
    "wrong.xml:3: facade: its depth of 0.5 m is less than the reveal depth of 0.6 m" df "$scratch/wrong.xml"
tap_done
