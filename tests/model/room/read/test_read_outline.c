/* test_read_outline.c - obstructions that were outlined in a photograph. */
#include "tests/lib/near.h"

#include "model/room/read/read_outline.h"

/* An equidistant fisheye picture of 180 degrees that looks at the zenith, with north at
 * the top and east on the left; its circle is 600 pixels in radius about 1000, 700. */
static const struct pp_sky_frame upwards = {.width = 2000,
                                            .height = 1400,
                                            .projection = PP_SKY_EQUIDISTANT,
                                            .half_angle_rad = PP_PI / 2.0,
                                            .centre = {1000.0, 700.0},
                                            .radius = {600.0, 600.0},
                                            .right = {-1.0, 0.0, 0.0},
                                            .up = {0.0, 1.0, 0.0},
                                            .toward = {0.0, 0.0, 1.0}};

static enum pp_status parse(struct pp_mesh_triangles *mesh, const char *text,
                            size_t length, struct pp_error *err)
{
    return pp_read_outline_parse(mesh, text, length, "a.csv", &upwards, 20.0, err);
}

/* East is 90 degrees clockwise from north: on the left of the picture. 400 pixels from
 * the centre is an altitude of 30 degrees. */
static void a_point_on_the_left_is_in_the_east(void **state)
{
    (void)state;
    struct pp_mesh_triangles mesh = {0};
    assert_int_equal(parse(&mesh, "x,y\n600,700\n620,600\n", 20, NULL), PP_OK);
    assert_int_equal(mesh.triangle_count, 2);
    assert_near(mesh.corners[3].x, 20.0, 1e-9);
    assert_near(mesh.corners[3].y, 0.0, 1e-9);
    assert_near(mesh.corners[3].z, 20.0 * tan(30.0 * PP_RAD), 1e-9);
    assert_true(mesh.corners[2].x > 0.0 && mesh.corners[2].y > 0.0);
    assert_near(mesh.corners[0].z, 0.0, 0.0);
    pp_read_outline_stand(&mesh, -1.5);
    assert_near(mesh.corners[0].z, -1.5, 0.0);
    assert_near(mesh.corners[3].z, 20.0 * tan(30.0 * PP_RAD), 1e-9);
    pp_mesh_triangles_clear(&mesh);
}

/* Points at the horizon have no face; a point above the horizon and one at it have a
 * triangle. */
static void obstructions_end_at_the_horizon(void **state)
{
    (void)state;
    struct pp_mesh_triangles mesh = {0};
    static const char text[] = "400;700\r\n500;660\r\n\r\n"
                               "# another one\r\n1600;700\r\n"
                               "1300;660\r\n1300;740\r\n";
    assert_int_equal(parse(&mesh, text, sizeof text - 1, NULL), PP_OK);
    assert_int_equal(mesh.triangle_count, 1 + 1 + 2);
    pp_mesh_triangles_clear(&mesh);
}

static void mistakes_have_their_line_and_reason(void **state)
{
    (void)state;
    static const struct {
        const char *text, *wanted;
    } cases[] = {
        {"x,y\n600,700\nhere\n", "a.csv:3: \"here\" is no point"},
        {"600,700\n399,700\n", "a.csv:2: the point \"399,700\" is outside the circle"},
        {"600,700\n995,700\n", "a.csv:2: the point is 89.2 degrees above the horizon"},
        {"600,700\n1400,700\n", "a.csv:2: the point is 180 degrees of bearing"},
        {"600,700\n\n600,700\n600,720\n", "a.csv:2: the outline has one point"},
        {"600,700\n", "the outline has one point"},
        {"x,y\n", "the file has no outline"},
        {"", "the file has no outline"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct pp_mesh_triangles mesh = {0};
        struct pp_error err;
        assert_int_equal(parse(&mesh, cases[i].text, strlen(cases[i].text), &err),
                         PP_BAD_INPUT);
        if (!strstr(err.message, cases[i].wanted))
            fail_msg("\"%s\" instead of \"%s\"", err.message, cases[i].wanted);
        pp_mesh_triangles_clear(&mesh);
    }
}

static void a_file_does_not_end_at_a_nul_byte(void **state)
{
    (void)state;
    static const char text[] = "600,700\n620,600\n630,620\00010\n700,500\n";
    struct pp_mesh_triangles mesh = {0};
    struct pp_error err;
    assert_int_equal(parse(&mesh, text, sizeof text - 1, &err), PP_BAD_INPUT);
    if (!strstr(err.message, "a.csv:3: there is a NUL byte"))
        fail_msg("%s", err.message);
    pp_mesh_triangles_clear(&mesh);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_point_on_the_left_is_in_the_east),
        cmocka_unit_test(obstructions_end_at_the_horizon),
        cmocka_unit_test(mistakes_have_their_line_and_reason),
        cmocka_unit_test(a_file_does_not_end_at_a_nul_byte),
    };
    add_tests(tests, NULL, NULL);
}
