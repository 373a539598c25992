/* test_envelope.c - rooms of any shape: closed, with the right orientation, cut by the
 * working plane. */
#include <stdlib.h>

#include "model/geometry/polygon.h"
#include "model/room/world.h"
#include "tests/lib/room_of.h"
#include "model/room/position.h"

/* A text buffer. */
struct text {
    char bytes[32768];
    int length;
};

static void add(struct text *text, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void add(struct text *text, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    text->length += vsnprintf(text->bytes + text->length,
                              sizeof text->bytes - text->length, format, args);
    va_end(args);
    assert_true(text->length < (int)sizeof text->bytes);
}

/* Faces of a prism: the profile in the x-z plane, counter-clockwise seen from the
 * south, extruded from y = 0 to depth. Edge i has a role and a name. */
struct profile {
    int count;
    const double (*xz)[2];
    const char *const *roles; /* of the edges */
    double depth;
};

static void add_vertex(struct text *text, double x, double y, double z)
{
    add(text, "<vertex x=\"%.17g\" y=\"%.17g\" z=\"%.17g\"/>", x, y, z);
}

static void add_prism(struct text *text, const struct profile *p)
{
    for (int end = 0; end < 2; end++) {
        /* From inside, the south end appears clockwise, the north end as in the
         * profile. */
        add(text, "<face role=\"wall\" name=\"%s\">", end ? "north" : "south");
        for (int i = 0; i < p->count; i++) {
            int k = end ? i : p->count - 1 - i;
            add_vertex(text, p->xz[k][0], end ? p->depth : 0.0, p->xz[k][1]);
        }
        add(text, "</face>\n");
    }
    for (int i = 0; i < p->count; i++) {
        const double *a = p->xz[i], *b = p->xz[(i + 1) % p->count];
        add(text, "<face role=\"%s\" name=\"edge-%d\">", p->roles[i], i);
        add_vertex(text, a[0], 0.0, a[1]);
        add_vertex(text, b[0], 0.0, b[1]);
        add_vertex(text, b[0], p->depth, b[1]);
        add_vertex(text, a[0], p->depth, a[1]);
        add(text, "</face>\n");
    }
}

static struct pp_world *prism_room(const struct profile *profile, const char *parts)
{
    struct text text = {.length = 0};
    add(&text, "<room version=\"1\"><envelope>\n");
    add_prism(&text, profile);
    add(&text, "</envelope>\n%s</room>", parts);
    return pp_test_world(text.bytes);
}

/* The flux of a constant field, and of the position vector, out of the envelope. */
static void check_closed(const struct pp_world *world, double volume_m3)
{
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    double flow = 0.0;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        struct pp_vec3 area = pp_vec_scale(face->normal, face->area_m2);
        sum = pp_vec_add(sum, area);
        flow -= pp_vec_dot(area, pp_polygon_middle(face));
    }
    assert_near(pp_vec_length(sum), 0.0, 1e-12 * (1.0 + volume_m3));
    assert_relative(flow / 3.0, volume_m3, 1e-12);
}

/* Seen from the south the floor is first, then the right-hand wall. */
static const char *const box_roles[] = {"floor", "wall", "ceiling", "wall"};

