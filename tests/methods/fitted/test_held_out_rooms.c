/* test_held_out_rooms.c - the fitted formulae in traced rooms that were not used for
 * the fit: the errors stated in docs/theory.md. */
#include <math.h>

#include "methods/method.h"
#include "tests/lib/traced_rooms.h"

/* Sums of the squares of ln(figure/traced), of figure/traced - 1 and of figure -
 * traced, for the darkest quarter of the points, for the other points and for
 * averages. */
enum { DARK, ELSEWHERE, AVERAGE, PLACES };
struct errors {
    double sum[PLACES], relative[PLACES], absolute[PLACES];
    int count[PLACES];
};

enum { IRC_ATLAS, BRE_ATLAS, FLUX_ATLAS, DF_ATLAS, BRE, FLUX, DF, METHODS };
static const struct pp_method *const methods[METHODS] = {
    &pp_method_irc_atlas,        &pp_method_bre_atlas, &pp_method_split_flux_atlas,
    &pp_method_average_df_atlas, &pp_method_bre,       &pp_method_split_flux,
    &pp_method_average_df};

static bool covers(const struct pp_method *method, const struct pp_traced_room *room)
{
    for (int i = 0; i < room->world->opening_count && method->refuses; i++)
        if (method->refuses(room->world, &room->light, room->world->openings + i, NULL))
            return false;
    return true;
}

static double figure_of(const struct pp_method *method,
                        const struct pp_traced_room *room, int index, const void *tools)
{
    double sum = 0.0;
    for (int i = 0; i < room->world->opening_count; i++) {
        struct pp_part part = {0};
        const struct pp_opening *opening = room->world->openings + i;
        assert_int_equal(
            method->evaluate(room->world, &room->light, opening,
                             index < 0 ? NULL : room->world->receivers + index, tools,
                             &part, NULL),
            PP_OK);
        sum += part.value * pp_allowance_factor(method->allowances, opening);
    }
    return sum;
}

static void add(struct errors *errors, const struct pp_method *method,
                const struct pp_traced_room *room)
{
    void *tools = NULL;
    bool whole = method->gives == PP_GIVES_WHOLE;
    if (method->prepare)
        assert_int_equal(method->prepare(&tools, room->world, &room->light, NULL),
                         PP_OK);
    for (int i = 0; i < room->count; i++) {
        const struct pp_traced_point *point = room->points + i;
        int place = point->index < 0 ? AVERAGE : point->dark ? DARK : ELSEWHERE;
        double figure = figure_of(method, room, point->index, tools);
        if (!(point->irc > 2e-5 && point->std_error < 0.3 * point->irc)
            || (whole && place != AVERAGE) || !(figure > 0.0))
            continue;
        double truth = whole ? point->df : point->irc;
        double off = log(figure / truth);
        errors->sum[place] += off * off;
        errors->relative[place] += (figure / truth - 1.0) * (figure / truth - 1.0);
        errors->absolute[place] += (figure - truth) * (figure - truth);
        errors->count[place]++;
    }
    if (method->destroy_tools)
        method->destroy_tools(tools);
}

static int read_errors(void **state)
{
    static struct errors errors[METHODS];
    char path[1000];
    struct pp_traced_room room;
    snprintf(path, sizeof path, "%s/tests/methods/fitted/held_out_rooms.txt",
             getenv("srcdir"));
    FILE *in = fopen(path, "r");
    if (!in)
        return 1;
    while (pp_traced_rooms_next(in, &room)) {
        if (covers(&pp_method_bre_atlas, &room))
            for (int i = 0; i < METHODS; i++)
                add(errors + i, methods[i], &room);
        pp_world_destroy(room.world);
    }
    fclose(in);
    *state = errors;
    return 0;
}

static double rms(void **state, int method, int place)
{
    const struct errors *errors = (const struct errors *)*state + method;
    assert_true(errors->count[place] > 50);
    return sqrt(errors->sum[place] / errors->count[place]);
}

