/* test_sample_bright.c - directions to the sun of a photographed sky. */
#include "simulate/sampling/sample_bright.h"

#include "model/light/photographs/sky_picture.h"
#include "simulate/sampling/lobe.h"
#include "simulate/sampling/sobol.h"
#include "tests/lib/near.h"

#include <stdlib.h>

static struct pp_sobol sobol;

static int make_sobol(void **state)
{
    (void)state;
    pp_sobol_init(&sobol);
    return 0;
}

/* A panorama with north in its middle: a luminance of 1000 cd/m2, and a sun of 2.4
 * degrees in radius at bearing 140, altitude 31 degrees. */
static struct pp_sky_picture *panorama(double sun_cd_m2, enum pp_sky_sampling sampling)
{
    struct pp_sky_picture *picture = calloc(1, sizeof *picture);
    assert_non_null(picture);
    picture->fill_cd_m2 = NAN;
    picture->sampling = sampling;
    picture->lamps = 16;
    picture->frame_count = 1;
    struct pp_sky_frame *frame = &picture->frames[0];
    *frame = (struct pp_sky_frame){.width = 1024,
                                   .height = 512,
                                   .projection = PP_SKY_LATITUDE_LONGITUDE,
                                   .half_angle_rad = PP_PI,
                                   .centre = {512.0, 256.0},
                                   .radius = {512.0, 256.0},
                                   .right = {1.0, 0.0, 0.0},
                                   .up = {0.0, 0.0, 1.0},
                                   .toward = {0.0, 1.0, 0.0}};
    frame->luminance = malloc(1024 * 512 * sizeof *frame->luminance);
    assert_non_null(frame->luminance);
    struct pp_vec3 sun = pp_vec_at_bearing(140.0 * PP_RAD, 31.0 * PP_RAD);
    for (int i = 0; i < 1024 * 512; i++) {
        double bearing = (i % 1024 + 0.5) / 1024.0 * 2.0 * PP_PI - PP_PI;
        double altitude = PP_PI / 2.0 - (i / 1024 + 0.5) / 512.0 * PP_PI;
        bool in_sun =
            pp_vec_dot(sun, pp_vec_at_bearing(bearing, altitude)) > cos(2.4 * PP_RAD);
        frame->luminance[i] = (float)(in_sun ? sun_cd_m2 : 1000.0);
    }
    assert_int_equal(pp_sky_picture_settle(picture, NAN, NULL), PP_OK);
    return picture;
}

/* A sky turned by an awkward angle, and its bright parts. */
struct sunny {
    struct pp_sky_picture *picture;
    struct pp_sky sky;
    struct pp_sky_bright *bright;
};

static struct sunny sampled_sky(double sun_cd_m2, enum pp_sky_sampling sampling)
{
    struct sunny sunny = {.picture = panorama(sun_cd_m2, sampling)};
    sunny.sky = pp_sky_of_picture(sunny.picture, 0.37);
    assert_int_equal(pp_sky_bright_create(&sunny.bright, &sunny.sky, NULL), PP_OK);
    return sunny;
}

static struct sunny sunny_sky(double sun_cd_m2)
{
    return sampled_sky(sun_cd_m2, PP_SKY_SAMPLE_BRIGHT);
}

static void clear_sunny(struct sunny *sunny)
{
    pp_sky_bright_destroy(sunny->bright);
    pp_sky_picture_release(sunny->picture);
}

static struct pp_sobol_sequence sequence_of(uint64_t seed)
{
    struct pp_sobol_sequence sequence;
    pp_sobol_sequence_init(&sequence, &sobol, seed);
    return sequence;
}

static void a_sky_without_a_sun_has_no_bright_parts(void **state)
{
    (void)state;
    struct sunny dull = sunny_sky(1500.0);
    assert_null(dull.bright);
    clear_sunny(&dull);
}

/* The solid angle of a disc is 2 pi (1 - cos r); the mean of 1/p over the directions
 * that are drawn is the solid angle of the bright cells, larger by those at the rim. */
