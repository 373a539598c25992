#!/bin/sh
# Several ranks under mpirun, with a program that is configured --with-mpi in a separate folder.
. "$srcdir/tests/lib/tap.sh"

if ! command -v mpirun >/dev/null || ! pkg-config --exists ompi-c; then
    skip "several ranks give the same bytes" "Open MPI is not installed"
    tap_done
    exit
fi
source=$(cd "$srcdir" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cached=$(command -v ccache || true)
ln -s "$source" "$scratch/source"
mkdir "$scratch/build"
cd "$scratch/build" || exit 1

build() {
    ../source/configure -q --with-mpi=yes CC="$cached ${CC##* }" &&
        make -s -j"$(getconf _NPROCESSORS_ONLN)"
}
ranks() {
    srcdir=../source sh ../source/tests/cli/cli_ranks.sh >log 2>&1
    ! grep '^not ok' -A 5 log && grep -q '^ok' log
}
check "the module for MPI builds" build
check "several ranks give the same bytes" ranks
tap_done
