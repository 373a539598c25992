# odd_rooms.awk - valid but unusual rooms and buildings: sizes from millimetres to hundreds of
# metres, openings from edge to edge, slivers, surfaces without area, reflectances of 0 and 1,
# numbers with 17 digits, elements in any order. Many also violate a rule of the file format; the
# program must then reject them with a message.
#
#    awk -v folder=DIR -v room=17 -f odd_rooms.awk    DIR/17.xml, with DIR/17-1.obj and so on
#
# Prints a point in the room, X,Y.
#
# The script generates its own random numbers, so that every awk gives the same rooms.

# ---- choices ----

# A number from 0 to below 1: the minimal standard generator of Park and Miller.
function chance() {
    state = state * 16807 % 2147483647
    return state / 2147483647
}
function between(low, high) { return low + (high - low) * chance() }
function one_of(list,    words, count) {
    count = split(list, words, " ")
    return words[1 + int(count * chance())]
}
function number(value,    r) {
    r = chance()
    return sprintf(r < .7 ? "%.4g" : r < .9 ? "%.9g" : "%.17g", value)
}
function has(name, value) { return sprintf(" %s=\"%s\"", name, value) }
function exact(name, value) { return sprintf(" %s=\"%.17g\"", name, value) }
function vertex(x, y) { return "<vertex" exact("x", x) exact("y", y) "/>" }

# Elements of a room come in any order.
function add(text) { parts[++part_count] = text }
function shuffled(    i, k, text, all) {
    for (i = part_count; i > 0; i--) {
        k = 1 + int(i * chance())
        all = all "  " parts[k] "\n"
        parts[k] = parts[i]
    }
    part_count = 0
    return all
}

# ---- outside ----

# A mesh of triangles; some are points, lines, slivers, or duplicates.
function mesh(    name, file, count, i, k, base, corners, x, y, z, t, line) {
    name = room "-" ++mesh_count ".obj"
    file = folder "/" name
    count = one_of("1 2 5 20 60")
    base = 0
    for (i = 0; i < count; i++) {
        x = between(-20, 20); y = between(-30, -3); z = between(0, 15)
        t = chance()
        corners = 3
        for (k = 0; k < 3; k++) {
            if (t < .5)
                print "v", x + between(-4, 4), y + between(-1.5, 1.5), z + between(-3, 4) >file
            else if (t < .65)
                print "v", x, y, z >file
            else if (t < .8)
                print "v", x + k, y, z >file
            else
                print "v", x + (k > 0) * 4, y, z + (k == 2) * 1e-9 >file
        }
        line = "f " base + 1 " " base + 2 " " base + 3
        print line >file
        if (chance() < .3) print line >file
        if (chance() < .2) print "f " base + 3 " " base + 2 " " base + 1 >file
        base += corners
    }
    close(file)
    return "<mesh" has("file", name) has("x", number(between(-1, 1))) \
        has("y", number(between(-3, 0))) has("rotate", one_of("0 45.0001 180 1e-7")) "/>"
}

function block(away,    x, y, w, d, turn, roof) {
    x = between(-30, 20)
    w = one_of(".0011 .5 3 10 40 200"); d = one_of(".0011 .5 3 10")
    y = between(-60, -3 - away)
    if (y > -1 - d - away) y = -1 - d - away
    turn = one_of("0 0 0 45.0001 90 1e-6 -.0001")
    if (turn * turn > 1) y -= w + d + 2
    roof = w > .1 && d > .1 && chance() < .25 ? has("roof", one_of("mono gable hip")) \
        has("pitch", one_of("1 30 45 60 84.9")) has("ridge", one_of("width depth longer")) : ""
    if (chance() < .1)
        return "<block" has("height", one_of("1 20")) ">" vertex(x, y - 5) vertex(x + 6, y - 5) \
            vertex(x + 6, y) vertex(x + 3, y - 4.9) "</block>"
    return "<block" has("x", number(x)) has("y", number(y)) has("width", w) has("depth", d) \
        has("height", one_of(".0011 1 5 20 300")) has("rotate", turn) \
        has("reflectance", one_of("0 .2 1 .99 snow")) roof "/>"
}