static void directions_are_drawn_in_the_sun_with_their_density(void **state)
{
    (void)state;
    struct sunny sunny = sunny_sky(4e6);
    struct pp_sobol_sequence sequence = sequence_of(5);
    struct pp_vec3 sun =
        pp_sky_from_north(&sunny.sky, pp_vec_at_bearing(140.0 * PP_RAD, 31.0 * PP_RAD));
    double solid = 0.0;
    assert_non_null(sunny.bright);
    for (uint32_t i = 0; i < 1024; i++) {
        double u[2];
        pp_sobol_sequence_draw(&sequence, i, 0, 2, u);
        struct pp_vec3 to = pp_sky_bright_draw(sunny.bright, u[0], u[1]);
        assert_true(pp_vec_dot(to, sun) > cos(3.1 * PP_RAD));
        solid += 1.0 / pp_sky_bright_pdf(sunny.bright, to) / 1024.0;
    }
    double disc = 2.0 * PP_PI * (1.0 - cos(2.4 * PP_RAD));
    assert_true(solid > disc && solid < 1.7 * disc);
    assert_near(pp_sky_bright_pdf(sunny.bright, pp_vec(0.0, 0.0, 1.0)), 0.0, 0.0);
    clear_sunny(&sunny);
}

static void light_found_by_chance_has_no_bright_parts(void **state)
{
    (void)state;
    struct sunny chance = sampled_sky(4e6, PP_SKY_SAMPLE_CHANCE);
    assert_null(chance.bright);
    clear_sunny(&chance);
}

/* The mean of 1/p over directions drawn from a density that is nowhere 0 is the solid
 * angle of the sky, the mean of L/p its scalar illuminance: 2 pi L for a grey sky. */
static void lamps_of_a_cube_cover_the_sky_with_their_density(void **state)
{
    (void)state;
    struct sunny grey = sampled_sky(1000.0, PP_SKY_SAMPLE_LAMPS);
    struct sunny sunny = sampled_sky(4e6, PP_SKY_SAMPLE_LAMPS);
    struct pp_sobol_sequence sequence = sequence_of(5);
    double solid = 0.0, sunlit = 0.0;
    const int count = 1 << 14;
    for (uint32_t i = 0; i < (uint32_t)count; i++) {
        double u[2];
        pp_sobol_sequence_draw(&sequence, i, 0, 2, u);
        struct pp_vec3 to = pp_sky_bright_draw(grey.bright, u[0], u[1]);
        solid += 1.0 / pp_sky_bright_pdf(grey.bright, to) / count;
        to = pp_sky_bright_draw(sunny.bright, u[0], u[1]);
        sunlit += pp_sky_luminance(&sunny.sky, to) / pp_sky_bright_pdf(sunny.bright, to)
                  / count;
    }
    assert_relative(solid, 2.0 * PP_PI, 0.002);
    double disc = 2.0 * PP_PI * (1.0 - cos(2.4 * PP_RAD));
    assert_relative(sunlit * sunny.picture->horizontal_lx,
                    1000.0 * 2.0 * PP_PI + 4e6 * disc, 0.03);
    clear_sunny(&grey);
    clear_sunny(&sunny);
}

/* Mean of pi L over 64 directions about n, over the horizontal illuminance. */
static double illuminance_by(const struct sunny *sunny,
                             const struct pp_sky_bright *bright, struct pp_vec3 n,
                             uint64_t seed)
{
    struct pp_sobol_sequence sequence = sequence_of(seed);
    struct pp_vec3 a, b, to;
    double sum = 0.0;
    pp_lobe_frame(n, &a, &b);
    for (uint32_t i = 0; i < 64; i++) {
        double u[2];
        pp_sobol_sequence_draw(&sequence, i, 0, 2, u);
        double factor = pp_sample_bright_lobe(bright, a, b, n, u[0], u[1], &to);
        if (to.z > 0.0)
            sum += factor * PP_PI * pp_sky_luminance(&sunny->sky, to) / 64.0;
    }
    return sum;
}

