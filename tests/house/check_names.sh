#!/bin/sh
# Names show where things are: no two files have the same name, no two structs the same tag; every
# file has a first comment; include guards are paths; external functions begin with the name of
# their file and are declared in its header; names of static functions are rarely repeated; folders
# and files have a limited size.
. "$srcdir/tests/lib/tap.sh"

program="model formats methods simulate studies charts reports api serve cli"
files_most=35        # a folder
lines_most=500       # a file of the program
test_lines_most=700  # a test or benchmark: a list of facts, each short
share_least=95       # per cent of the external functions
statics_most=3       # files in which static functions have one name

# Files that may be longer: one per line, with the reason.
long_files='
'

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# All sources, by path from the top; those of a build in the source tree are excluded.
(cd "$srcdir" && find $program tests bench -name '*.[ch]' | LC_ALL=C sort) >"$scratch/sources"
grep -E "^($(echo "$program" | tr ' ' '|'))/" "$scratch/sources" >"$scratch/program"

# Files that need a name of their own: also tables, scripts and dictionaries. A .c and a .h with
# the same stem belong together, in one folder.
(cd "$srcdir" && find $program tables tests bench \
    -name '*.[ch]' -o -name '*.sh' -o -name '*.csv' -o -name '*.awk' -o -name '*.dict') |
    sed 's|\(.*\)/\([^/]*\)|\2 \1|' | LC_ALL=C sort >"$scratch/named"

same_names() {
    awk '{ folders[$1] = folders[$1] " " $2; n[$1]++ }
        END { for (name in n) if (n[name] > 1) print name " is in" folders[name] }' \
        "$scratch/named"
    sed -n 's/^\([^ ]*\)\.[ch] /\1 /p' "$scratch/named" | LC_ALL=C sort -u |
        awk '{ folders[$1] = folders[$1] " " $2; n[$1]++ }
            END { for (name in n) if (n[name] > 1) print name ".[ch] is in" folders[name] }'
}

# code FILE...: lines "FILE CODE" without comments and contents of strings.
code() {
    (cd "$srcdir" && awk '
        FNR == 1 { inside = 0 }
        {
            line = $0
            if (inside) {
                if (!(end = index(line, "*/")))
                    next
                line = substr(line, end + 2)
                inside = 0
            }
            gsub(/\\./, "", line)
            gsub(/"[^"]*"/, "\"\"", line)
            while ((from = index(line, "/*"))) {
                rest = substr(line, from + 2)
                line = substr(line, 1, from - 1)
                if (!(end = index(rest, "*/"))) {
                    inside = 1
                    break
                }
                line = line " " substr(rest, end + 2)
            }
            sub(/\/\/.*/, "", line)
            if (line ~ /[^ ]/)
                print FILENAME " " line
        }' "$@")
}

