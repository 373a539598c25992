#!/bin/sh
# compare_radiance.sh PROGRAM [SCENE ...] - error against processor time of PROGRAM's `df
# --simulate` and of Radiance in the same rooms, as lines of Markdown. Scenes: deep, street,
# triangles (a hundred thousand, as leaves in front of the window), balcony, well, attic, classroom;
# all of them by default. Takes half an hour. If Radiance is not on PATH, it only prints a note.
set -eu
LC_ALL=C
export LC_ALL

if [ $# -lt 1 ]; then
    echo "usage: compare_radiance.sh PROGRAM [SCENE ...]" >&2
    exit 2
fi
pepperpot=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
shift
[ $# -gt 0 ] || set -- deep street triangles balcony well attic classroom
for program in oconv rtrace mkillum; do
    command -v $program >/dev/null && continue
    echo "Radiance's $program is not on PATH: nothing is compared with it."
    exit 0
done
# shellcheck source=bench/expert_radiance.sh
. "$(dirname "$0")/expert_radiance.sh"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# ---- the rooms, with the points that are timed ----

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

leaves() { # 100,000 triangles, as trees in front of the window
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
    balcony)
        echo '<room version="1" name="Under a balcony"><site ground-level="-9"/>
<plan width="4.2" depth="6" height="2.6"/>
<finishes floor="0.3" walls="0.7" ceiling="0.8"/>
<window wall="south" left="0.6" sill="0.1" width="3" height="2.2" glazing="low-e-double"/>
<block x="0" y="-1.7" base="2.6" width="4.2" depth="1.5" height="0.25" reflectance="0.4"/>
<block x="0" y="-1.7" base="-0.25" width="4.2" depth="1.5" height="0.25" reflectance="0.4"/>
<surface reflectance="0.5"><vertex x="0" y="-1.7" z="0"/><vertex x="4.2" y="-1.7" z="0"/>
<vertex x="4.2" y="-1.7" z="1.1"/><vertex x="0" y="-1.7" z="1.1"/></surface>
<block x="-12" y="-29" width="30" depth="12" height="28" reflectance="0.35"/>
<working-plane height="0.85"/>'
        points 4 6 4.2 6
        ;;
    well)
        echo '<room version="1" name="At a light well"><site ground-level="-3.2"/>
<plan width="3" depth="3.6" height="2.8"/>
<finishes floor="0.2" walls="0.6" ceiling="0.8"/>
<window wall="south" left="0.9" sill="0.95" width="1.2" height="1.5" reveal="0.2"/>
<block x="-10" y="-4" width="10" depth="4" height="17" reflectance="0.7"/>
<block x="3" y="-4" width="10" depth="4" height="17" reflectance="0.7"/>
<block x="-10" y="-14" width="23" depth="10" height="17" reflectance="0.7"/>
<block x="-10" y="0.3" width="23" depth="8" base="2.8" height="11" reflectance="0.7"/>
<working-plane height="0.85"/>'
        points 4 6 3 3.6
        ;;
    attic)
        echo '<room version="1" name="Attic"><site ground-level="-6"/><envelope>
<face role="floor" name="floor"><vertex x="0" y="0" z="0"/><vertex x="5" y="0" z="0"/>
<vertex x="5" y="5" z="0"/><vertex x="0" y="5" z="0"/></face>
<face role="wall" name="south"><vertex x="0" y="0" z="0"/><vertex x="0" y="0" z="1"/>
<vertex x="5" y="0" z="1"/><vertex x="5" y="0" z="0"/></face>
<face role="wall" name="east"><vertex x="5" y="0" z="0"/><vertex x="5" y="0" z="1"/>
<vertex x="5" y="5" z="4"/><vertex x="5" y="5" z="0"/></face>
<face role="wall" name="north"><vertex x="0" y="5" z="0"/><vertex x="5" y="5" z="0"/>
<vertex x="5" y="5" z="4"/><vertex x="0" y="5" z="4"/></face>
<face role="wall" name="west"><vertex x="0" y="0" z="0"/><vertex x="0" y="5" z="0"/>
<vertex x="0" y="5" z="4"/><vertex x="0" y="0" z="1"/></face>
<face role="ceiling" name="slope"><vertex x="0" y="0" z="1"/><vertex x="0" y="5" z="4"/>
<vertex x="5" y="5" z="4"/><vertex x="5" y="0" z="1"/></face></envelope>
<finishes floor="0.3" walls="0.8" ceiling="0.8"/>
<opening glazing="low-e-double" frame-factor="0.7"><vertex x="0.8" y="1" z="1.6"/>
<vertex x="0.8" y="2" z="2.2"/><vertex x="1.8" y="2" z="2.2"/><vertex x="1.8" y="1" z="1.6"/>
</opening>
<opening glazing="low-e-double" frame-factor="0.7"><vertex x="3.2" y="1" z="1.6"/>
<vertex x="3.2" y="2" z="2.2"/><vertex x="4.2" y="2" z="2.2"/><vertex x="4.2" y="1" z="1.6"/>
</opening>
<working-plane height="0.7"/>'
        points 4 6 5 5
        ;;
    classroom)
        echo '<room version="1" name="Classroom"><plan width="8.4" depth="7.2" height="3.1"/>
