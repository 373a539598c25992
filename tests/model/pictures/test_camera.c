/* test_camera.c - views: the ray through each position of the picture. */
#include "tests/lib/near.h"

#include <stdio.h>
#include <string.h>

#include "model/pictures/camera.h"

static struct pp_camera camera_of(enum pp_view_kind kind, double across, double down)
{
    struct pp_camera camera;
    struct pp_error err = {0};
    if (pp_camera_set(&camera, kind, pp_vec(1.3, -0.4, 1.6), pp_vec(0.7, 2.1, -0.3),
                      pp_vec(0.1, 0.0, 2.0), across, down, &err)
        != PP_OK)
        fail_msg("%s", err.message);
    return camera;
}

static void assert_vec(struct pp_vec3 v, double x, double y, double z)
{
    assert_near(v.x, x, 1e-12);
    assert_near(v.y, y, 1e-12);
    assert_near(v.z, z, 1e-12);
}

/* Facing north, east is on the right; an angle of view of 90 degrees has its edges at
 * 45 degrees. */
static void the_right_of_a_picture_is_the_right_of_who_looks(void **state)
{
    (void)state;
    struct pp_camera camera;
    struct pp_vec3 from, to, up = pp_vec(0.0, 0.0, 1.0), north = pp_vec(0.0, 3.0, 0.0);
    assert_int_equal(pp_camera_set(&camera, PP_VIEW_PERSPECTIVE, pp_vec(2.0, 3.0, 1.6),
                                   north, up, PP_PI / 2.0, PP_PI / 2.0, NULL),
                     PP_OK);
    assert_true(pp_camera_ray(&camera, 0.5, 0.5, &from, &to));
    assert_vec(from, 2.0, 3.0, 1.6);
    assert_vec(to, 0.0, 1.0, 0.0);
    assert_true(pp_camera_ray(&camera, 1.0, 0.5, &from, &to));
    assert_vec(to, sqrt(0.5), sqrt(0.5), 0.0);
    assert_true(pp_camera_ray(&camera, 0.5, 0.0, &from, &to));
    assert_vec(to, 0.0, sqrt(0.5), sqrt(0.5));
    /* A plan, seen from above: north is up in the picture. */
    assert_int_equal(pp_camera_set(&camera, PP_VIEW_PARALLEL, pp_vec(2.0, 3.0, 9.0),
                                   pp_vec(0.0, 0.0, -1.0), north, 4.0, 6.0, NULL),
                     PP_OK);
    assert_true(pp_camera_ray(&camera, 1.0, 0.0, &from, &to));
    assert_vec(from, 4.0, 6.0, 9.0);
    assert_vec(to, 0.0, 0.0, -1.0);
}

static void a_point_is_seen_where_its_ray_goes(void **state)
{
    (void)state;
    const struct pp_camera cameras[] = {
        camera_of(PP_VIEW_PERSPECTIVE, 1.3, 0.9),
        camera_of(PP_VIEW_PARALLEL, 4.1, 2.7),
        camera_of(PP_VIEW_HEMISPHERICAL, PP_PI, PP_PI),
        camera_of(PP_VIEW_HEMISPHERICAL, 2.0, 1.5),
        camera_of(PP_VIEW_ANGULAR, 2.0 * PP_PI, 2.0 * PP_PI),
        camera_of(PP_VIEW_ANGULAR, PP_PI, 1.1)};
    for (size_t i = 0; i < sizeof cameras / sizeof *cameras; i++)
        for (double x = 0.07; x < 1.0; x += 0.11)
            for (double y = 0.04; y < 1.0; y += 0.13) {
                struct pp_vec3 from, to;
                double back_x, back_y, distance;
                if (!pp_camera_ray(&cameras[i], x, y, &from, &to))
                    continue;
                assert_near(pp_vec_length(to), 1.0, 1e-14);
                assert_true(pp_camera_project(&cameras[i], pp_vec_along(from, 2.3, to),
                                              &back_x, &back_y, &distance));
                assert_near(back_x, x, 1e-12);
                assert_near(back_y, y, 1e-12);
                assert_near(distance, 2.3, 1e-12);
            }
}

/* Directions at 45 degrees are at sin 45 of the half width in a projection by
 * illuminance, and at half of it in a projection by angle. Beyond the circle the first
 * shows nothing, the second shows directions below the horizon. */
static void a_fisheye_shows_a_circle(void **state)
{
    (void)state;
    struct pp_vec3 up = pp_vec(0.0, 0.0, 1.0), north = pp_vec(0.0, 1.0, 0.0), from, to;
    struct pp_camera camera;
    assert_int_equal(pp_camera_set(&camera, PP_VIEW_HEMISPHERICAL, pp_vec(0, 0, 0), up,
                                   north, PP_PI, PP_PI, NULL),
                     PP_OK);
    assert_true(pp_camera_ray(&camera, 0.5, 0.5 - 0.5 * sqrt(0.5), &from, &to));
    assert_vec(to, 0.0, sqrt(0.5), sqrt(0.5));
    assert_false(pp_camera_ray(&camera, 0.99, 0.99, &from, &to));
    assert_false(
        pp_camera_project(&camera, pp_vec(0.1, 0.0, -0.1), &to.x, &to.y, &to.z));
    assert_int_equal(pp_camera_set(&camera, PP_VIEW_ANGULAR, pp_vec(0, 0, 0), up, north,
                                   PP_PI, PP_PI, NULL),
                     PP_OK);
    assert_true(pp_camera_ray(&camera, 0.5, 0.25, &from, &to));
    assert_vec(to, 0.0, sqrt(0.5), sqrt(0.5));
    assert_true(pp_camera_ray(&camera, 0.99, 0.99, &from, &to)); /* below the horizon */
    assert_true(to.z < 0.0);
}

