# cli.sh - for the end-to-end tests: runs the program and looks at its output.
#
# Sourced behind tap.sh. $scratch is a directory of our own, removed at the end; out and
# err in it are the standard output and error of the last run, $status is its status.

pepperpot=$PWD/pepperpot
examples=$(cd "$srcdir/examples" && pwd)
deep=$examples/deep-office.xml
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Under AddressSanitizer half of a chart's time went to the names of calls, which it looks up for
# every leak of the libraries that tests/lib/lsan.supp passes by module.
export ASAN_OPTIONS="symbolize=0:${ASAN_OPTIONS-}"

# some WORDS: every third of them, each on a line; all with FULL_SIZE set, as
# tests/long/long_full_size.sh has it.
some() {
    some_left=0
    for some_word; do
        [ -z "${FULL_SIZE-}" ] && [ $some_left -ne 0 ] || echo "$some_word"
        some_left=$(((some_left + 1) % 3))
    done
}

# run WORDS: runs the program with these arguments.
run() {
    "$pepperpot" "$@" >"$scratch/out" 2>"$scratch/err" </dev/null
    status=$?
}

# told: prints the last run's status and first lines for the log, and fails.
told() {
    echo "status $status"
    head -n 5 "$scratch/out" "$scratch/err"
    return 1
}

# quietly WORDS: status 0, and nothing on standard output or error.
quietly() {
    run "$@"
    [ $status -eq 0 ] && [ ! -s "$scratch/out" ] && [ ! -s "$scratch/err" ] || told
}

# gives WORDS: status 0, something on standard output, nothing on standard error.
gives() {
    run "$@"
    [ $status -eq 0 ] && [ -s "$scratch/out" ] && [ ! -s "$scratch/err" ] || told
}

# refuses STATUS TEXT WORDS: that status, the text on standard error, nothing on standard
# output.
refuses() {
    wanted=$1
    text=$2
    shift 2
    run "$@"
    [ $status -eq "$wanted" ] && [ ! -s "$scratch/out" ] &&
        grep -qF -- "$text" "$scratch/err" || told
}

# shows TEXT WORDS: gives, and the text is on standard output.
shows() {
    text=$1
    shift
    gives "$@" && { grep -qF -- "$text" "$scratch/out" || told; }
}

# words FILE.pdf: what is written on its pages.
if command -v pdftotext >/dev/null; then
    words() { pdftotext -layout "$1" - | tr '\302\240' '  ' | tr -s ' '; }
else
    words() { :; }
fi
# says FILE.pdf TEXT: it is written there, where that can be read.
says() {
    ! command -v pdftotext >/dev/null || words "$1" | tr '\n' ' ' | tr -s ' ' | grep -qF -- "$2" ||
        { words "$1" | head -n 30; return 1; }
}

# too_wide: lines of the output of more than 80 characters; those that name a file are as
# long as its path.
too_wide() {
    # The bytes behind the first of a character are none.
    LC_ALL=C awk -v files="$examples/" '{ line = $0; gsub(/[\200-\277]/, "", line) }
        length(line) > 80 && !index($0, files)' "$scratch/out"
}

# untidy: lines of the output that are too wide, end with a blank, or hold a NaN.
untidy() {
    too_wide
    grep -n ' $' "$scratch/out"
    grep -inE '(^|[^a-z])-?(nan|inf)([^a-z]|$)' "$scratch/out"
}

# leftovers: temporary files and directories that the program left in $scratch.
leftovers() {
    find "$scratch" -name '*.pepperpot-*'
}

# same FILE FILE: byte for byte.
same() {
    cmp "$1" "$2"
}

# same_by_threads "N M ..." WORDS: the output is the same with each number of threads; a
# copy is in $scratch/by_threads.
same_by_threads() {
    numbers=$1
    shift
    rm -f "$scratch/by_threads"
    for threads in $numbers; do
        gives "$@" --threads "$threads" || return 1
        [ -e "$scratch/by_threads" ] || cp "$scratch/out" "$scratch/by_threads"
        same "$scratch/by_threads" "$scratch/out" || return 1
    done
}

# on_full_disk BLOCKS WORDS: like run, but no file can grow beyond that many blocks, as on
# a full disk; standard output is not kept.
on_full_disk() {
    blocks=$1
    shift
    : >"$scratch/out"
    printed=$(
        trap '' XFSZ # writes fail instead of ending the program
        ulimit -f "$blocks"
        exec "$pepperpot" "$@" 2>&1 >/dev/null </dev/null
    )
    status=$?
    printf '%s' "$printed" >"$scratch/err"
}

# check_words WHAT FILE TEXT...: a check that the texts stand in a PDF, as text.
check_words() {
    what=$1
    file=$2
    shift 2
    if command -v pdftotext >/dev/null; then
        check "$what" has_words "$file" "$@"
    else
        skip "$what" "no pdftotext"
    fi
}
has_words() {
    pdftotext "$1" "$scratch/words.txt" || return 1
    shift
    for words; do
        grep -q -- "$words" "$scratch/words.txt" || {
            echo "no \"$words\""
            return 1
        }
    done
}

# simulates PID: does that run catch signals by now, and has it worked for a second since?
simulates() {
    caught=$(sed -n 's/^SigCgt:.*\(....\)$/\1/p' "/proc/$1/status")
    busy=$(awk '{ print $14 + $15 }' "/proc/$1/stat")
    case $caught in
    [4-7c-f]*) # bit 15, SIGTERM
        : "${begun:=$busy}"
        [ "$busy" -gt $((begun + 100)) ]
        ;;
    *) false ;;
    esac
}

# interrupted WORDS: like run, but SIGTERM is sent once the simulation is well under way,
# however slow the machine; after two minutes in any case.
interrupted() {
    "$pepperpot" "$@" >"$scratch/out" 2>"$scratch/err" </dev/null &
    begun= tries=0
    until simulates $! || [ $tries -eq 1200 ]; do
        sleep 0.1
        tries=$((tries + 1))
    done
    kill -TERM $!
    wait $!
    status=$?
}
