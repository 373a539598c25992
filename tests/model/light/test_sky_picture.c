/* test_sky_picture.c - photographed skies: light and shadow compared with known
 * skies. */
#include "model/light/photographs/sky_picture.h"

#include "model/light/sky.h"
#include "tests/lib/near.h"

#include <stdlib.h>

/* A picture that faces the zenith with north at its top, so that west is on the right;
 * or a latitude-longitude picture with north in its middle. */
struct lens {
    enum pp_sky_projection projection;
    double half_angle_rad;
    int size_px; /* height */
};

static struct pp_vec3 direction_of(const struct pp_sky_frame *frame, struct pp_vec3 own)
{
    struct pp_vec3 u = pp_vec_scale(frame->right, own.x);
    return pp_vec_along(pp_vec_along(u, own.y, frame->up), own.z, frame->toward);
}

/* Samples of a sky at the centres of pixels; black below the horizon and outside the
 * circle. */
static struct pp_sky_frame frame_of(const struct pp_sky *sky, struct lens lens,
                                    double factor)
{
    bool sphere = lens.projection == PP_SKY_LATITUDE_LONGITUDE;
    int width = sphere ? 2 * lens.size_px : lens.size_px;
    struct pp_sky_frame f = {.width = width,
                             .height = lens.size_px,
                             .projection = lens.projection,
                             .half_angle_rad = lens.half_angle_rad,
                             .centre = {0.5 * width, 0.5 * lens.size_px},
                             .radius = {0.5 * width, 0.5 * lens.size_px},
                             .right = {-1.0, 0.0, 0.0},
                             .up = {0.0, 1.0, 0.0},
                             .toward = {0.0, 0.0, 1.0}};
    if (sphere) {
        f.right = pp_vec(1.0, 0.0, 0.0);
        f.up = pp_vec(0.0, 0.0, 1.0);
        f.toward = pp_vec(0.0, 1.0, 0.0);
    }
    f.luminance = calloc((size_t)width * (size_t)lens.size_px, sizeof *f.luminance);
    assert_non_null(f.luminance);
    for (int y = 0; y < f.height; y++)
        for (int x = 0; x < width; x++) {
            double place[2] = {(x + 0.5 - f.centre[0]) / f.radius[0],
                               (f.centre[1] - y - 0.5) / f.radius[1]};
            struct pp_vec3 own;
            if (pp_sky_projection_direction(f.projection, f.half_angle_rad, place,
                                            &own))
                f.luminance[y * width + x] =
                    (float)(factor * pp_sky_luminance(sky, direction_of(&f, own)));
        }
    return f;
}

static struct pp_sky_picture *picture_of(const struct pp_sky *sky, struct lens lens,
                                         double factor)
{
    struct pp_sky_picture *picture = calloc(1, sizeof *picture);
    assert_non_null(picture);
    picture->frames[picture->frame_count++] = frame_of(sky, lens, factor);
    picture->fill_cd_m2 = NAN;
    assert_int_equal(pp_sky_picture_settle(picture, NAN, NULL), PP_OK);
    return picture;
}

static struct pp_sky clear_sky(void)
{
    struct pp_sky sky;
    double b = 150.0 * PP_RAD, a = 35.0 * PP_RAD;
    struct pp_vec3 sun = pp_vec(cos(a) * sin(b), cos(a) * cos(b), sin(a));
    assert_int_equal(pp_sky_iso(&sky, 12, sun, NULL), PP_OK);
    return sky;
}

static const struct lens lenses[] = {{PP_SKY_EQUIDISTANT, PP_PI / 2.0, 256},
                                     {PP_SKY_EQUISOLID, 0.52 * PP_PI, 256},
                                     {PP_SKY_HEMISPHERICAL, PP_PI / 2.0, 512},
                                     {PP_SKY_LATITUDE_LONGITUDE, PP_PI, 256}};

/* Each wall separately: if the picture were read mirrored, east and west would be
 * exchanged. */