# ---- openings ----

function pane(    r, text) {
    r = chance()
    text = r < .35 ? has("glazing", one_of("none clear-double opal-glass rough-cast " \
            "low-e-triple etched-glass solar-control-dark")) : \
        r < .5 ? has("transmittance", one_of(".001 1 .5 .92")) \
            (chance() < .3 ? " diffusing=\"yes\"" : "") : ""
    if (chance() < .3) text = text has("frame-factor", one_of("metal .5 1 wood .01"))
    if (chance() < .2) text = text has("maintenance", one_of("auto .5"))
    return text
}

function device(high,    r) {
    r = chance()
    if (r < .25)
        return "<overhang" has("depth", one_of(".001 .8 5")) has("above", one_of("0 .1")) \
            has("left", one_of("0 .3")) "/>"
    if (r < .5)
        return "<fin" has("depth", one_of(".3 2")) has("side", one_of("left right both")) \
            has("gap", one_of("0 .1")) "/>"
    if (r < .7) return "<shelf" has("height", number(high * .6)) " depth=\"0.4\"/>"
    if (r < .85) return "<balcony depth=\"1.2\"" has("parapet", one_of("0 1.1")) "/>"
    return "<blind" has("angle", one_of("0 45 -80 89")) "/>"
}

# The windows of a wall, in cells: windows that fill their cells have common edges.
function windows(wall, length_, count,    i, left, wide, sill, high, t, reveal) {
    reveal = one_of("0 0 0 .1 .3 1") * (scale < 1 ? scale : 1)
    for (i = 0; i < count; i++) {
        left = length_ / count * i; wide = length_ / count
        t = chance()
        if (t > .3 && t < .4) wide = wide / 1000 > .001 ? wide / 1000 : wide / 2
        else if (t >= .4) {
            left += wide / 10
            wide *= .7
        }
        t = chance()
        sill = t < .25 ? 0 : t < .35 ? height * .5 : height * .3
        high = t < .15 ? height : t < .42 && t >= .35 ? height * .001 : height * .5
        if (sill + high > height) high = height - sill
        add("<window" has("wall", wall) exact("left", left) exact("sill", sill) \
            exact("width", wide) exact("height", high) exact("reveal", reveal) pane() ">" \
            (chance() < .2 && !placed ? device(high) : "") "</window>")
    }
}

# ---- rooms ----

# The plan; its walls, and their lengths.
function plan(kind,    i, k, x, y, corners, text) {
    wall_count = 4
    split("south east north west", walls, " ")
    lengths[1] = lengths[3] = width; lengths[2] = lengths[4] = depth
    roof = ""
    if (kind == "roof") {
        roof = one_of("mono gable hip saw-tooth")
        return "<plan" exact("width", width) exact("depth", depth) exact("height", height) \
            has("roof", roof) has("pitch", roof == "saw-tooth" ? one_of("20 30 45") : \
                one_of("1 10 35 45 60 85")) \
            has("ridge", roof == "hip" ? "longer" : one_of("width depth longer")) \
            (roof == "saw-tooth" ? " teeth=\"2\"" : "") "/>"
    }
    if (kind == "box")
        return "<plan" exact("width", width) exact("depth", depth) exact("height", height) "/>"
    # Steps down to the left; two steps are an L-shape.
    k = kind == "L" ? 2 : one_of("3 6 15")
    corners = 0
    xs[++corners] = 0; ys[corners] = 0
    xs[++corners] = width; ys[corners] = 0
    for (i = 0; i < k; i++) {
        x = width * (1 - i / k); y = depth * (i + 1) / k
        xs[++corners] = x; ys[corners] = y
        xs[++corners] = i < k - 1 ? width * (1 - (i + 1) / k) : 0; ys[corners] = y
    }
    wall_count = corners
    for (i = 1; i <= corners; i++) {
        k = i % corners + 1
        walls[i] = i
        lengths[i] = sqrt((xs[k] - xs[i]) ^ 2 + (ys[k] - ys[i]) ^ 2)
        text = text vertex(xs[i], ys[i])
    }
    return "<plan" exact("height", height) ">" text "</plan>"
}

