#!/bin/sh
# df with several engines: their results and differences.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

here='--points=1.5,2;1.5,7'
check "photons stand beside paths" shows "photons: by photons from the openings" \
    df -s --engine path,photons -m exact+bre --error 2% "$here" "$deep"
check "with their distance in standard errors" grep -q "diff./s.e." "$scratch/out"

# Differences of at most four standard errors, exceeded once in 16,000 cases.
check "as JSON" gives df -s --engine path,photons,cache -m exact+bre --error 2% "$here" \
    --format json "$deep"
check "and agree with them" sh -c "tr ',{}' '\\n\\n\\n' <'$scratch/out' | awk -F: '
    /\"apart\"/ { n++; if (\$2 > 4 || \$2 < -4) bad = 1 } END { exit bad || n < 6 }'"
check "the same by 1, 2 and 4 threads" same_by_threads "1 2 4" \
    df -s --engine photons --samples 32 "$here" --format csv "$deep"
check "photons alone are what hand figures are held against" \
    shows "off, %" df -s --engine photons -m exact+bre --error 3% "$here" "$deep"
# Discs with a diameter of 1 m receive enough photons within seconds.
check "counted on discs" gives df -s --engine photons --sensor 0.5 --error 4% "$here" \
    --format csv "$deep"
check "which are near what the points get" sh -c "awk -F, '\$11 == \"photons\" &&
    \$10 == \"df\" && \$3 == \"point\" { n++; v[n] = \$12 }
    END { exit !(n == 2 && v[1] > 5 && v[1] < 6.2 && v[2] > 0.36 && v[2] < 0.5) }' '$scratch/out'"
check "radiosity says what its error is" shows "by finite elements, ± the error bound of the mesh refinement" \
    df -s --engine radiosity "$here" "$deep"
check "and is near the paths" gives df -s --engine path,radiosity --error 2% "$here" \
    --format csv "$deep"
check "at both points" sh -c "awk -F, '\$10 == \"df\" && \$3 == \"point\" {
    if (\$11 == \"traced\") t[++n] = \$12
    if (\$11 == \"radiosity\") r[++m] = \$12 }
    END { for (i = 1; i <= 2; i++) if (r[i] < 0.95 * t[i] || r[i] > 1.05 * t[i]) exit 1
          exit !(n == 2 && m == 2) }' '$scratch/out'"
check "radiosity is the same by 1, 2 and 4 threads" same_by_threads "1 2 4" \
    df -s --engine radiosity "$here" --format csv "$deep"
check "paths have no discs" refuses 2 "--sensor needs --engine photons" \
    df -s --sensor 0.2 "$deep"
check "a disc has a radius" refuses 2 "0.001 to 10 m" \
    df -s --engine photons --sensor 0 "$deep"
check "an engine that there is not" refuses 2 "path, cache, photons, radiosity or plain" \
    df -s --engine rays "$deep"

# A suite that compares the engines room by room.
check "a suite of all engines" gives validate engines --samples 64 "$deep" \
    --format csv
check "holds photons, radiosity and cache against paths" sh -c \
    "grep -c ',photons,' '$scratch/out' | grep -qx 18 && grep -c ',cached,' '$scratch/out' | grep -qx 18"
check "without hand methods" refuses 2 "engines compares only simulations" \
    validate engines -m bre "$deep"
tap_done
