# cli.sh - for tests of the whole program: runs it and tests its output.
#
# To be sourced after tap.sh. $scratch is a temporary folder, removed at the end; $scratch/out and
# $scratch/err are the standard output and error of the last run, $status is its exit status.

pepperpot=$PWD/pepperpot
examples=$(cd "$srcdir/examples" && pwd)
deep=$examples/deep-office.xml
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Symbolising every leak of libraries that tests/lib/lsan.supp suppresses would take half of a
# chart's time under AddressSanitizer.
export ASAN_OPTIONS="symbolize=0:${ASAN_OPTIONS-}"

# some WORDS: every third word, one per line; all words if FULL_SIZE is set, as in
# tests/long/long_full_size.sh.
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

# told: prints the exit status and the first lines of the last run, and fails.
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

# refuses STATUS TEXT WORDS: this status, the text on standard error, and nothing on standard
# output.
refuses() {
    wanted=$1
    text=$2
    shift 2
    run "$@"
    [ $status -eq "$wanted" ] && [ ! -s "$scratch/out" ] &&
        grep -qF -- "$text" "$scratch/err" || told
}

# shows TEXT WORDS: as gives, with the text on standard output.
shows() {
    text=$1
    shift
    gives "$@" && { grep -qF -- "$text" "$scratch/out" || told; }
}

# words FILE.pdf: the text on its pages.
if command -v pdftotext >/dev/null; then
    words() { pdftotext -layout "$1" - | tr '\302\240' '  ' | tr -s ' '; }
else
    words() { :; }
fi
# says FILE.pdf TEXT: the file contains the text; succeeds if pdftotext is not installed.
says() {
    ! command -v pdftotext >/dev/null || words "$1" | tr '\n' ' ' | tr -s ' ' | grep -qF -- "$2" ||
        { words "$1" | head -n 30; return 1; }
}

# too_wide: lines of the output with more than 80 characters, except lines that contain the path of
# an example.
too_wide() {
    # Continuation bytes of UTF-8 do not count as characters.
    LC_ALL=C awk -v files="$examples/" '{ line = $0; gsub(/[\200-\277]/, "", line) }
        length(line) > 80 && !index($0, files)' "$scratch/out"
}

# untidy: lines of the output that are too wide, end with a blank, or contain "nan" or "inf".
untidy() {
    too_wide
    grep -n ' $' "$scratch/out"
    grep -inE '(^|[^a-z])-?(nan|inf)([^a-z]|$)' "$scratch/out"
}

# leftovers: temporary files and folders that the program left in $scratch.
leftovers() {
    find "$scratch" -name '*.pepperpot-*'
}

# same FILE FILE: the files are identical.
same() {
    cmp "$1" "$2"
}

# same_by_threads "N M ..." WORDS: the output is identical with each number of threads; a copy is
# in $scratch/by_threads.
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

# on_full_disk BLOCKS WORDS: like run, but no file can grow beyond this number of blocks, as on a
# full disk; standard output is discarded.
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

# check_words WHAT FILE TEXT...: a check that the text of a PDF contains each of these texts.
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

# simulates PID: succeeds if the process catches SIGTERM and has used a second of CPU time since it
# was first found to do so.
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

# interrupted WORDS: like run, but sends SIGTERM while the simulation is running, on any machine;
# at the latest after two minutes.
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
