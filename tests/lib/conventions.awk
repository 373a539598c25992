# conventions.awk - for tests of the elements of a room file: writes a room with these elements,
# and the same room with everything written as polygons.
#
#    awk -f conventions.awk -v number=N -v written=no      reveal, frame-factor, facade, ...
#    awk -f conventions.awk -v number=N -v written=yes     surfaces
#
# Openings are unglazed, so that polygons can represent frame and reveal. Rooms with the same
# number have the same dimensions. u is measured along the window wall from its left end as seen
# from outside, v outwards from its inner face.

function dice(low, high) {
    state = (state * 48271) % 2147483647
    return low + (high - low) * state / 2147483647
}

function chance(share) {
    return dice(0, 1) < share
}

function vertex(u, v, z, x, y) {
    x = wall == "south" ? u : wall == "east" ? width + v : wall == "north" ? width - u : -v
    y = wall == "south" ? -v : wall == "east" ? u : wall == "north" ? depth + v : depth - u
    return sprintf("<vertex x=\"%.9g\" y=\"%.9g\" z=\"%.9g\"/>", x, y, z)
}

# Rectangles: in u and z at v; in u and v at z; in v and z at u.
function upright(u1, u2, v, z1, z2, attributes) {
    if (u2 > u1 && z2 > z1)
        print "<surface " attributes ">" vertex(u1, v, z1) vertex(u2, v, z1) vertex(u2, v, z2) \
            vertex(u1, v, z2) "</surface>"
}
function level(u1, u2, v1, v2, z, attributes) {
    print "<surface " attributes ">" vertex(u1, v1, z) vertex(u2, v1, z) vertex(u2, v2, z) \
        vertex(u1, v2, z) "</surface>"
}
function across(u, v1, v2, z1, z2, attributes) {
    print "<surface " attributes ">" vertex(u, v1, z1) vertex(u, v2, z1) vertex(u, v2, z2) \
        vertex(u, v1, z2) "</surface>"
}

function reflects(share) {
    return sprintf("reflectance=\"%.9g\"", share)
}

# Four pieces around the opening within a rectangle of the wall.
function around(u1, u2, v, z1, z2, attributes) {
    upright(u1, u2, v, z1, sill, attributes)
    upright(u1, u2, v, head, z2, attributes)
    upright(u1, left, v, sill, head, attributes)
    upright(right, u2, v, sill, head, attributes)
}

# The four sides of the reveal, and forty bars of the frame, 2 mm inside the opening: a surface
# closer than 1 mm to a wall would be treated as its cladding.
function write_opening(i, bar, from) {
    if (reveal > 0) {
        level(left, right, 0, reveal, sill, reflects(walls))
        level(left, right, 0, reveal, head, reflects(walls))
        across(left, 0, reveal, sill, head, reflects(walls))
        across(right, 0, reveal, sill, head, reflects(walls))
    }
    bar = (1 - glass) * (right - left) / 40
    for (i = 0; i < 40 && bar > 0; i++) {
        from = left + (i + 0.5) * (right - left) / 40 - bar / 2
        upright(from, from + bar, reveal - 0.002, sill, head, reflects(walls))
    }
}

function write_shade(v) {
    v = reveal
    if (shade == "overhang")
        level(left - 0.3, right + 0.2, v, v + 0.9, head + 0.1, reflects(0.4))
    if (shade == "fin") {
        across(left - 0.1, v, v + 0.6, sill - 0.2, head + 0.3, reflects(0.5))
        across(right + 0.1, v, v + 0.6, sill - 0.2, head + 0.3, reflects(0.5))
    }
    if (shade == "balcony") {
        level(left - 0.5, right + 0.4, v, v + 1.2, 0.02, reflects(0.3))
        upright(left - 0.5, right + 0.4, v + 1.2, 0.02, 1.02, reflects(0.3))
        across(left - 0.5, v, v + 1.2, 0.02, 1.02, reflects(0.3))
        across(right + 0.4, v, v + 1.2, 0.02, 1.02, reflects(0.3))
    }
}

function say_shade() {
    if (shade == "overhang")
        print "<overhang depth=\"0.9\" above=\"0.1\" left=\"0.3\" right=\"0.2\" reflectance=\"0.4\"/>"
    if (shade == "fin")
        print "<fin depth=\"0.6\" gap=\"0.1\" below=\"0.2\" above=\"0.3\" reflectance=\"0.5\"/>"
    if (shade == "balcony")
        print "<balcony depth=\"1.2\" left=\"0.5\" right=\"0.4\" level=\"0.02\" parapet=\"1\" reflectance=\"0.3\"/>"
}

