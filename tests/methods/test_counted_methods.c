/* test_counted_methods.c - `waldram` and `pepper-pot` in rooms: squares and dots
 * compared with the exact direct component. */
#include "methods/method.h"
#include "methods/waldram/waldram_squares.h"
#include "methods/view/window_drawing.h"
#include "methods/allowance.h"

#include "tests/lib/near.h"
#include "tests/lib/room_of.h"

/* Pseudo-random number in [0, 1), the same on all machines. */
static double next(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-53;
}

static struct pp_receiver facing_up(double x, double y, double z)
{
    return (struct pp_receiver){{x, y, z}, {0.0, 0.0, 1.0}, 0, 0.0};
}

/* Direct component of a whole room by one method, with corrections. */
static struct pp_part direct(const struct pp_method *method,
                             const struct pp_world *world,
                             const struct pp_outside_light *light,
                             const struct pp_receiver *receiver)
{
    struct pp_part sum = {0};
    void *tools = NULL;
    assert_null(method->refuses_room ? method->refuses_room(world, light, receiver)
                                     : NULL);
    if (method->prepare)
        assert_int_equal(method->prepare(&tools, world, light, NULL), PP_OK);
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        struct pp_part part = {0};
        assert_null(method->refuses ? method->refuses(world, light, opening, receiver)
                                    : NULL);
        assert_int_equal(
            method->evaluate(world, light, opening, receiver, tools, &part, NULL),
            PP_OK);
        double factor = pp_allowance_factor(method->allowances, opening);
        sum.sky += factor * part.sky;
        sum.external += factor * part.external;
    }
    if (method->destroy_tools)
        method->destroy_tools(tools);
    return sum;
}

/* Exact areas of sky and obstructions of a room's openings on the diagram. */
static struct pp_part areas(const struct pp_world *world,
                            const struct pp_outside_light *light,
                            const struct pp_receiver *receiver, bool glazed)
{
    struct pp_part sum = {0};
    struct pp_waldram waldram;
    assert_int_equal(pp_waldram_scale_init(&waldram, &light->sky, glazed, NULL), PP_OK);
    for (int i = 0; i < world->opening_count; i++) {
        struct pp_window_drawing drawing;
        assert_int_equal(pp_window_drawing_init(&drawing, world, light,
                                                &world->openings[i], receiver->position,
                                                NULL),
                         PP_OK);
        for (int k = 0; k < drawing.count; k++) {
            const struct pp_drawn_part *part = &drawing.parts[k];
            double area = pp_waldram_scale_area(&waldram, &drawing.axes, &part->region);
            *(part->hidden ? &sum.external : &sum.sky) += part->factor * area;
        }
        pp_window_drawing_clear(&drawing);
    }
    return sum;
}

static struct pp_world *random_room(struct pp_outside_light *light, uint64_t *seed,
                                    const char *sky, const char *glazing,
                                    bool obstructed)
{
    char xml[2000], outside[400] = "";
    double r
        [9]; /* drawn one by one, since the evaluation order of arguments is not defined */
    for (int i = 0; i < 9; i++)
        r[i] = next(seed);
    if (obstructed)
        snprintf(outside, sizeof outside,
                 "<skyline wall=\"south\" angle=\"%.2f\"/>"
                 "<block x=\"%.2f\" y=\"%.2f\" width=\"3.1\" depth=\"2.3\" "
                 "height=\"%.2f\" rotate=\"%.1f\" reflectance=\"0.35\"/>",
                 3.0 + 20.0 * r[0], 8.0 * r[1] - 4.0, -5.0 - 6.0 * r[2],
                 2.0 + 5.0 * r[3], 90.0 * r[4]);
    snprintf(xml, sizeof xml,
             "<room version=\"1\"><sky type=\"%s\"/>"
             "<plan width=\"5.3\" depth=\"7.1\" height=\"3.4\"/>"
             "<window wall=\"south\" left=\"%.3f\" sill=\"%.3f\" width=\"%.3f\" "
             "height=\"%.3f\" glazing=\"%s\"/>%s"
             "<working-plane height=\"0.85\"/></room>",
             sky, 0.1 + 2.0 * r[5], 1.6 * r[6], 0.2 + 2.9 * r[7], 0.2 + 1.5 * r[8],
             glazing, outside);
    return pp_test_lit_world(light, xml);
}

/* A point on the working plane between two depths. */
static struct pp_receiver random_point(uint64_t *seed, double nearest, double farthest)
{
    double x = 0.2 + 4.9 * next(seed);
    return facing_up(x, nearest + (farthest - nearest) * next(seed), 0.85);
}

/* 2,000 random windows with and without obstructions, without glass: the areas on the
 * diagram equal the sky components and equivalent sky components of `exact`. Scales
 * from tables are accurate to 1e-10 of Eh, which limits the accuracy of small
 * differences. */
