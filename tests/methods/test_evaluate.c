/* test_evaluate.c - sums over openings, corrections, selection of methods, averages,
 * rooms not covered. */
#include "methods/evaluate.h"

#include <stdio.h>
#include <stdlib.h>

#include "methods/method.h"
#include "methods/method_run.h"
#include "methods/selection.h"
#include "tests/lib/room_of.h"

/* Rounding of some sums and products. */
#define ROUNDING 1e-13

#define ROOM_BEGIN                                                                     \
    "<room version=\"1\">\n"                                                           \
    "<site ground-reflectance=\"0.1\"/>\n"                                             \
    "<plan width=\"3.7\" depth=\"6.1\" height=\"2.8\"/>\n"                             \
    "<finishes floor=\"0.2\" walls=\"0.6\" ceiling=\"0.75\"/>\n"
#define ROOM_POINTS                                                                    \
    "<line from=\"1.3 0.7\" to=\"1.9 5.2\" points=\"5\"/>\n"                           \
    "</room>\n"

/* A room with one south window that has these additional attributes. */
static struct pp_world *room_with_window(struct pp_outside_light *light,
                                         const char *attributes)
{
    char xml[1500];
    snprintf(xml, sizeof xml,
             ROOM_BEGIN
             "<window wall=\"south\" left=\"0.6\" sill=\"0.9\" width=\"2.1\" "
             "height=\"1.4\" %s/>\n" ROOM_POINTS,
             attributes);
    return pp_test_lit_world(light, xml);
}

static struct pp_report evaluate_by(int threads, const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const char *selection)
{
    struct pp_report report = {.world = world,
                               .light = *light,
                               .receivers = world->receivers,
                               .receiver_count = world->receiver_count,
                               .finished = true,
                               .threads = threads};
    struct pp_error err = {0};
    if (pp_methods_evaluate(&report, selection, &err) != PP_OK)
        fail_msg("%s", err.message);
    return report;
}

static struct pp_report evaluate(const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const char *selection)
{
    return evaluate_by(0, world, light, selection);
}

static const struct pp_column *column_of(const struct pp_report *report,
                                         enum pp_component component, const char *name)
{
    const struct pp_column *column = pp_report_find(report, component, name);
    if (!column)
        fail_msg("no column %s", name);
    return column;
}

