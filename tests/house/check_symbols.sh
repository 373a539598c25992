#!/bin/sh
# The shared library exports the functions of its installed headers, and no other name.
. "$srcdir/tests/lib/tap.sh"

library=.libs/libpepperpot.so
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

if [ ! -e "$library" ]; then
    skip "what is exported is what the headers declare" "there is no shared library"
    tap_done
    exit
fi

$NM -D --defined-only "$library" | awk '{ print $NF }' | sed 's/@.*//' |
    LC_ALL=C sort >"$scratch/exported"

# The compiler is asked, not our own list: it knows a name that a header declares, and
# refuses any other.
undeclared() {
    for header in $HEADERS; do
        echo "#include \"$header\""
    done >"$scratch/names.c"
    echo 'void names(void);' >>"$scratch/names.c"
    echo 'void names(void) {' >>"$scratch/names.c"
    sed 's/.*/    (void)&;/' "$scratch/exported" >>"$scratch/names.c"
    echo '}' >>"$scratch/names.c"
    $CC -std=gnu11 -I"$srcdir" $HEADER_CFLAGS -fsyntax-only "$scratch/names.c"
}

each_header_alone() {
    for header in $HEADERS; do
        echo "#include \"$header\"" >"$scratch/alone.c"
        $CC -std=gnu11 -I"$scratch/include" $HEADER_CFLAGS -fsyntax-only "$scratch/alone.c" ||
            return 1
    done
}

# Only what is installed, so that a header that needs one which isn't is found out.
for header in $HEADERS; do
    mkdir -p "$scratch/include/$(dirname "$header")"
    cp "$srcdir/$header" "$scratch/include/$header"
done

check "every declared function is exported" \
    nothing "$(LC_ALL=C comm -23 libpepperpot.sym "$scratch/exported")"
check "nothing else is exported" \
    nothing "$(LC_ALL=C comm -13 libpepperpot.sym "$scratch/exported")"
check "the compiler finds every exported name in an installed header" undeclared
check "every installed header stands alone among the installed ones" each_header_alone
check "every exported name begins with pp_" \
    nothing "$(grep -v '^pp_' "$scratch/exported")"

# Names that the command's objects ask of others and do not have among themselves.
$NM -g cli/*.o .libs/libcli.a .libs/libreports.a 2>/dev/null | awk '$1 == "U" && $2 ~ /^pp_/ { print $2 }' |
    LC_ALL=C sort -u >"$scratch/asked"
$NM -g --defined-only cli/*.o .libs/libcli.a 2>/dev/null | awk 'NF == 3 { print $3 }' |
    LC_ALL=C sort -u >"$scratch/own"
check "the command gets by with what the library exports" \
    nothing "$(LC_ALL=C comm -23 "$scratch/asked" "$scratch/own" |
        LC_ALL=C comm -23 - "$scratch/exported")"
tap_done
