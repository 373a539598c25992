/* test_world.c - positions of the parts that a room file describes. */
#include "model/room/world.h"

#include "model/geometry/polygon.h"
#include "tests/lib/room_of.h"
#include "model/room/position.h"

static const struct pp_surface *face_named(const struct pp_world *world,
                                           const char *name)
{
    for (int i = 0; i < world->face_count; i++)
        if (world->surfaces[i].name && strcmp(world->surfaces[i].name, name) == 0)
            return &world->surfaces[i];
    fail_msg("no face %s", name);
    return NULL;
}

#define PLAN "<plan width=\"4.3\" depth=\"6.1\" height=\"2.9\"/>"

static struct pp_world *room_with(const char *parts)
{
    char xml[8192];
    snprintf(xml, sizeof xml, "<room version=\"1\">\n" PLAN "\n%s</room>", parts);
    return pp_test_world(xml);
}

/* In every wall a window near the left end, as seen from outside: the west end of the
 * south wall, the east end of the north wall. */
static void left_is_seen_from_outside(void **state)
{
    (void)state;
    struct pp_world *world = room_with(
        "<window wall=\"south\" left=\"0.2\" sill=\"0.7\" width=\"1\" height=\"1.3\"/>"
        "<window wall=\"east\" left=\"0.2\" sill=\"0.7\" width=\"1\" height=\"1.3\"/>"
        "<window wall=\"north\" left=\"0.2\" sill=\"0.7\" width=\"1\" height=\"1.3\"/>"
        "<window wall=\"west\" left=\"0.2\" sill=\"0.7\" width=\"1\" height=\"1.3\"/>");
    static const double middle[4][3] = {
        {0.7, 0.0, 1.35}, {4.3, 0.7, 1.35}, {3.6, 6.1, 1.35}, {0.0, 5.4, 1.35}};
    assert_int_equal(world->opening_count, 4);
    for (int i = 0; i < 4; i++) {
        const struct pp_opening *window = &world->openings[i];
        struct pp_vec3 m = pp_polygon_middle(&window->inner);
        assert_near(m.x, middle[i][0], 1e-12);
        assert_near(m.y, middle[i][1], 1e-12);
        assert_near(m.z, middle[i][2], 1e-12);
        struct pp_vec3 normal = pp_vec_cross(window->along, window->up);
        assert_near(pp_vec_dot(normal, window->inner.normal), 1.0, 1e-14);
        struct pp_vec3 inward = pp_vec_sub(pp_vec(2.15, 3.05, 1.35), m);
        assert_true(pp_vec_dot(normal, inward) > 0.0);
        assert_near(window->width_m, 1.0, 1e-12);
        assert_near(window->height_m, 1.3, 1e-12);
        assert_near(window->slope_rad, PP_PI / 2.0, 1e-15);
        assert_true(window->rectangle);
    }
    pp_world_destroy(world);
}

static void a_rectangle_has_six_faces_that_look_inwards(void **state)
{
    (void)state;
    struct pp_world *world = room_with("");
    struct pp_vec3 middle = pp_vec(2.15, 3.05, 1.45);
    assert_int_equal(world->face_count, 6);
    assert_int_equal(world->surface_count, 6);
    for (int i = 0; i < 6; i++) {
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        assert_near(pp_vec_length(outline->normal), 1.0, 1e-15);
        assert_true(pp_polygon_height(outline, middle) > 1.0);
    }
    assert_near(face_named(world, "south")->outline.normal.y, 1.0, 0.0);
    assert_near(face_named(world, "east")->outline.normal.x, -1.0, 0.0);
    assert_near(face_named(world, "north")->outline.normal.y, -1.0, 0.0);
    assert_near(face_named(world, "west")->outline.normal.x, 1.0, 0.0);
    assert_near(pp_region_area(&world->plane), 4.3 * 6.1, 1e-12);
    pp_world_destroy(world);
}

/* The six walls of an L-shaped room: their area is the perimeter times the height; the
 * floor is the square without its corner. */
