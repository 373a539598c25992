# cli.sh - for the end-to-end tests: runs the program and looks at what it says.
#
# Sourced behind tap.sh. $scratch is a directory of our own, gone at the end.

pepperpot=$PWD/pepperpot
examples=$(cd "$srcdir/examples" && pwd)
deep=$examples/deep-office.xml
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# run WORDS: the program's standard output and error go to files, its status to $status.
run() {
    "$pepperpot" "$@" >"$scratch/out" 2>"$scratch/err" </dev/null
    status=$?
}

# what happened, for the log
told() {
    echo "status $status"
    head -n 5 "$scratch/out" "$scratch/err"
    return 1
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

same() {
    cmp "$1" "$2"
}
