#!/bin/sh
# Runs all scripts of tests/cli under clang's AddressSanitizer and UndefinedBehaviorSanitizer, and
# the C tests once more with detection of pointers into functions that have returned. Builds the
# program in a separate folder.
. "$srcdir/tests/lib/tap.sh"

if ! command -v clang >/dev/null; then
    skip "no command has a memory error" "there is no clang"
    tap_done
    exit
fi
source=$(cd "$srcdir" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cores=$(getconf _NPROCESSORS_ONLN)
cached=$(command -v ccache || true)
# Uses a link without a space in its name, since configure rejects spaces.
ln -s "$source" "$scratch/source"
mkdir "$scratch/build"
cd "$scratch/build" || exit 1

build() {
    ../source/configure -q --enable-sanitizers --disable-shared CC="$cached clang" \
        CFLAGS='-O1 -g1' && make -s -j"$cores"
}
scripts() {
    make -s -j"$cores" check check_PROGRAMS= check_LIBRARIES= TESTS="$(cd ../source &&
        echo tests/cli/cli_*.sh)" >check.log 2>&1 || {
        grep -h '^not ok' tests/cli/*.log
        return 1
    }
}
# The tests of the simulation are excluded: their paths would triple the time.
programs() {
    ASAN_OPTIONS=detect_stack_use_after_return=1 make -s -j"$cores" check \
        dist_check_SCRIPTS= TESTS="$(cd ../source && ls -d tests/*/ | grep -v \
        'simulate\|house\|long\|fuzz\|lib' | sed 's|tests/\(.*\)/|tests/\1/\1_tests|' |
        tr '\n' ' ')" >check.log 2>&1 || {
        grep -h '^not ok' tests/*/*.log
        return 1
    }
}
check "the program builds" build
check "every script of tests/cli passes" scripts
rooms() { srcdir=../source sh ../source/tests/long/long_odd_rooms.sh >rooms.log 2>&1 && ! grep -A 20 "^not ok" rooms.log; }
check "no command on unusual rooms has a memory error" rooms
check "no pointer into a function that has returned is used" programs
tap_done
