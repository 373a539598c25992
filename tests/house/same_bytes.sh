#!/bin/sh
# The same room, options and seed give identical output with gcc and clang, at -O0 and -O3, with
# and without wide registers (simulate/sampling/lanes.h), and with 1, 2 and 4 threads. Builds the
# program six times, which takes minutes (make check-long).
. "$srcdir/tests/lib/tap.sh"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
source=$(cd "$srcdir" && pwd)
cores=$(getconf _NPROCESSORS_ONLN)
cached=$(command -v ccache || true)

# Uses a link without a space in its name, since configure rejects spaces.
ln -s "$source" "$scratch/source"

build() {
    mkdir -p "$scratch/$1$2"
    cd "$scratch/$1$2" || return 1
    ../source/configure -q --disable-shared CC="$cached $1" CFLAGS="$(echo "$2" | tr , ' ')" &&
        make -s -j"$cores"
}

# results BUILD THREADS: the output for every example, in all formats.
results() {
    for room in "$source"/examples/*.xml; do
        for format in json csv text; do
            "$scratch/$1/pepperpot" df --methods all --simulate --samples 32 --seed 11 \
                --threads "$2" --quiet --format "$format" "$room" || return 1
        done
    done
}

first=
for compiler in gcc clang; do
    if ! command -v "$compiler" >/dev/null; then
        skip "$compiler gives the same bytes" "there is no $compiler"
        continue
    fi
    for level in -O0 -O3 -O2,-DPP_LANES_NARROW; do
        name=$compiler$level
        check "$compiler $level builds" build "$compiler" "$level"
        for threads in 1 2 4; do
            results "$name" "$threads" >"$scratch/$name.$threads" 2>&1
            if [ -z "$first" ]; then
                first=$scratch/$name.$threads
                check "there are results to compare" grep -q '"traced"' "$first"
            else
                check "$compiler $level with $threads threads gives the same bytes" \
                    cmp "$first" "$scratch/$name.$threads"
            fi
        done
    done
done
tap_done
