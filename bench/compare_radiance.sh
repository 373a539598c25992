#!/bin/sh
# compare_radiance.sh PROGRAM [SCENE ...] - error against processor time of PROGRAM's
# `df --simulate` and of Radiance's rtrace in the same rooms, as lines of Markdown. Scenes:
# deep, street, triangles (a hundred thousand, as leaves before the window); all of them by
# default. Minutes; where Radiance is not on PATH, that is said, and nothing is done.
set -eu
LC_ALL=C
export LC_ALL

if [ $# -lt 1 ]; then
    echo "usage: compare_radiance.sh PROGRAM [SCENE ...]" >&2
    exit 2
fi
pepperpot=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
shift
[ $# -gt 0 ] || set -- deep street triangles
if ! command -v rtrace >/dev/null || ! command -v oconv >/dev/null; then
    echo "Radiance's oconv and rtrace are not on PATH: nothing is compared with them."
    exit 0
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# ---- the rooms, with as many points as are timed ----

points() { # COLUMNS ROWS WIDTH DEPTH: a grid over a plan
    awk -v n="$1" -v m="$2" -v w="$3" -v d="$4" 'BEGIN {
        for (j = 0; j < m; j++) for (i = 0; i < n; i++)
            printf "<point x=\"%.6g\" y=\"%.6g\"/>\n", (i + 0.5) * w / n, (j + 0.5) * d / m }'
}

deep_office() {
    echo '<room version="1" name="Deep office"><plan width="3" depth="9" height="2.7"/>
<finishes floor="0.2" walls="0.5" ceiling="0.7"/>
<window wall="south" left="0.2" sill="0.8" width="2.6" height="1.5" glazing="clear-single"/>
<working-plane height="0.85"/>'
}

leaves() { # 100,000 of them, as trees before the window
    awk 'BEGIN { srand(1)
        for (i = 0; i < 100000; i++) {
            x = 23 * rand() - 10; y = -3 - 17 * rand(); z = 8 * rand()
            for (k = 0; k < 3; k++)
                printf "v %.3f %.3f %.3f\n", x + 0.2 * rand(), y + 0.2 * rand(), z + 0.2 * rand()
            print "f", 3 * i + 1, 3 * i + 2, 3 * i + 3
        } }'
}

room() {
    case $1 in
    deep)
        deep_office
        points 12 32 3 9
        ;;
    street)
        echo '<room version="1" name="Street"><plan width="3.7" depth="4.9" height="2.6"/>
<finishes floor="0.3" walls="0.6" ceiling="0.8"/>
<window wall="south" left="0.9" sill="0.8" width="1.9" height="1.5"/>
<block x="-43" y="-20" width="91" depth="11" height="13.7" reflectance="0.25"/>
<working-plane height="0.85"/>'
        points 6 8 3.7 4.9
        ;;
    triangles)
        deep_office
        leaves >"$scratch/leaves.obj"
        echo '<mesh file="leaves.obj" reflectance="0.3"/>'
        points 4 6 3 9
        ;;
    *)
        echo "compare_radiance.sh: there is no scene \"$1\"" >&2
        return 1
        ;;
    esac
    echo '</room>'
}

# What is run of rtrace: options but -ad and how many -ad, for paths without a cache; every
# how many points are compared; rays of the reference.
choices() {
    case $1 in
    deep) few=512 many=2048 every=8 fine=32768 ;;
    street) few=1024 many=4096 every=1 fine=32768 ;;
    triangles) few=256 many=1024 every=1 fine=16384 ;;
    esac
}
paths='-ab 22 -lr 0 -as 0 -aa 0 -lw 1e-7'
cut_paths='-ab 8 -lr -8 -as 0 -aa 0 -lw 1e-4'
common='-ab 5 -ad 1024 -as 256 -aa 0.1 -ar 256'
# -ar is in terms of the scene, which is as wide as its ground: 256 keeps records metres
# apart.
fine_cache='-ab 8 -ad 1024 -as 256 -aa 0.1 -ar 100000'
limit=90        # seconds that a run of rtrace may take, but for the reference
seeds='1 2 3 4' # of ours, whose errors and times are taken together
fine_seeds='101 102 103 104 105 106 107 108' # of our reference

