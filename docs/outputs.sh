#!/bin/sh
# outputs.sh PROGRAM SOURCES PAGE.md [PICTURES] - prints a page of the manual with the outputs
# that it shows made anew. With a folder for PICTURES those that the page shows go there.
# With QUICK=yes blocks behind `<!-- long -->` stay as they are.
#
# Commands run in order in one scratch folder. It has examples/ of the sources, and the files that
# are not pages from the folder of the page:
#
#     ```console                      a block of commands and outputs: `$ ` begins a command,
#     $ pepperpot df room.xml         which may go on behind a `\`; what follows is its output
#     ...
#     ```
#     <!-- shown: 1-6 12 -->          before a block: these lines of its outputs are shown, and
#                                     `...` stands for the others; or a script of `sed -n`,
#                                     such as /Criteria/,/^$/p
#     <!-- file: room.xml -->         the block behind it is written to that file
#     <!-- run: COMMAND -->           a command that is not shown
#     <!-- long -->                   before a block that takes seconds
#
# Exit status 1 where a command fails, unless the page has `<!-- fails -->` before its block.
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
# run COMMAND: in the scratch folder; what it prints goes to $scratch/out.
run() {
    status=0
    sh -c "$1" >"$scratch/printed" 2>&1 </dev/null || status=$?
    tr -d '\r' <"$scratch/printed" >"$scratch/out" # lines of CSV end as RFC 4180 has them
    if [ "$status" -ne 0 ] && [ -z "$fails" ]; then
        echo "$page: exit status $status: $1" >&2
        sed 's/^/    /' "$scratch/out" >&2
        failed=1
    fi
}
# The part of what was printed that the page shows: all, lines as "1-6 12", or those that
# `sed -n` prints by a script. A part of nothing is a mistake.
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

# The pictures that the page shows have to be there.
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
