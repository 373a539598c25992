#!/bin/sh
# Eight rooms opposite ground in shadow: the simulation, and Radiance with the exported room,
# compared with Radiance with a scene whose ground is polygons, four kilometres wide. ROOMS="NAME
# ...": only these rooms of tests/long/ground; TIMES=N: N times the paths.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

rooms=${ROOMS:-street light-well court balcony own-facade near-skyline far-skyline rooflight}
times=${TIMES:-1}

# with_polygons FILE: the room over open ground, with a millimetre above it four rectangles around
# its plan, or one below its floor.
with_polygons() {
    awk '
    function value(name) { # of an attribute in this line
        return match($0, " " name "=\"[^\"]*\"") \
            ? substr($0, RSTART + length(name) + 3, RLENGTH - length(name) - 4) : 0
    }
    function polygon(x0, y0, x1, y1) {
        printf "<surface reflectance=\"%s\">", reflectance
        for (i = 0; i < 4; i++)
            printf "<vertex x=\"%s\" y=\"%s\" z=\"%s\"/>", \
                (i % 3 ? x1 : x0), (i > 1 ? y1 : y0), level + 0.001
        print "</surface>"
    }
    BEGIN { reflectance = 0.2; site = "<site ground=\"open\"/>" }
    /<site / {
        level = value("ground-level")
        if (value("ground-reflectance")) reflectance = value("ground-reflectance")
        sub(/<site /, "<site ground=\"open\" ")
        site = ""
    }
    /<plan / { width = value("width"); depth = value("depth") }
    /<\/room>/ {
        if (site) print site
        if (level < 0) {
            polygon(-2000, -2000, 2000, 2000)
        } else {
            polygon(-2000, -2000, 2000, 0)
            polygon(-2000, depth, 2000, 2000)
            polygon(-2000, 0, 0, depth)
            polygon(width, 0, 2000, depth)
        }
    }
    { print }' "$1"
}

# radiance FILE: daylight factor and standard error of each point by 16 runs of rtrace.
radiance() {
    rm -rf "$scratch/scene"
    "$pepperpot" export -q --to radiance -o "$scratch/scene" "$1" || return 1
    awk '{ for (i = 0; i < 16; i++) print }' "$scratch/scene/points.pts" >"$scratch/points"
    mv "$scratch/points" "$scratch/scene/points.pts"
    "$scratch/scene/daylight_factors.sh" -ab 22 -lr 0 -ad $((times * 8192)) -as 0 -aa 0 \
        -lw 1e-7 | awk '
        { sum += $4; squares += $4 * $4 }
        NR % 16 == 0 {
            mean = sum / 16
            print mean, sqrt((squares / 16 - mean * mean) / 15)
            sum = squares = 0
        }'
}

# simulated FILE: daylight factor and standard error of each point by the simulation.
simulated() {
    "$pepperpot" df -q --methods exact --simulate --error 0.3% --format csv "$1" |
        awk -F, '$3 == "point" && $10 == "df" && $11 == "traced" { print $12, $13 }'
}

# agree A B: three points each agree within 1 % or three standard errors of the difference, which
# is itself below 3 %.
agree() {
    paste -d' ' "$1" "$2" | awk '
    NF == 4 {
        off = $1 - $3; error = sqrt($2 * $2 + $4 * $4)
        printf "%9.4f +- %.4f %9.4f +- %.4f  %+6.2f %%  %+5.2f\n", $1, $2, $3, $4,
            100 * off / $3, off / error
        if (off < 0) off = -off
        good += (off < 0.01 * $3 || off < 3 * error) && error < 0.03 * $3
    }
    END { exit !(NR == 3 && good == 3) }'
}

if ! command -v rtrace >/dev/null || ! command -v oconv >/dev/null; then
    skip "the ground's shadow is Radiance's" "Radiance is not installed"
    tap_done
    exit 0
fi
for room in $rooms; do
    file=$srcdir/tests/long/ground/$room.xml
    with_polygons "$file" >"$scratch/$room.xml"
    radiance "$scratch/$room.xml" >"$scratch/polygons"
    radiance "$file" >"$scratch/disc"
    simulated "$file" >"$scratch/simulated"
    check "$room: the export's ground is that of polygons" \
        agree "$scratch/disc" "$scratch/polygons"
    check "$room: the simulation's too" agree "$scratch/simulated" "$scratch/polygons"
done
tap_done
