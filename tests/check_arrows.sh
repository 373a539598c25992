#!/bin/sh
# The arrows between the folders: by what the sources include and by what the objects
# call. methods and simulate know nothing of each other, charts nothing of either, design
# knows the methods, model nothing of anyone; the library never prints, exits or looks at its surroundings, and
# keeps nothing in writable data.
. "$srcdir/tests/tap.sh"

library="model methods design simulate charts"

# may_use FOLDER: the folders whose headers and functions it may use.
may_use() {
    case $1 in
    model) echo model ;;
    design) echo "design methods model" ;;
    cli) echo "cli $library" ;;
    *) echo "model $1" ;;
    esac
}

# Lines "FILE includes HEADER" that go against an arrow.
wrong_includes() {
    for folder in $library cli; do
        allowed=" $(may_use "$folder") "
        (cd "$srcdir" && grep -rH --include='*.[ch]' '^[ 	]*#[ 	]*include[ 	]*"' "$folder") |
            while IFS=: read -r file include; do
                header=${include#*\"}
                header=${header%%\"*}
                case $header in
                config.h | tables/*) continue ;;
                */*) ;;
                *) echo "$file includes $header without its folder" ;;
                esac
                case $allowed in
                *" ${header%%/*} "*) ;;
                *) echo "$file includes $header" ;;
                esac
            done
    done
}

# Lines "FOLDER/OBJECT NAME" of what a folder's objects define for others, or ask of
# others; from its archive, which holds no object of a source that is gone.
symbols_of() {
    $NM -A -g "$2" ".libs/lib$1.a" 2>/dev/null | sed "s|^[^:]*:|$1/|; s|:| |" |
        awk 'NF > 2 { print $1, $NF }'
}

wrong_calls() {
    for folder in $library; do
        symbols_of "$folder" --undefined-only >"$scratch/wants"
        for other in $library; do
            case " $(may_use "$folder") " in *" $other "*) continue ;; esac
            symbols_of "$other" --defined-only | awk -v folder="$folder" '
                NR == FNR { defined[$2] = $1; next }
                $2 in defined { print $1 " calls " $2 " of " defined[$2] }
            ' - "$scratch/wants"
        done
    done
}

# Lines "OBJECT uses NAME" for names that match a pattern in the library's objects.
library_uses() {
    for folder in $library; do
        symbols_of "$folder" --undefined-only
    done | awk -v pattern="^($1)\$" '$2 ~ pattern { print $1 " uses " $2 }'
}

# What prints, ends the process, or makes a result depend on its surroundings.
forbidden='(__)?v?printf(_chk)?|puts|putchar|perror|stdout|stderr|stdin'
forbidden="$forbidden|exit|_exit|_Exit|quick_exit|abort|atexit|signal|sigaction"
forbidden="$forbidden|getenv|secure_getenv|setenv|putenv|setlocale|rand|srand|random|time"

# The reader of room files may read standard input: "-" is a path of INTERFACE.
uses_forbidden() {
    library_uses "$forbidden" | grep -v '^model/.*uses stdin$'
}

# Files of the library that include a header: there may be one at most.
includers() {
    (cd "$srcdir" && grep -Erl --include='*.[ch]' "^[ 	]*#[ 	]*include[ 	]*<($1)" \
        $library cli)
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
    nothing "$(includers "$2" | grep -v "^$1/")"
}

# Symbols in sections that are written to. Tables of pointers that are constant but for
# their relocation lie in .data.rel.ro and are not meant.
writable_data() {
    for folder in $library; do
        $NM -A -f sysv ".libs/lib$folder.a" 2>/dev/null |
            sed -n "s|^[^:]*:|$folder/|; s|:|\||p" | awk -F'|' '
                { section = $NF; gsub(/ /, "", section); gsub(/ /, "", $2) }
                section ~ /^\.?(data|bss|tdata|tbss|\*COM\*)/ &&
                    section !~ /^\.data\.rel\.ro/ && $2 !~ /^\.gomp_critical_user_/ {
                    print $1 " keeps " $2 " in " section
                }'
    done
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

check "every include follows the arrows" nothing "$(wrong_includes)"
check "every call between the folders follows the arrows" nothing "$(wrong_calls)"
check "the library neither prints nor exits nor looks at its surroundings" \
    nothing "$(uses_forbidden)"
check "one file at most knows GEOS" one_file_at_most geos_c.h
check "one file at most knows Embree 3" one_file_at_most embree3/
check "one file at most knows Embree 4" one_file_at_most embree4/
check "XML is read in model" only_in model libxml/
check "ray queries are made in simulate" only_in simulate embree
check "charts alone draw" only_in charts 'cairo|<pango'
check "JSON is written in cli" only_in cli json

if $NM .libs/libmodel.a 2>/dev/null | grep -Eq '__(asan|ubsan|gcov|llvm_profile)'; then
    skip "file-scope data is constant" "the build is instrumented, and that keeps data"
else
    check "file-scope data is constant" nothing "$(writable_data)"
fi
tap_done
