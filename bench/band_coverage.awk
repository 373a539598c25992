# band_coverage.awk - the tables of band_coverage.sh, from three kinds of files, with the rooms in
# any order: rooms.csv of ordinary_rooms.awk; the CSV of `df --bands --simulate`, in files N.csv;
# and the JSON of `df --advise`, in files N.json.
#
# A figure is in its range if low <= truth <= high. Left out, but counted, are figures without a
# range, true values below 0.005 %, and true values with a standard error of more than 3 %. 0.02 %
# is added to all values before ratios are formed, as in the fit of the ranges.

function shifted(value) { return value + 0.02 }
function magnitude(value) { return value < 0 ? -value : value }

# Sorts values[1] to values[count] in ascending order.
function sort_up(values, count,    i, j, value) {
    for (i = 2; i <= count; i++) {
        value = values[i]
        for (j = i - 1; j > 0 && values[j] > value; j--) values[j + 1] = values[j]
        values[j + 1] = value
    }
}

# Quantile `share` (0 to 1) of sorted values, interpolated linearly.
function quantile(values, count, share,    at, below) {
    at = 1 + share * (count - 1)
    below = int(at)
    return below >= count ? values[count] : \
        values[below] + (at - below) * (values[below + 1] - values[below])
}

# ---- input ----

