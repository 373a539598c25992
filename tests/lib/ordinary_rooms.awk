# ordinary_rooms.awk - 300 ordinary rooms, to measure how often the true value is in the likely
# range of a hand figure. The rooms are independent of the atlas, from which the ranges are
# derived, and of the examples.
#
#    awk -v folder=DIR -f ordinary_rooms.awk          DIR/1.xml to DIR/300.xml, DIR/rooms.csv
#    awk -v folder=DIR -v room=17 -f ordinary_rooms.awk                   DIR/17.xml alone
#
# rooms.csv has a line for each room: its number and kind; the obstruction's angle in degrees (0:
# none) and its distance in metres (0: infinite); whether light comes from above; and for each
# point its distance from the nearest window wall divided by the height of the window head above
# the working plane.
#
# A room is designed with its main window wall along u, from left to right as seen from outside,
# and its depth along v; `turn` quarter turns then rotate this wall to the south, east, north or
# west. The script generates its own random numbers, so that every awk gives the same rooms.

# ---- choices ----

# A number from 0 to below 1: the minimal standard generator of Park and Miller.
function chance() {
    state = state * 16807 % 2147483647
    return state / 2147483647
}

# One word of a list; more frequent words are repeated in the list.
function one_of(list,    words, count) {
    count = split(list, words, " ")
    return words[1 + int(count * chance())]
}

# A multiple of `step` from `low` to `high`.
function between(low, high, step) {
    return low + step * int(chance() * ((high - low) / step + 1.0000001))
}

function smaller(a, b) { return a < b ? a : b }
function larger(a, b) { return a > b ? a : b }
function radians(angle) { return angle * atan2(0, -1) / 180 }
function tangent(angle) { return sin(radians(angle)) / cos(radians(angle)) }
function degrees(rise, run) { return atan2(rise, run) * 180 / atan2(0, -1) }

function say(text) { print text >file }
function number(value) { return sprintf("%.6g", value) }
function has(name, value) { return sprintf(" %s=\"%s\"", name, number(value)) }

# ---- conversion of u and v to the plan ----

# Name of the wall that is `quarters` quarter turns counter-clockwise from the main wall.
function wall_name(quarters) { return walls[(quarters + turn) % 4] }
function x_of(u, v) { return turn == 0 ? u : turn == 1 ? depth - v : turn == 2 ? width - u : v }
function y_of(u, v) { return turn == 0 ? v : turn == 1 ? u : turn == 2 ? depth - v : width - u }
function wall_length(quarters) { return quarters % 2 ? depth : width }

# The block from u0 to u1 and v0 to v1.
function block(u0, v0, u1, v1, height, roof,    x0, y0, x1, y1) {
    x0 = x_of(u0, v0); y0 = y_of(u0, v0); x1 = x_of(u1, v1); y1 = y_of(u1, v1)
    say("  <block" has("x", smaller(x0, x1)) has("y", smaller(y0, y1)) \
        has("width", larger(x0, x1) - smaller(x0, x1)) \
        has("depth", larger(y0, y1) - smaller(y0, y1)) \
        has("height", height) has("reflectance", one_of(".1 .15 .2 .2 .3 .3 .4")) roof "/>")
}

# ---- windows ----

# Glazing, frame factor, maintenance factor and reveal of all windows of the room.
function choose_glazing() {
    if (is_home)
        glazing = one_of("clear-single clear-double clear-double clear-double low-e-double " \
            "low-e-double low-e-triple")
    else
        glazing = one_of("clear-single clear-double clear-double clear-double low-e-double " \
            "low-e-double low-e-double low-e-triple clear-triple solar-control-light")
    frame = one_of(is_home ? ".6 .65 .7 .7 .75 .75 .8" : ".7 .75 .8 .8 .85 .85 .9")
    maintenance = one_of("auto .8 .85 .9 .9 .9 .92 .95 1")
    reveal = one_of(is_home ? "0 .05 .1 .1 .15 .2 .25 .3" : "0 0 .05 .1 .1 .15 .2")
}
function glass() {
    return " glazing=\"" glazing "\"" has("frame-factor", frame) \
        (maintenance == "auto" ? " maintenance=\"auto\"" : has("maintenance", maintenance))
}

