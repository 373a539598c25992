#!/bin/sh
# Several ranks under mpirun: identical output to a single process, messages from one rank only,
# and a rank that is killed.

. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

if ! command -v mpirun >/dev/null || [ ! -f .libs/pepperpot-mpi.so ]; then
    echo '1..0 # SKIP there is no mpirun, or it was built without MPI'
    exit 0
fi

# Open MPI does not free all of its memory.
export ASAN_OPTIONS="detect_leaks=0:$ASAN_OPTIONS"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# ranks N WORDS: runs the program as N ranks.
ranks() {
    count=$1
    shift
    timeout 120 mpirun --oversubscribe -n "$count" "$pepperpot" "$@" \
        >"$scratch/out" 2>"$scratch/err" </dev/null
    status=$?
}

# lines WORDS: prints one word per line. Unquoted expansions below are split at line ends only,
# since the folder of the examples may contain blanks.
lines() {
    printf '%s\n' "$@"
}
IFS='
'
files=$(lines "$examples/office.xml" "$deep" "$examples/classroom.xml" "$examples/l-shaped.xml")
batch=$(lines "$files" --simulate --samples 8 --format json)

the_same_bytes_of_df() {
    run df $batch
    [ $status -eq 0 ] || told || return 1
    cp "$scratch/out" "$scratch/alone"
    for n in 1 2 4; do
        ranks $n df $batch
        [ $status -eq 0 ] && cmp "$scratch/alone" "$scratch/out" || told || return 1
    done
}

the_same_bytes_of_assess() {
    run assess $files --samples 8 --format json
    [ $status -eq 0 ] || told || return 1
    cp "$scratch/out" "$scratch/alone"
    ranks 3 assess $files --samples 8 --format json --threads 2
    [ $status -eq 0 ] && cmp "$scratch/alone" "$scratch/out" || told
}

the_same_bytes_of_validate() {
    few=$(lines rooms "$deep" "$examples/office.xml" --samples 8 --methods exact+bre \
        --format json)
    run validate $few
    [ $status -eq 0 ] || told || return 1
    cp "$scratch/out" "$scratch/alone"
    for n in 2 3; do
        ranks $n validate $few --page "$scratch/$n.html"
        [ $status -eq 0 ] && cmp "$scratch/alone" "$scratch/out" || told || return 1
    done
    cmp "$scratch/2.html" "$scratch/3.html"
}

# Only rank 0 prints results of its own.
a_suite_is_run_once() {
    run validate analytic --format csv
    cp "$scratch/out" "$scratch/alone"
    ranks 2 validate analytic --format csv
    [ $status -eq 0 ] && cmp "$scratch/alone" "$scratch/out" || told
}

# In place of Radiance, two programs that return an irradiance of 1 everywhere.
the_same_bytes_beside_radiance() {
    mkdir -p "$scratch/bin"
    printf '#!/bin/sh\n' >"$scratch/bin/oconv"
    printf '#!/bin/sh\nwhile read -r line; do echo 1 1 1; done\n' >"$scratch/bin/rtrace"
    chmod +x "$scratch/bin/oconv" "$scratch/bin/rtrace"
    (
        PATH=$scratch/bin:$PATH
        for words in radiance "$(lines --against radiance)"; do
            run validate $words $batch_of_two
            cp "$scratch/out" "$scratch/alone"
            ranks 2 validate $words $batch_of_two
            cmp "$scratch/alone" "$scratch/out" || told || return 1
        done
    )
    grep -q '"against": "radiance"' "$scratch/out" || told
}
batch_of_two=$(lines "$deep" "$examples/office.xml" --samples 8 --format json)

# simulates PID: succeeds if the process has used a second of CPU time; it simulates by then.
simulates() {
    ticks=$(sed 's/.*) //' "/proc/$1/stat" 2>/dev/null | cut -d' ' -f12)
    [ "${ticks:-0}" -ge "$(getconf CLK_TCK)" ]
}

