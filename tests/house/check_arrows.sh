#!/bin/sh
# Dependencies between folders, from the includes of the sources and the calls of the objects: a
# folder uses only folders below it in the table. methods and simulate do not use each other; only
# studies uses both. A header that states "Inside X/ only" is included there only; there are no
# circular includes. The library never prints, exits or reads the environment, and has no writable
# data.
. "$srcdir/tests/lib/tap.sh"

folders="model formats methods simulate studies charts reports api serve cli"
library="model formats methods simulate studies charts reports api"

# Each folder and those that it may use besides itself, lowest first. "model" stands for all of its
# folders.
places='
model/base
model/geometry      model/base
model/expression    model/base model/geometry
model/light         model/base model/geometry model/expression
model/mesh          model/base model/geometry
model/pictures      model/base model/geometry model/light
model/room          model/base model/geometry model/expression model/light model/mesh model/pictures
model/results       model/base model/geometry model/expression model/light model/room model/pictures
formats             model
methods             model
simulate/sampling   model
simulate/estimate   model simulate/sampling
simulate/scene      model simulate/sampling
simulate/path_tracer model simulate/sampling simulate/estimate simulate/scene
simulate/transport  model simulate/sampling simulate/estimate simulate/scene
simulate/fast       model simulate/sampling simulate/estimate simulate/scene simulate/transport
simulate/cache      model simulate/sampling simulate/estimate simulate/scene simulate/transport
simulate/render     model simulate
simulate/year       model simulate/sampling simulate/scene simulate/path_tracer
simulate/research/radiosity model
simulate/research/photons model simulate/sampling simulate/estimate simulate/scene
studies             model formats methods simulate
charts              model
reports             model formats methods simulate studies
api                 model formats methods simulate studies charts reports
serve
cli                 model formats methods simulate studies charts reports api serve'

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
printf '%s\n' "$places" | sed 1d >"$scratch/places"

# awk functions on the table of places, which is read first.
arrows='
    function place_of(path,    name) {
        name = path
        while (name != "" && !(name in uses))
            if (!sub(/\/[^\/]*$/, "", name))
                name = ""
        return name
    }
    function may_use(from, to,    mine, theirs, list, i, n) {
        mine = place_of(from); theirs = place_of(to)
        if (mine == "" || theirs == "")
            return 0
        if (mine == theirs)
            return 1
        n = split(uses[mine], list, " ")
        for (i = 1; i <= n; i++)
            if (theirs == list[i] || index(theirs, list[i] "/") == 1)
                return 1
        return 0
    }
    FILENAME == ARGV[1] { name = $1; $1 = ""; uses[name] = $0; next }'

# Lines "FILE HEADER": the project's headers that each file includes.
(cd "$srcdir" && grep -rH --include='*.[ch]' '^[ 	]*#[ 	]*include[ 	]*"' $folders) |
    sed -n 's/^\([^:]*\):[^"]*"\([^"]*\)".*/\1 \2/p' |
    grep -Ev ' (config\.h|pepperpot\.h|tables/.*)$' >"$scratch/includes"

wrong_includes() {
    awk "$arrows"'
        $2 !~ /\// { print $1 " includes " $2 " without its folder"; next }
        !may_use($1, $2) { print $1 " includes " $2 }
    ' "$scratch/places" "$scratch/includes"
}

# Headers that name the folder they are for, and files elsewhere that include them.
wrong_guests() {
    (cd "$srcdir" && find $folders -name '*.h' | xargs awk '
        FNR == 1 { text = ""; in_head = 1 }
        in_head { line = $0; sub(/^ \* /, "", line); text = text " " line }
        in_head && /\*\// {
            in_head = 0
            if (match(text, /[Ii]nside [a-z_\/]*\/ only/))
                print FILENAME, substr(text, RSTART + 7, RLENGTH - 12)
        }') >"$scratch/owners"
    awk 'NR == FNR { owner[$1] = $2; next }
        $2 in owner && index($1, owner[$2]) != 1 {
            print $1 " includes " $2 ", which is inside " owner[$2] " only"
        }' "$scratch/owners" "$scratch/includes"
}

# symbols_of FOLDER OPTION: lines "FILE NAME" of the symbols that a folder's objects define or
# need, from its archive, which contains no objects of deleted sources. File names are unique, so
# an object's name gives its folder.
symbols_of() {
    $NM -A -g "$2" "lib$1.a" 2>/dev/null |
        sed -n 's/^[^:]*:\([^:]*\)\.o:.* \([^ ]*\)$/\1 \2/p' |
        awk 'NR == FNR { path[$1] = $2; next } { print path[$1], $2 }' "$scratch/stems" -
}

(cd "$srcdir" && find $folders -name '*.c') |
    sed 's|^\(.*/\)\([^/]*\)\.c$|\2 \1\2.c|' >"$scratch/stems"
for folder in $library cli; do
    symbols_of "$folder" --undefined-only >>"$scratch/wants"
    symbols_of "$folder" --defined-only >>"$scratch/gives"