# A slab or a balcony over a window of the main wall.
function shading(    text) {
    text = ""
    if (above == "slab")
        text = "    <overhang" has("depth", balcony_depth) \
            has("above", smaller(.3, height - head + .2)) has("left", .4) has("right", .4) \
            has("reflectance", slab) "/>"
    else if (above == "balcony")
        text = "    <balcony" has("depth", balcony_depth) has("left", .3) has("right", .3) \
            has("level", height + .3) has("parapet", one_of("0 1 1.1")) \
            has("reflectance", slab) "/>"
    return text
}
function window(quarters, left, sill, wide, high,    line, shade) {
    line = "  <window wall=\"" wall_name(quarters) "\"" has("left", left) has("sill", sill) \
        has("width", wide) has("height", high) glass() has("reveal", reveal)
    shade = quarters == 0 ? shading() : ""
    if (shade == "")
        say(line "/>")
    else
        say(line ">\n" shade "\n  </window>")
    has_window[quarters] = 1
}

# As many windows of width `wide`, with piers between them, as the wall has space for, and at most
# `most`; a few windows are in the middle or to one side.
function row(quarters, sill, head, wide, pier, most,    length_, edge, count, used, left, i) {
    length_ = wall_length(quarters)
    edge = .15
    wide = smaller(wide, length_ - 2 * edge)
    count = int((length_ - 2 * edge + pier) / (wide + pier) + 1e-9)
    if (count > most) count = most
    used = count * wide + (count - 1) * pier
    left = (length_ - used) / 2
    if (chance() < .3) left = larger(edge, smaller(left, one_of(".3 .45 .6 .9")))
    if (chance() < .5) left = length_ - used - left
    for (i = 0; i < count; i++)
        window(quarters, left + i * (wide + pier), sill, wide, head - sill)
}

# One window from wall to wall, or windows between posts.
function strip(quarters, sill, head,    edge, span, count) {
    if (chance() < .4) {
        edge = one_of(".1 .15 .2 .3")
        window(quarters, edge, sill, wall_length(quarters) - 2 * edge, head - sill)
        return
    }
    row(quarters, sill, head, one_of("1.05 1.2 1.5 1.8 2.4"), one_of(".15 .2 .3 .45 .6"), 99)
}

# ---- outside ----

function ground_level() { return ground_floor ? one_of("0 0 -.15 -.3 -.5") : -storey * floors }

# Obstructions in front of the main wall; `obstruction` and `away` are for rooms.csv.
function outside(kind,    angle, high, d, middle, from, to, house, fence) {
    middle = (sill + head) / 2 - ground
    obstruction = away = 0
    if (kind == "skyline") {
        angle = between(5, ground_floor ? 40 : 30, 5)
        say("  <skyline wall=\"" wall_name(0) "\"" has("angle", angle) has("reflectance",
            one_of(".1 .2 .2 .2 .3")) "/>")
        obstruction = angle
    } else if (kind == "distant-street") { # a skyline with a distance
        angle = between(10, ground_floor ? 50 : 35, 5)
        d = one_of("8 10 12 12 15 18 20 25")
        say("  <skyline wall=\"" wall_name(0) "\"" has("angle", angle) has("distance", d) \
            has("reflectance", one_of(".15 .2 .2 .3 .4 .5")) "/>")
        obstruction = angle; away = d
        front()
    } else if (kind == "street") { # a terrace, or a building by itself
        d = one_of("9 12 14 16 18 20 24")
        angle = between(10, ground_floor ? 45 : 30, 5)
        high = middle + d * tangent(angle)
        from = width / 2 - between(8, 40, 4); to = width / 2 + between(8, 40, 4)
        block(from, -d - 10, to, -d, high, "")
        obstruction = angle; away = d
        front()
    } else if (kind == "garden") {
        fence = one_of("6 8 10 12 15")
        block(width / 2 - 6, -fence - .2, width / 2 + 6, -fence, one_of("1.2 1.6 1.8 1.8 2"), "")
        house = fence + one_of("6 8 10 12")
        high = one_of("5.5 6 8.5")
        block(width / 2 - 7 + between(-3, 3, 1), -house - 8, width / 2 + 8, -house, high, \
            chance() < .5 ? " roof=\"gable\"" has("pitch", one_of("30 35 40")) : "")
        obstruction = larger(0, degrees(high - middle, house)); away = house
    }
}

