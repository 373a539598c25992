# plan_vectors.sh - reads the contours of a plan from its SVG and compares them with df.
#
# On both sides of a contour, at a distance of the width of the line, df's daylight factors must
# enclose the level of the contour; all points of a line have the same level. To be sourced after
# cli.sh.

# contours_of SVG JSON: points of the contours in metres, each with the number of its line and the
# points on both sides: "line x1 y1 x2 y2". The outline of the walls in the drawing and the corners
# of the plane in the JSON give the scale. off_y: y of the planes of vertical rooflights above the
# room.
contours_of() {
    awk -v most="${places:-200}" -v off="${off_y:-}" '
    # True if y is closer than 0.03 m to the plane of a vertical rooflight above the room. The plan
    # shows there the light 20 mm in front of this plane (methods/direct_plane.h).
    function is_under(y,    w, n, i) {
        n = split(off, w, / /)
        for (i = 1; i <= n; i++)
            if (y > w[i] - 0.03 && y < w[i] + 0.03) return 1
        return 0
    }
    # True if the point is closer than `least` to an edge of the plane, or outside it.
    function is_off(x, y, least,    r, i, j, within, dx, dy, t, gap) {
        for (r = 1; r <= rings; r++)
            for (i = 1; i <= corners[r]; i++) {
                j = i % corners[r] + 1
                dx = cx[r, j] - cx[r, i]; dy = cy[r, j] - cy[r, i]
                t = ((x - cx[r, i]) * dx + (y - cy[r, i]) * dy) / (dx * dx + dy * dy)
                t = t < 0 ? 0 : t > 1 ? 1 : t
                gap = sqrt((cx[r, i] + t * dx - x) ^ 2 + (cy[r, i] + t * dy - y) ^ 2)
                if (gap < least) return 1
                if ((cy[r, i] > y) != (cy[r, j] > y) &&
                    x < cx[r, i] + (y - cy[r, i]) / dy * dx)
                    within = !within
            }
        return !within
    }
    # The point in the middle of the segment after corner k of a line, and the points on its sides.
    # Segments are skipped if the line bends sharply within four times its width, or if a wall is
    # so close that one of the points may be in it.
    function look_at(k, m,    x, y, dx, dy, l, a, b, ax, ay, bx, by) {
        x = (vx[k] + vx[k + 1]) / 2; y = (vy[k] + vy[k + 1]) / 2
        dx = vx[k + 1] - vx[k]; dy = vy[k + 1] - vy[k]
        l = sqrt(dx * dx + dy * dy)
        if (l < 0.02 || is_under(hy - (y - top) / scale) || is_off(lx + (x - left) / scale, hy - (y - top) / scale, 0.15))
            return
        for (a = k; a > 1 && (vx[a] - x) ^ 2 + (vy[a] - y) ^ 2 < 16 * wide ^ 2; a--);
        for (b = k + 1; b < m && (vx[b] - x) ^ 2 + (vy[b] - y) ^ 2 < 16 * wide ^ 2; b++);
        ax = x - vx[a]; ay = y - vy[a]; bx = vx[b] - x; by = vy[b] - y
        if (ax * bx + ay * by < 0.95 * sqrt((ax ^ 2 + ay ^ 2) * (bx ^ 2 + by ^ 2)))
            return
        all[++places] = sprintf("%d %.5f %.5f %.5f %.5f", p,
            lx + (x - wide * dy / l - left) / scale, hy - (y + wide * dx / l - top) / scale,
            lx + (x + wide * dy / l - left) / scale, hy - (y - wide * dx / l - top) / scale)
    }
    FNR == NR {
        if ($0 ~ /"plane": \[/) inside = 1
        if (inside) {
            rest = $0
            if (/"x"/) rings++
            while (match(rest, /"x": [-0-9.e]+, "y": [-0-9.e]+/)) {
                split(substr(rest, RSTART, RLENGTH), w, /[ ,]+/)
                if (!seen++ || w[2] < lx) lx = w[2]
                if (seen == 1 || w[2] > hx) hx = w[2]
                if (seen == 1 || w[4] < ly) ly = w[4]
                if (seen == 1 || w[4] > hy) hy = w[4]
                corners[rings]++
                cx[rings, corners[rings]] = w[2] + 0
                cy[rings, corners[rings]] = w[4] + 0
                rest = substr(rest, RSTART + RLENGTH)
            }
            if ($0 ~ /"decorations"/) inside = 0
        }
        next
    }
    /<path style="fill:none/ {
        width = $0; sub(/.*stroke-width:/, "", width); width += 0
        d = $0; sub(/.* d="/, "", d); sub(/".*/, "", d)
        n = split(d, w, / /)
        if (/linejoin:miter/ && width > walls && d ~ /Z/) {
            walls = width; left = top = 1e9; right = bottom = -1e9
            for (i = 2; i < n; i++)
                if (w[i - 1] == "M" || w[i - 1] == "L") {
                    if (w[i] < left) left = w[i] + 0
                    if (w[i] > right) right = w[i] + 0
                    if (w[i + 1] < top) top = w[i + 1] + 0
                    if (w[i + 1] > bottom) bottom = w[i + 1] + 0
                }
        }
        if (/linejoin:round/ && !/dasharray/ && /rgb\(0%,0%,0%\)/) {
            paths[++count] = d
            widths[count] = width
        }
    }
    END {
        scale = (right - left) / (hx - lx)
        for (p = 1; p <= count; p++) {
            n = split(paths[p], w, / /)
            m = 0
            wide = widths[p] + 0.01
            for (i = 1; i <= n + 1; i++) {
                if (w[i] == "L" || (w[i] == "M" && m == 0)) {
                    m++; vx[m] = w[i + 1] + 0; vy[m] = w[i + 2] + 0
                } else if (w[i] == "M" || i == n + 1) {
                    for (k = 1; k < m; k++) look_at(k, m)
                    m = 0
                    if (w[i] == "M") i--
                }
            }
        }
        step = places > most ? places / most : 1
        for (i = 1; i <= places; i += step) print all[int(i)]
    }' "$2" "$1"
}

