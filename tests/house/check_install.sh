#!/bin/sh
# The installed files suffice for programs that use nothing else of the project: one header; the
# examples, built with C and C++ compilers; the library loaded at run time; the pictures, tables
# and examples named in the manual. The program runs every command from the staging folder and
# after the tree is moved; uninstalling removes all files.
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

# Without the jobs and flags of this run of make, which are for the tests.
staged() {
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -s "$1" DESTDIR="$root" \
        >"$scratch/install.log" 2>&1 || { cat "$scratch/install.log"; return 1; }
}
check "everything installs" staged install

prefix=$root$(sed -n 's/^prefix = //p' Makefile)
lib=$(dirname "$(find "$root" -name libpepperpot.so | head -n 1)")
include=$(dirname "$(find "$root" -name pepperpot.h | head -n 1)")
LD_LIBRARY_PATH=$lib
export LD_LIBRARY_PATH

one_header() {
    nothing "$(find "$prefix/include" -type f ! -name pepperpot.h)"
}

# built COMPILER NAME: builds an example with the installed tree.
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
    test -s "$doc/docs/index.md" -a -s "$doc/docs/gallery/deep-office-section.png"
check "tables and examples are installed beside it" \
    test -s "$doc/tables/finishes.csv" -a -s "$doc/examples/office.xml" \
    -a -s "$doc/examples/sweep.c"

# runs TREE: runs every command of the program in this tree.
runs() {
    bin=$1/bin
    work=$(mktemp -d "$scratch/work.XXXXXX")
    cp "$examples/deep-office.xml" "$work/room.xml"
    (
        unset LD_LIBRARY_PATH
        cd "$work" || exit 1
        for command in doctor "df room.xml" "chart section room.xml -o section.svg" \
            "render --size 8x6 --samples 1 --quiet -ad 16 -as 4 -o picture.png room.xml" \
            "assess --by-hand --quiet room.xml" "report --by-hand --quiet room.xml -o report.html" \
            "size --target 2% --by-hand --quiet room.xml" \
            "availability -m exact+split-flux --latitude 51 --quiet room.xml" \
            "validate --samples 2 --quiet room.xml" "atlas --accuracy" \
            "export room.xml --to radiance -o scene" \
            "import scene/materials.rad scene/room.rad scene/sky.rad" \
            "compare --as-if ab=2 --error 20% --quiet room.xml"; do
            IFS=' '
            "$bin/pepperpot" $command >out 2>err || {
                echo "$command"
                cat err
                exit 1
            }
        done
        "$bin/pepperpot" --help >help &&
            [ "$(sed -n '/^Commands:/,/^$/p' help | grep -c '^  ')" -eq 17 ]
    )
}

# finds_its_module TREE: a module that reports that MPI cannot be started, in the first place where
# the MPI module is searched.
finds_its_module() {
    mkdir -p "$1/lib/pepperpot"
    echo 'int pp_mpirun_module(void) { return 1; }' >"$scratch/module.c"
    $CC -shared -fPIC "$scratch/module.c" -o "$1/lib/pepperpot/pepperpot-mpi.so" || return 1
    OMPI_COMM_WORLD_SIZE=2 "$1/bin/pepperpot" --version 2>"$scratch/err"
    [ $? -eq 3 ] && grep -q "MPI cannot be started" "$scratch/err"
}

moved="$scratch/a moved tree"
cp -R "$prefix" "$moved"
check "every command runs where the program is staged" runs "$prefix"
check "it uninstalls" staged uninstall
check "uninstalling leaves nothing behind" nothing \
    "$(find "$root" ! -type d; cd "$prefix" && find . -name '*pepperpot*')"
chmod -R a-w "$moved"
check "every command runs in a tree that is moved and read-only" runs "$moved"
chmod -R u+w "$moved"
check "there it finds its module for MPI" finds_its_module "$moved"
tap_done