# A skyline in front of another wall.
function second_skyline(quarters, angle) {
    say("  <skyline wall=\"" wall_name(quarters) "\"" has("angle", angle) "/>")
    obstruction = larger(obstruction, angle)
}

# The façade of the room's own building.
function front() {
    if (chance() > .5) return
    say("  <facade wall=\"" wall_name(0) "\"" has("left", between(3, 12, 3)) \
        has("right", between(3, 12, 3)) \
        has("up", one_of("3 3 6 9")) has("down", ground_floor ? 0 : -ground) \
        has("reflectance", one_of(".2 .25 .3 .4 .5")) "/>")
}

# ---- points ----

# A point, u from the left and v from the main window wall; `depths` gets its depth.
function point(u, v,    nearest) {
    nearest = v
    if (has_window[1]) nearest = smaller(nearest, width - u)
    if (has_window[2]) nearest = smaller(nearest, depth - v)
    if (has_window[3]) nearest = smaller(nearest, u)
    say("  <point" has("x", x_of(u, v)) has("y", y_of(u, v)) "/>")
    depths = depths " " sprintf("%.2f", nearest / larger(.5, head - plane))
}

# Six to eight points: a line perpendicular to the window wall, or a grid.
function points(    margin, far, count, columns, rows, i, j, u) {
    margin = smaller(from_walls, smaller(width, depth) / 4)
    if (chance() < .4) {
        count = between(6, 8, 1)
        u = width * one_of(".25 .4 .5 .5 .5 .6")
        for (i = 0; i < count; i++)
            point(u, margin + i * (depth - 2 * margin) / (count - 1))
        return
    }
    split(one_of("2x3 2x3 3x2 2x4 4x2"), far, "x")
    columns = far[1]; rows = far[2]
    for (j = 0; j < rows; j++)
        for (i = 0; i < columns; i++)
            point(margin + i * (width - 2 * margin) / (columns - 1), \
                margin + j * (depth - 2 * margin) / (rows - 1))
}

# ---- kinds of rooms ----

function sizes(u, v, high) {
    width = u; depth = v; height = high
}

# Sill and head; the head leaves space for a lintel in a low room.
function heights(low, high) {
    sill = low
    head = smaller(high, height - one_of("0.1 0.2 0.2 0.3"))
}

