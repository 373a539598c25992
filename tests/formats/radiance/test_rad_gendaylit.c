/* test_rad_gendaylit.c - skies of gendaylit's options in Radiance scenes. */
#include "tests/lib/near.h"

#include <stdio.h>

#include "formats/radiance/read/rad_read.h"

static enum pp_status read_scene(struct pp_scene_description *scene, const char *text,
                                 struct pp_error *err)
{
    struct pp_rad_summary summary;
    return pp_rad_read_bytes(scene, &summary, text, strlen(text), "room.rad", err);
}

/* Skies as printed by Radiance's gendaylit, to its digits: from irradiances, from
 * clearness and brightness (-P), illuminances (-L) and a global irradiance (-E), and
 * with the sun in the sunlit part of an hour (-i). */
static void skies_are_those_of_gendaylit(void **state)
{
    (void)state;
    static const struct {
        const char *options;
        double zenith, ground, perez[5], sun[3], solar;
    } skies[] = {{"-ang 35 -30 -W 600 120",
                  37.64,
                  15.93,
                  {-1.020356, -0.313945, 13.055488, -3.439730, 0.294227},
                  {0.409576, -0.709406, 0.573576},
                  4.846e6},
                 {"3 21 12 -a 51.5 -o 0.1 -m 0 -W 0 150 -g 0.3",
                  16.88,
                  8.279,
                  {0.842267, -0.561730, 0.681250, -0.514831, -0.019387},
                  {0.034037, -0.786521, 0.616625},
                  0.0},
                 {"6 21 +9.5 -a 51.5 -y 2021 -W 300 100 -O 1",
                  52.91,
                  18.38,
                  {-1.075933, -0.232554, 13.116358, -3.473042, 0.210480},
                  {0.558547, -0.322094, 0.764382},
                  4.414e6},
                 {"6 21 12 -a 23 -o 0 -m 0 -G 800 60 -s -d 5",
                  15.71,
                  5.654,
                  {-1.028290, -0.283610, 28.340997, -6.602328, 1.551987},
                  {0.030374, 0.042620, 0.998630},
                  0.0},
                 {"-ang 89 0 -W 850 90 -w",
                  23.24,
                  39.44,
                  {-1.020169, -0.269402, 27.552033, -6.358006, 1.586417},
                  {0.0, -0.052336, 0.998630},
                  7.252e6},
                 {"-ang 35 -30 -P 4 .2 -g .3",
                  38.41,
                  36.43,
                  {-0.896575, -0.345998, 13.060946, -3.417024, 0.285650},
                  {0.409576, -0.709406, 0.573576},
                  7.466e6},
                 {"3 21 +9.5 -a 51.5 -P 1 .3",
                  19.86,
                  6.647,
                  {0.541492, -0.423469, 1.825108, -1.085297, 0.048117},
                  {0.608746, -0.625255, 0.488348},
                  0.0},
                 {"-ang 35 -30 -L 60000 15000",
                  36.97,
                  15.13,
                  {-1.087021, -0.296682, 13.052549, -3.451959, 0.298846},
                  {0.409576, -0.709406, 0.573576},
                  4.932e6},
                 {"-ang 50 10 -L 20000 30000 -O 1",
                  48.66,
                  22.68,
                  {-0.961622, -0.569953, 14.777736, -3.225879, 0.211091},
                  {-0.111619, -0.633022, 0.766044},
                  3.036e6},
                 {"-ang 25 60 -E 420",
                  32.05,
                  13.72,
                  {-0.995096, -0.320499, 13.104252, -3.403701, 0.346789},
                  {-0.784886, -0.453154, 0.422618},
                  5.798e6},
                 {"6 21 12 -a 40 -o 3 -m 0 -E 150",
                  18.67,
                  3.665,
                  {1.196203, -0.621874, 0.311777, -0.265874, -0.033776},
                  {0.053618, -0.283828, 0.957375},
                  8.474e3},
                 {"3 21 6.2 -a 51.5 -o 0 -m 0 -i 60 -W 120 40",
                  7.148,
                  1.022,
                  {-1.159566, -1.049156, 13.922966, -2.850647, -0.105340},
                  {0.996784, -0.066855, 0.044177},
                  1.184e5},
                 {"12 21 15.7 -a 51.5 -o 0.1 -m 0 -i 60 -y 2021 -W 150 30",
                  6.365,
                  0.9868,
                  {-0.706653, -0.805987, 9.372562, -2.906857, 0.011915},
                  {-0.729304, -0.683278, 0.035304},
                  2.193e5}};
    for (size_t i = 0; i < sizeof skies / sizeof *skies; i++) {
        char text[200];
        snprintf(text, sizeof text,
                 "!gendaylit %s\nskyfunc glow sky 0 0 4 1 1 1 0\n"
                 "sky source dome 0 0 4 0 0 1 180\n",
                 skies[i].options);
        struct pp_scene_description scene;
        struct pp_error err = {0};
        if (read_scene(&scene, text, &err) != PP_OK)
            fail_msg("%s: %s", skies[i].options, err.message);
        const struct pp_pattern *sky = &scene.patterns[0];
        assert_int_equal(sky->type, PP_GENSKY_PEREZ);
        assert_relative(sky->zenith, skies[i].zenith, 1e-3);
        assert_relative(sky->ground, skies[i].ground, 1e-3);
        for (int k = 0; k < 5; k++)
            assert_near(sky->perez[k], skies[i].perez[k], 2e-5);
        assert_near(sky->sun.x, skies[i].sun[0], 2e-6);
        assert_near(sky->sun.y, skies[i].sun[1], 2e-6);
        assert_near(sky->sun.z, skies[i].sun[2], 2e-6);
        bool sun = skies[i].solar > 0.0;
        assert_int_equal(scene.shape_count, sun ? 2 : 1);
        if (sun)
            assert_relative(scene.materials[0].radiance.g, skies[i].solar, 1e-3);
        pp_scene_description_clear(&scene);
    }
}

