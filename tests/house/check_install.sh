#!/bin/sh
# What is installed serves programs that know nothing else of the project: one header; the
# examples, built by C and C++ compilers against it; the library opened at run time; the
# pictures, tables and examples that the manual points to.
. "$srcdir/tests/lib/tap.sh"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
root=$scratch/root
examples=$(cd "$srcdir/examples" && pwd)

if [ ! -e .libs/libpepperpot.so ]; then
    skip "examples work against what is installed" "there is no shared library"
    tap_done
    exit
fi
if $NM libmodel.a 2>/dev/null | grep -Eq '__(asan|ubsan)'; then
    skip "examples work against what is installed" "the build is instrumented"
    tap_done
    exit
fi

# Without this run's jobs and flags of make, which are about the tests.
installed() {
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -s install DESTDIR="$root" \
        >"$scratch/install.log" 2>&1 || { cat "$scratch/install.log"; return 1; }
}
check "everything installs" installed

prefix=$root$(sed -n 's/^prefix = //p' Makefile)
lib=$(dirname "$(find "$root" -name libpepperpot.so | head -n 1)")
include=$(dirname "$(find "$root" -name pepperpot.h | head -n 1)")
LD_LIBRARY_PATH=$lib
export LD_LIBRARY_PATH

one_header() {
    nothing "$(find "$prefix/include" -type f ! -name pepperpot.h)"
}

# built COMPILER NAME: an example against the installed tree.
built() {
    $1 -Wall -Wextra -Werror -I"$include" "$examples/$2.c" -o "$scratch/$2" -L"$lib" \
        -lpepperpot
}

daylight_factors() {
    "$scratch/daylight" "$examples/deep-office.xml" >"$scratch/out" &&
        grep -q 'by hand .* traced' "$scratch/out"
}

grows_with_width() {
    "$scratch/sweep" >"$scratch/widths.csv" &&
        awk -F, 'NR > 2 && !($2 > before) { exit 1 } { before = $2 } END { exit NR != 11 }' \
            "$scratch/widths.csv"
}

charts_in_memory() {
    "$scratch/chart" "$examples/deep-office.xml" >"$scratch/charts" &&
        test "$(grep -c 'bytes of <?xml' "$scratch/charts")" -eq 2
}

opened_at_run_time() {
    cat >"$scratch/open.c" <<'END'
#include <dlfcn.h>
#include <pepperpot.h>
int main(void)
{
    void *library = dlopen("libpepperpot.so.0", RTLD_NOW);
    int (*version)(void) = library ? (int (*)(void))dlsym(library, "pp_version") : 0;
    return version && version() == PP_VERSION_NUMBER ? 0 : 1;
}
END
    $CC -I"$include" "$scratch/open.c" -o "$scratch/open" -ldl && "$scratch/open"
}

check "pepperpot.h is the one header installed" one_header
compilers=$CC
command -v g++ >/dev/null && compilers="$compilers|g++ -x c++"
IFS='|'
for compiler in $compilers; do
    IFS=' '
    for example in daylight sweep chart; do
        check "$compiler builds examples/$example.c" built "$compiler" $example
    done
    check "hand and traced figures stand side by side ($compiler)" daylight_factors
    check "a wider window gives more light ($compiler)" grows_with_width
    check "charts are drawn into memory ($compiler)" charts_in_memory
done
IFS=' '
check "the library is opened at run time" opened_at_run_time

doc=$(find "$root" -type d -path '*/doc/pepperpot' | head -n 1)
check "the manual is installed, and the gallery that it shows" \
    test -s "$doc/docs/manual.md" -a -s "$doc/docs/gallery/deep-office-section.png"
check "tables and examples are installed beside it" \
    test -s "$doc/tables/finishes.csv" -a -s "$doc/examples/office.xml" \
    -a -s "$doc/examples/sweep.c"
tap_done