<finishes floor="0.25" walls="0.65" ceiling="0.8"/>'
        for left in 0.3 2.4 4.5 6.6; do
            echo "<window wall=\"south\" left=\"$left\" sill=\"0.9\" width=\"1.5\" height=\"2\"
glazing=\"clear-double\" frame-factor=\"0.8\" reveal=\"0.2\"/>"
        done
        echo '<block x="-20" y="-34" width="50" depth="12" height="10" reflectance="0.3"/>
<working-plane height="0.75"/>'
        points 8 6 8.4 7.2
        ;;
    *)
        echo "compare_radiance.sh: there is no scene \"$1\"" >&2
        return 1
        ;;
    esac
    echo '</room>'
}

# choices SCENE: sets the numbers of -ad for paths without a cache, the step from one compared point
# to the next, and the rays of the reference.
choices() {
    few=1024 many=4096 every=1 fine=32768 more=0
    case $1 in
    deep) few=512 many=2048 every=8 ;;
    triangles) few=256 many=1024 fine=16384 ;;
    classroom) few=512 many=2048 every=2 ;;
    balcony) more=2 ;; # its soffit and the street's other side light the window by several bounces
    well) more=7 ;; # its light reaches the window by many bounces
    esac
}
paths='-ab 22 -lr 0 -as 0 -aa 0 -lw 1e-7'
limit=300       # seconds that a run of Radiance may take, except the reference
seeds='1 2 3 4' # of our runs, whose errors and times are combined
fine_seeds='101 102 103 104 105 106 107 108' # of the runs for our reference

# ---- running ----

# seconds OUT IN COMMAND ...: runs the command; prints its processor time, user and system.
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

# factors IN OUT: rtrace's irradiances as daylight factors, one per line.
factors() {
    horizontal=$(sed -n 's/^horizontal=\([0-9.]*\).*/\1/p' "$scratch/scene/daylight_factors.sh")
    awk -v h="$horizontal" '{ print (0.265 * $1 + 0.670 * $2 + 0.065 * $3) / h }' "$1" >"$2"
}

# traced OUT ERROR SEED FILE: our daylight factors, one per line; prints the processor time.
traced() {
    taken=$(seconds "$scratch/csv" /dev/null "$pepperpot" df -q -m brs-table --no-bands --simulate -j 1 \
        --error "$2" --seed "$3" --format csv "$4")
    awk -F, '/,point,/ && $(NF - 5) == "df" && $(NF - 4) == "traced" { print $(NF - 3) / 100 }' \
        "$scratch/csv" >"$1"
    echo "$taken"
}

# rays OUT POINTS OPTIONS ...: daylight factors by rtrace, one per line; prints the processor time,
# 0 if rtrace was stopped.
rays() {
    to=$1 from=$2
    shift 2
    (cd "$scratch/scene" && ulimit -t "$limit" &&
        seconds "$scratch/irradiance" "$from" rtrace -w -h -I -dt 0 "$@" scene.oct)
    factors "$scratch/irradiance" "$to"
}

# expert_rays OUT POINTS RUN: daylight factors by an expert's run, one per line; prints the
# processor time of mkillum and both passes, 0 if one of them was stopped.
expert_rays() {
    expert "$3"
    (
        cd "$scratch/scene" && ulimit -t "$limit"
        expert_scene
        # shellcheck disable=SC2086 # options are several words
        {
            seconds illum.rad to_illum.rad mkillum -w -as 0 $outside plain.oct
            expert_octree
            for _ in overture last; do
                seconds "$scratch/irradiance" "$2" rtrace -w -h -I -dt 0 $inside -af ambient illum.oct
            done
        } | awk '{ sum += $1; none += $1 == 0 } END { printf "%.3f\n", none ? 0 : sum }'
    )
    factors "$scratch/irradiance" "$1"
}

# reference: our reference, one line per point: the mean of the fine runs, and the square of its
# standard error from their spread; prints the processor time.
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

# off FOUND ...: relative errors in per cent: the RMS error against our reference, less the noise of
# the reference; the mean error, which is the bias of a run with a cache; and the RMS error against
# rtrace's reference, which includes its noise.
off() {
    for found; do
        awk -v every="$every" 'NR % every == 1 || every == 1' "$found" |
            paste -d' ' - "$scratch/ours" "$scratch/theirs"
    done | awk '
        { ours += (($1 - $2) ^ 2 - $3) / $2 ^ 2; mean += $1 / $2 - 1; theirs += ($1 / $4 - 1) ^ 2 }
        END { printf "%.3f %+.3f %.3f\n", 100 * sqrt(ours > 0 ? ours / NR : 0), 100 * mean / NR,
            100 * sqrt(theirs / NR) }'
}