/* The edge of a view of less than a hemisphere is at half of the angle, and the
 * positions between follow the sine. */
static void a_narrow_fisheye_keeps_to_its_angle(void **state)
{
    (void)state;
    struct pp_camera camera;
    struct pp_vec3 from, to;
    assert_int_equal(pp_camera_set(&camera, PP_VIEW_HEMISPHERICAL, pp_vec(0, 0, 0),
                                   pp_vec(0, 0, 1), pp_vec(0, 1, 0), 80.0 * PP_RAD,
                                   80.0 * PP_RAD, NULL),
                     PP_OK);
    assert_true(pp_camera_ray(&camera, 0.5, 0.0, &from, &to));
    assert_vec(to, 0.0, sin(40.0 * PP_RAD), cos(40.0 * PP_RAD));
    assert_true(pp_camera_ray(&camera, 0.5, 0.25, &from, &to));
    assert_near(to.y, 0.5 * sin(40.0 * PP_RAD), 1e-12);
}

static void the_options_give_the_view_again(void **state)
{
    (void)state;
    for (int kind = PP_VIEW_PERSPECTIVE; kind <= PP_VIEW_ANGULAR; kind++) {
        struct pp_camera camera = camera_of(kind, 1.3, 0.9);
        char text[512], letter;
        struct pp_vec3 p, d, u;
        double across, down;
        pp_camera_options(&camera, text, sizeof text);
        int count = sscanf(
            text,
            "-vt%c -vp %lf %lf %lf -vd %lf %lf %lf -vu %lf %lf %lf -vh %lf -vv %lf",
            &letter, &p.x, &p.y, &p.z, &d.x, &d.y, &d.z, &u.x, &u.y, &u.z, &across,
            &down);
        assert_int_equal(count, 12);
        assert_int_equal(letter, "vlha"[kind]);
        double unit = kind == PP_VIEW_PARALLEL ? 1.0 : PP_RAD;
        assert_near(pp_vec_length(pp_vec_sub(p, camera.eye)), 0.0, 1e-11);
        assert_near(pp_vec_length(pp_vec_sub(d, camera.toward)), 0.0, 1e-11);
        assert_near(pp_vec_length(pp_vec_sub(u, camera.up)), 0.0, 1e-11);
        assert_near(across * unit, 1.3, 1e-11);
        assert_near(down * unit, 0.9, 1e-11);
    }
}

static void a_view_that_shows_nothing_is_refused(void **state)
{
    (void)state;
    struct pp_vec3 o = {0, 0, 0}, z = {0, 0, 1}, y = {0, 1, 0};
    static const struct {
        enum pp_view_kind kind;
        double across;
        const char *says;
    } sizes[] = {{PP_VIEW_PERSPECTIVE, PP_PI, "less than 180"},
                 {PP_VIEW_PERSPECTIVE, 0.0, "more than 0"},
                 {PP_VIEW_HEMISPHERICAL, 3.2, "up to 180"},
                 {PP_VIEW_ANGULAR, 6.3, "up to 360"},
                 {PP_VIEW_PARALLEL, -1.0, "more than 0"},
                 {PP_VIEW_PARALLEL, INFINITY, "more than 0"},
                 {PP_VIEW_ANGULAR, NAN, "more than 0"}};
    struct pp_camera camera;
    struct pp_error err;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        assert_int_equal(
            pp_camera_set(&camera, sizes[i].kind, o, y, z, sizes[i].across, 1.0, &err),
            PP_BAD_INPUT);
        if (!strstr(err.message, sizes[i].says))
            fail_msg("%s", err.message);
    }
    assert_int_equal(pp_camera_set(&camera, PP_VIEW_PARALLEL, o, z, z, 1.0, 1.0, &err),
                     PP_BAD_INPUT);
    assert_int_equal(pp_camera_set(&camera, PP_VIEW_PARALLEL, o, o, z, 1.0, 1.0, &err),
                     PP_BAD_INPUT);
    assert_int_equal(pp_camera_set(&camera, PP_VIEW_PARALLEL, pp_vec(NAN, 0, 0), y, z,
                                   1.0, 1.0, &err),
                     PP_BAD_INPUT);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_right_of_a_picture_is_the_right_of_who_looks),
        cmocka_unit_test(a_point_is_seen_where_its_ray_goes),
        cmocka_unit_test(a_fisheye_shows_a_circle),
        cmocka_unit_test(the_options_give_the_view_again),
        cmocka_unit_test(a_view_that_shows_nothing_is_refused),
        cmocka_unit_test(a_narrow_fisheye_keeps_to_its_angle),
    };
    add_tests(tests, NULL, NULL);
}