static void options_without_a_meaning_here_are_refused(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        {"!gendaylit 1 1 12 -P 2\n", "valid numbers after gendaylit's option -P"},
        {"!gendaylit 1 1 12 -l 2\n", "not gendaylit's option -l"},
        {"!gendaylit -ang 35 0 -P 12.5 .1\n", "has no sky for these values"},
        {"!gendaylit -ang 35 0 -P 5 .1 -C\n", "a sky without colours"},
        {"!gendaylit 12 21 3 -i 60 -W 9 9\n", "below the horizon"},
        {"!gendaylit 1 1 12 -W 2\n", "valid numbers after gendaylit's option -W"},
        {"!gendaylit 1 1 12\n", "expected gendaylit with -W, -G, -L, -P or -E"},
        {"!gendaylit 13 1 12 -W 2 3\n", "expected gendaylit with month"},
        {"!gendaylit -ang -3 0 -W 2 3\n", "below the horizon"},
        {"!gendaylit -ang 3 0 -W 9 0\n", "has no sky for these values"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct pp_scene_description scene;
        struct pp_error err = {0};
        assert_int_equal(read_scene(&scene, wrong[i][0], &err), PP_BAD_INPUT);
        if (!strstr(err.message, wrong[i][1]))
            fail_msg("%s: %s", wrong[i][0], err.message);
    }
}

/* Between overcast and clear gendaylit gives no colours (-C), with a warning. */
static void intermediate_skies_have_no_colours(void **state)
{
    (void)state;
    struct pp_scene_description scenes[2];
    assert_int_equal(read_scene(&scenes[0], "!gendaylit -ang 35 0 -P 3 .1 -C\n", NULL),
                     PP_OK);
    assert_int_equal(read_scene(&scenes[1], "!gendaylit -ang 35 0 -P 3 .1\n", NULL),
                     PP_OK);
    assert_near(scenes[0].patterns[0].zenith, scenes[1].patterns[0].zenith, 0.0);
    pp_scene_description_clear(&scenes[0]);
    pp_scene_description_clear(&scenes[1]);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(skies_are_those_of_gendaylit),
        cmocka_unit_test(options_without_a_meaning_here_are_refused),
        cmocka_unit_test(intermediate_skies_have_no_colours),
    };
    add_tests(tests, NULL, NULL);
}
