#!/bin/sh
# compare_rpict.sh PROGRAM [SIZE] - error against processor time of pictures of the deep office,
# SIZE pixels square (default 256), by PROGRAM's `render` and by Radiance's rpict, as lines of
# Markdown. Takes minutes. If Radiance is not on PATH, it only prints a note.
set -eu
LC_ALL=C
export LC_ALL

if [ $# -lt 1 ]; then
    echo "usage: compare_rpict.sh PROGRAM [SIZE]" >&2
    exit 2
fi
pepperpot=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
size=${2:-256}
for program in oconv rpict rtrace pvalue mkillum; do
    command -v $program >/dev/null && continue
    echo "Radiance's $program is not on PATH: nothing is compared with it."
    exit 0
done
# shellcheck source=bench/expert_radiance.sh
. "$(dirname "$0")/expert_radiance.sh"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
limit=${LIMIT:-600} # seconds that a run of rpict may take; set by LIMIT

cat >"$scratch/room.xml" <<'END'
<room version="1" name="Deep office"><plan width="3" depth="9" height="2.7"/>
<finishes floor="0.2" walls="0.5" ceiling="0.7"/>
<window wall="south" left="0.2" sill="0.8" width="2.6" height="1.5" glazing="clear-single"/>
<working-plane height="0.85"/><point x="1.5" y="4"/></room>
END
"$pepperpot" export -q --to radiance -o "$scratch/scene" "$scratch/room.xml"
(cd "$scratch/scene" && ./daylight_factors.sh -w -ab 0 >/dev/null)

# ---- running ----

# seconds COMMAND ...: runs the command; prints its processor time, user and system.
seconds() {
    ("$@" >"$scratch/out" 2>"$scratch/err" <"${from:-/dev/null}" && times) | awk '
        { last = $0 }
        END {
            n = split(last, parts, " ")
            for (i = 1; i <= n; i++) {
                split(parts[i], t, "m")
                sum += 60 * t[1] + t[2]
            }
            printf "%.2f\n", sum
        }'
}

# values PICTURE FILE: the luminances of the picture over 179, one per line. The sky of both
# programs gives 10,000 lx.
values() {
    pvalue -h -H -d -b "$1" >"$2"
}

# ours OUT OPTIONS ...: luminances by `render`; prints the processor time.
ours() {
    to=$1
    shift
    seconds "$pepperpot" render -q -j 1 --from 1.5,8,1.6 --towards 1.5,0,1.4 --angle 75 \
        --size "${size}x$size" "$@" -o "$scratch/ours.hdr" "$scratch/room.xml"
    values "$scratch/ours.hdr" "$to"
}

# theirs OUT RUN: luminances by an expert's run; prints the processor time of mkillum and both
# passes, 0 if one of them was stopped. The overture has a sixteenth of the pixels.
theirs() {
    expert "$2"
    (
        cd "$scratch/scene" && ulimit -t "$limit"
        expert_scene
        # shellcheck disable=SC2086 # options are several words
        {
            from=to_illum.rad seconds mkillum -w -as 0 $outside plain.oct
            cp "$scratch/out" illum.rad
            expert_octree
            for width in $((size / 4)) "$size"; do
                seconds rpict -w -t 0 -vtv -vp 1.5 8 1.6 -vd 0 -8 -0.2 -vu 0 0 1 -vh 75 -vv 75 \
                    -x "$width" -y "$width" -pa 1 -ps 1 -pj 0 -dt 0 $inside -af ambient illum.oct
            done
        } | awk '{ sum += $1; none += $1 == 0 } END { printf "%.2f\n", none ? 0 : sum }'
    )
    # A run that was stopped has no complete picture.
    values "$scratch/out" "$1" 2>"$scratch/err" || :
}

# ---- comparing ----

# Finds the pixels that are similar to their neighbours, in a picture with little noise. This
# picture is not a reference, since a choice by the references would prefer pixels where their noise
# cancels. At these pixels a path through the middle has the same value as the mean of the pixel.
# The pixels of the window are left out, since both programs have them directly from the sky.
smooth() {
    awk -v n="$size" '
        { v[NR - 1] = $1; if ($1 > most) most = $1 }
        END {
            for (i = 0; i < NR; i++) {
                x = i % n; good = x > 1 && x < n - 2 && i >= 2 * n && i < NR - 2 * n
                for (dy = -2; good && dy <= 2; dy++)
                    for (dx = -2; dx <= 2; dx++) {
                        r = v[i + dy * n + dx] / v[i]
                        if (r > 1.15 || r < 0.87) good = 0
                    }
                print (good && v[i] < 0.5 * most ? 1 : 0)
            }
        }' "$scratch/quiet" >"$scratch/smooth"
}

# off FOUND: RMS of the relative error, per cent. The mean product of the differences from two
# independent references does not contain their noise.
off() {
    paste -d' ' "$scratch/smooth" "$1" "$scratch/a" "$scratch/b" | awk '
        $1 { n++; s += ($2 - $3) * ($2 - $4) / ($3 * $4) }
        END { printf "%.2f\n", 100 * sqrt(s > 0 ? s / n : 0) }'
}

row() { # WORDS SECONDS FOUND KIND
    error=$(off "$3")
    printf '| %s | %.2f | %s |\n' "$1" "$2" "$error"
    echo "$4 $2 $error" >>"$scratch/runs"
}

reference_s=$(ours "$scratch/a" --engine path --windows aimed --samples 256 --seed 101)
ours "$scratch/b" --engine path --windows aimed --samples 256 --seed 202 >/dev/null
ours "$scratch/quiet" --samples 64 --seed 303 >/dev/null
smooth

# Compares the references with rtrace without a cache, at up to 256 pixels.
awk -v n="$size" 'BEGIN { step = n / 16 } {
        x = (NR - 1) % n; y = int((NR - 1) / n)
        if ($1 && x % step == int(step / 2) && y % step == int(step / 2)) print NR, x, y
    }' "$scratch/smooth" >"$scratch/some"