static void an_envelope_of_a_plan_s_faces_is_the_plan(void **state)
{
    (void)state;
    static const double box[4][2] = {{0.0, 0.0}, {4.3, 0.0}, {4.3, 2.9}, {0.0, 2.9}};
    struct profile profile = {4, box, box_roles, 6.1};
    static const char parts[] =
        "<window wall=\"%s\" left=\"0.4\" sill=\"0.7\" width=\"1.1\" height=\"1.3\" "
        "reveal=\"0.2\"/>"
        "<window wall=\"%s\" left=\"0.4\" sill=\"0.7\" width=\"1.1\" height=\"1.3\"/>"
        "<rooflight x=\"1.1\" y=\"2.3\" width=\"0.8\" depth=\"1.4\"/>";
    char of_plan[1024], of_envelope[1024];
    int length = snprintf(of_plan, sizeof of_plan,
                          "<room version=\"1\">"
                          "<plan width=\"4.3\" depth=\"6.1\" height=\"2.9\"/>");
    snprintf(of_plan + length, sizeof of_plan - length, parts, "north", "east");
    strcat(of_plan, "</room>");
    snprintf(of_envelope, sizeof of_envelope, parts, "north", "edge-1");
    struct pp_world *plan = pp_test_world(of_plan);
    struct pp_world *envelope = prism_room(&profile, of_envelope);

    check_closed(plan, 4.3 * 6.1 * 2.9);
    check_closed(envelope, 4.3 * 6.1 * 2.9);
    assert_int_equal(plan->surface_count, envelope->surface_count);
    assert_int_equal(plan->receiver_count, envelope->receiver_count);
    assert_near(pp_region_area(&plan->plane), pp_region_area(&envelope->plane), 1e-12);
    for (int i = 0; i < 3; i++) {
        const struct pp_opening *a = &plan->openings[i], *b = &envelope->openings[i];
        for (int k = 0; k < 4; k++) {
            assert_near(
                pp_vec_length(pp_vec_sub(a->inner.vertices[k], b->inner.vertices[k])),
                0.0, 1e-12);
            assert_near(
                pp_vec_length(pp_vec_sub(a->outer.vertices[k], b->outer.vertices[k])),
                0.0, 1e-12);
        }
        assert_near(pp_vec_length(pp_vec_sub(a->along, b->along)), 0.0, 1e-15);
    }
    pp_world_destroy(plan);
    pp_world_destroy(envelope);
}

static void a_gable_s_section_narrows_with_height(void **state)
{
    (void)state;
    static const double gable[5][2] = {
        {0.0, 0.0}, {5.0, 0.0}, {5.0, 2.1}, {2.5, 4.6}, {0.0, 2.1}};
    static const char *const roles[] = {"floor", "wall", "ceiling", "ceiling", "wall"};
    struct profile profile = {5, gable, roles, 7.3};
    static const double height[] = {0.85, 2.1, 3.1, 4.5};
    for (int i = 0; i < 4; i++) {
        char parts[128];
        snprintf(parts, sizeof parts, "<working-plane height=\"%g\"/>", height[i]);
        struct pp_world *world = prism_room(&profile, parts);
        double width = 5.0 - 2.0 * fmax(height[i] - 2.1, 0.0);
        assert_near(pp_region_area(&world->plane), width * 7.3, 1e-12);
        check_closed(world, 7.3 * (5.0 * 2.1 + 2.5 * 2.5));
        assert_true(pp_position_in_room(world, pp_vec(2.4, 3.3, 4.4)));
        assert_false(pp_position_in_room(world, pp_vec(1.0, 3.3, 4.4)));
        assert_false(pp_position_in_room(world, pp_vec(2.4, 3.3, 4.6)));
        pp_world_destroy(world);
    }
}

/* A roof with two ridges; its valley is at 3 m. */
static const double saw[7][2] = {{0.0, 0.0}, {8.0, 0.0}, {8.0, 3.5}, {6.0, 5.0},
                                 {4.0, 3.0}, {2.0, 5.0}, {0.0, 3.5}};
static const char *const saw_roles[] = {"floor",   "wall",    "ceiling", "ceiling",
                                        "ceiling", "ceiling", "wall"};

