# year_methods.awk - tables of the errors of hand methods for the year, their likely ranges, and
# the constants of the rule D (k_d E_d + k_s E_s). Run by year_methods.sh:
#
#     awk -v part=tables|ranges -f year_methods.awk hours.1.csv hours.2.csv hours.3.csv year.csv
#
# The rule is fitted in rooms 1 to 8, and its error measured in the others too. The coverage of ranges
# is that of each room by ranges from all others. Errors are hand less simulated daylight autonomy
# in percentage points. With part=ranges only the rows of tables/year_ranges.csv are printed.

function magnitude(x) { return x < 0 ? -x : x }
function group_of(bearing) { return bearing == 180 ? 0 : bearing == 0 ? 2 : 1 }
function class_of(hand,    k) {
    for (k = CLASSES; k > 1 && hand < least[k]; k--) ;
    return k
}

# ---- the rule ----

# The share of occupied hours (per cent) with k_d E_d + k_s E_s of at least lx, by bins of 1 %.
function fill_shares(climate, kd, ks,    i, bin, sum) {
    delete count
    for (i = 1; i <= hours[climate]; i++) {
        bin = kd * Ed[climate, i] + ks * Es[climate, i]
        if (bin >= 1)
            count[int(70 * log(bin))] += weight[climate, i]
    }
    sum = 0
    for (i = 900; i >= 0; i--)
        reach[climate, i] = sum += count[i]
}
function share_of(climate, lx,    bin) {
    bin = int(70 * log(lx) + 0.5)
    return bin > 900 ? 0 : 100 * reach[climate, bin < 0 ? 0 : bin] / all_hours[climate]
}
# Mean absolute error of the rule for one bearing in the rooms for fits, or in those held out.
function rule_error(bearing, held,    n, sum, i) {
    n = sum = 0
    for (i = 1; i <= points; i++)
        if (p_bearing[i] == bearing && (p_room[i] > 8) == held) {
            n++
            sum += magnitude(share_of(p_climate[i], 100 * p_target[i] / p_df[i]) - p_true[i])
        }
    return sum / n
}
function try_rule(kd, ks,    c, b, e) {
    for (c = 1; c <= 3; c++)
        fill_shares(c, kd, ks)
    for (b = 0; b < 360; b += 90) {
        e = rule_error(b, 0)
        if (!(b in best) || e < best[b]) {
            best[b] = e; best_kd[b] = kd; best_ks[b] = ks
        }
    }
}
function fit_rule(    i, k, b, kd, ks) {
    for (i = 0.6; i < 2.45; i += 0.2)
        for (k = 0; k < 2.05; k += 0.2)
            try_rule(i, k)
    for (b = 0; b < 360; b += 90) {
        kd = best_kd[b]; ks = best_ks[b]
        for (i = -2; i <= 2; i++)
            for (k = -2; k <= 2; k++)
                if ((i != 0 || k != 0) && ks + 0.05 * k > -0.01)
                    try_rule(kd + 0.05 * i, ks + 0.05 * k)
    }
    if (part == "ranges")
        return
    print "constants of the rule: bearing, k_d, k_s, mean absolute error in rooms for fits, held out"
    for (b = 0; b < 360; b += 90) {
        for (i = 1; i <= 3; i++)
            fill_shares(i, best_kd[b], best_ks[b])
        printf "%d %.2f %.2f %.2f %.2f\n", b, best_kd[b], best_ks[b], best[b], rule_error(b, 1)
    }
}

# ---- input ----

BEGIN {
    FS = ","
    ROOMS = 12
    TAIL = 0.02 # share of the figures beyond each end of a range
    CLASSES = split("0 2 10 25 45 65 80 90", least, " ")
    for (i = 1; i <= CLASSES; i++) least[i] += 0
}
FNR == 1 { file++; next }
/^[0-9]+,[0-9]+,[0-9.]+,.*/ && FILENAME ~ /hours\.[0-9]+\.csv$/ {
    if ($8 > 0) {
        all_hours[file] += $8
        if ($6 + $7 > 0) {
            i = ++hours[file]
            weight[file, i] = $8
            Ed[file, i] = $6
            Es[file, i] = $4 > 0 ? $7 * sin($4 * atan2(0, -1) / 180) : 0
        }
    }
    next
}
FILENAME ~ /hours/ || $7 == "df-rule" { next } # the rule is that of this fit: add_rule
{
    i = ++lines
    room[i] = $2; bearing[i] = $3; point[i] = $4; target[i] = $6; method[i] = $7
    hand[i] = $8; truth[i] = $9
    if (!(($7) in seen)) { seen[$7] = 1; order[++methods] = $7 }
    if ($7 == "df-diffuse") {
        i = ++points
        p_climate[i] = $1; p_room[i] = $2; p_bearing[i] = $3; p_df[i] = $5; p_target[i] = $6
        p_true[i] = $9; p_point[i] = $4
    }
}

# ---- tables ----