done
# The server is a user of pepperpot.h: it only calls functions declared there.
(cd "$srcdir" && ${AWK:-awk} -f libpepperpot.awk pepperpot.h) >"$scratch/public"
symbols_of serve --undefined-only |
    awk 'NR == FNR { public[$1] = 1; next } !($2 in public)' "$scratch/public" - >>"$scratch/wants"
symbols_of serve --defined-only >>"$scratch/gives"

wrong_calls() {
    awk "$arrows"'
        FILENAME == ARGV[2] { defined[$2] = $1; next }
        $2 in defined && !may_use($1, defined[$2]) {
            print $1 " calls " $2 " of " defined[$2]
        }
    ' "$scratch/places" "$scratch/gives" "$scratch/wants"
}

# Circular includes of headers, and circular calls between files: tsort reports a loop.
circles() {
    grep '\.h .*\.h$' "$scratch/includes" | tsort 2>&1 >/dev/null
    awk 'NR == FNR { defined[$2] = $1; next }
        $2 in defined && defined[$2] != $1 { print $1, defined[$2] }
    ' "$scratch/gives" "$scratch/wants" | sort -u | tsort 2>&1 >/dev/null
}

# Lines "FILE uses NAME" for names that match a pattern in the library's objects.
library_uses() {
    grep -Ev '^(cli|serve)/' "$scratch/wants" |
        awk -v pattern="^($1)\$" '$2 ~ pattern { print $1 " uses " $2 }'
}

# Symbols that print, end the process, or make a result depend on the environment.
forbidden='(__)?v?printf(_chk)?|puts|putchar|perror|stdout|stderr|stdin'
forbidden="$forbidden|exit|_exit|_Exit|quick_exit|abort|atexit|signal|sigaction"
forbidden="$forbidden|getenv|secure_getenv|setenv|putenv|setlocale|rand|srand|random|time"

# The reader of room files may read standard input: "-" is a documented path.
uses_forbidden() {
    library_uses "$forbidden" | grep -v '^model/base/.*uses stdin$'
}

# includers HEADER: files that include a system header; at most one may.
includers() {
    (cd "$srcdir" && grep -Erl --include='*.[ch]' "^[ 	]*#[ 	]*include[ 	]*<($1)" $folders)
}

one_file_at_most() {
    files=$(includers "$1")
    [ "$(printf '%s\n' "$files" | grep -c .)" -le 1 ] || {
        echo "more than one file includes $1:"
        echo "$files"
        return 1
    }
}

only_in() {
    nothing "$(includers "$2" | grep -Ev "^($1)/")"
}

# Symbols in writable sections. Tables of constant pointers that are only relocated are in
# .data.rel.ro and are allowed.
writable_data() {
    for folder in $library; do
        $NM -A -f sysv "lib$folder.a" 2>/dev/null |
            sed -n "s|^[^:]*:|$folder/|; s|:|\||p" | awk -F'|' '
                { section = $NF; gsub(/ /, "", section); gsub(/ /, "", $2) }
                section ~ /^\.?(data|bss|tdata|tbss|\*COM\*)/ &&
                    section !~ /^\.data\.rel\.ro/ {
                    print $1 " keeps " $2 " in " section
                }'
    done
}

check "there are arrows to hold" test -s "$scratch/includes" -a -s "$scratch/gives"
check "every include follows the arrows" nothing "$(wrong_includes)"
check "every call between the folders follows the arrows" nothing "$(wrong_calls)"
check "what is inside a folder is included there only" nothing "$(wrong_guests)"
check "there are such headers" test -s "$scratch/owners"
check "no files include or call one another in a circle" nothing "$(circles)"
check "the library neither prints nor exits nor looks at its surroundings" \
    nothing "$(uses_forbidden)"
check "one file at most knows GEOS" one_file_at_most geos_c.h
check "one file at most knows Embree 3" one_file_at_most embree3/
check "one file at most knows Embree 4" one_file_at_most embree4/
check "only the loader of the MPI module uses dlopen" nothing \
    "$(includers dlfcn.h | grep -v '^cli/ranks/mpirun.c$')"
check "one file of the library starts threads, and the server's line of tasks" nothing \
    "$(includers '(pthread|threads|omp)\.h' | grep -Ev '^model/base/thread_pool.c$|^serve/')"
check "the web server is in serve" only_in serve microhttpd
check "XML is read in model/base" only_in model/base libxml/
check "ray queries are made in simulate/scene" only_in simulate/scene embree
check "charts alone draw" only_in charts 'cairo|<pango'
check "JSON is written in reports, and by the server" only_in 'reports|serve' json

if $NM libmodel.a 2>/dev/null | grep -Eq '__(asan|ubsan|gcov|llvm_profile)'; then
    skip "file-scope data is constant" "the build is instrumented, and that keeps data"
else
    check "file-scope data is constant" nothing "$(writable_data)"
fi
tap_done