static void the_walls_of_an_ell_have_its_perimeter(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version=\"1\"><plan height=\"2.6\">"
        "<vertex x=\"-0.7\" y=\"0\"/><vertex x=\"5.3\" y=\"0\"/>"
        "<vertex x=\"5.3\" y=\"3.1\"/><vertex x=\"2.4\" y=\"3.1\"/>"
        "<vertex x=\"2.4\" y=\"6.2\"/><vertex x=\"-0.7\" y=\"6.2\"/></plan>"
        "<window wall=\"4\" left=\"0.3\" sill=\"1\" width=\"0.8\" height=\"1\"/>"
        "</room>");
    double walls_m2 = 0.0;
    for (int i = 0; i < world->face_count; i++)
        if (world->surfaces[i].role == PP_WALL)
            walls_m2 += world->surfaces[i].outline.area_m2;
    assert_near(walls_m2, 2.0 * (6.0 + 6.2) * 2.6, 1e-12);
    assert_near(pp_region_area(&world->plane), 6.0 * 6.2 - 2.9 * 3.1, 1e-12);

    /* Wall 4 faces east into the corner; its left end from outside is to the south. */
    const struct pp_opening *window = &world->openings[0];
    assert_ptr_equal(&world->surfaces[window->face], face_named(world, "4"));
    assert_near(window->inner.normal.x, -1.0, 0.0);
    struct pp_vec3 middle = pp_polygon_middle(&window->inner);
    assert_near(middle.x, 2.4, 1e-12);
    assert_near(middle.y, 3.1 + 0.3 + 0.4, 1e-12);

    static const double inside[][2] = {{5.2, 3.0}, {2.3, 6.1}, {-0.6, 0.1}, {2.4, 3.0}};
    static const double outside[][2] = {
        {2.5, 3.2}, {5.4, 1.0}, {-0.8, 3.0}, {2.0, 6.3}};
    for (int i = 0; i < 4; i++) {
        assert_true(
            pp_position_in_room(world, pp_vec(inside[i][0], inside[i][1], 1.3)));
        assert_false(
            pp_position_in_room(world, pp_vec(inside[i][0], inside[i][1], 2.7)));
        assert_false(
            pp_position_in_room(world, pp_vec(inside[i][0], inside[i][1], -0.1)));
        assert_false(
            pp_position_in_room(world, pp_vec(outside[i][0], outside[i][1], 1.3)));
    }
    pp_world_destroy(world);
}

/* In double precision 1.1 + 2.2 is more than 3.3 and 0.1 + 0.2 more than 0.3; the
 * window still ends exactly at the end of the wall. */
static void a_window_may_fill_its_wall(void **state)
{
    (void)state;
    assert_true(1.1 + 2.2 > 3.3 && 0.1 + 0.2 > 0.3);
    struct pp_world *world = pp_test_world(
        "<room version=\"1\"><plan width=\"3.3\" depth=\"5\" height=\"0.3\"/>"
        "<working-plane height=\"0.15\"/>"
        "<window wall=\"south\" left=\"1.1\" sill=\"0.1\" width=\"2.2\" "
        "height=\"0.2\"/>"
        "<window wall=\"north\" left=\"0\" sill=\"0\" width=\"3.3\" height=\"0.3\"/>"
        "</room>");
    const struct pp_polygon *inner = &world->openings[0].inner;
    double right = -1.0, top = -1.0;
    for (int i = 0; i < 4; i++) {
        right = fmax(right, inner->vertices[i].x);
        top = fmax(top, inner->vertices[i].z);
    }
    assert_true(right == 3.3);
    assert_true(top == 0.3);
    assert_near(world->openings[1].inner.area_m2, 0.99, 1e-15);
    pp_world_destroy(world);
}

/* Each side of the reveal faces the opening, and their total area is the length of the
 * outline times the depth. */