function choose_size() {
    is_home = kind ~ /^(Living room|Bedroom|Kitchen|Corner living room|Attic)$/
    if (kind == "Cellular office") {
        sizes(one_of("2.4 2.7 3 3 3.6 3.6 4.05 4.2 4.8"), one_of("3.9 4.2 4.5 4.8 5 5.4 6"),
            one_of("2.5 2.6 2.7 2.7 2.8 3 3.2"))
        heights(one_of("0 .6 .75 .8 .85 .9 .9"), one_of("2.1 2.2 2.4 2.4 2.6 2.7"))
        plane = one_of(".72 .75 .8 .85")
    } else if (kind == "Open office") {
        sizes(one_of("8.1 9.6 10.8 12 13.5 16.2 18 21.6"), one_of("6 7.2 7.5 9 10 12 14.4"),
            one_of("2.7 2.8 3 3 3.2 3.5"))
        heights(one_of("0 .3 .75 .8 .9 .9"), one_of("2.3 2.4 2.5 2.7 2.8 3"))
        plane = one_of(".72 .75 .8 .85")
    } else if (kind == "Classroom") {
        sizes(one_of("7.2 7.5 8 8.4 9 9 9.6"), one_of("6 6.5 7 7.2 7.5 8"),
            one_of("2.7 2.8 3 3 3.2 3.3 3.6"))
        heights(one_of(".7 .8 .8 .9 1"), one_of("2.4 2.5 2.6 2.7 2.9 3.1"))
        plane = one_of(".6 .65 .7 .7 .75")
    } else if (kind == "Living room") {
        sizes(one_of("3.3 3.6 3.8 4 4.2 4.5 5 6"), one_of("3.6 4 4.2 4.5 5 5.5 6 7.2"),
            one_of("2.4 2.4 2.5 2.5 2.6 2.7 3"))
        heights(one_of("0 .05 .4 .6 .75 .8 .9"), one_of("2 2.1 2.1 2.2 2.3"))
        plane = .85
    } else if (kind == "Bedroom") {
        sizes(one_of("2.4 2.6 2.8 3 3.2 3.4 3.6 4"), one_of("2.7 3 3.3 3.6 3.9 4.2 4.5"),
            one_of("2.3 2.4 2.4 2.4 2.5 2.5 2.7"))
        heights(one_of(".6 .8 .9 .9 1 1.05"), one_of("2 2.1 2.1 2.2"))
        plane = .85
    } else if (kind == "Kitchen") {
        sizes(one_of("1.8 2.1 2.4 2.7 3 3.3 4"), one_of("2.4 2.7 3 3.3 3.6 4 4.8"),
            one_of("2.3 2.4 2.4 2.5 2.5 2.7"))
        heights(one_of("1 1.05 1.05 1.1 1.1 1.2"), one_of("2 2.1 2.1 2.2"))
        plane = one_of(".85 .85 .9")
    } else if (kind == "Ward") {
        sizes(one_of("3.3 3.6 4.2 6.6 7.2 7.5 9 12"), one_of("5.1 5.4 6 6.3 6.6 7.5"),
            one_of("2.6 2.7 2.7 2.8 3 3.3"))
        heights(one_of(".5 .6 .7 .8 .9"), one_of("2.2 2.3 2.4 2.4 2.6"))
        plane = one_of(".85 .85 .9")
    } else if (kind == "Meeting room") {
        sizes(one_of("3.6 4.2 4.8 5.4 6 7.2 8.1"), one_of("3.6 4.2 4.8 5 5.4 6 7"),
            one_of("2.6 2.7 2.8 3 3.2"))
        heights(one_of("0 .45 .75 .8 .9"), one_of("2.2 2.4 2.5 2.6"))
        plane = one_of(".72 .75 .75")
    } else if (kind == "Library") {
        sizes(one_of("7.5 9 10.5 12 14.4 16 18"), one_of("6 7.5 8 9 10.5 12"),
            one_of("3 3.2 3.5 3.6 4 4.5"))
        heights(one_of(".75 .9 1 1.2"), one_of("2.6 2.8 3 3.2 3.6"))
        plane = one_of(".72 .75 .75")
    } else if (kind == "Shop") {
        sizes(one_of("4 4.5 5 5.4 6 7.2 8"), one_of("5 6 7 8 9 10 12"),
            one_of("2.8 3 3 3.2 3.5 3.8"))
        heights(one_of("0 .2 .3 .45 .6"), one_of("2.3 2.5 2.6 2.8 3"))
        plane = one_of(".85 .9 1")
    } else if (kind == "Corner office") {
        sizes(one_of("3.6 4.2 4.8 5.4 6 7.2"), one_of("3.6 4.2 4.8 5.4 6"),
            one_of("2.6 2.7 2.8 3"))
        heights(one_of("0 .6 .8 .9 .9"), one_of("2.2 2.4 2.5"))
        plane = one_of(".72 .75 .8")
    } else if (kind == "Corner living room") {
        sizes(one_of("3.6 4 4.2 4.8 5.4"), one_of("4 4.5 5 5.5 6"), one_of("2.4 2.5 2.6 2.8"))
        heights(one_of(".4 .6 .8 .9"), one_of("2 2.1 2.2"))
        plane = .85
    } else if (kind == "Attic") {
        sizes(one_of("3 3.6 4 4.5 5 6"), one_of("5 6 6.6 7.2 8"), one_of(".9 1 1 1.2 1.5"))
        sill = .85; head = 2.1
        plane = .85
    } else { # a room under rooflights
        sizes(one_of("3.6 4.5 5 6 7.5 9"), one_of("4 5 6 7.2 9"),
            one_of("2.5 2.7 2.8 3 3.3 3.6"))
        heights(.9, 2.1)
        plane = one_of(".75 .85 .85")
    }
}