# Tags of structs, unions and enums that more than one place of the program defines.
same_tags() {
    code $(cat "$scratch/program") | awk '
        match($0, /(struct|union|enum) +[A-Za-z0-9_]+ *\{/) {
            split(substr($0, RSTART, RLENGTH), words, /[ {]+/)
            tag = words[1] " " words[2]
            places[tag] = places[tag] " " $1
            n[tag]++
        }
        END { for (tag in n) if (n[tag] > 1) print tag " is defined in" places[tag] }'
}

# Sources that do not begin with a comment, and first comments that name another file.
without_head() {
    (cd "$srcdir" && awk '
        FNR == 1 {
            name = FILENAME
            sub(/.*\//, "", name)
            if ($1 != "/*" || NF < 2)
                print FILENAME " begins with no comment"
            else if ($3 == "-" && $2 ~ /\.[ch]$/ && $2 != name)
                print FILENAME " has the head of " $2
        }' $(cat "$scratch/sources"))
}

# Headers whose guard is not PP_ and their path.
wrong_guards() {
    code $(grep '\.h$' "$scratch/sources") | awk '
        function guard_of(path) {
            gsub(/[^A-Za-z0-9]/, "_", path)
            return "PP_" toupper(path)
        }
        $1 != file {
            file = $1
            headers[file] = 1
            if ($2 != "#ifndef" || $3 != guard_of(file))
                print file " does not begin with #ifndef " guard_of(file)
            ifndef = 1
            next
        }
        ifndef {
            ifndef = 0
            if ($2 != "#define" || $3 != guard_of(file))
                print file " does not define " guard_of(file)
        }'
}

# Lines "PATH NAME" of the program's external functions, from its archives: names are unique, so
# the name of an object gives its source.
sed -n 's|\(.*/\)\([^/]*\)\.c$|\2 \1\2.c|p' "$scratch/program" >"$scratch/stems"
for folder in $program; do
    $NM -A -g --defined-only "lib$folder.a" 2>/dev/null
done | sed -n 's/^[^:]*:\([^:]*\)\.o:[^ ]* T \([^_ ][^ ]*\)$/\1 \2/p' |
    awk 'NR == FNR { path[$1] = $2; next } $1 in path { print path[$1], $2 }' \
        "$scratch/stems" - >"$scratch/functions"

# Lines "HEADER NAME" of declarations, by a prototype or by the name of a function type
# ("pp_option_reader pp_options_read_text;").
code pepperpot.h $(grep '\.h$' "$scratch/program") | awk '
    {
        file = $1
        $1 = ""
        while (match($0, /[a-z][a-z0-9_]*[(;]/)) {
            print file " " substr($0, RSTART, RLENGTH - 1)
            $0 = substr($0, RSTART + RLENGTH)
        }
    }' >"$scratch/declared"

# External functions with another name than pp_[folder_]file..., and those that the header of their
# file does not declare. Functions declared in pepperpot.h have names for users, and may be in any
# file of api/; pp_building_read and similar ones must be in the file of their name.
astray() {
    awk '
        NR == FNR { declared[$1, $2] = 1; next }
        {
            header = path = $1
            sub(/\.c$/, ".h", header)
            n = split(path, parts, "/")
            stem = parts[n]
            sub(/\.c$/, "", stem)
            public = ("pepperpot.h", $2) in declared
            if (public && path ~ /^api\//)
                next
            if ($2 !~ "^pp_(" parts[n - 1] "_)?" stem "(_|$)")
                print path ": " $2 " does not begin with pp_" stem
            else if (!public && !((header, $2) in declared))
                print path ": " $2 " is not declared in " header
        }' "$scratch/declared" "$scratch/functions"
}

# Names of static functions in more than a few files: in a stack trace they do not show their file,
# and a breakpoint on such a name is ambiguous.
same_statics() {
    code $(cat "$scratch/program") | awk -v most=$statics_most '
        {
            file = $1
            line = substr($0, length(file) + 2)
            if (file == before && head != "")
                line = head " " line
            before = file
            head = ""
            if (line !~ /^static /)
                next
            if (line !~ /[(=;{]/) {
                head = line
                next
            }
            if (!match(line, /[A-Za-z0-9_]+\(/) || index(substr(line, 1, RSTART), "="))
                next
            name = substr(line, RSTART, RLENGTH - 1)
            if ((file, name) in seen)
                next
            seen[file, name] = 1
            places[name] = places[name] " " file
            n[name]++
        }
        END { for (name in n) if (n[name] > most) print name " is static in" places[name] }'
}

large_folders() {
    sed 's|/[^/]*$||' "$scratch/sources" | LC_ALL=C sort | uniq -c |
        awk -v most=$files_most '$1 > most { print $2 " holds " $1 " files" }'
}

long_sources() {
    printf '%s' "$long_files" >"$scratch/long"
    (cd "$srcdir" && wc -l $(cat "$scratch/sources")) |
        awk -v most=$lines_most -v test_most=$test_lines_most '
            NR == FNR { if (NF > 1) allowed[$1] = 1; next }
            $2 != "total" && !($2 in allowed) &&
                $1 > ($2 ~ /^(tests|bench)\// ? test_most : most) {
                print $2 " has " $1 " lines"
            }' "$scratch/long" -
}

check "there are names to look at" test -s "$scratch/functions" -a -s "$scratch/declared"
check "no two files have one name" nothing "$(same_names)"
check "no two structs have one tag" nothing "$(same_tags)"
check "every source begins with a comment" nothing "$(without_head)"
check "include guards are paths" nothing "$(wrong_guards)"
check "no static name is in more than $statics_most files" nothing "$(same_statics)"
check "no folder holds more than $files_most files" nothing "$(large_folders)"
check "no file is longer than $lines_most lines, but for reasons" nothing "$(long_sources)"

# The share is always printed, and the misplaced functions if it is too high.
astray >"$scratch/astray"
wrong=$(wc -l <"$scratch/astray")
all=$(wc -l <"$scratch/functions")
share=$(awk -v wrong="$wrong" -v all="$all" \
    'BEGIN { printf "%.1f", all ? 100 * (all - wrong) / all : 0 }')
enough() {
    awk -v share="$share" -v least=$share_least 'BEGIN { exit !(share >= least) }' || {
        cat "$scratch/astray"
        return 1
    }
}
check "$share % of $((all)) functions are where their names say ($share_least % at least)" enough
tap_done