static void reveals_line_the_opening_s_depth(void **state)
{
    (void)state;
    struct pp_world *world = room_with(
        "<finish wall=\"east\" reflectance=\"0.37\"/>"
        "<window wall=\"east\" left=\"0.6\" sill=\"0.7\" width=\"1.9\" height=\"1.3\" "
        "reveal=\"0.28\"/>");
    const struct pp_opening *window = &world->openings[0];
    assert_near(pp_polygon_middle(&window->outer).x, 4.3 + 0.28, 1e-12);
    struct pp_vec3 heart =
        pp_vec_along(pp_polygon_middle(&window->inner), -0.14, window->inner.normal);
    int sides = 0;
    double area_m2 = 0.0;
    for (int i = world->face_count; i < world->surface_count; i++) {
        const struct pp_surface *side = &world->surfaces[i];
        assert_int_equal(side->role, PP_REVEAL);
        assert_int_equal(side->owner, 0);
        assert_true(side->inside);
        assert_near(side->front, 0.37, 0.0);
        assert_true(pp_polygon_height(&side->outline, heart) > 0.5);
        area_m2 += side->outline.area_m2;
        sides++;
    }
    assert_int_equal(sides, 4);
    assert_near(area_m2, 2.0 * (1.9 + 1.3) * 0.28, 1e-12);
    pp_world_destroy(world);
}

static void a_rooflight_lies_in_the_ceiling_at_its_place_in_plan(void **state)
{
    (void)state;
    struct pp_world *world = room_with("<rooflight x=\"0.6\" y=\"1.7\" width=\"0.9\" "
                                       "depth=\"2.2\" reveal=\"0.4\"/>");
    const struct pp_opening *light = &world->openings[0];
    struct pp_vec3 middle = pp_polygon_middle(&light->inner);
    assert_near(middle.x, 1.05, 1e-12);
    assert_near(middle.y, 2.8, 1e-12);
    assert_near(middle.z, 2.9, 1e-12);
    assert_near(pp_polygon_middle(&light->outer).z, 3.3, 1e-12);
    assert_near(light->slope_rad, 0.0, 0.0);
    assert_near(light->width_m, 0.9, 1e-12);
    assert_near(light->height_m, 2.2, 1e-12);
    assert_near(light->middle_z_m, 2.9, 1e-12);
    assert_near(light->inner.normal.z, -1.0, 0.0);
    assert_near(pp_polygon_area_vector(light->inner.vertices, 4).z, -1.98, 1e-12);
    pp_world_destroy(world);
}

/* The outward flux of any constant field through the sides of a box is zero, and that
 * of the position vector is three times its volume. */
static void a_turned_block_s_sides_close_round_its_volume(void **state)
{
    (void)state;
    struct pp_world *world =
        room_with("<block x=\"-9\" y=\"-14\" width=\"3.3\" depth=\"2.1\" base=\"1.2\" "
                  "height=\"7.7\" rotate=\"37\" reflectance=\"0.31\"/>"
                  "<block x=\"9\" y=\"-14\" width=\"3.3\" depth=\"2.1\" height=\"7.7\" "
                  "rotate=\"-120\"/>");
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    double flow = 0.0;
    int sides[2] = {0, 0};
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *side = &world->surfaces[i];
        if (side->role != PP_BLOCK)
            continue;
        sides[side->owner]++;
        if (side->owner == 1)
            continue;
        struct pp_vec3 area = pp_vec_scale(side->outline.normal, side->outline.area_m2);
        sum = pp_vec_add(sum, area);
        flow += pp_vec_dot(area, pp_polygon_middle(&side->outline));
        assert_near(side->front, 0.31, 0.0);
        assert_false(side->inside);
    }
    /* A block 1.2 m above the ground shows its underside. */
    assert_int_equal(sides[0], 6);
    assert_int_equal(sides[1], 5);
    assert_near(pp_vec_length(sum), 0.0, 1e-12);
    assert_near(flow / 3.0, 3.3 * 2.1 * 7.7, 1e-10);
    /* Rotated to the left, seen from above: the end of its width. */
    double c = cos(37.0 * PP_RAD), s = sin(37.0 * PP_RAD);
    struct pp_vec3 end = pp_vec(-9.0 + 3.3 * c, -14.0 + 3.3 * s, 1.2);
    double nearest = INFINITY;
    for (int i = 0; i < world->surface_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++) {
            struct pp_vec3 v = world->surfaces[i].outline.vertices[k];
            nearest = fmin(nearest, pp_vec_length(pp_vec_sub(v, end)));
        }
    assert_near(nearest, 0.0, 1e-12);
    pp_world_destroy(world);
}