# row WHOSE WORDS SECONDS FOUND ...: adds a line to the table, and to the list of runs.
row() {
    whose=$1 words=$2 taken=$3
    shift 3
    errors=$(off "$@")
    # shellcheck disable=SC2086 # three numbers
    printf '| %s | %.2f | %s | %s | %s |\n' "$words" "$taken" $errors
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
            END { printf "%+.2f ± %.2f %% on average and by %.2f %% RMS,\nincluding noise of %.2f %% in the `df` reference",
                100 * s / NR, 100 * sqrt((q - s * s / NR) / (NR - 1) / NR), 100 * sqrt(q / NR),
                100 * sqrt(own / NR) }')

    printf '\n### %s: %d points\n\n' "$(sed -n 's/.*<room [^>]*name="\([^"]*\)".*/\1/p' \
        "$scratch/room.xml")$([ "$scene" = triangles ] && echo ', 100,000 triangles')" "$count"
    printf 'The reference values at %d points are the means of eight runs of `df --simulate --error 0.2%%`\n' \
        "$number"
    printf '(%.1f s in all). The second reference is one run of `rtrace %s -ad %d` (%.1f s).\nThe two references differ by %s. ' \
        "$ours_s" "$paths" "$fine" "$theirs_s" "$apart"
    printf 'Errors in the table are relative RMS errors in per cent,\nwithout this noise.\n\n'
    echo '| run | processor time, s | error | mean error | error against rtrace |'
    echo '| --- | ---: | ---: | ---: | ---: |'
    for error in 2% 1% 0.4%; do
        for seed in $seeds; do
            traced "$scratch/found.$seed" "$error" "$seed" "$scratch/room.xml"
        done | awk '{ sum += $1 } END { print sum / NR }' >"$scratch/taken"
        row "ours $error" "\`df --simulate --error $error\`, mean of four" \
            "$(cat "$scratch/taken")" "$scratch"/found.[1-4]
    done
    for number in $few $many; do
        # shellcheck disable=SC2086 # options are several words
        taken=$(rays "$scratch/found" "$all" $paths -ad "$number")
        finished "rtrace $paths -ad $number" &&
            row paths "\`rtrace $paths -ad $number\`" "$taken" "$scratch/found"
    done
    for run in $expert_runs; do
        expert "$run"
        taken=$(expert_rays "$scratch/found" "$all" "$run")
        finished "expert, $run" &&
            row "expert-$run" "expert, $run: \`mkillum $samples $outside\`, twice \`rtrace $inside\`" \
                "$taken" "$scratch/found"
    done
    ratios
}

# finished WORDS: succeeds if the run was finished; otherwise prints a line that states that it was
# not.
finished() {
    [ "$taken" != 0.000 ] || {
        printf '| %s | not finished after %d s | | | |\n' "$1" "$limit"
        false
    }
}

# Prints ratios of the times of Radiance to ours. An expert's run is biased, so it is compared as it
# is with the fastest of our runs whose error is no larger. The time of an unbiased run is
# proportional to the inverse square of its error. Both times are therefore extrapolated to the
# target error of one of our runs.
ratios() {
    echo
    awk '
        $1 == "ours" { t[++n] = $3; e[n] = $4; wanted[n] = $2 + 0; next }
        $1 == "paths" { rt[++k] = $2; re[k] = $3; next }
        {
            best = 0
            for (i = 1; i <= n; i++)
                if (e[i] <= $3 && (!best || t[i] < t[best])) best = i
            sub(/^expert-/, "")
            if (best)
                printf "- Expert, %s: Radiance takes %.3g s for an error of %.2g %% (mean error %s %%);\n" \
                    "  `df` takes %.2g s for an error of %.2g %%. The ratio of these measured times is %.0f.\n",
                    $1, $2, $3, $4, t[best], e[best], $2 / t[best]
            else
                printf "- Expert, %s: Radiance takes %.2g s for an error of %.2g %% (mean error %s %%);\n" \
                    "  no run of `df` has an error as small as this.\n",
                    $1, $2, $3, $4
        }
        END {
            for (i = 1; i <= n; i++) {
                own = t[i] * (e[i] / wanted[i]) ^ 2
                best = 0
                for (j = 1; j <= k; j++) {
                    s = rt[j] * (re[j] / wanted[i]) ^ 2
                    if (!best || s < least) { best = j; least = s }
                }
                if (best && own > 0)
                    printf "- Without a cache, for an error of %g %%: `rtrace` takes %.3g s, extrapolated from an error of %.2g %%;\n" \
                        "  `df` takes %.3g s, extrapolated from an error of %.2g %%. The ratio of these times is %.0f.\n",
                        wanted[i], least, re[best], own, e[i], least / own
            }
        }' "$scratch/runs"
}

for scene; do
    compare "$scene"
done