static void areas_without_glass_are_exact(void **state)
{
    (void)state;
    static const char *const skies[] = {"overcast", "uniform", "iso-3"};
    uint64_t seed = 17;
    for (int i = 0; i < 2000; i++) {
        const char *sky = skies[i % 20 == 19 ? 2 : i % 2];
        struct pp_outside_light light;
        struct pp_world *world = random_room(&light, &seed, sky, "none", i % 4 == 0);
        struct pp_receiver receiver = random_point(&seed, 0.3, 6.8);
        struct pp_part exact = direct(&pp_method_exact, world, &light, &receiver);
        struct pp_part drawn = areas(world, &light, &receiver, false);
        assert_near(drawn.sky, exact.sky, 1e-6 * exact.sky + 1e-10);
        assert_near(drawn.external, exact.external, 1e-6 * exact.external + 1e-10);
        pp_world_destroy(world);
    }
}

/* With glass the diagram is never too low, at most 12 % too high, and at most 2 % too
 * high on average. */
static void areas_with_glass_are_never_short(void **state)
{
    (void)state;
    uint64_t seed = 23;
    double sum = 0.0;
    enum { WINDOWS = 200 };
    for (int i = 0; i < WINDOWS; i++) {
        struct pp_outside_light light;
        struct pp_world *world =
            random_room(&light, &seed, "overcast", "clear-single", false);
        struct pp_receiver receiver = random_point(&seed, 1.0, 6.5);
        double exact = direct(&pp_method_exact, world, &light, &receiver).sky;
        double drawn = areas(world, &light, &receiver, true).sky;
        if (exact > 1e-4) {
            assert_true(drawn >= exact * (1.0 - 1e-5));
            assert_true(drawn <= exact * 1.12);
            sum += drawn / exact - 1.0;
        }
        pp_world_destroy(world);
    }
    assert_near(sum / WINDOWS, 0.01, 0.01);
}

/* The squares in one column have an error of at most a twentieth of a square, because
 * the remainder is carried over; a dot has an error if the outline cuts its cell. These
 * limits hold for every room, not only on average. */
static void counts_come_near_exact_in_rooms(void **state)
{
    (void)state;
    uint64_t seed = 29;
    for (int i = 0; i < 100; i++) {
        bool bare = i % 2;
        struct pp_outside_light light;
        struct pp_world *world =
            random_room(&light, &seed, i % 3 ? "overcast" : "uniform",
                        bare ? "none" : "clear-single", i % 5 == 0);
        struct pp_receiver receiver = random_point(&seed, 0.6, 6.6);
        struct pp_part drawn = areas(world, &light, &receiver, !bare);
        struct pp_part squares = direct(&pp_method_waldram, world, &light, &receiver);
        struct pp_part dots = direct(&pp_method_pepper_pot, world, &light, &receiver);
        struct pp_part exact = direct(&pp_method_exact, world, &light, &receiver);
        assert_near(squares.sky, drawn.sky, 0.05 * PP_WALDRAM_WORTH * 36);
        assert_near(dots.sky, exact.sky, 0.008);
        pp_world_destroy(world);
    }
}

/* A pepper-pot diagram has the correct glass losses at every angle: the counts at many
 * points have the mean of `exact`. */
static void dots_are_unbiased_with_glass(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version=\"1\"><plan width=\"5.3\" depth=\"7.1\" height=\"3.4\"/>"
                "<window wall=\"south\" left=\"0.7\" sill=\"0.6\" width=\"3.7\" "
                "height=\"2.3\"/>"
                "<working-plane height=\"0.85\"/></room>");
    double dots = 0.0, exact = 0.0;
    for (int i = 0; i < 17; i++)
        for (int k = 0; k < 11; k++) {
            struct pp_receiver receiver =
                facing_up(0.2 + 0.29 * i, 0.7 + 0.53 * k, 0.85);
            dots += direct(&pp_method_pepper_pot, world, &light, &receiver).sky;
            exact += direct(&pp_method_exact, world, &light, &receiver).sky;
        }
    assert_relative(dots, exact, 0.01);
    pp_world_destroy(world);
}

static void an_upright_point_is_counted_on_a_diagram_of_its_own(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version=\"1\"><plan width=\"5.3\" depth=\"4.1\" height=\"3.4\"/>"
                "<window wall=\"south\" left=\"0.7\" sill=\"0.6\" width=\"3.7\" "
                "height=\"2.3\"/>"
                "<working-plane height=\"0.85\"/></room>");
    double turns[] = {-0.9, -0.2, 0.0, 0.7};
    for (int i = 0; i < 4; i++) {
        struct pp_receiver receiver = {
            {2.3, 3.1, 1.2}, {sin(turns[i]), -cos(turns[i]), 0.0}, 0, 0.0};
        double dots = direct(&pp_method_pepper_pot, world, &light, &receiver).sky;
        assert_near(dots, direct(&pp_method_exact, world, &light, &receiver).sky,
                    0.004);
    }
    struct pp_receiver away = {{2.3, 3.1, 1.2}, {0.0, 1.0, 0.0}, 0, 0.0};
    assert_near(direct(&pp_method_pepper_pot, world, &light, &away).sky, 0.0, 0.0);
    pp_world_destroy(world);
}

