#!/bin/sh
# The contours of a plan, read back from its drawing, are at the levels that df calculates.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/plan_vectors.sh"

places=60
for methods in exact exact+bre brs-table+bre; do
    check "deep office by $methods" agrees $methods "$deep"
done
check "an L-shaped room" agrees exact+bre "$examples/l-shaped.xml"
check "roof windows, by the pair that stands in" \
    agrees exact+split-flux "$examples/studio.xml"
places=30
check "traced" agrees traced "$deep" --error 4%

tap_done
