#!/bin/sh
# The lumen method, with tables supplied by the user.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

own="$srcdir/tables/lumen_sidelight.csv"
check "the lumen method answers for the deep office" \
    shows '"lumen": { "value"' df --methods lumen --no-bands --format json "$deep"
cp "$scratch/out" "$scratch/builtin"
check "the program's own table as a file gives the same bytes" \
    gives df --methods lumen --no-bands --format json --lumen-table "$own" \
    --lumen-table "$srcdir/tables/lumen_toplight.csv" "$deep"
check "to the last" same "$scratch/builtin" "$scratch/out"
check "its sum is set out" shows "coefficient of utilization for the sky" \
    df --explain --points 1.5,3 --methods lumen "$deep"

printf 'Ev_over_Eh,depth_over_window_height,position_percent,2\n0.4,6,10,x\n' >"$scratch/bad"
check "a wrong table is refused with its line" refuses 1 "bad:2: a coefficient is" \
    df --lumen-table "$scratch/bad" "$deep"
check "one that is not there too" refuses 1 "No such file" \
    df --lumen-table "$scratch/none" "$deep"
check "a third one is too many" refuses 2 "at most two files" \
    df --lumen-table "$own" --lumen-table "$own" --lumen-table "$own" "$deep"
printf 'Ev_over_Eh,depth_over_window_height,position_percent,2\n0.4,5,10,.1\n' >"$scratch/short"
check "a table that does not reach the room gives no number" \
    shows "covers 5 to 5" df --methods lumen --lumen-table "$scratch/short" "$deep"
tap_done
