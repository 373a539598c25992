#!/bin/sh
# make distcheck: the tarball builds outside a read-only source tree, passes its tests, installs,
# and uninstalls without leaving a file. Runs only tests that read files of the sources or install.
. "$srcdir/tests/lib/tap.sh"

# Without the jobs and flags of this run of make.
distcheck() {
    programs="tests/formats/formats_tests tests/model/room/read/test_wrong_rooms"
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -s -j"$(getconf _NPROCESSORS_ONLN)" distcheck \
        DISTCHECK_CONFIGURE_FLAGS="CC='$CC'" check_PROGRAMS="$programs" \
        TESTS="$programs tests/house/check_install.sh tests/house/check_docs.sh tests/cli/cli_input.sh" \
        >distcheck.log 2>&1 || { tail -n 60 distcheck.log; return 1; }
    rm -f distcheck.log
}
check "make distcheck passes" distcheck
tap_done