# ---- running ----

# seconds OUT IN COMMAND ...: its processor time, user's and system's.
seconds() {
    out=$1 in=$2
    shift 2
    ("$@" <"$in" >"$out" && times) | awk '
        { last = $0 }
        END {
            n = split(last, parts, " ")
            for (i = 1; i <= n; i++) {
                split(parts[i], t, "m")
                sum += 60 * t[1] + t[2]
            }
            printf "%.3f\n", sum
        }'
}

# factors IN OUT: rtrace's irradiances as daylight factors, one a line.
factors() {
    horizontal=$(sed -n 's/^horizontal=\([0-9.]*\).*/\1/p' "$scratch/scene/daylight_factors.sh")
    awk -v h="$horizontal" '{ print (0.265 * $1 + 0.670 * $2 + 0.065 * $3) / h }' "$1" >"$2"
}

# traced OUT ERROR SEED FILE: ours, one a line; prints the seconds.
traced() {
    taken=$(seconds "$scratch/csv" /dev/null "$pepperpot" df -q -m brs-table --no-bands --simulate -j 1 \
        --error "$2" --seed "$3" --format csv "$4")
    awk -F, '/,point,/ && $(NF - 5) == "df" && $(NF - 4) == "traced" { print $(NF - 3) / 100 }' \
        "$scratch/csv" >"$1"
    echo "$taken"
}

# rays OUT POINTS OPTIONS ...: rtrace's, one a line; prints the seconds, 0 where it was stopped.
rays() {
    to=$1 from=$2
    shift 2
    (cd "$scratch/scene" && ulimit -t "$limit" &&
        seconds "$scratch/irradiance" "$from" rtrace -w -h -I -dt 0 "$@" scene.oct)
    factors "$scratch/irradiance" "$to"
}

# reference: ours, one a line: the mean of the fine runs, and the square of its standard error by
# how far they are apart; prints the seconds.
reference() {
    for seed in $fine_seeds; do
        traced "$scratch/fine.$seed" 0.2% "$seed" "$scratch/few.xml"
    done | awk '{ sum += $1 } END { print sum }'
    paste -d' ' "$scratch"/fine.* | awk '
        { sum = squares = 0
          for (i = 1; i <= NF; i++) sum += $i / NF
          for (i = 1; i <= NF; i++) squares += ($i - sum) ^ 2
          print sum, squares / (NF - 1) / NF }' >"$scratch/ours"
}

# off FOUND ...: the root of the mean square of the relative error, in per cent: against our
# reference, whose own noise is taken off; then against rtrace's with its noise.
off() {
    for found; do
        awk -v every="$every" 'NR % every == 1 || every == 1' "$found" |
            paste -d' ' - "$scratch/ours" "$scratch/theirs"
    done | awk '
        { ours += (($1 - $2) ^ 2 - $3) / $2 ^ 2; theirs += ($1 / $4 - 1) ^ 2 }
        END { printf "%.3f %.3f\n", 100 * sqrt(ours > 0 ? ours / NR : 0),
            100 * sqrt(theirs / NR) }'
}

# row WHOSE WORDS SECONDS FOUND ...: a line of the table, and of the list of runs.
row() {
    whose=$1 words=$2 taken=$3
    shift 3
    errors=$(off "$@")
    # shellcheck disable=SC2086 # two numbers
    printf '| %s | %.2f | %s | %s |\n' "$words" "$taken" $errors
    echo "$whose $taken $errors" >>"$scratch/runs"
}

# ---- a scene ----