function points(plane,    r, i, count) {
    r = chance()
    count = one_of("1 2 3")
    if (r < .6)
        for (i = 0; i < count; i++)
            add("<point" has("x", number(width * between(.05, .15))) \
                has("y", number(depth * between(.05, .45))) "/>")
    else if (r < .7) { # on a wall, and on the floor
        add("<point" exact("x", width * .1) " y=\"0\"" exact("z", height * .2) \
            " nx=\"0\" ny=\"1\" nz=\"0\"/>")
        add("<point" exact("x", width * .1) exact("y", depth * .1) \
            " z=\"0\" nx=\"0\" ny=\"0\" nz=\"1\"/>")
    } else if (r < .85)
        add("<grid" exact("spacing", (width > depth ? width : depth) / 6) \
            exact("margin", one_of("0 .1") * (width < depth ? width : depth)) "/>")
    else
        add("<line from=\"" width * .1 " " depth * .05 "\" to=\"" width * .1 " " depth * .9 "\"" \
            has("points", one_of("2 5")) "/>")
}

# The attributes of a room in `room_attributes`; returns its elements.
function make_room(    kind, i, first, count, used, plane, many) {
    kind = one_of("box box box box box L L stairs roof roof")
    r = chance()
    scale = placed || r > .12 ? 1 : r < .03 ? .002 : r < .06 ? .1 : r < .09 ? 30 : 300
    width = one_of("1 2.5 3 4 6.37 12") * scale
    depth = one_of("1 2.5 3 4 6.37 12") * scale
    height = one_of("2.1 2.4 2.8 3.3 6") * scale
    room_attributes = chance() < .6 ? has("use", one_of("office kitchen bedroom living-room ward " \
        "classroom store circulation")) : ""
    if (!placed && chance() < .3)
        room_attributes = room_attributes has("north", one_of("0 45.0001 -180 359.999999"))
    add(plan(kind))
    if (chance() < .7)
        add("<finishes" has("floor", one_of("0 .2 1 .95 white-paint mirror")) \
            has("walls", one_of("0 .5 .99 brick 1")) has("ceiling", one_of("0 .7 .999 white-paint")) \
            has("decorations", one_of("1 auto .5 .01")) "/>")
    count = one_of("0 1 1 1 1 1 2 2 2 5")
    if (chance() < .03) count = 12
    first = int(wall_count * chance())
    used = one_of("1 1 2 3")
    for (i = 0; i < used; i++) {
        k = (first + i) % wall_count + 1
        if (count > 0) windows(walls[k], lengths[k], count)
        if (chance() < .25)
            add("<skyline" has("wall", walls[k]) has("angle", one_of(".001 20 45 60 89.9")) \
                (chance() < .5 ? has("distance", one_of("1.5 10 1000")) : "") "/>")
        if (!placed && chance() < .15)
            add("<facade" has("wall", walls[k]) has("left", one_of("0 3")) \
                has("right", one_of("0 50")) has("up", one_of("0 9")) " down=\"0\"/>")
    }
    if (kind != "roof" && chance() < .3)
        add("<rooflight" exact("x", width * .05) exact("y", depth * .05) \
            exact("width", width * .1) exact("depth", depth * .1) pane() "/>")
    if (roof ~ /gable|hip/ && chance() < .7)
        add("<window" has("wall", one_of("roof-south roof-north roof-east roof-west")) \
            has("left", number(width * .3)) exact("sill", .1 * scale) exact("width", .3 * scale) \
            exact("height", .3 * scale) pane() "/>")
    if (roof == "saw-tooth")
        add("<window wall=\"light-1\"" has("left", number(width * .2)) exact("sill", .05 * scale) \
            exact("width", .4 * scale) exact("height", .2 * scale) pane() "/>")
    if (!placed) {
        many = chance() < .03 ? 100 : one_of("0 0 0 0 1 1 1 3 3 20")
        for (i = 0; i < many; i++) add(block(1))
        if (chance() < .25) add(mesh())
        if (chance() < .1)
            add("<surface" has("exitance", one_of("0 .1")) "><vertex x=\"-3\" y=\"-5\" z=\"0\"/>" \
                "<vertex x=\"5\" y=\"-5\" z=\"0\"/><vertex x=\"5\" y=\"-5\" z=\"4\"/>" \
                "<vertex x=\"-3\" y=\"-5\"" has("z", one_of("4 1")) "/></surface>")
    }
    if (scale == 1 && height < 4 && kind ~ /box|roof/ && width > 3 && depth > 3 && chance() < .3)
        add(chance() < .7 ? "<furniture x=\"1\" y=\"1\"" has("width", one_of(".001 1")) \
            " depth=\"0.6\"" has("height", one_of(".75 .85 2")) \
            has("rotate", one_of("0 0 45.0001")) "/>" : \
            "<column x=\"1.2\" y=\"1.2\" diameter=\"0.4\"" (roof ? " height=\"2\"" : "") "/>")
    if (scale == 1 && used < wall_count && chance() < .15)
        add("<door" has("wall", walls[(first + used) % wall_count + 1]) \
            " left=\"0\" width=\"0.9\" height=\"2\"/>")
    if (chance() < .1) add("<dado" exact("height", height * .3) " reflectance=\"0.25\"/>")
    spot = width * .12 "," depth * .2
    plane = one_of(".85 .85 0 .7") * scale
    add("<working-plane" exact("height", plane < height ? plane : 0) "/>")
    points(plane)
    return shuffled()
}