/* A neighbour built against the wall, and a picture on it: a ray must not have to
 * choose between two surfaces in one plane. */
static void what_lies_flush_with_a_wall_is_set_off_it(void **state)
{
    (void)state;
    struct pp_world *world = room_with(
        "<block x=\"4.3\" y=\"0\" width=\"3\" depth=\"6.1\" height=\"9\"/>"
        "<surface reflectance=\"0.5\"><vertex x=\"0\" y=\"1\" z=\"1\"/>"
        "<vertex x=\"0\" y=\"2\" z=\"1\"/><vertex x=\"0\" y=\"2\" z=\"2\"/></surface>");
    double least = INFINITY;
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        if (surface->role == PP_FREE_SURFACE) {
            assert_true(surface->inside);
            assert_near(pp_polygon_middle(&surface->outline).x, 1e-4, 1e-12);
        }
        for (int k = 0; surface->role == PP_BLOCK && k < 4; k++)
            least = fmin(least, surface->outline.vertices[k].x - 4.3);
    }
    /* The other sides of the block still begin in the plane of the wall. */
    assert_near(least, 0.0, 1e-12);
    const struct pp_surface *flush = NULL;
    for (int i = 0; i < world->surface_count; i++)
        if (world->surfaces[i].role == PP_BLOCK
            && world->surfaces[i].outline.normal.x < -0.5)
            flush = &world->surfaces[i];
    assert_non_null(flush);
    assert_near(pp_polygon_middle(&flush->outline).x, 4.3 + 1e-4, 1e-12);
    pp_world_destroy(world);
}

static void free_surfaces_are_classified_as_inside_or_outside(void **state)
{
    (void)state;
    /* A desk, a shelf that ends in the wall, and a canopy that begins there. */
    struct pp_world *world = room_with(
        "<surface reflectance=\"0.5\"><vertex x=\"1\" y=\"1\" z=\"0.7\"/>"
        "<vertex x=\"2\" y=\"1\" z=\"0.7\"/><vertex x=\"2\" y=\"2\" z=\"0.7\"/>"
        "</surface>"
        "<surface reflectance=\"0.5\"><vertex x=\"1\" y=\"0\" z=\"2\"/>"
        "<vertex x=\"2\" y=\"0\" z=\"2\"/><vertex x=\"2\" y=\"0.6\" z=\"2\"/>"
        "<vertex x=\"1\" y=\"0.6\" z=\"2\"/></surface>"
        "<surface reflectance=\"0.5\"><vertex x=\"1\" y=\"0\" z=\"2.2\"/>"
        "<vertex x=\"2\" y=\"0\" z=\"2.2\"/><vertex x=\"2\" y=\"-0.6\" z=\"2.2\"/>"
        "<vertex x=\"1\" y=\"-0.6\" z=\"2.2\"/></surface>");
    assert_int_equal(world->surface_count, 9);
    assert_true(world->surfaces[6].inside);
    assert_true(world->surfaces[7].inside);
    assert_false(world->surfaces[8].inside);
    pp_world_destroy(world);
}

/* The reference height is midway between the lowest sill and the highest head of the
 * wall's windows; at 20 degrees and 14 m the skyline is 14 tan 20 higher. */