compare() {
    scene=$1
    choices "$scene"
    room "$scene" >"$scratch/room.xml"
    awk -v every="$every" '/^<point/ && n++ % every { next } { print }' "$scratch/room.xml" \
        >"$scratch/few.xml"
    rm -rf "$scratch/scene" "$scratch/runs"
    "$pepperpot" export -q --to radiance -o "$scratch/scene" "$scratch/room.xml"
    all=$scratch/scene/points.pts
    (cd "$scratch/scene" && ./daylight_factors.sh -w -ab 0 >/dev/null)
    count=$(awk 'END { print NR }' "$all")
    awk -v every="$every" 'NR % every == 1 || every == 1' "$all" >"$scratch/few.pts"
    number=$(awk 'END { print NR }' "$scratch/few.pts")

    ours_s=$(reference)
    theirs_s=$(limit=600 && rays "$scratch/theirs" "$scratch/few.pts" $paths -ad "$fine")
    apart=$(paste -d' ' "$scratch/ours" "$scratch/theirs" |
        awk '{ d = $1 / $3 - 1; s += d; q += d * d; own += $2 / $1 ^ 2 }
            END { printf "%+.2f ± %.2f %% in the mean, %.2f %% RMS, of which ours has %.2f %%",
                100 * s / NR, 100 * sqrt((q - s * s / NR) / (NR - 1) / NR), 100 * sqrt(q / NR),
                100 * sqrt(own / NR) }')

    printf '\n### %s: %d points\n\n' "$(sed -n 's/.*<room [^>]*name="\([^"]*\)".*/\1/p' \
        "$scratch/room.xml")$([ "$scene" = triangles ] && echo ', 100,000 triangles')" "$count"
    printf 'References at %d of the points: the mean of eight runs of `df --simulate --error 0.2%%`\n' \
        "$number"
    printf '(%.1f s) and `rtrace %s -ad %d` (%.1f s);\nthey differ by %s. ' \
        "$ours_s" "$paths" "$fine" "$theirs_s" "$apart"
    printf 'Error: RMS, relative, per cent;\nagainst ours its own noise is taken off.\n\n'
    echo '| run | processor s | error | against rtrace |'
    echo '| --- | ---: | ---: | ---: |'
    for error in 1% 0.4%; do
        for seed in $seeds; do
            traced "$scratch/found.$seed" "$error" "$seed" "$scratch/room.xml"
        done | awk '{ sum += $1 } END { print sum / NR }' >"$scratch/taken"
        row "ours $error" "\`df --simulate --error $error\`, the mean of four" \
            "$(cat "$scratch/taken")" "$scratch"/found.[1-4]
    done
    # shellcheck disable=SC2086 # options are several words
    for options in "$paths -ad $few" "$paths -ad $many" "$cut_paths -ad $many" "$common" \
        "$fine_cache"; do
        taken=$(rays "$scratch/found" "$all" $options)
        if [ "$taken" = 0.000 ]; then
            printf '| `rtrace %s` | not done after %d s | | |\n' "$options" "$limit"
            continue
        fi
        case $options in *'-aa 0 '*) kind=paths ;; *) kind=cache ;; esac
        row "$kind" "\`rtrace $options\`" "$taken" "$scratch/found"
    done
    ratios
}

# What equal errors cost: an unbiased run's time goes with the inverse square of its error; a
# run through rtrace's cache counts as it is, where its error is that or less.
ratios() {
    echo
    awk '
        $1 == "ours" { t[++n] = $3; e[n] = $4; wanted[n] = $2 }
        $1 == "paths" { k++; rt[k] = $2; re[k] = $3 }
        $1 == "cache" { c++; ct[c] = $2; ce[c] = $3 }
        END {
            for (i = 1; i <= n; i++) {
                target = wanted[i] + 0
                own = t[i] * (e[i] / target) ^ 2
                best = -1
                for (j = 1; j <= k; j++) {
                    s = rt[j] * (re[j] / target) ^ 2
                    if (best < 0 || s < best) best = s
                }
                from = "paths"
                for (j = 1; j <= c; j++)
                    if (ce[j] <= target && ct[j] < best) { best = ct[j]; from = "its cache" }
                if (own > 0)
                    printf "At an error of %g %%: %.3g s and, by rtrace at its best (%s), %.3g s: %.0f times.\n",
                        target, own, best < 0 ? "none" : from, best, best / own
                else # the noise of the reference is larger than it
                    printf "At an error of %g %%: our error is below what the reference tells.\n", target
            }
        }' "$scratch/runs"
}

for scene; do
    compare "$scene"
done
