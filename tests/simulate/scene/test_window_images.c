/* test_window_images.c - sampling of windows by their images in polished planes. */
#include "simulate/scene/images/window_images.h"

#include "simulate/scene/light_scene_of_world.h"
#include "simulate/scene/light_scene_parts.h"
#include "tests/lib/room_of.h"

static const char room[] =
    "<room version='1'><plan width='4' depth='5' height='3'/>"
    "<finishes floor='polished-aluminium' walls='0.5' ceiling='0.7'/>"
    "<window wall='south' left='0.3' sill='0.9' width='2' height='1.5'/>"
    "<window wall='east' left='3' sill='2' width='0.3' height='0.3'/>"
    "<window wall='north' left='1' sill='1' width='1' height='1'/></room>";

/* Multiple importance sampling is unbiased only if both estimates use the same density.
 * One image has far more light than the others: there the even part of the choice
 * matters most. */
static void the_density_of_a_direction_is_that_with_which_it_is_drawn(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(room);
    struct pp_light_scene *scene = NULL;
    assert_int_equal(pp_light_scene_of_world_sunlit(&scene, world,
                                                    &(struct pp_outside_sun){0}, NULL),
                     PP_OK);
    assert_int_equal(scene->window_image_count, 3);
    const struct pp_brightness brightness = {.ground = 0.2, .gradation = 2.0};
    const struct pp_image_viewer viewer = {
        {0.3, -1.5, 1.4}, {0.0, 0.0, -1.0}, &brightness};
    double least = INFINITY;
    int drawn = 0;
    for (int k = 0; k < 300; k++) {
        struct pp_vec3 to;
        double probability, pdf;
        int image =
            pp_window_images_choose(scene, &viewer, (k + 0.5) / 300.0, &probability);
        assert_true(image >= 0);
        if (!pp_window_images_sample(scene, image, &viewer, 0.3, 0.6, &to, &pdf))
            continue;
        const struct pp_window_image *pair = &scene->window_images[image];
        assert_relative(
            pp_window_images_pdf(scene, pair->reflector, pair->window, &viewer, to),
            probability * pdf, 1e-9);
        least = fmin(least, probability);
        drawn++;
    }
    assert_true(drawn > 200);
    assert_true(least < 0.1);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_density_of_a_direction_is_that_with_which_it_is_drawn),
    };
    add_tests(tests, NULL, NULL);
}