# The façade, 2 mm in front of the plane of the glass; the wall of the skyline; the ground.
function write_outside(bottom, top, corners, i) {
    bottom = -up_to_ground < ground ? ground : -up_to_ground
    if (facade)
        around(-beside, span + beside, reveal + 0.002, bottom, height + over, reflects(front))
    top = (sill + head) / 2 + distance * sin(angle) / cos(angle)
    if (skyline == "near")
        upright(-9000, 9000 + span, distance, ground, top, reflects(opposite))
    if (skyline == "far") # Ev/Eh of the overcast sky, before a ground that reflects nothing
        upright(-90000, 90000, 1800, -1, 1800 * sin(angle) / cos(angle), \
            sprintf("reflectance=\"0\" exitance=\"%.9g\"", opposite * 0.39617))
    for (i = 0; i < 4 && soil > 0; i++) # at least 5 mm under the floor, to be outside
        corners = corners sprintf("<vertex x=\"%d\" y=\"%d\" z=\"%g\"/>", \
            i == 1 || i == 2 ? 9000 : -9000, i > 1 ? 9000 : -9000, ground - 0.005)
    if (soil > 0)
        print "<surface " reflects(soil) ">" corners "</surface>"
}

function say_outside() {
    if (facade)
        printf "<facade wall=\"%s\" left=\"%.9g\" right=\"%.9g\" up=\"%.9g\" down=\"%.9g\" reflectance=\"%.9g\"/>\n", \
            wall, beside, beside, over, up_to_ground, front
    if (skyline != "none")
        printf "<skyline wall=\"%s\" angle=\"%.9g\" reflectance=\"%.9g\"%s/>\n", wall, \
            angle * 180 / atan2(0, -1), opposite, \
            skyline == "near" ? sprintf(" distance=\"%.9g\"", distance) : ""
}

BEGIN {
    state = 7919 * number + 104729
    for (i = 0; i < 20; i++) dice(0, 1)
    said = written == "no"
    split("south east north west", walls_of, " ")
    wall = walls_of[1 + number % 4]
    width = dice(2.6, 5.4); depth = dice(2.8, 6.2); height = dice(2.4, 3.2)
    span = number % 2 ? depth : width
    walls = dice(0.3, 0.8)
    left = dice(0.4, 0.9); right = span - dice(0.3, 0.8)
    sill = dice(0.5, 1.0); head = height - dice(0.2, 0.5)
    reveal = chance(0.5) ? dice(0.05, 0.4) : 0
    glass = chance(0.5) ? dice(0.6, 0.95) : 1
    split("overhang fin balcony none none none", shades, " ")
    shade = shades[1 + int(dice(0, 6))]
    split("near near far none none", skylines, " ")
    skyline = skylines[1 + int(dice(0, 5))]
    angle = dice(12, 50) * atan2(0, -1) / 180
    distance = dice(6, 30); opposite = dice(0.1, 0.7)
    facade = skyline != "far" && chance(0.6)
    beside = dice(2, 20); over = dice(1, 9); up_to_ground = dice(0, 6); front = dice(0.1, 0.7)
    ground = chance(0.5) ? -3 * int(dice(1, 5)) : 0
    soil = skyline == "far" ? 0 : dice(0.1, 0.5)

    print "<room version=\"1\" name=\"Conventions " number "\">"
    printf "<site ground-level=\"%g\" ground-reflectance=\"%.9g\"/>\n", \
        said ? ground : ground - 0.01, said ? soil : 0
    printf "<plan width=\"%.9g\" depth=\"%.9g\" height=\"%.9g\"/>\n", width, depth, height
    printf "<finishes floor=\"%.9g\" walls=\"%.9g\" ceiling=\"%.9g\"/>\n", dice(0.15, 0.4), walls, \
        dice(0.6, 0.85)
    printf "<window wall=\"%s\" left=\"%.9g\" sill=\"%.9g\" width=\"%.9g\" height=\"%.9g\" glazing=\"none\"", \
        wall, left, sill, right - left, head - sill
    if (said) {
        printf " reveal=\"%.9g\" frame-factor=\"%.9g\">\n", reveal, glass
        say_shade()
    } else
        print ">"
    print "</window>"
    if (said)
        say_outside()
    else {
        write_opening()
        write_shade()
        write_outside()
    }
    for (i = 0; i < 3; i++)
        printf "<point x=\"%.9g\" y=\"%.9g\"/>\n", width * dice(0.2, 0.8), depth * dice(0.15, 0.85)
    print "</room>"
}