static void a_section_above_the_valley_falls_into_two(void **state)
{
    (void)state;
    struct profile profile = {7, saw, saw_roles, 6.0};
    static const struct {
        double height, width;
        int rings;
    } cases[] = {
        {2.9, 8.0, 1},
        {3.0, 8.0,
         2}, /* at the valley: just above it there are two regions that touch */
        {3.5, 8.0 - 2 * 0.5, 2},
        {4.5, 2 * (0.5 * 2.0 / 1.5 + 0.5), 2},
    };
    for (int i = 0; i < 4; i++) {
        char parts[128];
        snprintf(parts, sizeof parts, "<working-plane height=\"%g\"/>",
                 cases[i].height);
        struct pp_world *world = prism_room(&profile, parts);
        assert_int_equal(world->plane.count, cases[i].rings);
        assert_near(pp_region_area(&world->plane), cases[i].width * 6.0, 1e-12);
        assert_true(world->receiver_count > 0);
        for (int k = 0; k < world->receiver_count; k++)
            assert_true(pp_position_in_room(world, world->receivers[k].position));
        pp_world_destroy(world);
    }
}

/* A room with a shaft through it: floor and ceiling with a hole cannot be one outline
 * each, so each is divided in two, and the sides of the shaft face outwards. The
 * section has a hole. */
static void a_shaft_is_a_hole_in_the_section(void **state)
{
    (void)state;
    struct text text = {.length = 0};
    add(&text, "<room version=\"1\"><envelope>");
    /* Outer outline 6 x 5, shaft 2..3.5 x 2..4, both divided at x = 2.75. */
    static const double outer[6][2] = {{0, 0}, {2.75, 0}, {6, 0},
                                       {6, 5}, {2.75, 5}, {0, 5}};
    static const double shaft[6][2] = {{2, 2},   {2.75, 2}, {3.5, 2},
                                       {3.5, 4}, {2.75, 4}, {2, 4}};
    static const int half[2][8] = {{0, 1, 7, 6, 11, 10, 4, 5},
                                   {1, 2, 3, 4, 10, 9, 8, 7}};
    for (int level = 0; level < 2; level++)
        for (int side = 0; side < 2; side++) {
            add(&text, "<face role=\"%s\" name=\"f\">", level ? "ceiling" : "floor");
            for (int i = 0; i < 8; i++) {
                int k = half[side][level ? 7 - i : i];
                const double *xy = k < 6 ? outer[k] : shaft[k - 6];
                add_vertex(&text, xy[0], xy[1], level ? 2.5 : 0.0);
            }
            add(&text, "</face>");
        }
    for (int ring = 0; ring < 2; ring++)
        for (int i = 0; i < 6; i++) {
            const double(*xy)[2] = ring ? shaft : outer;
            const double *a = xy[i], *b = xy[(i + 1) % 6];
            if (!ring) { /* seen from inside, an outer wall runs from right to left */
                const double *swap = a;
                a = b, b = swap;
            }
            add(&text, "<face role=\"wall\" name=\"w%d%d\">", ring, i);
            add_vertex(&text, a[0], a[1], 0.0);
            add_vertex(&text, b[0], b[1], 0.0);
            add_vertex(&text, b[0], b[1], 2.5);
            add_vertex(&text, a[0], a[1], 2.5);
            add(&text, "</face>");
        }
    add(&text, "</envelope></room>");
    struct pp_world *world = pp_test_world(text.bytes);
    check_closed(world, (6.0 * 5.0 - 1.5 * 2.0) * 2.5);
    assert_int_equal(world->plane.count, 2);
    assert_near(pp_region_area(&world->plane), 27.0, 1e-12);
    assert_false(pp_region_contains(&world->plane, 3.0, 3.0));
    assert_false(pp_position_in_room(world, pp_vec(3.0, 3.0, 1.0)));
    assert_true(pp_position_in_room(world, pp_vec(3.0, 1.0, 1.0)));
    assert_string_equal(
        pp_position_receiver_fault(world, pp_vec(3.0, 3.0, 1.0), pp_vec(0.0, 0.0, 1.0)),
        "lies outside the room");
    pp_world_destroy(world);
}

/* ---- openings in slopes ---- */