static void a_skyline_is_seen_from_the_middle_of_its_wall_s_windows(void **state)
{
    (void)state;
    struct pp_world *world = room_with(
        "<window wall=\"south\" left=\"0.2\" sill=\"0.7\" width=\"1\" height=\"0.5\"/>"
        "<window wall=\"south\" left=\"2\" sill=\"1.5\" width=\"1\" height=\"1.2\"/>"
        "<window wall=\"east\" left=\"2\" sill=\"0\" width=\"1\" height=\"2.9\"/>"
        "<block x=\"0\" y=\"-30\" width=\"4\" depth=\"4\" height=\"9\"/>"
        "<skyline wall=\"south\" angle=\"20\" distance=\"14\"/>"
        "<skyline wall=\"north\" angle=\"35\" reflectance=\"0.1\"/>");
    const struct pp_skyline *near = &world->skylines[0], *far = &world->skylines[1];
    assert_near(near->middle_z_m, 0.5 * (0.7 + 2.7), 1e-12);
    assert_near(near->head_z_m, 1.7 + 14.0 * tan(20.0 * PP_RAD), 1e-12);
    assert_ptr_equal(&world->surfaces[near->face], face_named(world, "south"));
    assert_near(near->reflectance, 0.2, 0.0);
    assert_true(isinf(far->distance_m) && isinf(far->head_z_m));
    assert_near(far->middle_z_m, 1.45,
                1e-12); /* a wall without a window: its own middle */
    assert_near(far->angle_rad, 35.0 * PP_RAD, 1e-15);
    pp_world_destroy(world);
}

static void faces_have_the_finishes_inside_and_bare_walls_outside(void **state)
{
    (void)state;
    struct pp_world *world =
        room_with("<finishes floor=\"0.21\" walls=\"0.63\" ceiling=\"0.84\"/>"
                  "<finish wall=\"west\" reflectance=\"0.11\"/>");
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        double expected = face->role == PP_FLOOR     ? 0.21
                          : face->role == PP_CEILING ? 0.84
                                                     : 0.63;
        if (face == face_named(world, "west"))
            expected = 0.11;
        assert_near(face->front, expected, 0.0);
        assert_near(face->back, 0.2, 0.0);
    }
    pp_world_destroy(world);
}

static void openings_without_a_name_get_the_next_free_letter_and_number(void **state)
{
    (void)state;
    struct pp_world *world = room_with(
        "<window wall=\"south\" left=\"0.2\" sill=\"0.7\" width=\"1\" height=\"1.3\"/>"
        "<rooflight x=\"0.6\" y=\"1.7\" width=\"0.9\" depth=\"0.9\"/>"
        "<window name=\"W2\" wall=\"south\" left=\"2\" sill=\"0.7\" width=\"1\" "
        "height=\"1.3\"/>"
        "<window wall=\"east\" left=\"0.2\" sill=\"0.7\" width=\"1\" height=\"1.3\"/>"
        "<window name=\"Küche über dem Hof, links oben\" wall=\"north\" left=\"0.2\" "
        "sill=\"0.7\" width=\"1\" height=\"1.3\"/>");
    static const char *const labels[] = {"W1", "RL1", "W2", "W3"};
    for (int i = 0; i < 4; i++)
        assert_string_equal(world->openings[i].label, labels[i]);
    assert_int_equal(strncmp(world->openings[4].label, "Küche über dem Hof", 20), 0);
    assert_true(strlen(world->openings[4].label) < PP_WORLD_LABEL);
    assert_string_equal(pp_world_label(world, world->openings[0].line), "W1");
    assert_string_equal(pp_world_label(world, 99), "");
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(left_is_seen_from_outside),
        cmocka_unit_test(a_rectangle_has_six_faces_that_look_inwards),
        cmocka_unit_test(the_walls_of_an_ell_have_its_perimeter),
        cmocka_unit_test(a_window_may_fill_its_wall),
        cmocka_unit_test(reveals_line_the_opening_s_depth),
        cmocka_unit_test(a_rooflight_lies_in_the_ceiling_at_its_place_in_plan),
        cmocka_unit_test(a_turned_block_s_sides_close_round_its_volume),
        cmocka_unit_test(what_lies_flush_with_a_wall_is_set_off_it),
        cmocka_unit_test(free_surfaces_are_classified_as_inside_or_outside),
        cmocka_unit_test(a_skyline_is_seen_from_the_middle_of_its_wall_s_windows),
        cmocka_unit_test(faces_have_the_finishes_inside_and_bare_walls_outside),
        cmocka_unit_test(openings_without_a_name_get_the_next_free_letter_and_number),
    };
    add_tests(tests, NULL, NULL);
}