# Rank 0 receives a signal while it simulates: the results so far are printed, marked as
# unfinished.
a_stop_prints_what_is_there() {
    timeout 60 mpirun --oversubscribe -n 2 "$pepperpot" df --simulate --error 0.001% \
        --time 50 --format json $files >"$scratch/out" 2>"$scratch/err" </dev/null &
    job=$!
    zero=
    until [ -n "$zero" ]; do
        kill -0 $job 2>/dev/null || told || return 1
        sleep 0.05
        mpirun=$(pgrep -P $job) && zero=$(pgrep -P "$mpirun" pepperpot | head -n 1)
    done
    tries=0
    until simulates "$zero" || [ $tries -eq 400 ]; do
        sleep 0.1
        tries=$((tries + 1))
    done
    kill -INT "$zero"
    wait $job
    status=$?
    [ $status -eq 130 ] && [ "$(grep -c '"name":' "$scratch/out")" -ge 4 ] &&
        grep -q '"finished": false' "$scratch/out" || told
}

one_rank_writes() {
    run df "$deep"
    cp "$scratch/out" "$scratch/alone"
    ranks 4 df "$deep" -o "$scratch/file"
    [ $status -eq 0 ] && [ ! -s "$scratch/out" ] || told || return 1
    cmp "$scratch/alone" "$scratch/file" || return 1
    run size --help
    cp "$scratch/out" "$scratch/alone"
    ranks 3 size --help
    cmp "$scratch/alone" "$scratch/out"
}

one_rank_speaks() {
    ranks 4 df "$deep" "$scratch/none.xml"
    [ $status -eq 1 ] || [ $status -eq 3 ] || told || return 1
    [ "$(grep -c 'none.xml' "$scratch/err")" -eq 1 ] || told
}

the_same_bytes_of_an_atlas() {
    few=$(lines atlas --rooms 5 --error 20% --quiet)
    run $few -o "$scratch/one.csv"
    for n in 2 4; do
        ranks $n $few -o "$scratch/$n.csv"
        [ $status -eq 0 ] && cmp "$scratch/one.csv" "$scratch/$n.csv" || told || return 1
    done
}

# The last rank is killed after the first room is complete, so that all ranks are working. Only the
# file is tested: after the death of a rank mpirun itself does not always end, and is ended once
# the file is complete.
a_rank_may_be_killed() {
    run atlas --rooms 12 --error 20% --quiet -o "$scratch/never.csv"
    timeout 120 mpirun --oversubscribe --enable-recovery -n 3 "$pepperpot" atlas \
        --rooms 12 --error 20% --quiet -o "$scratch/killed.csv" \
        >"$scratch/out" 2>"$scratch/err" </dev/null &
    job=$!
    until grep -q '^0,-1,' "$scratch/killed.csv" 2>/dev/null; do
        kill -0 $job 2>/dev/null || told || return 1
        sleep 0.05
    done
    victim=$(pgrep -P "$(pgrep -P $job)" | tail -n 1)
    [ -n "$victim" ] && kill -9 "$victim" || return 1
    until cmp -s "$scratch/never.csv" "$scratch/killed.csv" || ! kill -0 $job 2>/dev/null; do
        sleep 0.2
    done
    kill $job 2>/dev/null
    wait $job
    status=$?
    cmp "$scratch/never.csv" "$scratch/killed.csv" || told
}

check '1, 2 and 4 ranks give the bytes of one process' the_same_bytes_of_df
check 'so does assess, with two threads each' the_same_bytes_of_assess
check 'so does validate beside Radiance, whose programs each rank runs' \
    the_same_bytes_beside_radiance
check 'so does validate, which deals out rooms and the worlds of their methods' \
    the_same_bytes_of_validate
check 'and its suites of known answers' a_suite_is_run_once
check 'a stop prints what is there' a_stop_prints_what_is_there
check 'rank 0 alone writes, also of a command that does not deal' one_rank_writes
check 'a mistake is told once, with its exit status' one_rank_speaks
check 'so does the atlas' the_same_bytes_of_an_atlas
check 'a rank that is killed costs nothing but time' a_rank_may_be_killed
tap_done