function windows() {
    if (kind ~ /office|Meeting/) {
        if (chance() < .6) strip(0, sill, head)
        else row(0, sill, head, one_of("1 1.2 1.2 1.5 1.8 2.1"), one_of(".3 .45 .6 .9"), 99)
    } else if (kind == "Classroom" || kind == "Ward" || kind == "Library")
        row(0, sill, head, one_of("1 1.2 1.5 1.5 1.8 2 2.4 3"), one_of(".2 .3 .3 .45 .6 .9 1.2"),
            99)
    else if (kind ~ /iving room/)
        row(0, sill, head, one_of(sill < .3 ? "1.2 1.5 1.8 2.4 3" : "1.2 1.5 1.8 2.1 2.4"),
            one_of(".6 .9 1.2"), one_of("1 1 2 2"))
    else if (kind == "Bedroom")
        row(0, sill, head, one_of(".9 1.1 1.2 1.2 1.5 1.8"), one_of(".6 .9"), one_of("1 1 1 2"))
    else if (kind == "Kitchen")
        row(0, sill, head, one_of(".6 .9 1 1.2 1.2 1.5 1.8"), .6, 1)
    else if (kind == "Shop")
        row(0, sill, head, (width - .4) * one_of(".4 .6 .8 1"), .3, 2)

    # A second window wall.
    if (kind ~ /^Corner/)
        row(one_of("1 3"), sill, head, one_of("1 1.2 1.5 1.8"), one_of(".3 .6 .9"),
            is_home ? one_of("1 2") : 99)
    else if (kind == "Open office" && depth >= 9 && chance() < .6)
        strip(2, sill, head)
    else if (kind == "Classroom" && chance() < .2)
        row(2, height - .9, height - .2, one_of("1.2 1.8 2.4"), .3, 99)
    else if (kind == "Library" && chance() < .3)
        row(2, sill, head, 1.2, one_of(".9 1.2 1.8"), 99)
    else if (kind == "Living room" && depth >= 6 && chance() < .6)
        row(2, .8, smaller(2.1, height - .2), one_of("1.2 1.5 1.8"), .9, 1)
}

# Roof windows of common sizes, one or several next to each other; often on one slope only.
function roof_windows(slope, length_,    wide, high, count, i, gap, low) {
    wide = one_of(".55 .78 .78 .94 1.14"); high = one_of(".98 1.18 1.18 1.4")
    low = one_of(".4 .6 .8 1")
    count = one_of("1 2 2 3")
    while (count * (wide + .3) > length_) count--
    gap = (length_ - count * wide) / (count + 1)
    for (i = 0; i < count; i++)
        say("  <window wall=\"" slope "\"" has("left", gap + i * (wide + gap)) has("sill", low) \
            has("width", wide) has("height", high) glass() "/>")
}

function rooflights(    wide, deep, columns, rows, i, j) {
    wide = one_of(".6 .9 1 1.2 1.5"); deep = one_of("0.9 1 1.2 1.8")
    columns = larger(1, int(width / 3)); rows = larger(1, int(depth / 3.5))
    for (j = 0; j < rows; j++)
        for (i = 0; i < columns; i++)
            say("  <rooflight" has("x", (i + .5) * width / columns - wide / 2) \
                has("y", (j + .5) * depth / rows - deep / 2) \
                has("width", wide) has("depth", deep) glass() has("reveal", one_of(".1 .2 .3")) "/>")
}

function choose_outside() {
    if (kind == "Shop") return one_of("street street distant-street distant-street none skyline")
    if (kind == "Attic") return one_of("none none none skyline")
    if (kind == "Rooflit room") return one_of("none skyline garden")
    if (is_home)
        return ground_floor ? \
            one_of("none garden garden garden street street distant-street skyline") : \
            one_of("none none garden street street distant-street skyline")
    return one_of("none none none skyline skyline skyline street street street " \
        "distant-street distant-street")
}

