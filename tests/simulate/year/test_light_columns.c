/* test_light_columns.c - each hour's luminances, horizontal illuminance and light of
 * skylines, compared with closed forms of a uniform sky. */
#include "simulate/year/light_columns.h"

#include "model/base/thread_pool.h"
#include "simulate/scene/light_scene_of_world.h"
#include "tests/lib/light_on.h"
#include "tests/lib/room_of.h"

#define STREET                                                                         \
    "<room version='1'><site ground-reflectance='0.3'/>"                               \
    "<plan width='3.6' depth='5.1' height='2.7'/>"                                     \
    "<window wall='south' left='0.8' sill='0.9' width='2' height='1.5'/>"              \
    "<skyline wall='south' angle='25' reflectance='0.4'/><point x='1.8' "              \
    "y='2'/></room>"

enum { PATCHES = 577, HOURS = 37 };

/* The skyline in the south faces north. A uniform sky of diffuse illuminance D has the
 * luminance D/pi, and gives a wall D/2. The sun adds its light times the cosine of its
 * angle: cos(altitude) from the north, nothing from the south. The ground in front
 * reflects half of its light to the wall. Patches count at their centres: 2e-3. */
static void a_skyline_reflects_half_the_sky_its_sun_and_the_ground(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, STREET);
    struct pp_light_scene *scene = NULL;
    assert_int_equal(pp_light_scene_of_world_matt(&scene, world, NULL), PP_OK);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_thread_pool *pool = NULL;
    assert_int_equal(pp_thread_pool_create(&pool, 1, NULL), PP_OK);
    struct pp_sky uniform = pp_sky_uniform();
    struct pp_perez_sky skies[HOURS];
    struct pp_light_columns columns;
    for (int i = 0; i < HOURS; i++) {
        double altitude = 0.04 * (i + 1), north = i % 2 ? 1.0 : -1.0;
        struct pp_vec3 sun = {0.0, north * cos(altitude), sin(altitude)};
        skies[i] = pp_perez_sky_of_standard(&uniform, sun, 1000.0 * i, 9000.0 + i);
    }
    assert_int_equal(environment->skylines->far_count, 1);
    assert_int_equal(pp_light_columns_init(&columns, environment, skies, HOURS, PATCHES,
                                           0.0, pool, NULL),
                     PP_OK);
    for (int i = 0; i < HOURS; i++) {
        double altitude = 0.04 * (i + 1), diffuse = 9000.0 + i, direct = 1000.0 * i;
        double horizontal = diffuse + direct * sin(altitude);
        double on_wall = diffuse / 2.0 + (i % 2 ? direct * cos(altitude) : 0.0);
        double reflected = 0.4 * (on_wall + 0.3 * horizontal / 2.0) / PP_PI;
        assert_near(pp_light_columns_at(&columns, 0, i), diffuse / PP_PI, 0.1);
        assert_near(pp_light_columns_at(&columns, PATCHES - 1, i), diffuse / PP_PI,
                    0.1);
        assert_near(pp_light_columns_at(&columns, PATCHES, i), horizontal,
                    1e-6 * horizontal);
        assert_near(pp_light_columns_at(&columns, PATCHES + 1, i), reflected,
                    2e-3 * reflected);
    }
    pp_light_columns_clear(&columns);
    pp_thread_pool_destroy(pool);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* Only the diffuse light remains. */
static void a_sun_below_the_horizon_gives_no_light(void **state)
{
    (void)state;
    struct pp_sky uniform = pp_sky_uniform();
    struct pp_vec3 sun = {0.0, 0.8, -0.6};
    struct pp_perez_sky sky = pp_perez_sky_of_standard(&uniform, sun, 5000.0, 300.0);
    assert_near(pp_light_columns_horizontal(&sky), 300.0, 1e-9);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_skyline_reflects_half_the_sky_its_sun_and_the_ground),
        cmocka_unit_test(a_sun_below_the_horizon_gives_no_light),
    };
    add_tests(tests, NULL, NULL);
}
