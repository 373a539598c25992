/* test_world.c - what a room file says, and where things then stand. */
#include "model/world.h"

#include <stdio.h>

#include "model/polygon.h"
#include "tests/room_of.h"

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

/* In every wall a window near the left end as an elevation from outside shows it: in
 * the south wall that is the west end, in the north wall the east end. */
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
        struct pp_vec3 normal = pp_cross(window->along, window->up);
        assert_near(pp_dot(normal, window->inner.normal), 1.0, 1e-14);
        struct pp_vec3 inward = pp_sub(pp_vec(2.15, 3.05, 1.35), m);
        assert_true(pp_dot(normal, inward) > 0.0);
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
        assert_near(pp_length(outline->normal), 1.0, 1e-15);
        assert_true(pp_polygon_height(outline, middle) > 1.0);
    }
    assert_near(face_named(world, "south")->outline.normal.y, 1.0, 0.0);
    assert_near(face_named(world, "east")->outline.normal.x, -1.0, 0.0);
    assert_near(face_named(world, "north")->outline.normal.y, -1.0, 0.0);
    assert_near(face_named(world, "west")->outline.normal.x, 1.0, 0.0);
    assert_near(pp_region_area(&world->plane), 4.3 * 6.1, 1e-12);
    pp_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(left_is_seen_from_outside),
        cmocka_unit_test(a_rectangle_has_six_faces_that_look_inwards),
    };
    return cmocka_run_group_tests_name("world", tests, NULL, NULL);
}