function make(n,    index_, i, plan) {
    state = 20011 + 7919 * n
    for (i = 0; i < 5; i++) chance()
    index_ = n * 127 % 300 # kinds alternate, so that the first rooms are a sample of all
    for (i = 1; index_ >= upto[i]; i++) {}
    kind = kinds[i]
    file = folder "/" n ".xml"
    split("", has_window)
    depths = ""; above = ""
    choose_size()
    choose_glazing()
    ground_floor = chance() < (kind ~ /Shop|Rooflit/ ? 1 : kind == "Attic" ? 0 : is_home ? .5 : .4)
    floors = one_of("1 1 2 2 3 4"); storey = is_home ? 2.8 : 3.5
    ground = ground_level()
    turn = kind ~ /Attic|Rooflit/ ? 0 : one_of("0 0 0 0 1 2 3")
    balcony_depth = one_of("0.9 1.2 1.2 1.5"); slab = one_of(".3 .4 .5 .6")
    if (kind == "Living room" && chance() < .3) above = one_of("slab balcony balcony")
    if (kind == "Bedroom" && chance() < .08) above = "slab"
    from_walls = one_of(".5 .5 .6 .75 1")

    say("<?xml version=\"1.0\" encoding=\"UTF-8\"?>")
    say("<room version=\"1\" name=\"" kind " " n "\">")
    say("  <site surroundings=\"" one_of("urban urban rural") "\"" \
        has("ground-reflectance", one_of(".1 .15 .2 .2 .2 .25 .3")) has("ground-level", ground) "/>")
    plan = turn % 2 ? has("width", depth) has("depth", width) : \
        has("width", width) has("depth", depth)
    if (kind == "Attic") {
        if (chance() < .6)
            plan = plan has("height", height) " roof=\"gable\" ridge=\"width\"" \
                has("pitch", one_of("35 40 42 45"))
        else { # under a lean-to roof
            depth = smaller(depth, 6)
            height = one_of("1.8 2.1 2.2")
            plan = has("width", width) has("depth", depth) has("height", height) \
                " roof=\"mono\" ridge=\"width\"" has("pitch", one_of("15 20 25 30"))
        }
    } else
        plan = plan has("height", height)
    say("  <plan" plan "/>")
    say("  <finishes" has("floor", one_of(".2 .2 .25 .3 .3 .35 .4")) \
        has("walls", one_of(".5 .55 .6 .6 .65 .7 .7 .75 .8")) \
        has("ceiling", one_of(".7 .75 .8 .8 .85")) "/>")
    if (kind !~ /Attic/ && chance() < .12)
        say("  <finish wall=\"" wall_name(3) "\"" has("reflectance", one_of(".2 .3 .4 .5")) "/>")
    if (kind == "Attic") {
        roof_windows("roof-south", width)
        if (plan ~ /gable/ && chance() < .4) roof_windows("roof-north", width)
    } else if (kind == "Rooflit room") {
        rooflights()
        if (chance() < .5) row(0, sill, head, one_of("1.2 1.8"), .6, 2)
    } else
        windows()
    if (kind !~ /Attic|Rooflit|Open|Library|Corner/ && !has_window[2] && chance() < .15)
        say("  <door wall=\"" wall_name(2) "\"" has("left", .4) has("reflectance",
            one_of(".2 .3 .5 .7")) "/>")
    outside(choose_outside())
    if (kind ~ /^Corner/ && chance() < .5)
        second_skyline(has_window[1] ? 1 : 3, one_of("10 15 20 30"))
    if (has_window[2] && chance() < .5)
        second_skyline(2, one_of("10 15 20 25"))
    say("  <working-plane" has("height", plane) "/>")
    points()
    say("</room>")
    close(file)
    if (!room)
        print n "," kind "," number(obstruction) "," number(away) "," \
            (kind ~ /Attic|Rooflit/ ? "yes" : "no") "," substr(depths, 2) >(folder "/rooms.csv")
}

BEGIN {
    walls[0] = "south"; walls[1] = "east"; walls[2] = "north"; walls[3] = "west"
    list = "Cellular office:40,Open office:28,Classroom:34,Living room:38,Bedroom:36,Kitchen:24," \
        "Ward:18,Meeting room:16,Corner office:10,Corner living room:10,Library:14,Shop:12," \
        "Attic:12,Rooflit room:8"
    sum = 0
    for (i = split(list, entries, ","); i > 0; i--) order[i] = entries[i]
    for (i = 1; i in order; i++) {
        split(order[i], entry, ":")
        kinds[i] = entry[1]
        upto[i] = sum += entry[2]
    }
    if (!folder) folder = "."
    if (!room)
        print "room,kind,obstruction_deg,obstruction_m,roof,depths" >(folder "/rooms.csv")
    for (n = room ? room : 1; n <= (room ? room : 300); n++)
        make(n)
}
