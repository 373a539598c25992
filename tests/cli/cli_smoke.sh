#!/bin/sh
# Each command once with a result and once with a mistake. Under sanitizers CI only runs this
# script; make check-long runs the others.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

few='--samples 16 --seed 5 --quiet'
street=$examples/situations/street.xml

check "help" gives --help
check "df by hand, with steps" gives df -m all --explain --points 1.4,1.5 "$deep"
# shellcheck disable=SC2086 # words
{
    check "df by all four engines, as JSON" gives df -s \
        --engine path,photons,radiosity,cache -ad 64 -as 16 --points 1.5,2 --error 5% --quiet \
        --format json "$deep"
    check "df by the plain code" gives df -s --plain -m exact --points 1.5,2 --error 5% --quiet "$deep"
    check "assess, as CSV" gives assess --by-hand --quiet --format csv "$street"
    check "size" gives size --target 2% --by-hand --quiet "$deep"
    check "availability" gives availability -m exact+split-flux --latitude 51 --quiet "$deep"
    check "validate" gives validate $few "$deep"
    check "render" quietly render --size 24x18 -ad 32 -as 8 $few -o "$scratch/picture.png" "$deep"
    check "export" quietly export --to radiance -o "$scratch/scene" -q "$deep"
    check "import" gives import "$scratch/scene"/materials.rad "$scratch/scene"/[!m]*.rad \
        --points-file "$scratch/scene/points.pts" $few
    check "report" quietly report --by-hand -q -o "$scratch/report.html" "$deep"
    check "atlas, one room" gives atlas --room 3
}
check "chart section" quietly chart section --dpi 40 -o "$scratch/section.png" "$deep"
check "chart plan" quietly chart plan -o "$scratch/plan.svg" "$deep"
check "chart nomogram" quietly chart nomogram -o "$scratch/nomogram.pdf" "$deep"
for kind in waldram pepper-pot protractor; do
    check "chart $kind" quietly chart $kind --points 1.4,1.5 -o "$scratch/$kind.pdf" "$deep"
done
printf 'x,y,df_percent\n1.5,2,3.1\n' >"$scratch/other.csv"
check "compare" gives compare --error 5% --seed 9 "$deep" "$scratch/other.csv"

echo '<room version="1"><plan width="3" depth="-4" height="2.7"/><windoww/>' >"$scratch/wrong.xml"
for command in df assess 'size --target 2%' availability validate \
    "export --to radiance -o $scratch/none" report; do
    # shellcheck disable=SC2086 # words
    check "${command%% *} of a wrong room" refuses 1 "wrong.xml:1: " $command "$scratch/wrong.xml"
done
check "an unknown command" refuses 2 "there is no command" sissors
tap_done
