/* test_sky_patches.c - the patches of the sky. */
#include "tests/lib/near.h"

#include "model/light/sky_patches.h"

static const int counts[] = {145, 577, 2305};

static void together_they_are_the_hemisphere(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        struct pp_sky_patches patches;
        double sum = 0.0;
        assert_true(pp_sky_patches_init(&patches, counts[k], 0.3));
        for (int i = 0; i < counts[k]; i++)
            sum += pp_sky_patches_solid_angle(&patches, i);
        assert_near(sum, 2.0 * PP_PI, 1e-12);
    }
    struct pp_sky_patches none;
    assert_false(pp_sky_patches_init(&none, 144, 0.0));
}

/* Tregenza's first row has patches of 12 by 12 degrees and 0.0435 sr; the cap has a
 * radius of 6 degrees and 0.0344 sr. */
static void patches_are_those_of_tregenza(void **state)
{
    (void)state;
    struct pp_sky_patches patches;
    assert_true(pp_sky_patches_init(&patches, 145, 0.0));
    assert_near(pp_sky_patches_solid_angle(&patches, 0), 0.04355, 1e-5);
    assert_near(pp_sky_patches_solid_angle(&patches, 144), 0.03442, 1e-5);
    struct pp_vec3 first = pp_sky_patches_centre(&patches, 1);
    assert_near(asin(first.z), 6.0 * PP_RAD, 1e-12);
    assert_near(atan2(first.x, first.y), 12.0 * PP_RAD,
                1e-12); /* clockwise from north */
}

static void a_centre_lies_in_its_patch(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        struct pp_sky_patches patches;
        pp_sky_patches_init(&patches, counts[k], 2.1);
        for (int i = 0; i < counts[k]; i++)
            assert_int_equal(
                pp_sky_patches_of(&patches, pp_sky_patches_centre(&patches, i)), i);
    }
}

/* In a room whose y axis points east, the eastern patch is along y. */
static void patches_turn_with_the_axes_of_the_room(void **state)
{
    (void)state;
    struct pp_sky_patches north, east;
    pp_sky_patches_init(&north, 577, 0.0);
    pp_sky_patches_init(&east, 577, PP_PI / 2.0);
    assert_int_equal(pp_sky_patches_of(&north, pp_vec_unit(pp_vec(0.9, 0.0, 0.3))),
                     pp_sky_patches_of(&east, pp_vec_unit(pp_vec(0.0, 0.9, 0.3))));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(together_they_are_the_hemisphere),
        cmocka_unit_test(patches_are_those_of_tregenza),
        cmocka_unit_test(a_centre_lies_in_its_patch),
        cmocka_unit_test(patches_turn_with_the_axes_of_the_room),
    };
    add_tests(tests, NULL, NULL);
}