FNR == 1 {
    room = FILENAME
    sub(/.*\//, "", room)
    sub(/\..*/, "", room)
    point = advice = 0
    place = ""
    waiting = 0
}

FILENAME ~ /rooms\.csv$/ {
    if (FNR == 1) next
    split($0, fact, ",")
    kind[fact[1]] = fact[2]
    if (!(fact[2] in listed)) {
        listed[fact[2]]
        kinds[++kind_count] = fact[2]
    }
    obstruction[fact[1]] = fact[3]
    away[fact[1]] = fact[4]
    roof[fact[1]] = fact[5] == "yes"
    depths[fact[1]] = fact[6]
    next
}

FILENAME ~ /\.csv$/ {
    gsub(/"[^"]*"/, "") # sentences contain commas
    sub(/\r$/, "") # otherwise the last number would be a string
    split($0, field, ",")
    if (field[3] != "point" && field[3] != "average") next
    if (field[3] field[4] field[5] != place) {
        place = field[3] field[4] field[5]
        at = field[3] == "point" ? point++ : "average"
        if (at == 0) rooms_read++
    }
    component = field[10]
    if (field[11] != "traced") {
        waiting++
        method[waiting] = field[11]
        figure[waiting] = field[12]
        low[waiting] = field[16]
        high[waiting] = field[17]
        if (component == "df" && field[12] != "") hand[room, at, field[11]] = field[12]
        next
    }
    for (i = 1; i <= waiting; i++) count_figure(i, component, at, field[12], field[13])
    if (component == "df") truth[room, at] = field[12]
    waiting = 0
    next
}

# The JSON of --advise has one key per line.
/^  "advice": \[/ { advice = 1; next }
advice && /^  \]/ { advice = 0 }
advice && /"of": / { of_points = /"points"/; next }
advice && /"points": \[/ { advised_count = numbers($0, advised_points); next }
advice && /"use": / { use = $0; sub(/.*"use": "/, "", use); sub(/".*/, "", use); next }
advice && /"corrected": / {
    found = numbers($0, corrected)
    if (!of_points)
        advise("average", use, corrected[1])
    else
        for (i = 1; i <= found; i++) advise(advised_points[i], use, corrected[i])
}

# Stores the numbers after the colon of a line in values[1], values[2], ...; returns their count.
function numbers(line, values) {
    sub(/^[^:]*:/, "", line)
    gsub(/[][,]/, " ", line)
    return split(line, values, " ")
}

function advise(at, method_, corrected_) {
    advised[room, at] = method_
    advised_corrected[room, at] = corrected_
}

# ---- coverage ----

function count_figure(i, component, at, true_value, error,    key, of) {
    if (figure[i] == "") return
    of = at == "average" ? "averages" : "points"
    key = of SUBSEP component SUBSEP method[i]
    if (!(key in order)) {
        order[key] = ++key_count
        keys[key_count] = key
    }
    if (true_value == "" || true_value < 0.005) { dark[key]++; dark_all[of]++; return }
    if (error > 0.03 * shifted(true_value)) { noisy[key]++; noisy_all[of]++; return }
    if (low[i] == "" || high[i] == "") { bare[key]++; bare_all[of]++; return }
    figures[key]++
    in_room[key, room]++
    inside = low[i] + 0 <= true_value + 0 && true_value + 0 <= high[i] + 0
    hit[key, room] += inside
    log_width[key, room] += log(shifted(high[i]) / shifted(low[i]))
    log_bias[key, room] += log(shifted(figure[i]) / shifted(true_value))
    count_regimes(of, component, at, inside, key)
    if (trace)
        print room, at, component, method[i], figure[i], low[i], high[i], true_value, \
            (inside ? "in" : "out") >trace
}

# A room counts once for each method in a regime.
function count_regimes(of, component, at, inside, key,    depth, deep, name) {
    add("all", of, component, inside, key)
    add("kind: " kind[room], of, component, inside, key)
    if (roof[room]) {
        add("light from above", of, component, inside, key)
        return
    }
    if (obstruction[room] == 0) name = "nothing outside"
    else if (obstruction[room] < 30) name = "obstruction under 30 degrees"
    else name = "obstruction of 30 degrees or more"
    add(name, of, component, inside, key)
    if (away[room] > 0 && away[room] <= 12)
        add("obstruction within 12 m", of, component, inside, key)
    if (at == "average") return
    split(depths[room], depth, " ")
    deep = depth[at + 1]
    if (deep <= 1) name = "point within one head height"
    else if (deep <= 2) name = "point at one to two"
    else name = "point deeper than two head heights"
    add(name, of, component, inside, key)
}
function add(regime, of, component, inside, key,    cell) {
    cell = regime SUBSEP key SUBSEP room
    if (!(cell in cell_figures)) {
        cell_list[++cell_count] = cell
        cell_regime[cell_count] = regime
        cell_of[cell_count] = of
        cell_component[cell_count] = component
    }
    cell_figures[cell]++
    cell_hits[cell] += inside
    if (!((regime, room) in met)) { met[regime, room]; regime_rooms[regime]++ }
}

# ---- tables ----

function method_table(of,    k, key, part, n, share, width, bias, r, mark, one) {
    printf "\n%s\n", (of == "points" ? "At points" : "Averages over the working plane")
    printf "%-4s %-24s %5s %7s %8s %6s %8s %8s %5s %5s\n", "", "method", "rooms", "figures",
        "coverage", "width", "bias", "no range", "dark", "noisy"
    for (k = 1; k <= key_count; k++) {
        key = keys[k]
        split(key, part, SUBSEP)
        if (part[1] != of) continue
        n = share = width = 0
        split("", bias)
        for (r in kind)
            if ((key, r) in in_room) {
                one = in_room[key, r]
                share += hit[key, r] / one
                width += log_width[key, r] / one
                bias[++n] = log_bias[key, r] / one
            }
        if (n == 0) {
            printf "%-4s %-24s %5d %7d %8s %6s %8s %8d %5d %5d\n", part[2], part[3],
                0, 0, "-", "-", "-", bare[key], dark[key], noisy[key]
            continue
        }
        sort_up(bias, n)
        share *= 100 / n
        mark = share < 92 ? "  too low" : share > 98 ? "  too high" : ""
        printf "%-4s %-24s %5d %7d %6.1f %% %6.2f %+6.1f %% %8d %5d %5d%s\n", part[2], part[3],
            n, figures[key], share, exp(width / n), 100 * (exp(quantile(bias, n, .5)) - 1),
            bare[key], dark[key], noisy[key], mark
    }
    printf "left out: %d figures without a range, %d of a truth below 0.005 %% (dark), ",
        bare_all[of], dark_all[of]
    printf "%d of an uncertain truth (noisy)\n", noisy_all[of]
}

function regime_table(    c, i, name, of, part, regime, regimes, regime_count, share, what) {
    regime_count = split("all;nothing outside;obstruction under 30 degrees;" \
        "obstruction of 30 degrees or more;obstruction within 12 m;light from above;" \
        "point within one head height;point at one to two;point deeper than two head heights",
        regimes, ";")
    for (c = 1; c <= kind_count; c++) regimes[++regime_count] = "kind: " kinds[c]
    for (c = 1; c <= cell_count; c++) {
        share = cell_hits[cell_list[c]] / cell_figures[cell_list[c]]
        for (i = 0; i < 2; i++) {
            name = cell_regime[c] SUBSEP cell_of[c] SUBSEP (i ? "all" : cell_component[c])
            sum[name] += share
            count[name]++
        }
    }
    split("sc erc irc df all", part, " ")
    printf "\nCoverage by regimes, in per cent, all methods together; "
    printf "a room counts once for each method\n"
    printf "%44s%-35s%s\n%-36s %5s", "", "points", "averages", "regime", "rooms"
    for (of = 0; of < 2; of++)
        for (i = 1; i <= 5; i++) printf " %6s", part[i]
    printf "\n"
    for (c = 1; c <= regime_count; c++) {
        regime = regimes[c]
        if (!regime_rooms[regime]) continue
        printf "%-36s %5d", regime, regime_rooms[regime]
        for (of = 0; of < 2; of++)
            for (i = 1; i <= 5; i++) {
                name = regime SUBSEP (of ? "averages" : "points") SUBSEP part[i]
                if (!count[name]) { printf " %6s", "-"; continue }
                share = 100 * sum[name] / count[name]
                printf " %6.1f", share
                what = sprintf("%s%s, %s: %.1f %%", (of ? "averages" : "points"),
                    (part[i] == "all" ? "" : " (" part[i] ")"), regime, share)
                if (regime == "all" || regime_rooms[regime] < 10) continue
                if (lowest_name == "" || share < lowest) { lowest = share; lowest_name = what }
                if (part[i] == "all" && (worst_name == "" ||
                    magnitude(share - 95) > magnitude(worst - 95))) {
                    worst = share
                    worst_name = what
                }
            }
        printf "\n"
    }
    printf "worst regime of 10 rooms or more: %s\n", worst_name
    printf "lowest of one component: %s\n", lowest_name
    pooled("points")
    pooled("averages")
}
function pooled(of) {
    printf "pooled, %s: %.1f %%\n", of, 100 * sum["all", of, "all"] / count["all", of, "all"]
}

function errors(what, values, n,    i, sum_) {
    for (i = 1; i <= n; i++) sum_ += values[i]
    sort_up(values, n)
    if (n > 0)
        printf "%-22s %6d %7.1f %% %7.1f %% %7.1f %%\n", what, n, sum_ / n,
            quantile(values, n, .5), quantile(values, n, .9)
}

function advice_table(    place, part, n, none, of, bare_, corrected_, true_value) {
    for (place in truth) {
        split(place, part, SUBSEP)
        of = part[2] == "average" ? "average" : "points"
        true_value = truth[place]
        if (true_value < 0.005) continue
        if (!(place in advised) || !((place, advised[place]) in hand)) { none[of]++; continue }
        n[of]++
        bare_[of, n[of]] = 100 * magnitude(hand[place, advised[place]] / true_value - 1)
        corrected_[of, n[of]] = 100 * magnitude(advised_corrected[place] / true_value - 1)
    }
    printf "\nAdvised methods: relative error, without its sign\n%-22s %6s %9s %9s %9s\n", "",
        "number", "mean", "median", "90th"
    each("average, as it is", "average", bare_, n["average"])
    each("average, corrected", "average", corrected_, n["average"])
    each("points, as they are", "points", bare_, n["points"])
    each("points, corrected", "points", corrected_, n["points"])
    printf "without advice: %d averages, %d points\n", none["average"], none["points"]
}
function each(what, of, values, n,    i, list) {
    for (i = 1; i <= n; i++) list[i] = values[of, i]
    errors(what, list, n)
}

END {
    printf "%d ordinary rooms, simulated to %s at their points\n", rooms_read, error
    method_table("points")
    method_table("averages")
    regime_table()
    advice_table()
}
