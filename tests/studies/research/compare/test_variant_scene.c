/* test_variant_scene.c - variants of an imported scene compared with closed forms:
 * sensors under a uniform sky, above an infinite coloured ground, and in a glass
 * ball. */
#include "formats/radiance/read/rad_read.h"
#include "studies/research/compare/variant_scene.h"
#include "tests/lib/near.h"

#define SKY                                                                            \
    "void glow even 0 0 4 1 1 1 0\n"                                                   \
    "even source sky 0 0 4 0 0 1 180\n"
#define GROUND                                                                         \
    SKY "void plastic turf 0 0 5 0.1 0.4 0.2 0 0\n"                                    \
        "turf ring ground 0 0 8 0 0 0 0 0 1 0 100000\n"
#define RED 0.1
#define GREEN 0.4
#define BLUE 0.2
#define BALL                                                                           \
    SKY "void glass pane 0 0 3 0.9 0.9 0.9\n"                                          \
        "pane sphere ball 0 0 4 0 0 1 0.5\n"

enum { POINTS = 3 };

/* Values of sensors that face up, sideways and down. */
static void values_of(double values[POINTS], const char *scene, const char *words)
{
    const struct pp_receiver points[POINTS] = {
        {.position = {0.0, 0.0, 1.0}, .normal = {0.0, 0.0, 1.0}},
        {.position = {0.0, 0.0, 1.0}, .normal = {1.0, 0.0, 0.0}},
        {.position = {0.0, 0.0, 1.0}, .normal = {0.0, 0.0, -1.0}}};
    const struct pp_variant_tracing tracing = {.error = 0.003, .seed = 1, .threads = 1};
    struct pp_scene_description description;
    struct pp_rad_summary summary;
    struct pp_room_variant variant = pp_room_variant_nothing();
    double errors[POINTS];
    assert_int_equal(pp_rad_read_bytes(&description, &summary, scene, strlen(scene),
                                       "scene.rad", NULL),
                     PP_OK);
    assert_int_equal(*words ? pp_room_variant_add(&variant, words, NULL) : PP_OK,
                     PP_OK);
    assert_int_equal(pp_variant_scene_values(values, errors, &description, points,
                                             POINTS, &variant, &tracing, NULL),
                     PP_OK);
    pp_scene_description_clear(&description);
}

/* A sensor that faces down sees only ground, one that faces sideways half sky and half
 * ground. */
static void assert_over_ground(const char *words, double reflectance)
{
    double values[POINTS];
    values_of(values, GROUND, words);
    assert_near(values[0], 1.0, 0.01);
    assert_near(values[1], 0.5 * (1.0 + reflectance), 0.01);
    assert_near(values[2], reflectance, 0.02 * reflectance + 1e-9);
}

static void channels_are_summed_up_as_the_other_program_does(void **state)
{
    (void)state;
    double luminance = 0.265 * RED + 0.670 * GREEN + 0.065 * BLUE;
    assert_over_ground("", luminance);
    assert_over_ground("colour=grey", luminance);
    assert_over_ground("colour=mean", (RED + GREEN + BLUE) / 3.0);
    assert_over_ground("colour=green", GREEN);
}

/* Counted as by rtrace's -ab: light from the sky is the first, light of surfaces lit by
 * the sky the second. */
static void light_is_followed_so_far(void **state)
{
    (void)state;
    double luminance = 0.265 * RED + 0.670 * GREEN + 0.065 * BLUE;
    assert_over_ground("bounces=0", 0.0);
    assert_over_ground("ab=1", 0.0);
    assert_over_ground("bounces=1", luminance);
    assert_over_ground("ab=2", luminance);
}

/* All light that reaches the centre of a ball passes the glass at normal incidence;
 * rho = (0.52 / 2.52)^2 at both surfaces. */
static void glass_variants_have_the_assumed_transmittance(void **state)
{
    (void)state;
    double rho = 0.52 / 2.52 * (0.52 / 2.52), clear = (1.0 - rho) * (1.0 - rho);
    double as_it_is = clear * 0.9 / (1.0 - rho * rho * 0.81);
    double twice = clear * as_it_is / (1.0 - rho * rho * as_it_is * as_it_is);
    double values[POINTS];
    values_of(values, BALL, "glass=none");
    assert_near(values[0], 1.0, 0.01);
    double open = values[0];
    values_of(values, BALL, "");
    double through = values[0];
    assert_near(through / open, as_it_is, 0.01);
    values_of(values, BALL, "glass=transmissivity");
    assert_near(values[0] / through, twice / as_it_is, 0.01);
}

static void parts_of_the_geometry_cannot_be_switched(void **state)
{
    (void)state;
    static const char *const words[] = {"sky=uniform", "ground=0.2", "outside=none"};
    const struct pp_variant_tracing tracing = {.error = 0.1, .seed = 1, .threads = 1};
    struct pp_scene_description description;
    struct pp_rad_summary summary;
    const char *scene = GROUND;
    assert_int_equal(pp_rad_read_bytes(&description, &summary, scene, strlen(scene),
                                       "scene.rad", NULL),
                     PP_OK);
    for (int i = 0; i < 3; i++) {
        struct pp_room_variant variant = pp_room_variant_nothing();
        struct pp_error err = {0};
        assert_int_equal(pp_room_variant_add(&variant, words[i], NULL), PP_OK);
        assert_int_equal(pp_variant_scene_values(NULL, NULL, &description, NULL, 0,
                                                 &variant, &tracing, &err),
                         PP_BAD_INPUT);
        assert_non_null(strstr(err.message, "part of the geometry"));
    }
    pp_scene_description_clear(&description);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(channels_are_summed_up_as_the_other_program_does),
        cmocka_unit_test(light_is_followed_so_far),
        cmocka_unit_test(glass_variants_have_the_assumed_transmittance),
        cmocka_unit_test(parts_of_the_geometry_cannot_be_switched),
    };
    add_tests(tests, NULL, NULL);
}