function site(    text) {
    text = ""
    if (chance() < .6)
        text = "<site" has("latitude", one_of("51.5 0 90 -90 -33.9 66.56")) \
            has("longitude", one_of("0 180 -.1")) " country=\"GB\"" \
            has("surroundings", one_of("rural urban industrial")) \
            has("ground-reflectance", one_of("0 .2 1 snow")) \
            has("ground-level", one_of("0 0 -10 -.001")) has("ground", one_of("shaded open")) "/>\n"
    if (chance() < .25)
        text = text "<sky" has("type", one_of("overcast uniform iso-1 iso-5")) "/>\n"
    else if (chance() < .1)
        text = text "<sky" has("type", one_of("iso-12 iso-15 iso-7")) \
            has("sun-altitude", one_of(".001 30 89.999")) has("sun-bearing", one_of("0 180 359")) "/>\n"
    return text
}

function make_building(    count, i, x, turn, text, states, elements) {
    text = "<building version=\"1\"" has("north", one_of("0 45.0001")) \
        (chance() < .2 ? " glass-reflectance=\"0.15\"" : "") ">\n" site()
    states = chance() < .5
    count = one_of("0 1 4")
    for (i = 0; i < count; i++) {
        elements = block(15)
        sub(/<block/, "<block name=\"Block " i "\"" \
            (states ? has("state", one_of("existing proposed")) : ""), elements)
        text = text elements "\n"
    }
    if (chance() < .4)
        text = text "<garden name=\"G\">" vertex(0, -9) vertex(9, -9) vertex(9, -2) vertex(0, -2) \
            "</garden>\n"
    if (chance() < .2) text = text mesh() "\n"
    count = one_of("2 3 5")
    placed = 1
    for (i = 0; i < count; i++) {
        turn = one_of("0 0 45.0001 90 1e-6")
        x = turn == "0" ? one_of("0 20 13") * i : 40 * i
        if (chance() < .1) x = 3 * i # they may overlap
        elements = make_room()
        text = text "<room" has("name", "R" i) room_attributes has("x", x) " y=\"0\"" \
            has("z", one_of("0 0 3.1")) has("rotate", turn) ">\n" elements "</room>\n"
    }
    return text "</building>"
}

BEGIN {
    state = (20011 + 7919 * room) % 2147483646 + 1
    for (i = 0; i < 5; i++) chance()
    if (chance() < .25)
        text = make_building()
    else {
        text = site() make_room()
        text = "<room version=\"1\" name=\"A\"" room_attributes ">\n" text "</room>"
    }
    print text >(folder "/" room ".xml")
    print spot
}
