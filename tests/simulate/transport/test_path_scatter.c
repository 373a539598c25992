/* test_path_scatter.c - where a path goes on from a diffuse surface. */
#include "tests/lib/near.h"

#include <stdlib.h>

#include "model/light/photographs/sky_bright.h"
#include "model/light/photographs/sky_picture.h"
#include "simulate/scene/environment.h"
#include "simulate/transport/path_scatter.h"

/* A grey panorama with a sun 45 degrees above the horizon. */
static struct pp_sky_picture *sunny(void)
{
    struct pp_sky_picture *picture = calloc(1, sizeof *picture);
    assert_non_null(picture);
    picture->fill_cd_m2 = NAN;
    picture->sun = pp_vec(0.0, sqrt(0.5), sqrt(0.5));
    picture->sun_lx = 8e4;
    picture->frame_count = 1;
    picture->frames[0] = (struct pp_sky_frame){.width = 128,
                                               .height = 64,
                                               .projection = PP_SKY_LATITUDE_LONGITUDE,
                                               .half_angle_rad = PP_PI,
                                               .centre = {64.0, 32.0},
                                               .radius = {64.0, 32.0},
                                               .right = {1.0, 0.0, 0.0},
                                               .up = {0.0, 0.0, 1.0},
                                               .toward = {0.0, 1.0, 0.0}};
    picture->frames[0].luminance = malloc(128 * 64 * sizeof(float));
    assert_non_null(picture->frames[0].luminance);
    for (int i = 0; i < 128 * 64; i++)
        picture->frames[0].luminance[i] = 1000.0F;
    assert_int_equal(pp_sky_picture_settle(picture, NAN, NULL), PP_OK);
    return picture;
}

/* A direction to the sun is drawn with a high density, so its weight is about 1/10,000.
 * If roulette counted that weight, it would end nearly all paths to the sun, and the
 * few others would have 10,000 times their light. */
static void roulette_does_not_end_paths_because_they_lead_to_the_sun(void **state)
{
    (void)state;
    static struct pp_sobol sobol;
    static struct pp_light_scene open;
    static struct pp_radiance_state paths;
    struct pp_sky_picture *picture = sunny();
    struct pp_environment environment = {.light.sky = pp_sky_of_picture(picture, 0.0)};
    assert_int_equal(
        pp_sky_bright_create(&environment.bright, &environment.light.sky, NULL), PP_OK);
    assert_non_null(environment.bright);
    pp_sobol_init(&sobol);
    paths.scene = &open;
    paths.environment = &environment;
    pp_sobol_sequence_init(&paths.sequence, &sobol, 1);
    const struct pp_frame level = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    int to_sun = 0, alive = 0;
    for (paths.index = 0; paths.index < 4096; paths.index++) {
        struct pp_light_path path = {
            .throughput = pp_rgb_grey(0.5), .vertex = 1, .from_window = true};
        bool survives = pp_path_scatter_diffuse(&paths, &path, pp_vec(0.0, 0.0, 0.0),
                                                &level, PP_OUTDOORS, 1.0);
        if (pp_vec_dot(path.ray.to, picture->sun) < cos(1.0 * PP_RAD))
            continue;
        to_sun++;
        alive += survives;
        assert_true(path.throughput.g < 0.1);
    }
    assert_true(to_sun > 200);
    assert_near((double)alive / to_sun, 0.5, 0.03);
    pp_sky_bright_destroy(environment.bright);
    pp_sky_picture_release(picture);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(roulette_does_not_end_paths_because_they_lead_to_the_sun),
    };
    add_tests(tests, NULL, NULL);
}