# agrees METHODS ROOM WORDS: the plan by the method (traced: by --simulate) agrees with df at its
# contours; prints the number of points tested.
agrees() {
    by=$1
    room=$2
    shift 2
    if [ "$by" = traced ]; then set -- --simulate "$@"; else set -- -m "$by" "$@"; fi
    "$pepperpot" chart plan "$@" -q -o "$scratch/plan.svg" "$room" || return 1
    "$pepperpot" df -m bre -f json "$room" >"$scratch/room.json" || return 1
    contours_of "$scratch/plan.svg" "$scratch/room.json" >"$scratch/places"
    [ "$(wc -l <"$scratch/places")" -ge 20 ] || { echo "hardly a contour"; return 1; }
    points=$(awk '{ printf "%s,%s %s,%s ", $2, $3, $4, $5 }' "$scratch/places")
    "$pepperpot" df "$@" -q -f csv -p "$points" "$room" >"$scratch/values" || return 1
    case $by in *+* | traced) direct=0 ;; *) direct=1 ;; esac
    awk -F, -v by="$by" -v direct=$direct '
    FNR == NR { split($0, w, / /); line[FNR] = w[1]; place[FNR] = $0; n = FNR; next }
    { gsub(/"[^"]*"/, "quoted") }
    $3 == "point" && $11 == by && (direct ? $10 == "sc" : $10 == "df") {
        value[++v] = $12; error[v] = $13 + 0
    }
    $3 == "point" && $11 == by && direct && $10 == "erc" { value[++e] += $12 }
    END {
        for (i = 1; i <= n; i++) {
            a = value[2 * i - 1]; b = value[2 * i]
            if (a > b) { c = a; a = b; b = c }
            # Simulated: three standard errors of both figures, which are independent.
            slack = 3 * 1.5 * (error[2 * i] > error[2 * i - 1] ? error[2 * i] : error[2 * i - 1])
            a -= slack; b += slack
            p = line[i]
            if (!(p in low) || a > low[p]) { low[p] = a; at[p] = place[i] }
            if (!(p in high) || b < high[p]) { high[p] = b; upto[p] = place[i] }
            seen++
        }
        for (p in low)
            # Printed digits of the figures, and the error of fixed quadrature rules (1e-4).
            if (low[p] > high[p] * 1.0003 + 2e-9) {
                printf "line %s: over %.6g at %s, under %.6g at %s\n", p, low[p], at[p],
                    high[p], upto[p]
                bad = 1
            }
        printf "%d places on %d lines\n", seen, length(low)
        exit bad || seen != n || v != 2 * n
    }' "$scratch/places" "$scratch/values"
}