function sort(list, n,    i, k, x, gap) {
    for (gap = int(n / 2); gap > 0; gap = int(gap / 2))
        for (i = gap + 1; i <= n; i++) {
            x = list[i]
            for (k = i; k > gap && list[k - gap] > x; k -= gap) list[k] = list[k - gap]
            list[k] = x
        }
}

# Ranges of simulated less hand values, by method, group of orientations and class, from all rooms
# but one (0: from all). Classes with fewer than 30 figures are joined with the next ones.
function find_ranges(left_out,    i, n, key, m, g, c, first, list, low_end, high_end) {
    for (m = 1; m <= methods; m++)
        for (g = 0; g < 3; g++) {
            n = 0; first = 1
            delete list
            for (c = 1; c <= CLASSES; c++) {
                key = order[m] SUBSEP g SUBSEP c
                for (i = 1; i <= size[key]; i++)
                    if (room[value[key, i]] != left_out)
                        list[++n] = truth[value[key, i]] - hand[value[key, i]]
                if (n < 30 && c < CLASSES) continue
                if (n >= 30) {
                    sort(list, n)
                    low_end = list[1 + int(TAIL * (n - 1))]
                    high_end = list[n - int(TAIL * (n - 1))]
                }
                for (; first <= c; first++) {
                    key = order[m] SUBSEP g SUBSEP first
                    low[key] = low_end; high[key] = high_end
                }
                n = 0
                delete list
            }
        }
}

# How many figures of each room are within the ranges from the other rooms.
function judge_ranges(    i, r, m, key) {
    for (r = 1; r <= ROOMS; r++) {
        find_ranges(r)
        for (i = 1; i <= lines; i++)
            if (room[i] == r) {
                m = method[i]
                key = m SUBSEP group_of(bearing[i]) SUBSEP class_of(hand[i])
                judged[m]++
                inside[m] += truth[i] >= hand[i] + low[key] - 0.05 && truth[i] <= hand[i] + high[key] + 0.05
                wide[m] += high[key] - low[key]
            }
    }
}

function print_tables(    i, m, e, key, b, d, bearings, names) {
    for (i = 1; i <= lines; i++) {
        m = method[i]
        e = hand[i] - truth[i]
        if (target[i] != 300) continue
        figures[m]++
        sum[m] += magnitude(e); bias[m] += e
        if (magnitude(e) > magnitude(worst[m])) worst[m] = e
        by_n[m, bearing[i]]++; by_sum[m, bearing[i]] += magnitude(e)
        d = point[i] <= 2 ? 1 : point[i] <= 5 ? 2 : 3
        by_n[m, "d" d]++; by_sum[m, "d" d] += magnitude(e)
        held_n[m] += room[i] > 8
        held_sum[m] += room[i] > 8 ? magnitude(e) : 0
    }
    print "| method | error | bias | worst | S | E | N | W | front | middle | back | held out | coverage % | width |"
    print "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
    for (m = 1; m <= methods; m++) {
        key = order[m]
        printf "| `%s` | %.1f | %+.1f | %+.0f |", key, sum[key] / figures[key], bias[key] / figures[key], worst[key]
        split("180 90 0 270 d1 d2 d3", names, " ")
        for (i = 1; i <= 7; i++) printf " %.1f |", by_sum[key, names[i]] / by_n[key, names[i]]
        printf " %.1f | %.1f | %.0f |\n", held_sum[key] / held_n[key],
            100 * inside[key] / judged[key], wide[key] / judged[key]
        all_inside += inside[key]; all_judged += judged[key]
    }
    printf "pooled coverage %.1f %% of %d figures\n", 100 * all_inside / all_judged, all_judged
}

function print_ranges(    m, g, c, key) {
    for (m = 1; m <= methods; m++)
        for (g = 0; g < 3; g++)
            for (c = 1; c <= CLASSES; c++) {
                key = order[m] SUBSEP g SUBSEP c
                if (key in low)
                    printf "%s,%d,%g,%.1f,%.1f\n", order[m], g, least[c], low[key], high[key]
            }
}

# The rule as a further method.
function add_rule(    b, i, c, m) {
    order[++methods] = "df-rule"
    for (b = 0; b < 360; b += 90) {
        for (c = 1; c <= 3; c++)
            fill_shares(c, best_kd[b], best_ks[b])
        for (i = 1; i <= points; i++)
            if (p_bearing[i] == b) {
                m = ++lines
                room[m] = p_room[i]; bearing[m] = b; point[m] = p_point[i]
                target[m] = p_target[i]; method[m] = "df-rule"; truth[m] = p_true[i]
                hand[m] = share_of(p_climate[i], 100 * p_target[i] / p_df[i])
            }
    }
}

END {
    fit_rule()
    add_rule()
    for (i = 1; i <= lines; i++) {
        key = method[i] SUBSEP group_of(bearing[i]) SUBSEP class_of(hand[i])
        value[key, ++size[key]] = i
    }
    if (part != "ranges") {
        judge_ranges()
        print_tables()
    } else {
        find_ranges(0)
        print_ranges()
    }
}
