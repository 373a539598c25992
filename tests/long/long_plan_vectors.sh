#!/bin/sh
# The contours in plans of all examples, by every method that a plan can show and by simulation,
# are at the levels that df calculates: 200 points each. ROOMS=FOLDER: also tests the rooms in this
# folder.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/plan_vectors.sh"

for room in "$examples"/*.xml ${ROOMS:+"$ROOMS"/*.xml}; do
    # Rooms of a building need an option each; the first room is enough.
    set --
    off_y=
    case $room in */workshop.xml) off_y="4 8" ;; esac
    first=$(sed -n 's/.*<room name="\([^"]*\)".*/\1/p' "$room" | head -n 1)
    ! grep -q "<building" "$room" || set -- --room "$first"
    for by in exact exact+bre exact+split-flux exact+sphere brs-table+bre \
        protractor+bre traced; do
        if ! "$pepperpot" chart plan -m ${by%traced} -o "$scratch/try.svg" "$@" "$room" \
            2>"$scratch/err" && [ $by != traced ]; then
            grep -q "cannot be drawn\|covered\|: the " "$scratch/err" ||
                check "$by of $(basename "$room") is drawn or refused with reason" false
            continue
        fi
        check "$by of $(basename "$room")" agrees $by "$room" "$@"
    done
done

tap_done