static void columns_by_default_in_the_order_of_the_results(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = room_with_window(&light, "");
    struct pp_report report = evaluate(world, &light, NULL);
    static const struct {
        enum pp_component component;
        const char *name;
    } expected[] = {{PP_SC, "exact"},         {PP_SC, "brs-table"},
                    {PP_ERC, "exact"},        {PP_ERC, "brs-table"},
                    {PP_IRC, "bre"},          {PP_DF, "exact+bre"},
                    {PP_DF, "brs-table+bre"}, {PP_DF, "average-df"}};
    assert_int_equal(report.column_count, 8);
    for (int i = 0; i < 8; i++) {
        assert_int_equal(report.columns[i].component, expected[i].component);
        assert_string_equal(report.columns[i].name, expected[i].name);
    }
    /* average-df only gives a value for the whole room */
    for (int i = 0; i < 8; i++)
        assert_true((report.columns[i].points == NULL) == (i == 7));
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void pairs_are_the_sum_of_their_parts_at_points_and_on_average(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = room_with_window(&light, "frame-factor=\"0.8\"");
    struct pp_report report = evaluate(world, &light, "brs-table+split-flux,exact+bre");
    static const char *const pairs[2][3] = {
        {"brs-table", "split-flux", "brs-table+split-flux"},
        {"exact", "bre", "exact+bre"}};
    for (int p = 0; p < 2; p++) {
        const struct pp_column *sc = column_of(&report, PP_SC, pairs[p][0]);
        const struct pp_column *erc = column_of(&report, PP_ERC, pairs[p][0]);
        const struct pp_column *irc = column_of(&report, PP_IRC, pairs[p][1]);
        const struct pp_column *df = column_of(&report, PP_DF, pairs[p][2]);
        for (int i = 0; i < report.receiver_count; i++) {
            assert_near(df->points[i].value,
                        sc->points[i].value + erc->points[i].value
                            + irc->points[i].value,
                        1e-17);
            assert_near(irc->points[i].value, irc->average.value, 0.0);
        }
        assert_near(df->average.value,
                    sc->average.value + erc->average.value + irc->average.value, 1e-17);
    }
    pp_report_clear(&report);
    pp_world_destroy(world);
}

/* Asserts the ratio of each method's values, at the first point and on average, to
 * those with the plain window. */
static void assert_all_scale(const char *attributes, double direct, double internal,
                             double whole)
{
    struct pp_outside_light plain_light;
    struct pp_world *plain = room_with_window(&plain_light, "");
    struct pp_outside_light light;
    struct pp_world *world = room_with_window(&light, attributes);
    struct pp_report before = evaluate(plain, &plain_light, "all"),
                     after = evaluate(world, &light, "all");
    assert_int_equal(before.column_count, after.column_count);
    for (int i = 0; i < before.column_count; i++) {
        const struct pp_column *a = before.columns + i, *b = after.columns + i;
        const struct pp_method *method = pp_method_find(a->name);
        if (!method)
            continue; /* a pair */
        double factor = method->gives == PP_GIVES_DIRECT     ? direct
                        : method->gives == PP_GIVES_INTERNAL ? internal
                                                             : whole;
        /* bre-table is not linear: twice the glass area gives slightly more than twice
         * the light. A nomogram is read to a fifth of a division of at most 8 %. */
        double tolerance = method == pp_method_find("bre-table")  ? 0.1
                           : method == pp_method_find("nomogram") ? 0.02
                                                                  : ROUNDING;
        if (factor > 0.0 && a->points)
            assert_relative(b->points[0].value, factor * a->points[0].value, tolerance);
        assert_true(isnan(a->average.value) == (method->speaks_for == PP_FOR_MINIMUM));
        if (factor > 0.0 && method->speaks_for != PP_FOR_MINIMUM)
            assert_relative(b->average.value, factor * a->average.value, tolerance);
    }
    pp_report_clear(&before);
    pp_report_clear(&after);
    pp_world_destroy(plain);
    pp_world_destroy(world);
}

static void frame_and_dirt_count_once_in_every_method(void **state)
{
    (void)state;
    assert_all_scale("frame-factor=\"0.73\"", 0.73, 0.73, 0.73);
    assert_all_scale("maintenance=\"0.61\"", 0.61, 0.61, 0.61);
    assert_all_scale("maintenance=\"0.61\" frame-factor=\"0.73\"", 0.4453, 0.4453,
                     0.4453);
}

/* A single pane with a lower normal transmittance is darker by the same ratio at every
 * angle. */
static void glass_counts_once_in_every_method(void **state)
{
    (void)state;
    double ratio = 0.45 / pp_glass_clear_single().normal;
    assert_all_scale("transmittance=\"0.45\"", ratio, ratio, ratio);
}

static void without_glass_the_tables_glass_is_taken_out(void **state)
{
    (void)state;
    struct pp_outside_light glazed_light;
    struct pp_world *glazed = room_with_window(&glazed_light, "");
    struct pp_outside_light open_light;
    struct pp_world *open = room_with_window(&open_light, "glazing=\"none\"");
    struct pp_report a = evaluate(glazed, &glazed_light, "all"),
                     b = evaluate(open, &open_light, "all");
    static const struct {
        enum pp_component component;
        const char *name;
    } printed[] = {{PP_SC, "brs-table"}, {PP_IRC, "bre"}};
    for (int i = 0; i < 2; i++)
        assert_relative(
            column_of(&b, printed[i].component, printed[i].name)->points[1].value,
            column_of(&a, printed[i].component, printed[i].name)->points[1].value
                / 0.85,
            ROUNDING);
    /* formulae that contain the transmittance use that of the glass */
    assert_relative(column_of(&b, PP_IRC, "split-flux")->points[1].value,
                    column_of(&a, PP_IRC, "split-flux")->points[1].value
                        / pp_glass_clear_single().diffuse,
                    ROUNDING);
    assert_relative(column_of(&b, PP_DF, "average-df")->average.value,
                    column_of(&a, PP_DF, "average-df")->average.value
                        / pp_glass_clear_single().diffuse,
                    ROUNDING);
    /* `exact` uses the transmittance at each angle: a few metres away, at nearly normal
     * incidence, the loss is the normal one. */
    assert_relative(column_of(&b, PP_SC, "exact")->points[4].value,
                    column_of(&a, PP_SC, "exact")->points[4].value
                        / pp_glass_clear_single().normal,
                    0.02);
    pp_report_clear(&a);
    pp_report_clear(&b);
    pp_world_destroy(glazed);
    pp_world_destroy(open);
}

static void two_windows_give_what_each_gives_together(void **state)
{
    (void)state;
#define LEFT                                                                           \
    "<window wall=\"south\" left=\"0.2\" sill=\"0.9\" width=\"1.3\" height=\"1.4\"/>"
#define RIGHT                                                                          \
    "<window wall=\"south\" left=\"2.1\" sill=\"0.9\" width=\"1.1\" height=\"1.4\"/>"
    struct pp_outside_light light[3];
    struct pp_world *worlds[3] = {
        pp_test_lit_world(&light[0], ROOM_BEGIN LEFT ROOM_POINTS),
        pp_test_lit_world(&light[1], ROOM_BEGIN RIGHT ROOM_POINTS),
        pp_test_lit_world(&light[2], ROOM_BEGIN LEFT RIGHT ROOM_POINTS)};
    static const char *const names[2] = {"exact", "brs-table"};
    struct pp_report reports[3];
    for (int i = 0; i < 3; i++)
        reports[i] = evaluate(worlds[i], &light[i], NULL);
    for (int n = 0; n < 2; n++)
        for (int i = 0; i < 5; i++) {
            double sum = column_of(&reports[0], PP_SC, names[n])->points[i].value
                         + column_of(&reports[1], PP_SC, names[n])->points[i].value;
            assert_relative(column_of(&reports[2], PP_SC, names[n])->points[i].value,
                            sum, ROUNDING);
        }
    for (int i = 0; i < 3; i++) {
        pp_report_clear(&reports[i]);
        pp_world_destroy(worlds[i]);
    }
}

static void a_room_without_openings_is_dark(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, ROOM_BEGIN ROOM_POINTS);
    struct pp_report report = evaluate(world, &light, "all");
    for (int i = 0; i < report.column_count; i++) {
        const struct pp_column *column = report.columns + i;
        if (!column->average.why) /* a minimum has no average */
            assert_near(column->average.value, 0.0, 0.0);
        else
            assert_non_null(strstr(column->average.why, "not an average"));
        for (int k = 0; k < report.receiver_count && column->points; k++)
            assert_near(column->points[k].value, 0.0, 0.0);
    }
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void one_opening_that_is_not_covered_is_named_by_its_label(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, ROOM_BEGIN
        "<window wall=\"south\" left=\"0.6\" sill=\"0.9\" width=\"2.1\" "
        "height=\"1\"/>\n"
        "<rooflight x=\"1\" y=\"4\" width=\"1\" depth=\"0.8\"/>\n" ROOM_POINTS);
    struct pp_report report = evaluate(world, &light, NULL);
    const char *why = "brs-table: rooflight RL1 is not vertical, but the method covers "
                      "only vertical windows";
    assert_string_equal(column_of(&report, PP_SC, "brs-table")->points[2].why, why);
    assert_string_equal(column_of(&report, PP_ERC, "brs-table")->average.why, why);
    assert_string_equal(column_of(&report, PP_DF, "brs-table+bre")->points[0].why, why);
    assert_true(isnan(column_of(&report, PP_DF, "brs-table+bre")->points[0].value));
    assert_non_null(strstr(column_of(&report, PP_DF, "exact+bre")->points[0].why,
                           "bre: rooflight RL1"));
    assert_true(column_of(&report, PP_SC, "exact")->points[0].value > 0.0);
    assert_true(column_of(&report, PP_DF, "average-df")->average.value > 0.0);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void an_uncovered_sky_is_reported_without_an_opening(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version=\"1\"><sky type=\"uniform\"/>"
        "<plan width=\"3.7\" depth=\"6.1\" height=\"2.8\"/>"
        "<window wall=\"south\" left=\"0.6\" sill=\"0.9\" width=\"2.1\" height=\"1\"/>"
        "<point x=\"1.7\" y=\"2.1\"/></room>");
    struct pp_report report = evaluate(world, &light, "all");
    assert_string_equal(column_of(&report, PP_SC, "brs-table")->points[0].why,
                        "brs-table: valid only for the CIE overcast sky");
    assert_true(column_of(&report, PP_DF, "exact+split-flux")->points[0].value > 0.0);
    assert_true(column_of(&report, PP_DF, "exact+split-flux")->average.value > 0.0);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

/* No table covers an upright point, but the other point and the average remain. */
static void a_receiver_that_is_not_covered_leaves_the_others(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version=\"1\"><plan width=\"3.7\" depth=\"6.1\" height=\"2.8\"/>"
        "<window wall=\"south\" left=\"0.6\" sill=\"0.9\" width=\"2.1\" height=\"1\"/>"
        "<point x=\"1.7\" y=\"2.1\"/>"
        "<point x=\"1.7\" y=\"2.1\" z=\"1.2\" nx=\"0\" ny=\"-1\" nz=\"0\"/></room>");
    struct pp_report report = evaluate(world, &light, "default,exact+split-flux");
    const struct pp_column *pair = column_of(&report, PP_DF, "brs-table+bre");
    assert_true(pair->points[0].value > 0.0 && pair->average.value > 0.0);
    assert_string_equal(pair->points[1].why,
                        "brs-table: valid only for points that face up");
    assert_true(column_of(&report, PP_DF, "exact+split-flux")->points[1].value
                > column_of(&report, PP_DF, "exact+split-flux")->points[0].value);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

/* Mean of a column over a fine grid of points of the plan. */
static double fine_mean(struct pp_world *world, const struct pp_outside_light *light,
                        enum pp_component component, const char *name, int across,
                        int along, double width_m, double depth_m)
{
    int count = across * along;
    struct pp_receiver *receivers = calloc((size_t)count, sizeof *receivers);
    assert_non_null(receivers);
    for (int i = 0; i < count; i++)
        receivers[i] = (struct pp_receiver){
            .position = {(i % across + 0.5) / across * width_m,
                         (i / across + 0.5) / along * depth_m, world->working_plane_m},
            .normal = {0, 0, 1}};
    struct pp_report report = {.world = world,
                               .light = *light,
                               .receivers = receivers,
                               .receiver_count = count};
    assert_int_equal(pp_methods_evaluate(&report, name, NULL), PP_OK);
    const struct pp_column *column = column_of(&report, component, name);
    double sum = 0.0;
    for (int i = 0; i < count; i++)
        sum += column->points[i].value;
    pp_report_clear(&report);
    free(receivers);
    return sum / count;
}

/* The sum over 180 x 300 points has an error of 0.5e-3, estimated by halving its
 * steps. */
static void averages_agree_with_a_fine_sum_over_the_plane(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = room_with_window(&light, "glazing=\"none\"");
    struct pp_report report = evaluate(world, &light, "exact,brs-table");
    static const char *const names[2] = {"exact", "brs-table"};
    for (int n = 0; n < 2; n++) {
        double fine = fine_mean(world, &light, PP_SC, names[n], 180, 300, 3.7, 6.1);
        assert_relative(column_of(&report, PP_SC, names[n])->average.value, fine,
                        PP_AVERAGE_ERROR + 0.5e-3);
    }
    pp_report_clear(&report);
    pp_world_destroy(world);
}

/* Averages use fixed quadrature rules instead of adaptive ones. */
static void a_rough_value_is_near_the_exact_one(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = room_with_window(&light, "");
    const struct pp_method *exact = pp_method_find("exact");
    for (double y = 0.3; y < 6.0; y += 0.4)
        for (double x = 0.1; x < 3.7; x += 0.6) {
            struct pp_receiver receiver = {{x, y, 0.85}, {0, 0, 1}, 0, 0.0};
            struct pp_part precise = {0}, rough = {0};
            assert_int_equal(exact->evaluate(world, &light, world->openings, &receiver,
                                             NULL, &precise, NULL),
                             PP_OK);
            assert_int_equal(exact->evaluate_roughly(world, &light, world->openings,
                                                     &receiver, NULL, &rough, NULL),
                             PP_OK);
            /* largest error for random windows at distances from 0.1 m: quadrature.h */
            assert_relative(rough.sky, precise.sky, 2e-5);
        }
    pp_world_destroy(world);
}

static void the_numbers_do_not_depend_on_the_number_of_threads(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version=\"1\"><plan height=\"2.9\"><vertex x=\"0\" y=\"0\"/>"
        "<vertex x=\"4\" y=\"0\"/><vertex x=\"4\" y=\"3\"/><vertex x=\"6.3\" y=\"3\"/>"
        "<vertex x=\"6.3\" y=\"6\"/><vertex x=\"0\" y=\"6\"/></plan>"
        "<window wall=\"1\" left=\"0.7\" sill=\"1\" width=\"2.6\" height=\"1.4\"/>"
        "<block x=\"-3\" y=\"-14\" width=\"9\" depth=\"4\" height=\"7\"/></room>");
    assert_true(world->receiver_count
                > 64); /* fewer points are not divided between threads */
    struct pp_report reports[2];
    for (int i = 0; i < 2; i++)
        reports[i] = evaluate_by(1 + 3 * i, world, &light, "default");
    for (int c = 0; c < reports[0].column_count; c++) {
        const struct pp_column *a = reports[0].columns + c, *b = reports[1].columns + c;
        assert_memory_equal(&a->average.value, &b->average.value, sizeof(double));
        for (int i = 0; i < world->receiver_count && a->points; i++)
            assert_memory_equal(&a->points[i].value, &b->points[i].value,
                                sizeof(double));
    }
    pp_report_clear(&reports[0]);
    pp_report_clear(&reports[1]);
    pp_world_destroy(world);
}

