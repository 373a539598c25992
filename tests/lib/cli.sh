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

# too_wide: lines of the output of more than 80 characters; those that name a file are as
# long as its path.
too_wide() {
    awk -v files="$examples/" 'length > 80 && !index($0, files)' "$scratch/out"
}

same() {
    cmp "$1" "$2"
}

# simulates PID: does it watch for signals by now, and has worked for a second since?
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

# interrupted WORDS: like run, but the program is ended once its simulation is well under
# way, however slow the machine; after two minutes whatever it does.
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