awk -v n="$size" '
    BEGIN { h = sin(37.5 * 3.14159265358979 / 180) / cos(37.5 * 3.14159265358979 / 180)
            l = sqrt(64 + 0.04) }
    {   # right and up of a view to -y, a little down; pictures are stored from the top
        r = (2 * ($2 + 0.5) / n - 1) * h; u = (1 - 2 * ($3 + 0.5) / n) * h
        printf "1.5 8 1.6 %.8f %.8f %.8f\n", -r, -8 / l - u * 0.2 / l, -0.2 / l + u * 8 / l
    }' "$scratch/some" >"$scratch/rays"
(cd "$scratch/scene" && rtrace -w -h -dt 0 -ab 22 -lr 0 -as 0 -aa 0 -lw 1e-7 -ad 4096 scene.oct \
    <"$scratch/rays" | awk '{ print 0.265 * $1 + 0.670 * $2 + 0.065 * $3 }' >"$scratch/rtrace")
apart=$(paste -d' ' "$scratch/a" "$scratch/b" | awk '
    FNR == NR { wanted[$1] = FNR; next }
    FNR in wanted { print ($1 + $2) / 2 }' "$scratch/some" - | paste -d' ' - "$scratch/rtrace" |
    awk '{ d = $1 / $2 - 1; s += d; q += d * d }
        END { printf "%+.2f %% on average over %d pixels and by %.2f %% RMS", 100 * s / NR, NR, 100 * sqrt(q / NR) }')

printf '\n### Deep office: a picture of %d by %d pixels\n\n' "$size" "$size"
printf 'The references are two runs of `render --engine path --samples 256` (%.1f s each). They differ from\n' "$reference_s"
printf '`rtrace` without a cache by %s.\nErrors are relative RMS errors in per cent, at pixels that differ little from their neighbours.\n\n' "$apart"
echo '| run | processor time, s | error |'
echo '| --- | ---: | ---: |'
for options in '--samples 4 --accuracy 0.2' '--samples 8' ''; do
    # shellcheck disable=SC2086 # options are several words
    taken=$(ours "$scratch/found" $options)
    row "\`render $options\`" "$taken" "$scratch/found" ours
done
for run in $expert_runs; do
    expert "$run"
    taken=$(theirs "$scratch/found" "$run")
    words="expert, $run: \`mkillum $samples $outside\`, twice \`rpict $inside\`"
    if [ "$taken" = 0.00 ] || [ -z "$taken" ]; then
        printf '| %s | not finished after %d s | |\n' "$words" "$limit"
        continue
    fi
    row "$words" "$taken" "$scratch/found" theirs
done
awk '
    $1 == "ours" { t[++n] = $2; e[n] = $3; next }
    {
        best = 0
        for (i = 1; i <= n; i++)
            if (e[i] <= $3 && (!best || t[i] < t[best])) best = i
        printf "\n`rpict` takes %.2f s for an error of %.2g %%, `render` %.2f s for %.2g %%; ratio of these times: %.0f.\n", $2, $3,
            t[best], e[best], $2 / t[best]
    }' "$scratch/runs"
