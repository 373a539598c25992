/* test_dresler.c - interreflection of two cavities, compared with light followed from
 * part to part, reflection by reflection. */
#include "methods/reflected/interior.h"
#include "methods/method.h"

#include "tests/methods/box_method.h"

/* The horizontal plane at 1.35 m divides the test room into two parts. The share S/A of
 * the light that a part reflects reaches the other part; the rest returns to the same
 * part. Openings have a reflectance of 0.1. */
struct two_parts {
    double S, A[2], rho[2]; /* 0 lower, 1 upper */
};

static struct two_parts awkward_parts(const struct box_method_symbols *s)
{
    double pane = 1.9 * 1.3 / 2;
    struct two_parts p = {.S = 3.7 * 5.3, .A = {s->A_l + pane, s->A_u + pane}};
    p.rho[0] = (s->A_l * s->rho_l + pane * 0.1) / p.A[0];
    p.rho[1] = (s->A_u * s->rho_u + pane * 0.1) / p.A[1];
    return p;
}

/* Light that reaches the plane from above, divided by the area of the plane. lower,
 * upper: light that first falls on these parts (m2 of open sky). *absorbed: the sum of
 * all absorbed light. */
static double followed(const struct two_parts *p, double lower, double upper,
                       double *absorbed)
{
    double on[2] = {lower, upper}, from_above = 0.0;
    *absorbed = 0.0;
    for (int i = 0; i < 3000; i++) {
        double next[2] = {0.0, 0.0};
        for (int k = 0; k < 2; k++) {
            double reflected = p->rho[k] * on[k], across = p->S / p->A[k];
            *absorbed += on[k] - reflected;
            next[1 - k] += reflected * across;
            next[k] += reflected * (1 - across);
            if (k == 1)
                from_above += reflected * across;
        }
        on[0] = next[0], on[1] = next[1];
    }
    return from_above / p->S;
}

static void window_is_light_followed_from_part_to_part(void **state)
{
    (void)state;
    struct box_room box;
    struct box_method_symbols s =
        box_method_awkward_room(&box, pp_glass_clear_single());
    struct two_parts parts = awkward_parts(&s);
    double sky = s.tau * s.Ag * s.C, ground = s.tau * s.Ag * s.rho_g / 2, absorbed;
    double expected = followed(&parts, sky, ground, &absorbed);
    assert_relative(absorbed, sky + ground, 1e-12); /* no light is lost or gained */
    assert_relative(box_method_value(&pp_method_dresler, &box, 0), expected, 1e-12);
}

static void diffusing_window_lights_both_parts_alike(void **state)
{
    (void)state;
    struct box_room box;
    struct box_method_symbols s =
        box_method_awkward_room(&box, pp_glass_diffusing(0.52));
    struct two_parts parts = awkward_parts(&s);
    double half = s.tau * s.Ag * (s.C + s.rho_g / 2) / 2, absorbed;
    assert_relative(box_method_value(&pp_method_dresler, &box, 0),
                    followed(&parts, half, half, &absorbed), 1e-12);
}

/* A black upper part reflects nothing downwards. If the lower part is black, only light
 * from the ground comes down, after reflection by the upper part. */
static void black_parts_reflect_nothing(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.3, 4.9, 2.6, 0.5, 0.0, 0.0);
    box_room_south(&box, 0.7, 0.9, 1.9, 1.1)->glass = pp_glass_none();
    double small =
        1.9 * 0.55 * 0.1 / (3.3 * 4.9); /* 0.1 is the reflectance of the opening */
    double black = box_method_value(&pp_method_dresler, &box, 0);
    assert_near(black, 0.0, small * 1.9 * 1.1 / (3.3 * 4.9));
    box_room_build(&box, 3.3, 4.9, 2.6, 0.0, 0.0, 0.7);
    box_room_south(&box, 0.7, 0.9, 1e-3, 1e-3)->glass = pp_glass_none();
    double ceiling = 3.3 * 4.9, A_u = ceiling + 2 * 8.2 * (2.6 - 0.9 - 5e-4);
    double mean = 0.7 * ceiling / A_u;
    double k = mean * ceiling / (A_u * (1 - mean) + mean * ceiling);
    assert_relative(box_method_value(&pp_method_dresler, &box, 0),
                    1e-6 * 0.1 * k / ceiling, 1e-5);
}

/* For a box the horizontal section has the area of the plan, and none above the box. */
static void section_is_the_plan_of_the_room(void **state)
{
    (void)state;
    struct box_room box;
    box_method_awkward_room(&box, pp_glass_clear_single());
    assert_relative(pp_interior_section_m2(&box.world, 0.4), 3.7 * 5.3, 1e-12);
    assert_near(pp_interior_section_m2(&box.world, 3.0), 0.0, 1e-12);
}

static void rooflights_are_refused(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.3, 4.9, 2.6, 0.4, 0.4, 0.8);
    box_room_open(&box, BOX_CEILING, pp_vec(1.0, 2.4, 2.6), 1.1, 0.7);
    assert_non_null(
        pp_method_dresler.refuses(&box.world, &box.light, box.openings, NULL));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(window_is_light_followed_from_part_to_part),
        cmocka_unit_test(diffusing_window_lights_both_parts_alike),
        cmocka_unit_test(black_parts_reflect_nothing),
        cmocka_unit_test(section_is_the_plan_of_the_room),
        cmocka_unit_test(rooflights_are_refused),
    };
    add_tests(tests, NULL, NULL);
}