static void a_picture_of_a_known_sky_lights_walls_as_that_sky(void **state)
{
    (void)state;
    struct pp_sky skies[2] = {pp_sky_overcast(), clear_sky()};
    for (int s = 0; s < 2; s++)
        for (size_t i = 0; i < sizeof lenses / sizeof *lenses; i++) {
            struct pp_sky_picture *picture = picture_of(&skies[s], lenses[i], 12345.0);
            assert_relative(picture->horizontal_lx, 12345.0, 3e-4);
            struct pp_sky sky = pp_sky_of_picture(picture, 0.0);
            assert_near(pp_sky_on_plane(&sky, pp_vec(0.0, 0.0, 1.0)), 1.0, 1e-4);
            for (int k = 0; k < 4; k++) {
                struct pp_vec3 n =
                    pp_vec(cos(k * PP_PI / 2.0), sin(k * PP_PI / 2.0), 0);
                assert_relative(pp_sky_on_plane(&sky, n), pp_sky_on_plane(&skies[s], n),
                                1e-3);
            }
            pp_sky_picture_release(picture);
        }
}

static void luminance_between_pixels_is_that_of_the_sky(void **state)
{
    (void)state;
    struct pp_sky clear = clear_sky();
    for (size_t i = 0; i < sizeof lenses / sizeof *lenses; i++) {
        struct pp_sky_picture *picture = picture_of(&clear, lenses[i], 1.0);
        for (int k = 0; k < 200; k++) {
            double a = fmod(k * 0.618034, 1.0) * 1.4 + 0.1, b = k * 2.39996;
            struct pp_vec3 u = pp_vec(cos(a) * sin(b), cos(a) * cos(b), sin(a));
            assert_relative(pp_sky_picture_luminance(picture, u, NULL),
                            pp_sky_luminance(&clear, u), 1e-2);
        }
        pp_sky_picture_release(picture);
    }
}

/* A room whose +y points east has the sky's east where another room has its north. */
static void north_turns_the_picture(void **state)
{
    (void)state;
    struct pp_sky clear = clear_sky();
    struct pp_sky_picture *picture = picture_of(&clear, lenses[0], 1.0);
    struct pp_sky straight = pp_sky_of_picture(picture, 0.0);
    struct pp_sky turned = pp_sky_of_picture(picture, PP_PI / 2.0);
    assert_near(pp_sky_luminance(&turned, pp_vec(0.0, 0.6, 0.8)),
                pp_sky_luminance(&straight, pp_vec(0.6, 0.0, 0.8)), 1e-12);
    assert_near(pp_sky_luminance(&turned, pp_vec(0.6, 0.0, 0.8)),
                pp_sky_luminance(&straight, pp_vec(0.0, -0.6, 0.8)), 1e-12);
    pp_sky_picture_release(picture);
}

static void a_measured_illuminance_scales_the_pixels(void **state)
{
    (void)state;
    struct pp_sky overcast = pp_sky_overcast();
    struct pp_sky_picture picture = {.frame_count = 1,
                                     .fill_cd_m2 = NAN,
                                     .frames = {frame_of(&overcast, lenses[0], 1.0)}};
    assert_int_equal(pp_sky_picture_settle(&picture, 8600.0, NULL), PP_OK);
    assert_near(picture.horizontal_lx, 8600.0, 1e-6);
    /* Lz = 9 Eh / (7 pi) */
    assert_relative(pp_sky_picture_luminance(&picture, pp_vec(0.0, 0.0, 1.0), NULL),
                    9.0 * 8600.0 / (7.0 * PP_PI), 2e-4);
    assert_int_equal(picture.saturated, 0);
    free(picture.frames[0].luminance);
    free(picture.cells);
}

/* Two pictures of 190 degrees, facing the zenith and the nadir, show all directions. */
static void two_opposite_pictures_show_all_directions(void **state)
{
    (void)state;
    struct lens wide = {PP_SKY_EQUIDISTANT, 95.0 * PP_RAD, 64};
    struct pp_sky overcast = pp_sky_overcast();
    struct pp_sky_picture *picture = picture_of(&overcast, wide, 1.0);
    struct pp_sky_frame *second = &picture->frames[picture->frame_count++];
    *second = picture->frames[0];
    second->toward = pp_vec(0.0, 0.0, -1.0);
    second->right = pp_vec(1.0, 0.0, 0.0);
    second->luminance = malloc(64 * 64 * sizeof(float));
    assert_non_null(second->luminance);
    for (int i = 0; i < 64 * 64; i++)
        second->luminance[i] = 7.0f;
    bool filled = true;
    assert_near(pp_sky_picture_luminance(picture, pp_vec(0.6, 0.0, -0.8), &filled), 7.0,
                1e-6);
    assert_false(filled);
    assert_near(pp_sky_picture_luminance(picture, pp_vec(0.0, 0.0, 1.0), &filled),
                9.0 / (7.0 * PP_PI), 1e-3);
    pp_sky_picture_release(picture);
}

