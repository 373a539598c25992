#!/bin/sh
# The commands shown in the manual run, and print the output shown. Blocks that take seconds are
# only run by make check-long (FULL_SIZE). `make docs-outputs` updates the pages.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

[ -n "${FULL_SIZE-}" ] || export QUICK=yes
AWK=${AWK:-awk}
export AWK
in_step() {
    sh "$srcdir/docs/outputs.sh" "$pepperpot" "$srcdir" "$1" >"$scratch/page" && diff "$1" "$scratch/page"
}
grep -l '^```console' "$srcdir"/docs/*.md "$srcdir"/docs/*/*.md >"$scratch/pages"
check "pages show commands" test "$(wc -l <"$scratch/pages")" -ge 20
while read -r page; do
    check "${page#"$srcdir"/docs/} shows what its commands print" in_step "$page"
done <"$scratch/pages"
tap_done