static void glass_is_counted_once(void **state)
{
    (void)state;
    static const char room[] =
        "<room version=\"1\"><plan width=\"5.3\" depth=\"4.1\" height=\"3.4\"/>"
        "<window wall=\"south\" left=\"0.7\" sill=\"0.6\" width=\"3.7\" height=\"2.3\" "
        "%s/><working-plane height=\"0.85\"/></room>";
    char xml[600];
    const struct pp_method *methods[] = {&pp_method_waldram, &pp_method_pepper_pot};
    struct pp_receiver receiver = facing_up(2.3, 2.1, 0.85);
    for (int m = 0; m < 2; m++) {
        snprintf(xml, sizeof xml, room, "");
        struct pp_outside_light clear_light;
        struct pp_world *clear = pp_test_lit_world(&clear_light, xml);
        snprintf(xml, sizeof xml, room, "transmittance=\"0.45\" frame-factor=\"0.8\"");
        struct pp_outside_light tinted_light;
        struct pp_world *tinted = pp_test_lit_world(&tinted_light, xml);
        snprintf(xml, sizeof xml, room, "glazing=\"none\"");
        struct pp_outside_light bare_light;
        struct pp_world *bare = pp_test_lit_world(&bare_light, xml);
        double of_clear = direct(methods[m], clear, &clear_light, &receiver).sky;
        assert_relative(direct(methods[m], tinted, &tinted_light, &receiver).sky
                            / of_clear,
                        0.45 / pp_glass_clear_single().normal * 0.8, 1e-9);
        double of_bare = direct(methods[m], bare, &bare_light, &receiver).sky;
        assert_near(of_bare, direct(&pp_method_exact, bare, &bare_light, &receiver).sky,
                    0.003);
        assert_true(of_bare > 1.05 * of_clear && of_bare < 1.3 * of_clear);
        pp_world_destroy(clear);
        pp_world_destroy(tinted);
        pp_world_destroy(bare);
    }
}

static void what_the_diagrams_do_not_hold_is_refused(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version=\"1\"><sky type=\"iso-12\" sun-altitude=\"30\" "
        "sun-bearing=\"170\"/><plan width=\"5.3\" depth=\"4.1\" height=\"3.4\"/>"
        "<rooflight x=\"1\" y=\"1\" width=\"1.3\" depth=\"1.7\"/>"
        "<rooflight x=\"3\" y=\"1\" width=\"1.3\" depth=\"1.7\" "
        "glazing=\"none\"/></room>");
    struct pp_receiver up = facing_up(2.3, 2.1, 0.85);
    struct pp_receiver tilted = {{2.3, 2.1, 0.85}, {0.6, 0.0, 0.8}, 0, 0.0};
    assert_non_null(
        strstr(pp_method_waldram.refuses_room(world, &light, &up), "azimuth"));
    assert_non_null(
        strstr(pp_method_pepper_pot.refuses_room(world, &light, &up), "overcast"));
    assert_non_null(strstr(
        pp_method_waldram.refuses(world, &light, &world->openings[0], &up), "sloping"));
    assert_null(pp_method_waldram.refuses(world, &light, &world->openings[1], &up));
    assert_non_null(
        pp_method_pepper_pot.refuses(world, &light, &world->openings[1], &up));
    pp_world_destroy(world);
    world = pp_test_lit_world(&light,
                              "<room version=\"1\"><plan width=\"5.3\" depth=\"4.1\" "
                              "height=\"3.4\"/></room>");
    assert_non_null(
        strstr(pp_method_waldram.refuses_room(world, &light, &tilted), "face up"));
    assert_non_null(strstr(pp_method_pepper_pot.refuses_room(world, &light, &tilted),
                           "or horizontally"));
    pp_world_destroy(world);
}

/* Behind the window and in its plane nothing is visible through it. */
static void a_window_seen_from_its_own_plane_gives_nothing(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version=\"1\"><plan width=\"5.3\" depth=\"4.1\" height=\"3.4\"/>"
                "<window wall=\"south\" left=\"0.7\" sill=\"0.6\" width=\"3.7\" "
                "height=\"2.3\"/>"
                "<working-plane height=\"0.85\"/></room>");
    for (int behind = 0; behind < 2; behind++) {
        struct pp_receiver receiver = facing_up(2.3, behind ? -0.7 : 0.0, 0.3);
        assert_near(direct(&pp_method_waldram, world, &light, &receiver).sky, 0.0, 0.0);
        assert_near(direct(&pp_method_pepper_pot, world, &light, &receiver).sky, 0.0,
                    0.0);
    }
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(areas_without_glass_are_exact),
        cmocka_unit_test(areas_with_glass_are_never_short),
        cmocka_unit_test(counts_come_near_exact_in_rooms),
        cmocka_unit_test(dots_are_unbiased_with_glass),
        cmocka_unit_test(an_upright_point_is_counted_on_a_diagram_of_its_own),
        cmocka_unit_test(glass_is_counted_once),
        cmocka_unit_test(what_the_diagrams_do_not_hold_is_refused),
        cmocka_unit_test(a_window_seen_from_its_own_plane_gives_nothing),
    };
    add_tests(tests, NULL, NULL);
}
