/* test_plan_roof.c - rooms under pitched roofs: their volume, and the same room as an
 * envelope. */
#include "tests/lib/room_of.h"

/* Volume by the divergence theorem, from the faces, whose normals point into the room.
 * *closed is the length of the sum of all area vectors, 0 for a closed envelope. */
static double volume_of(const struct pp_world *world, double *closed)
{
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    double volume = 0.0;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        struct pp_vec3 area = pp_vec_scale(face->normal, face->area_m2);
        sum = pp_vec_add(sum, area);
        volume -= pp_vec_dot(face->vertices[0], area) / 3.0;
    }
    *closed = pp_vec_length(sum);
    return volume;
}

static struct pp_world *roofed(double width, double depth, const char *roof)
{
    char xml[512];
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='%g' depth='%g' height='2.2' %s "
             "pitch='35'/></room>",
             width, depth, roof);
    return pp_test_world(xml);
}

static void check(double width, double depth, const char *roof, double volume,
                  double height, int faces)
{
    double closed;
    struct pp_world *world = roofed(width, depth, roof);
    assert_near(volume_of(world, &closed), volume, 1e-9 * volume);
    assert_near(closed, 0.0, 1e-9);
    assert_near(world->height_m, height, 1e-9);
    assert_int_equal(world->face_count, faces);
    pp_world_destroy(world);
}

/* Over a plan of 5 x 8 m with eaves at 2.2 m, with the ridge along the longer side and
 * across it. A hip roof is a gable roof without two pyramids of half its width. */
static void a_roof_has_the_volume_of_its_prism(void **state)
{
    (void)state;
    double t = tan(35.0 * PP_RAD), plan = 40.0;
    check(5, 8, "roof='mono'", plan * (2.2 + 2.5 * t), 2.2 + 5 * t, 6);
    check(5, 8, "roof='mono' ridge='width'", plan * (2.2 + 4 * t), 2.2 + 8 * t, 6);
    check(5, 8, "roof='gable'", plan * (2.2 + 1.25 * t), 2.2 + 2.5 * t, 7);
    check(5, 8, "roof='gable' ridge='width'", plan * (2.2 + 2 * t), 2.2 + 4 * t, 7);
    check(5, 8, "roof='hip'",
          plan * (2.2 + 1.25 * t) - 2.0 * 5 * 2.5 * 2.5 * t * (0.5 - 1.0 / 3.0),
          2.2 + 2.5 * t, 9);
    check(8, 5, "roof='hip'",
          plan * (2.2 + 1.25 * t) - 2.0 * 5 * 2.5 * 2.5 * t * (0.5 - 1.0 / 3.0),
          2.2 + 2.5 * t, 9);
    check(5, 5, "roof='hip'", 25 * (2.2 + 2.5 * t / 3.0), 2.2 + 2.5 * t, 9);
    check(5, 8, "roof='saw-tooth' ridge='width' teeth='3'",
          plan * (2.2 + 4.0 / 3.0 * t), 2.2 + 8.0 / 3.0 * t, 10);
    check(5, 8, "roof='saw-tooth' ridge='depth' teeth='1'", plan * (2.2 + 2.5 * t),
          2.2 + 5 * t, 6);
}

static const struct pp_surface *face_called(const struct pp_world *world,
                                            const char *name)
{
    for (int i = 0; i < world->face_count; i++)
        if (world->surfaces[i].name && strcmp(world->surfaces[i].name, name) == 0)
            return &world->surfaces[i];
    fail_msg("no face %s", name);
    return NULL;
}

/* Slopes are named by the direction that they face; walls keep their names for any
 * ridge. */
static void walls_and_slopes_are_named_by_the_way_they_look(void **state)
{
    (void)state;
    static const char *const names[] = {"south", "east", "north", "west"};
    static const double ways[][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    static const char *const roofs[] = {"roof='hip'", "roof='hip' ridge='depth'"};
    for (int k = 0; k < 2; k++) {
        struct pp_world *world = roofed(k ? 5 : 9, k ? 9 : 5, roofs[k]);
        for (int i = 0; i < 4; i++) {
            char slope[32];
            snprintf(slope, sizeof slope, "roof-%s", names[i]);
            const struct pp_surface *wall = face_called(world, names[i]),
                                    *roof = face_called(world, slope);
            assert_near(wall->outline.normal.x, -ways[i][0], 1e-9);
            assert_near(wall->outline.normal.y, -ways[i][1], 1e-9);
            assert_near(roof->outline.normal.x, -ways[i][0] * sin(35 * PP_RAD), 1e-9);
            assert_near(roof->outline.normal.y, -ways[i][1] * sin(35 * PP_RAD), 1e-9);
            assert_int_equal(wall->role, PP_WALL);
            assert_int_equal(roof->role, PP_CEILING);
        }
        pp_world_destroy(world);
    }
    struct pp_world *teeth = roofed(5, 9, "roof='saw-tooth' ridge='width' teeth='2'");
    assert_near(face_called(teeth, "light-1")->outline.normal.y, -1.0, 1e-9);
    assert_near(face_called(teeth, "light-1")->outline.vertices[0].y, 4.5, 1e-9);
    assert_true(face_called(teeth, "roof-2")->outline.normal.y > 0.1);
    pp_world_destroy(teeth);
}

/* A window in a slope has `left` and `sill` along the slope, left as seen from
 * outside. */
static void a_window_lies_in_a_slope_by_left_and_sill(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='6' depth='8' height='2' roof='gable' "
        "ridge='depth' pitch='30'/><window wall='roof-east' left='1' sill='0.5' "
        "width='1.2' height='1.4'/></room>");
    const struct pp_opening *opening = &world->openings[0];
    struct pp_vec3 middle = pp_polygon_middle(&opening->inner);
    /* Seen from the east, left is south. */
    assert_near(middle.y, 1.6, 1e-9);
    assert_near(middle.z, 2.0 + 1.2 * sin(30 * PP_RAD), 1e-9);
    assert_near(middle.x, 6.0 - 1.2 * cos(30 * PP_RAD), 1e-9);
    assert_near(opening->slope_rad, 30 * PP_RAD, 1e-9);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_roof_has_the_volume_of_its_prism),
        cmocka_unit_test(walls_and_slopes_are_named_by_the_way_they_look),
        cmocka_unit_test(a_window_lies_in_a_slope_by_left_and_sill),
    };
    add_tests(tests, NULL, NULL);
}