/* A room 2 m high at the east end, from which its roof rises over the room with this
 * slope (beyond 90 degrees it leans outwards), with an opening 1 x 0.5 m in the
 * roof. */
static struct pp_world *sloped_room(double slope_deg, const char *surroundings)
{
    double c = cos(slope_deg * PP_RAD), s = sin(slope_deg * PP_RAD);
    /* From (4, 2) 3 m up the slope, then horizontal. */
    double top[2] = {4.0 - 3.0 * c, 2.0 + 3.0 * s};
    const double profile_xz[5][2] = {
        {0.0, 0.0}, {4.0, 0.0}, {4.0, 2.0}, {top[0], top[1]}, {0.0, top[1]}};
    static const char *const roles[] = {"floor", "wall", "ceiling", "ceiling", "wall"};
    struct profile profile = {5, profile_xz, roles, 5.0};
    struct text text = {.length = 0};
    add(&text, "<room version=\"1\"><site surroundings=\"%s\"/><envelope>\n",
        surroundings);
    add_prism(&text, &profile);
    add(&text, "</envelope><opening maintenance=\"auto\">");
    static const double corner[4][2] = {{1.0, 2.0}, {1.0, 1.0}, {1.5, 1.0}, {1.5, 2.0}};
    for (int i = 0; i < 4; i++) /* distance along the slope, then y */
        add_vertex(&text, 4.0 - corner[i][0] * c, corner[i][1], 2.0 + corner[i][0] * s);
    add(&text, "</opening></room>");
    return pp_test_world(text.bytes);
}

static void maintenance_goes_by_slope_and_surroundings(void **state)
{
    (void)state;
    static const char *const surroundings[] = {"rural", "urban", "industrial"};
    static const struct {
        double slope_deg, rural;
    } cases[] = {{3.0, 0.7},  {14.9, 0.7}, {15.0, 0.8},  {45.0, 0.8}, {74.9, 0.8},
                 {75.0, 0.9}, {89.0, 0.9}, {100.0, 0.9}, {130.0, 0.9}};
    for (int i = 0; i < 9; i++)
        for (int k = 0; k < 3; k++) {
            struct pp_world *world = sloped_room(cases[i].slope_deg, surroundings[k]);
            const struct pp_opening *opening = &world->openings[0];
            assert_near(opening->slope_rad, cases[i].slope_deg * PP_RAD, 1e-12);
            assert_near(opening->maintenance, cases[i].rural - 0.1 * k, 1e-12);
            /* The long side of the opening is horizontal, the short one follows the
             * slope. */
            assert_near(opening->width_m, 1.0, 1e-12);
            assert_near(opening->height_m, 0.5, 1e-12);
            assert_true(opening->rectangle);
            assert_near(opening->along.z, 0.0, 0.0);
            assert_near(opening->up.z, sin(opening->slope_rad), 1e-12);
            double z = 2.0 + 1.25 * sin(opening->slope_rad);
            assert_near(opening->middle_z_m, z, 1e-12);
            pp_world_destroy(world);
        }
}

/* An opening half a millimetre off the face, by rounding, is moved into the face. */
static void an_opening_is_drawn_into_the_face_it_is_near(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version=\"1\"><plan width=\"4.3\" depth=\"6.1\" height=\"2.9\"/>"
        "<opening><vertex x=\"1.5\" y=\"0.0005\" z=\"1\"/>"
        "<vertex x=\"-0.0006\" y=\"-0.0004\" z=\"1\"/>"
        "<vertex x=\"0\" y=\"0\" z=\"2\"/><vertex x=\"0.7\" y=\"0\" z=\"2.4\"/>"
        "</opening></room>");
    const struct pp_opening *opening = &world->openings[0];
    assert_int_equal(opening->inner.count, 4);
    assert_false(opening->rectangle);
    for (int i = 0; i < 4; i++) {
        assert_near(opening->inner.vertices[i].y, 0.0, 1e-15);
        assert_true(opening->inner.vertices[i].x >= -1e-15);
    }
    assert_near(opening->slope_rad, PP_PI / 2.0, 1e-12);
    assert_near(opening->middle_z_m, 1.7, 1e-12);
    pp_world_destroy(world);
}