static void unknown_names_are_answered_with_the_known_ones(void **state)
{
    (void)state;
    struct pp_error err;
    assert_int_equal(pp_selection_check("exact+bre,exat", &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "\"exat\""));
    assert_non_null(strstr(err.message, "did you mean \"exact\"?"));
    assert_non_null(strstr(err.message, "brs-table"));
    assert_int_equal(pp_selection_check("exact+split-fluxx", &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "\"split-flux\"?"));
    assert_int_equal(pp_selection_check("", &err), PP_BAD_INPUT);
    assert_int_equal(pp_selection_check("exact,,bre", &err), PP_BAD_INPUT);
    assert_int_equal(pp_selection_check("bre+exact", &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "direct"));
    assert_int_equal(pp_selection_check("exact+average-df", &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "internally reflected"));
    assert_int_equal(pp_selection_check("exact+bre+bre", &err), PP_BAD_INPUT);
    assert_int_equal(pp_selection_check("default, all", &err), PP_OK);
    assert_int_equal(pp_selection_check(NULL, &err), PP_OK);
}

static void all_is_every_direct_with_bre_and_exact_with_every_internal(void **state)
{
    (void)state;
    struct pp_selection selection;
    assert_int_equal(pp_selection_parse(&selection, "all", NULL), PP_OK);
    int expected = -1; /* exact+bre is in both rows */
    for (int i = 0; pp_methods[i]; i++)
        expected += !pp_methods[i]->by_name;
    assert_int_equal(selection.count, expected);
    for (int i = 0; i < selection.count; i++) {
        struct pp_choice choice = selection.choices[i];
        if (choice.method->gives == PP_GIVES_WHOLE)
            assert_null(choice.internal);
        else
            assert_true(strcmp(choice.method->name, "exact") == 0
                        || strcmp(choice.internal->name, "bre") == 0);
    }
    pp_selection_clear(&selection);
}

