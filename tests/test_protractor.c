/* test_protractor.c - `protractor`: readings step by step, and how far they are from
 * the exact direct component. */
#include "methods/methods.h"
#include "methods/protractor.h"
#include "model/allowance.h"

#include "tests/near.h"
#include "tests/room_of.h"

static double next(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-53;
}

static struct pp_receiver facing_up(double x, double y, double z)
{
    return (struct pp_receiver){{x, y, z}, {0.0, 0.0, 1.0}, 0};
}

/* What the method gives of the world's first opening, its figures as read. */
static struct pp_part read_first(const struct pp_method *method,
                                 const struct pp_world *world, double x, double y,
                                 double z, struct pp_steps *steps)
{
    struct pp_receiver receiver = facing_up(x, y, z);
    struct pp_part part = {.steps = steps};
    void *tools = NULL;
    const struct pp_opening *opening = &world->openings[0];
    assert_null(method->refuses_room ? method->refuses_room(world, &receiver) : NULL);
    assert_null(method->refuses ? method->refuses(world, opening, &receiver) : NULL);
    if (method->prepare)
        assert_int_equal(method->prepare(&tools, world, NULL), PP_OK);
    assert_int_equal(method->evaluate(world, opening, &receiver, tools, &part, NULL),
                     PP_OK);
    if (method->put_away)
        method->put_away(tools);
    return part;
}

static double step_of(const struct pp_steps *steps, const char *words, int which)
{
    for (int i = 0; i < steps->count; i++)
        if (strstr(steps->list[i].what, words) && which-- == 0)
            return steps->list[i].value;
    fail_msg("no step \"%s\"", words);
    return NAN;
}

/* A window in the south wall of a hall, its head and sill over the point, and x of its
 * jambs from the point, 3 m away; the point stands at (50, 3, 0.85). */
static struct pp_world *hall(const char *sky, const char *glazing, double left,
                             double right, double sill, double head, const char *more)
{
    char xml[900];
    snprintf(xml, sizeof xml,
             "<room version=\"1\"><sky type=\"%s\"/>"
             "<plan width=\"100\" depth=\"20\" height=\"60\"/>"
             "<window wall=\"south\" left=\"%.9g\" sill=\"%.9g\" width=\"%.9g\" "
             "height=\"%.9g\" glazing=\"%s\"/>%s</room>",
             sky, 50.0 + left, 0.85 + sill, right - left, head - sill, glazing, more);
    return pp_test_world(xml);
}

/* Protractors 1, 2, 9, 10 through the method: per cent at 10 to 80 degrees, the printed
 * figures; and the primary scale itself to 1e-6. */
static void an_endless_window_has_the_reading_of_the_primary_scale(void **state)
{
    (void)state;
    static const struct {
        const char *sky, *glazing;
        int number;
        double printed[8];
    } scale[] = {
        {"overcast",
         "clear-single",
         2,
         {.344, 1.585, 3.978, 7.662, 12.600, 18.495, 24.634, 29.656}},
        {"uniform",
         "clear-single",
         1,
         {.670, 2.655, 5.878, 10.196, 15.383, 21.070, 26.628, 30.982}},
        {"overcast",
         "none",
         10,
         {.390, 1.796, 4.519, 8.755, 14.571, 21.886, 30.476, 39.994}},
        {"uniform",
         "none",
         9,
         {.760, 3.015, 6.699, 11.698, 17.861, 25.000, 32.899, 41.318}},
    };
    for (int s = 0; s < 4; s++)
        for (int i = 0; i < 8; i++) {
            char xml[600];
            double gamma = (i + 1) * 10.0 * PP_RAD;
            snprintf(
                xml, sizeof xml,
                "<room version=\"1\"><sky type=\"%s\"/>"
                "<plan width=\"90000\" depth=\"20\" height=\"60\"/>"
                "<window wall=\"south\" left=\"1\" sill=\"0.85\" width=\"89998\" "
                "height=\"%.12g\" glazing=\"%s\"/><point x=\"45000\" y=\"3\"/></room>",
                scale[s].sky, 3.0 * tan(gamma), scale[s].glazing);
            struct pp_world *world = pp_test_world(xml);
            double sky =
                read_first(&pp_method_protractor, world, 45000.0, 3.0, 0.85, NULL).sky;
            struct pp_protractor protractor;
            pp_protractor_published(&protractor, scale[s].number, NULL);
            assert_near(sky, pp_protractor_primary(&protractor, gamma), 1e-6);
            assert_near(100.0 * sky, scale[s].printed[i], 6e-4);
            pp_world_destroy(world);
        }
}

/* Sky components of rectangles with a jamb on the normal and the sill at the point's
 * height have closed forms; a reading is as near as one average altitude allows. */
static void rectangles_with_a_closed_form(void **state)
{
    (void)state;
    static const struct {
        double h, w, uniform, overcast, tolerance;
    } rectangle[] = {{0.5, 0.5, 1.3928, 0.9430, 0.5},
                     {1.0, 1.0, 5.5734, 4.5251, 0.5},
                     {1.0, 2.0, 6.8697, 5.4586, 0.5},
                     {2.0, 1.0, 9.5068, 8.8164, .5},
                     {0.5, 2.0, 2.5164, 1.6457, .5}};
    for (int i = 0; i < 5; i++)
        for (int uniform = 0; uniform < 2; uniform++) {
            double h = 3.0 * rectangle[i].h, w = 3.0 * rectangle[i].w;
            struct pp_world *world =
                hall(uniform ? "uniform" : "overcast", "none", 0.0, w, 0.0, h, "");
            double expected = uniform ? rectangle[i].uniform : rectangle[i].overcast;
            double read =
                100.0
                * read_first(&pp_method_protractor, world, 50.0, 3.0, 0.85, NULL).sky;
            print_message("# %g %g %d: %.4f %.4f\n", rectangle[i].h, rectangle[i].w,
                          uniform, read, expected);
            assert_relative(read, expected, rectangle[i].tolerance);
            pp_world_destroy(world);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_endless_window_has_the_reading_of_the_primary_scale),
        cmocka_unit_test(rectangles_with_a_closed_form),
    };
    return cmocka_run_group_tests_name("protractor", tests, NULL, NULL);
}