/* The outer faces of walls and roof have a reflectance of 0.2, for any finishes
 * inside. */
static void outer_sides_reflect_a_fifth(void **state)
{
    (void)state;
    struct pp_world *world =
        pp_test_world("<room version='1'><plan width='4' depth='5' height='3'/>"
                      "<finishes floor='0.3' walls='0.63' ceiling='0.81'/></room>");
    assert_int_equal(world->face_count, 6);
    for (int i = 0; i < world->face_count; i++)
        assert_near(world->surfaces[i].back, 0.2, 0.0);
    pp_world_destroy(world);
}

/* Prisms over random simple profiles, stars extruded along y, are closed and contain
 * the points that the profile contains. */
static void random_prisms_close_and_hold_their_points(void **state)
{
    (void)state;
    srand48(7);
    for (int room = 0; room < 60; room++) {
        enum { MOST = 12 };
        double xz[MOST][2];
        const char *roles[MOST];
        int count = 3 + (int)(drand48() * (MOST - 3));
        double twice = 0.0;
        for (int i = 0; i < count; i++) {
            double angle = 2.0 * PP_PI * (i + 0.8 * drand48()) / count;
            double radius = 1.0 + 3.0 * drand48();
            xz[i][0] = 7.0 + radius * cos(angle);
            xz[i][1] = 5.0 + radius * sin(angle);
            roles[i] = i % 3 ? "wall" : "ceiling";
        }
        for (int i = 0; i < count; i++) {
            const double *a = xz[i], *b = xz[(i + 1) % count];
            twice += a[0] * b[1] - b[0] * a[1];
        }
        struct profile profile = {count, (const double(*)[2])xz, roles, 3.3};
        struct pp_world *world = prism_room(&profile, "<working-plane height=\"5\"/>");
        check_closed(world, 0.5 * twice * 3.3);
        double section = 0.0;
        for (int i = 0; i < 400; i++) {
            struct pp_vec3 p =
                pp_vec(2.0 + 10.0 * drand48(), 3.3 * drand48(), 10.0 * drand48());
            enum pp_side side =
                pp_polygon_ring_side((const double(*)[2])xz, count, p.x, p.z, 1e-9);
            if (side != PP_ON_EDGE)
                assert_true(pp_position_in_room(world, p) == (side == PP_INSIDE));
            p.y += 3.4;
            assert_false(pp_position_in_room(world, p));
        }
        /* The width of the section from the crossings of the profile with z = 5. */
        for (int i = 0; i < count; i++) {
            const double *a = xz[i], *b = xz[(i + 1) % count];
            if ((a[1] > 5.0) != (b[1] > 5.0)) {
                double t = (5.0 - a[1]) / (b[1] - a[1]);
                section += (b[1] > 5.0 ? 1.0 : -1.0) * (a[0] + t * (b[0] - a[0]));
            }
        }
        assert_near(pp_region_area(&world->plane), section * 3.3, 1e-11);
        pp_world_destroy(world);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_envelope_of_a_plan_s_faces_is_the_plan),
        cmocka_unit_test(a_gable_s_section_narrows_with_height),
        cmocka_unit_test(a_section_above_the_valley_falls_into_two),
        cmocka_unit_test(a_shaft_is_a_hole_in_the_section),
        cmocka_unit_test(maintenance_goes_by_slope_and_surroundings),
        cmocka_unit_test(an_opening_is_drawn_into_the_face_it_is_near),
        cmocka_unit_test(outer_sides_reflect_a_fifth),
        cmocka_unit_test(random_prisms_close_and_hold_their_points),
    };
    add_tests(tests, NULL, NULL);
}