/* Ratios of RMS errors over all rooms that were held out: 0.37 and 0.28; in the sample
 * 0.38 and 0.30. */
static void by_position_the_dark_quarter_has_half_the_error_of_averages(void **state)
{
    double error = rms(state, IRC_ATLAS, DARK);
    assert_true(error < 0.5 * rms(state, BRE, DARK));
    assert_true(error < 0.5 * rms(state, FLUX, DARK));
    assert_true(rms(state, BRE_ATLAS, DARK) < 0.5 * rms(state, BRE, DARK));
    assert_true(rms(state, FLUX_ATLAS, DARK) < 0.5 * rms(state, FLUX, DARK));
}

/* Over all rooms that were held out, the RMS errors are 0.18 and 0.09 of those of the
 * averages by ratio, and 0.49 and 0.23 by daylight factor. Those of the corrected
 * averages are 0.48, 0.55, 0.45, and 0.24, 0.39, 0.30 by daylight factor. The last
 * value depends mainly on a few bright rooms: it varies by 0.09 between samples of this
 * size, so the limit is two of these above 0.47. */
static void position_formulae_beat_averages_by_ratio_and_by_daylight_factor(
    void **state)
{
    const struct errors *all = *state;
    for (int other = BRE; other <= FLUX; other++) {
        assert_true(all[IRC_ATLAS].relative[DARK] < 0.25 * all[other].relative[DARK]);
        assert_true(all[IRC_ATLAS].absolute[DARK]
                    < 0.65 * 0.65 * all[other].absolute[DARK]);
        assert_true(all[IRC_ATLAS].absolute[ELSEWHERE]
                    < all[other].absolute[ELSEWHERE]);
    }
    for (int place = 0; place < PLACES; place++) {
        assert_true(all[BRE_ATLAS].absolute[place]
                    < 0.68 * 0.68 * all[BRE].absolute[place]);
        assert_true(all[FLUX_ATLAS].absolute[place]
                    < 0.55 * 0.55 * all[FLUX].absolute[place]);
    }
}

static void and_no_more_elsewhere(void **state)
{
    double error = rms(state, IRC_ATLAS, ELSEWHERE);
    assert_true(error < rms(state, BRE, ELSEWHERE));
    assert_true(error < rms(state, FLUX, ELSEWHERE));
}

/* 0.46, 0.43 and 0.23 over all rooms that were held out; the sample has 80 of them. */
static void corrected_averages_are_nearer_to_the_traced_ones(void **state)
{
    assert_true(rms(state, BRE_ATLAS, AVERAGE) < 0.67 * rms(state, BRE, AVERAGE));
    assert_true(rms(state, FLUX_ATLAS, AVERAGE) < 0.55 * rms(state, FLUX, AVERAGE));
    assert_true(rms(state, DF_ATLAS, AVERAGE) < 0.5 * rms(state, DF, AVERAGE));
}

/* RMS of the logarithm of the ratio over all rooms that were held out: 0.211, 0.194,
 * 0.137. The standard error of each in the sample is about a tenth of the value. */
static void errors_are_those_of_the_theory(void **state)
{
    assert_near(rms(state, IRC_ATLAS, DARK), 0.211, 0.065);
    assert_near(rms(state, IRC_ATLAS, ELSEWHERE), 0.194, 0.06);
    assert_near(rms(state, IRC_ATLAS, AVERAGE), 0.137, 0.04);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_position_the_dark_quarter_has_half_the_error_of_averages),
        cmocka_unit_test(
            position_formulae_beat_averages_by_ratio_and_by_daylight_factor),
        cmocka_unit_test(and_no_more_elsewhere),
        cmocka_unit_test(corrected_averages_are_nearer_to_the_traced_ones),
        cmocka_unit_test(errors_are_those_of_the_theory),
    };
    add_tests(tests, read_errors, NULL);
}