/* Below the picture's horizon the sky continues with the same luminance, or has the
 * given one. */
static void a_horizon_is_filled_in_as_given(void **state)
{
    (void)state;
    struct pp_sky overcast = pp_sky_overcast();
    struct pp_sky_picture *picture = picture_of(&overcast, lenses[0], 1.0);
    double low = 5.0 * PP_RAD, high = 20.0 * PP_RAD;
    struct pp_vec3 at_low = pp_vec(cos(low), 0.0, sin(low));
    struct pp_vec3 at_high = pp_vec(cos(high), 0.0, sin(high));
    bool filled;
    picture->horizon_rad = high;
    assert_near(pp_sky_picture_luminance(picture, at_low, &filled),
                pp_sky_picture_luminance(picture, at_high, NULL), 1e-12);
    assert_true(filled);
    picture->fill_cd_m2 = 0.25;
    assert_near(pp_sky_picture_luminance(picture, at_low, NULL), 0.25, 0.0);
    pp_sky_picture_release(picture);
}

static void a_sun_that_is_cut_off_is_noticed(void **state)
{
    (void)state;
    struct pp_sky overcast = pp_sky_overcast();
    struct pp_sky_picture picture = {.frame_count = 1,
                                     .fill_cd_m2 = NAN,
                                     .frames = {frame_of(&overcast, lenses[0], 1e4)}};
    for (int y = 100; y < 103; y++)
        for (int x = 140; x < 142; x++)
            picture.frames[0].luminance[y * 256 + x] = 2e6f;
    assert_int_equal(pp_sky_picture_settle(&picture, NAN, NULL), PP_OK);
    assert_int_equal(picture.saturated, 6);
    free(picture.frames[0].luminance);
    free(picture.cells);
}

/* Illuminance from within 3 degrees of a direction on a plane that faces it. */
static double light_around(const struct pp_sky_picture *picture, struct pp_vec3 to)
{
    enum { FINE = 600 };
    struct pp_vec3 a = pp_vec_unit(pp_vec_cross(to, pp_vec(0.0, 0.0, 1.0)));
    struct pp_vec3 b = pp_vec_cross(to, a);
    double sum = 0.0, most = sin(3.0 * PP_RAD), step = 2.0 * most / FINE;
    for (int i = 0; i < FINE * FINE; i++) {
        double x = (i % FINE + 0.5) * step - most, y = (i / FINE + 0.5) * step - most;
        if (hypot(x, y) > most)
            continue;
        struct pp_vec3 u = pp_vec_along(pp_vec_scale(a, x), y, b);
        u = pp_vec_along(u, sqrt(1.0 - x * x - y * y), to);
        sum += step * step * pp_sky_picture_luminance(picture, u, NULL);
    }
    return sum;
}

static struct pp_sky_picture *unsettled(struct lens lens, double sun_lx,
                                        struct pp_vec3 sun)
{
    struct pp_sky overcast = pp_sky_overcast();
    struct pp_sky_picture *picture = calloc(1, sizeof *picture);
    assert_non_null(picture);
    picture->frames[picture->frame_count++] = frame_of(&overcast, lens, 1e4);
    picture->fill_cd_m2 = NAN;
    picture->sun_lx = sun_lx;
    picture->sun = sun;
    return picture;
}

