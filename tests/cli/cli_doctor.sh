#!/bin/sh
# doctor: reports about this installation, and a test page with true scale.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

cd "$scratch" || exit 1
check "all checks of this build pass" gives doctor
check "there are eight of them" test "$(grep -c '  ok: ' out)" -eq 8
check "none fails" nothing "$(grep FAILED out)"
check "a known daylight factor comes out by hand" grep -q \
    '^  by hand  *ok: daylight factor 4.5251 %, known value 4.5251 %$' out
check "and by simulation, with its standard error" grep -q '^  simulated .* 4.52.. % ± 0.000. %' out
check "libraries are listed" grep -q 'cairo 1\.' out
check "the examples of the sources are found" grep -q "^  examples  *$examples\$" out
check "lines are tidy" nothing "$(grep -v / out >lines && mv lines out && untidy)"
check "nothing is left behind" nothing "$(leftovers)"

for format in pdf svg png; do
    check "a test page as $format" gives doctor -o "page.$format"
    check "is named" grep -q "^Test page: page.$format\$" out
done
check "it is a PDF" grep -q '^%PDF-' page.pdf
check "it is a sheet of A4" grep -q 'width="210mm" height="297mm"\|width="595[^"]*pt"' page.svg
check_words "with rulers of 100 mm" page.pdf "100 mm" "Test page"
check "the same page twice, to the byte" sh -c "cp page.pdf before.pdf &&
    '$pepperpot' doctor -o page.pdf >/dev/null && cmp page.pdf before.pdf"

check "another kind of file is refused" refuses 2 "expected a name that ends in" \
    doctor -o page.tif
check "standard output is for the report" refuses 2 "expected a name that ends in" doctor -o -
check "words are refused" refuses 2 '"room.xml" is not an option; expected no argument' doctor room.xml
check "unknown options are refused" refuses 2 "there is no option --paper" doctor --paper a4

fails() {
    run "$@"
    [ $status -eq 3 ] || told
}
check "a page that cannot be written is the machine's fault" fails doctor -o none/page.pdf
check "and is named" grep -q "none/page.pdf cannot be written" err
without_folder() {
    TMPDIR=$scratch/none
    export TMPDIR
    fails doctor
}
check "a folder that files cannot go to fails a check" without_folder
check "which is named" grep -q '^  files  *FAILED: .*none/pepperpot-doctor' out
check "and counted" grep -q '1 of 8 checks failed' err
tap_done
