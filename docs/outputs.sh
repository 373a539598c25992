#!/bin/sh
# outputs.sh PROGRAM SOURCES PAGE.md [PICTURES] - runs the commands on a page of the manual and
# prints the page with their new outputs. If a folder PICTURES is given, the pictures that the page
# shows are copied to it. With QUICK=yes, blocks marked `<!-- long -->` are printed unchanged and
# their commands do not run.
#
# Commands run in order in one scratch folder. It contains the folder examples/ of the sources, and
# the files beside the page that are not pages. Marks on the page:
#
#     ```console                      a block of commands and outputs: a line with `$ ` begins a
#     $ pepperpot df room.xml         command, which continues on the next line after a `\`; the
#     ...                             lines up to the next command are its output
#     ```
#     <!-- shown: 1-6 12 -->          before a block: only these lines of each output are shown,
#                                     with `...` in place of the others; or a script for `sed -n`,
#                                     such as /Criteria/,/^$/p
#     <!-- file: room.xml -->         the next block, which is not a console block, is written to
#                                     that file
#     <!-- run: COMMAND -->           a command that is run but not shown
#     <!-- long -->                   before a block that takes several seconds
#     <!-- fails -->                  before a block: its commands may fail
#
# Exit status 1 if another command fails, if a `sed -n` script selects nothing, or if no command
# makes a picture that the page shows.
set -eu
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
sources=$(cd "$2" && pwd)
page=$3
case $page in /*) ;; *) page=$(pwd)/$page ;; esac
pictures=${4-}
[ -z "$pictures" ] || pictures=$(cd "$pictures" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/bin" "$scratch/work"
printf '#!/bin/sh\nexec "%s" "$@"\n' "$program" >"$scratch/bin/pepperpot"
chmod +x "$scratch/bin/pepperpot"
cp -R "$sources/examples" "$scratch/work/examples"
find "$(dirname "$page")" -maxdepth 1 ! -name '*.md' -type f -exec cp {} "$scratch/work" \;
PATH=$scratch/bin:$PATH
export PATH
cd "$scratch/work"

failed=0
# run COMMAND: runs it in the scratch folder; its output goes to $scratch/out.
run() {
    status=0
    sh -c "$1" >"$scratch/printed" 2>&1 </dev/null || status=$?
    tr -d '\r' <"$scratch/printed" >"$scratch/out" # lines of CSV end with CR LF (RFC 4180)
    if [ "$status" -ne 0 ] && [ -z "$fails" ]; then
        echo "$page: exit status $status: $1" >&2
        sed 's/^/    /' "$scratch/out" >&2
        failed=1
    fi
}
# shown LINES: prints the part of the output that the page shows: all of it, lines such as
# "1-6 12", or the lines that a script for `sed -n` selects. A script must select a line.
shown() {
    case $1 in
    '') cat "$scratch/out" ;;
    [0-9]*)
        ${AWK:-awk} -v lines="$1" '
            BEGIN { count = split(lines, part, " ") }
            {
                is_shown = 0
                for (i = 1; i <= count; i++) {
                    if (split(part[i], end, "-") == 1)
                        end[2] = end[1]
                    if (NR >= end[1] + 0 && NR <= end[2] + 0)
                        is_shown = 1
                }
                if (is_shown) print
                else if (!left_out) print "..."
                left_out = !is_shown
            }' "$scratch/out"
        ;;
    *)
        sed -n "$1" "$scratch/out" >"$scratch/part"
        if [ ! -s "$scratch/part" ]; then
            echo "$page: the output has no lines for $1: $command" >&2
            failed=1
        fi
        echo ...
        cat "$scratch/part"
        echo ...
        ;;
    esac
}

state=text lines='' file='' fails='' long=''
while IFS= read -r line || [ -n "$line" ]; do
    case $state in
    text)
        printf '%s\n' "$line"
        case $line in
        '<!-- shown: '*) lines=${line#<!-- shown: } lines=${lines% -->} ;;
        '<!-- file: '*) file=${line#<!-- file: } file=${file% -->} ;;
        '<!-- fails -->') fails=yes ;;
        '<!-- long -->') long=${QUICK-} ;;
        '<!-- run: '*)
            command=${line#<!-- run: }
            run "${command% -->}"
            ;;
        '```console')
            state=console
            [ -z "$long" ] || state=left
            ;;
        '```'?*)
            state=block
            [ -z "$file" ] || : >"$file"
            ;;
        esac
        ;;
    block)
        printf '%s\n' "$line"
        if [ "$line" = '```' ]; then
            state=text file=''
        elif [ -n "$file" ]; then
            printf '%s\n' "$line" >>"$file"
        fi
        ;;
    left)
        printf '%s\n' "$line"
        case $line in
        *' -o '*.png) : >"${line##* -o }.left" ;;
        '```') state=text lines='' long='' ;;
        esac
        ;;
    console)
        case $line in
        '$ '*)
            printf '%s\n' "$line"
            command=${line#$ }
            while case $command in *\\) true ;; *) false ;; esac && IFS= read -r line; do
                printf '%s\n' "$line"
                command=${command%\\}$line
            done
            run "$command"
            shown "$lines"
            ;;
        '```') printf '%s\n' "$line"; state=text lines='' fails='' ;;
        esac
        ;;
    esac
done <"$page"

# Every picture that the page shows must have been made, unless its block was left out.
sed -n 's/.*!\[[^]]*\](\(pictures\/[^)]*\)).*/\1/p' "$page" | sort -u >"$scratch/wanted"
while read -r picture; do
    name=$(basename "$picture")
    [ ! -e "$name.left" ] || continue
    if [ ! -s "$name" ]; then
        echo "$page: no command makes $picture" >&2
        failed=1
    elif [ -n "$pictures" ]; then
        pngquant --force --output "$pictures/$name" 32 "$name" 2>/dev/null ||
            cp "$name" "$pictures/$name"
    fi
done <"$scratch/wanted"
exit "$failed"