/* Value of the last step with this symbol. */
static double value_called(const struct pp_steps *steps, const char *symbol)
{
    const struct pp_calculation_step *step = pp_steps_find(steps, 0, symbol);
    if (!step)
        fail_msg("no step is called %s", symbol);
    return step->value;
}

/* Two windows, of which the second has half its area as frame: the printed steps add
 * up. */
static void explained_figures_are_the_sum_of_their_steps(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        ROOM_BEGIN "<window wall=\"south\" left=\"0.3\" sill=\"0.9\" width=\"1.1\" "
                   "height=\"1.4\"/>\n"
                   "<window wall=\"south\" left=\"1.9\" sill=\"0.9\" width=\"1.3\" "
                   "height=\"1.2\" frame-factor=\"0.5\"/>\n"
                   "<skyline wall=\"south\" angle=\"20\"/>\n" ROOM_POINTS);
    struct pp_report report = {.world = world,
                               .light = light,
                               .receivers = world->receivers,
                               .receiver_count = world->receiver_count,
                               .explain = true};
    struct pp_error err = {0};
    if (pp_methods_evaluate(&report, "waldram+bre,average-df", &err) != PP_OK)
        fail_msg("%s", err.message);
    for (int i = 0; i < report.receiver_count; i++) {
        const struct pp_reading *sc = &column_of(&report, PP_SC, "waldram")->points[i];
        const struct pp_steps *steps = sc->steps;
        double first = value_called(steps, "SC_1"),
               second = value_called(steps, "SC_2");
        double read = value_called(steps, "sc"), frame = value_called(steps, "B");
        assert_near(frame, 0.5, 0.0);
        assert_near(second, frame * read, ROUNDING);
        assert_near(value_called(steps, "SC"), sc->value, ROUNDING);
        assert_near(first + second, sc->value, ROUNDING);
        assert_null(column_of(&report, PP_ERC, "waldram")->points[i].steps);

        const struct pp_reading *df =
            &column_of(&report, PP_DF, "waldram+bre")->points[i];
        double sum = value_called(df->steps, "SC") + value_called(df->steps, "ERC")
                     + value_called(df->steps, "IRC");
        assert_near(sum, df->value, ROUNDING);
    }
    const struct pp_column *room = column_of(&report, PP_DF, "average-df");
    assert_near(value_called(room->average.steps, "DF"), room->average.value, 0.0);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void figures_have_no_steps_unless_requested(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = room_with_window(&light, "");
    struct pp_report report = evaluate(world, &light, "all");
    for (int c = 0; c < report.column_count; c++) {
        assert_null(report.columns[c].average.steps);
        for (int i = 0; report.columns[c].points && i < report.receiver_count; i++)
            assert_null(report.columns[c].points[i].steps);
    }
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void every_method_is_found_by_its_name(void **state)
{
    (void)state;
    int count = 0;
    for (; pp_methods[count]; count++) {
        assert_ptr_equal(pp_method_find(pp_methods[count]->name), pp_methods[count]);
        assert_ptr_equal(pp_method_at(count), pp_methods[count]);
        assert_true(strlen(pp_methods[count]->summary) > 20);
        assert_true(strlen(pp_methods[count]->source) > 3);
    }
    assert_null(pp_method_at(count));
    assert_null(pp_method_find("traced"));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_by_default_in_the_order_of_the_results),
        cmocka_unit_test(pairs_are_the_sum_of_their_parts_at_points_and_on_average),
        cmocka_unit_test(frame_and_dirt_count_once_in_every_method),
        cmocka_unit_test(glass_counts_once_in_every_method),
        cmocka_unit_test(without_glass_the_tables_glass_is_taken_out),
        cmocka_unit_test(two_windows_give_what_each_gives_together),
        cmocka_unit_test(a_room_without_openings_is_dark),
        cmocka_unit_test(one_opening_that_is_not_covered_is_named_by_its_label),
        cmocka_unit_test(an_uncovered_sky_is_reported_without_an_opening),
        cmocka_unit_test(a_receiver_that_is_not_covered_leaves_the_others),
        cmocka_unit_test(averages_agree_with_a_fine_sum_over_the_plane),
        cmocka_unit_test(a_rough_value_is_near_the_exact_one),
        cmocka_unit_test(the_numbers_do_not_depend_on_the_number_of_threads),
        cmocka_unit_test(unknown_names_are_answered_with_the_known_ones),
        cmocka_unit_test(all_is_every_direct_with_bre_and_exact_with_every_internal),
        cmocka_unit_test(explained_figures_are_the_sum_of_their_steps),
        cmocka_unit_test(figures_have_no_steps_unless_requested),
        cmocka_unit_test(every_method_is_found_by_its_name),
    };
    add_tests(tests, NULL, NULL);
}