/* A sun of 70,000 lx, 40 degrees above the horizon. */
static void a_measured_sun_adds_its_light_in_every_projection(void **state)
{
    (void)state;
    struct pp_vec3 sun = pp_vec_at_bearing(200.0 * PP_RAD, 40.0 * PP_RAD);
    for (size_t i = 0; i < sizeof lenses / sizeof *lenses; i++) {
        struct pp_sky_picture *without = unsettled(lenses[i], 0.0, sun);
        struct pp_sky_picture *with = unsettled(lenses[i], 7e4, sun);
        assert_int_equal(pp_sky_picture_settle(without, NAN, NULL), PP_OK);
        assert_int_equal(pp_sky_picture_settle(with, NAN, NULL), PP_OK);
        assert_near(with->horizontal_lx - without->horizontal_lx,
                    7e4 * sin(40.0 * PP_RAD), 1e-6);
        assert_relative(light_around(with, sun) - light_around(without, sun), 7e4,
                        0.01);
        assert_relative(pp_sky_picture_on_plane(with, sun)
                            - pp_sky_picture_on_plane(without, sun),
                        7e4, 1e-3);
        assert_int_equal(with->saturated, 0);
        pp_sky_picture_release(without);
        pp_sky_picture_release(with);
    }
}

static void a_measured_illuminance_includes_the_measured_sun(void **state)
{
    (void)state;
    struct pp_error err;
    struct pp_vec3 sun = pp_vec_at_bearing(1.0, 30.0 * PP_RAD);
    struct pp_sky_picture *picture = unsettled(lenses[0], 6e4, sun);
    assert_int_equal(pp_sky_picture_settle(picture, 5e4, NULL), PP_OK);
    assert_near(picture->horizontal_lx, 5e4, 1e-6);
    assert_relative(pp_sky_picture_luminance(picture, pp_vec(0.0, 0.0, 1.0), NULL),
                    2e4 * 9.0 / (7.0 * PP_PI), 1e-3);
    pp_sky_picture_release(picture);
    picture = unsettled(lenses[0], 6e4, sun);
    assert_int_equal(pp_sky_picture_settle(picture, 2.9e4, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "the sun alone gives 30000 lx"));
    pp_sky_picture_release(picture);
}

static void a_sun_outside_the_picture_is_refused(void **state)
{
    (void)state;
    struct pp_error err;
    struct lens narrow = {PP_SKY_EQUIDISTANT, 60.0 * PP_RAD, 64};
    struct pp_sky_picture *picture =
        unsettled(narrow, 6e4, pp_vec_at_bearing(1.0, 20.0 * PP_RAD));
    assert_int_equal(pp_sky_picture_settle(picture, NAN, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "outside the picture"));
    pp_sky_picture_release(picture);
}

static void a_picture_without_light_is_refused(void **state)
{
    (void)state;
    float pixels[64] = {0};
    struct pp_sky_picture black = {.frame_count = 1, .fill_cd_m2 = NAN};
    black.frames[0] = (struct pp_sky_frame){.width = 8,
                                            .height = 8,
                                            .luminance = pixels,
                                            .half_angle_rad = PP_PI / 2.0,
                                            .centre = {4.0, 4.0},
                                            .radius = {4.0, 4.0},
                                            .right = {-1.0, 0.0, 0.0},
                                            .up = {0.0, 1.0, 0.0},
                                            .toward = {0.0, 0.0, 1.0}};
    struct pp_error err;
    assert_int_equal(pp_sky_picture_settle(&black, NAN, &err), PP_BAD_INPUT);
    free(black.cells);
    pixels[27] = -1.0f;
    assert_int_equal(pp_sky_picture_settle(&black, NAN, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "row 4, pixel 4"));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_picture_of_a_known_sky_lights_walls_as_that_sky),
        cmocka_unit_test(luminance_between_pixels_is_that_of_the_sky),
        cmocka_unit_test(north_turns_the_picture),
        cmocka_unit_test(a_measured_illuminance_scales_the_pixels),
        cmocka_unit_test(two_opposite_pictures_show_all_directions),
        cmocka_unit_test(a_horizon_is_filled_in_as_given),
        cmocka_unit_test(a_sun_that_is_cut_off_is_noticed),
        cmocka_unit_test(a_measured_sun_adds_its_light_in_every_projection),
        cmocka_unit_test(a_measured_illuminance_includes_the_measured_sun),
        cmocka_unit_test(a_sun_outside_the_picture_is_refused),
        cmocka_unit_test(a_picture_without_light_is_refused),
    };
    add_tests(tests, NULL, NULL);
}
