/* room_cases.c - makes one case for each value, in the order of the report's
 * columns. */
#include "studies/research/validation/room_cases.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "studies/bands/band_features.h"
#include "studies/engines/engine.h"
#include "studies/research/validation/comparison.h"

static const double STD_ERRORS = 3.0;

/* Least difference that a simulation can distinguish from rounding. */
static const double ROUNDING = 1e-12;

/* The last case that was added; NULL if memory ran out. */
static struct pp_known_case *last_of(struct pp_known_cases *cases)
{
    return cases->whole ? &cases->list[cases->count - 1] : NULL;
}

/* Permitted relative error of an engine that is not a reference. */
static const double CACHE_SHARE = 0.02;

static double known_error(struct pp_reading reading)
{
    return isfinite(reading.std_error) ? reading.std_error : 0.0;
}

/* A result of a hand method, with its simulated value, its band and the parts of its
 * error. */
struct hand_figure {
    double hand;
    struct pp_reading traced;
    struct pp_band_ends band;
    struct pp_error_parts parts;
};

static void set_limits(struct pp_known_case *one, const struct hand_figure *figure,
                       const char *no_bands)
{
    double slack = STD_ERRORS * known_error(figure->traced) + ROUNDING;
    one->limit = figure->hand - figure->band.low + slack;
    one->least = figure->hand - figure->band.high - slack;
    if (isnan(one->limit))
        one->why = no_bands ? no_bands
                            : "no band: the atlas has no band of this method for "
                              "similar rooms and points";
}

static void add_figure(struct pp_known_cases *cases, const char *file,
                       const struct pp_report *report, const struct pp_column *column,
                       int point, const struct hand_figure *figure)
{
    const char *component = pp_band_features_components[column->component];
    char what[sizeof cases->list->what];
    if (!isfinite(figure->hand) || !isfinite(figure->traced.value))
        return;
    if (point < 0)
        snprintf(what, sizeof what, "%s, average", component);
    else
        snprintf(what, sizeof what, "%s at %.2f, %.2f", component,
                 report->receivers[point].position.x,
                 report->receivers[point].position.y);
    cases->group = column->name;
    pp_known_case_add(cases, what, column->name, figure->hand, figure->traced.value,
                      NAN);
    struct pp_known_case *one = last_of(cases);
    if (!one)
        return;
    set_limits(one, figure, report->no_bands);
    one->std_error = figure->traced.std_error;
    one->assumption = figure->parts.assumption;
    one->formula = figure->parts.formula;
    one->room = report->world->name;
    one->file = file;
}

static void add_room_case_column(struct pp_known_cases *cases, const char *file,
                                 const struct pp_report *report,
                                 const struct pp_column *column,
                                 const struct pp_column *traced,
                                 const struct pp_own_worlds *worlds)
{
    for (int i = 0; column->points && i < report->receiver_count; i++)
        add_figure(
            cases, file, report, column, i,
            &(struct hand_figure){column->points[i].value, traced->points[i],
                                  column->bands ? column->bands[i] : pp_band_none(),
                                  pp_comparison_parts(report, column, worlds, i)});
    if (!column->of_all_surfaces)
        add_figure(cases, file, report, column, -1,
                   &(struct hand_figure){
                       column->average.value, traced->average, column->average_band,
                       pp_comparison_parts(report, column, worlds, -1)});
}

void pp_room_cases_of_methods(struct pp_known_cases *cases, const char *file,
                              const struct pp_report *report,
                              const struct pp_own_worlds *worlds)
{
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        const struct pp_column *traced =
            pp_report_find(report, column->component, "traced");
        if (traced && traced != column)
            add_room_case_column(cases, file, report, column, traced, worlds);
    }
}

static void add_engine_figure(struct pp_known_cases *cases, const char *file,
                              const struct pp_report *report,
                              const struct pp_column *column, int point,
                              const struct pp_reading *figure,
                              const struct pp_reading *truth)
{
    const struct pp_engine *engine = pp_engine_of_column(column->name);
    double error = hypot(figure->std_error, truth->std_error);
    char what[sizeof cases->list->what] = "df, average";
    if (!isfinite(error) || !isfinite(figure->value - truth->value))
        return;
    if (point >= 0)
        snprintf(what, sizeof what, "df at %.2f, %.2f",
                 report->receivers[point].position.x,
                 report->receivers[point].position.y);
    cases->group = column->name;
    pp_known_case_add(cases, what, column->name, figure->value, truth->value,
                      STD_ERRORS * error + ROUNDING
                          + (engine->is_truth ? 0.0 : CACHE_SHARE * truth->value));
    struct pp_known_case *one = last_of(cases);
    if (!one)
        return;
    one->std_error = error;
    one->room = report->world->name;
    one->file = file;
}

void pp_room_cases_of_engines(struct pp_known_cases *cases, const char *file,
                              const struct pp_report *report)
{
    const struct pp_column *truth = pp_engine_truth(report);
    for (int i = 0; truth && i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (column == truth || column->component != PP_DF
            || !pp_engine_of_column(column->name))
            continue;
        for (int k = 0; k < report->receiver_count; k++)
            add_engine_figure(cases, file, report, column, k, &column->points[k],
                              &truth->points[k]);
        add_engine_figure(cases, file, report, column, -1, &column->average,
                          &truth->average);
    }
}

void pp_room_cases_of_radiance(struct pp_known_cases *cases, const char *file,
                               const struct pp_world *world, struct pp_vec3 position,
                               struct pp_reading traced, struct pp_reading radiance)
{
    double error = hypot(known_error(traced), known_error(radiance));
    char what[sizeof cases->list->what];
    snprintf(what, sizeof what, "df at %.3f, %.3f, %.3f", position.x, position.y,
             position.z);
    cases->group = world->name && *world->name ? world->name : file;
    pp_known_case_add(cases, what, "traced", traced.value, radiance.value,
                      fmax(STD_ERRORS * error, 0.01 * fabs(radiance.value)));
    struct pp_known_case *one = last_of(cases);
    if (!one)
        return;
    one->std_error = error;
    one->room = world->name;
    one->file = file;
}
