#!/bin/sh
# The shared library exports exactly the functions of pepperpot.h. The header compiles alone in C
# and C++, and has the version of the package.
. "$srcdir/tests/lib/tap.sh"

library=.libs/libpepperpot.so
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The compiler is the judge: it accepts a name that the header declares, and rejects any other.
undeclared() {
    echo '#include "pepperpot.h"' >"$scratch/names.c"
    echo 'void names(void);' >>"$scratch/names.c"
    echo 'void names(void) {' >>"$scratch/names.c"
    sed 's/.*/    (void)&;/' "$scratch/exported" >>"$scratch/names.c"
    echo '}' >>"$scratch/names.c"
    $CC -std=gnu11 -I"$srcdir" -fsyntax-only "$scratch/names.c"
}

alone() {
    echo '#include "pepperpot.h"' >"$scratch/alone.$2"
    $1 -I"$srcdir" -Wall -Wextra -Werror -fsyntax-only "$scratch/alone.$2"
}

header_version() {
    sed -n 's/^#define PP_VERSION_[A-Z]* \([0-9]*\)$/\1/p' "$srcdir/pepperpot.h" |
        tr '\n' '.' | sed 's/\.$//'
}

check "pepperpot.h stands alone in C" alone "$CC -std=c11" c
if command -v g++ >/dev/null; then
    check "pepperpot.h stands alone in C++" alone "g++ -std=c++11" cc
else
    skip "pepperpot.h stands alone in C++" "there is no g++"
fi
check "the header's version is the program's" \
    test "pepperpot $(header_version)" = "$(./pepperpot --version)"
check "at most 50 functions are exported" test "$(wc -l <libpepperpot.sym)" -le 50

if [ ! -e "$library" ]; then
    skip "what is exported is what the header declares" "there is no shared library"
    tap_done
    exit
fi
$NM -D --defined-only "$library" | awk '{ print $NF }' | sed 's/@.*//' |
    LC_ALL=C sort >"$scratch/exported"
check "every declared function is exported" \
    nothing "$(LC_ALL=C comm -23 libpepperpot.sym "$scratch/exported")"
check "nothing else is exported" \
    nothing "$(LC_ALL=C comm -13 libpepperpot.sym "$scratch/exported")"
check "the compiler finds every exported name in the header" undeclared
check "every exported name begins with pp_" \
    nothing "$(grep -v '^pp_' "$scratch/exported")"
tap_done