/* The sun fills 1/1100 of the sky: by chance one direction in 1,300 finds it, and 64
 * directions miss it or count it twenty times. Mixed, they find the illuminance of
 * planes that face the sun, and of those that do not. */
static void sixty_four_directions_find_the_illuminance_of_a_plane(void **state)
{
    (void)state;
    struct sunny sunny = sunny_sky(4e6);
    const struct pp_vec3 normals[] = {
        {0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}, {0.6, -0.8, 0.0}, {0.0, 0.8, 0.6}};
    double chance = 0.0;
    for (int k = 0; k < 4; k++) {
        double exact = pp_sky_on_plane(&sunny.sky, normals[k]), mean = 0.0;
        for (uint64_t seed = 0; seed < 16; seed++) {
            double one = illuminance_by(&sunny, sunny.bright, normals[k], seed);
            assert_relative(one, exact, 0.3);
            mean += one / 16.0;
            double off = illuminance_by(&sunny, NULL, normals[k], seed) / exact - 1.0;
            chance += off * off / 64.0;
        }
        assert_relative(mean, exact, 0.03);
    }
    assert_true(sqrt(chance) > 0.5);
    clear_sunny(&sunny);
}

/* A window of 2 x 1.4 m, seen from points in the room: its light by 1,024 directions,
 * of which some are to the sun, agrees with that by 131,072 directions to the window
 * alone. */
static void a_window_gives_the_same_light_with_directions_to_the_sun(void **state)
{
    (void)state;
    struct sunny sunny = sunny_sky(4e6);
    const struct pp_target window = {.normal = {0.0, 1.0, 0.0},
                                     .middle = {1.0, 0.0, 1.9},
                                     .area_m2 = 2.8,
                                     .rectangle = true,
                                     .corner = {2.0, 0.0, 1.2},
                                     .along = {-1.0, 0.0, 0.0},
                                     .up = {0.0, 0.0, 1.0},
                                     .width_m = 2.0,
                                     .height_m = 1.4};
    const struct pp_vec3 up = {0.0, 0.0, 1.0};
    for (int place = 0; place < 3; place++) {
        struct pp_vec3 from = {0.4 + 0.3 * place, 0.7 + 1.1 * place, 0.0};
        double light[2] = {0.0, 0.0};
        for (int way = 0; way < 2; way++) {
            struct pp_polygon_sampler sampler;
            struct pp_sobol_sequence sequence = sequence_of(7);
            uint32_t count = way ? 1024 : 1 << 17;
            pp_sample_polygon_init(
                &sampler, &window, from, up,
                &(struct pp_brightness){.ground = 0.2,
                                        .bright = way ? sunny.bright : NULL});
            for (uint32_t i = 0; i < count; i++) {
                double u[2];
                pp_sobol_sequence_draw(&sequence, i, 0, 2, u);
                struct pp_direction_sample to =
                    pp_sample_polygon_draw(&sampler, u[0], u[1]);
                if (!(to.per_density > 0.0))
                    continue;
                assert_relative(to.per_density,
                                1.0 / pp_sample_polygon_pdf(&sampler, to.direction),
                                1e-6);
                light[way] += to.per_density * to.direction.z
                              * pp_sky_luminance(&sunny.sky, to.direction) / count;
            }
        }
        assert_relative(light[1], light[0], 0.03);
    }
    clear_sunny(&sunny);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sky_without_a_sun_has_no_bright_parts),
        cmocka_unit_test(light_found_by_chance_has_no_bright_parts),
        cmocka_unit_test(lamps_of_a_cube_cover_the_sky_with_their_density),
        cmocka_unit_test(directions_are_drawn_in_the_sun_with_their_density),
        cmocka_unit_test(sixty_four_directions_find_the_illuminance_of_a_plane),
        cmocka_unit_test(a_window_gives_the_same_light_with_directions_to_the_sun),
    };
    add_tests(tests, make_sobol, NULL);
}
