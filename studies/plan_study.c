/* plan_study.c - makes plans by a hand method, or by simulation at many points. */
#include "studies/plan_study.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/daylight_curves.h"
#include "methods/default_methods.h"
#include "methods/selection.h"
#include "model/room/section.h"
#include "studies/plane_figures.h"
#include "studies/study_report.h"
#include "studies/traced_plane.h"

static const char traced[] = "traced";

/* ---- methods that can be drawn ---- */

/* Reason why a plan cannot show the method; NULL: it can. */
static const char *has_no_contours(const struct pp_choice *choice)
{
    const struct pp_method *method = choice->method;
    if (method->gives == PP_GIVES_INTERNAL)
        return "gives a single internally reflected component for the whole room, and "
               "so no contours; expected a pair, such as exact+bre";
    if (method->gives == PP_GIVES_WHOLE)
        return "does not give a value at every point of the plane; expected a pair, "
               "such as exact+bre";
    if (method->counts)
        return "counts dots, so its values change in steps and have no contours; df "
               "prints the values at points";
    return NULL;
}

enum pp_status pp_plan_study_check(const char *methods, bool simulate,
                                   struct pp_error *err)
{
    struct pp_selection selection;
    if (!methods)
        return PP_OK;
    enum pp_status status = pp_selection_parse(&selection, methods, err);
    if (status != PP_OK)
        return status;
    if (simulate && !selection.usual)
        status = pp_fail(err, PP_BAD_INPUT,
                         "a plan shows one result, either by %.100s or by simulation; "
                         "expected --methods or --simulate, not both",
                         methods);
    else if (!selection.usual && selection.count != 1)
        status = pp_fail(err, PP_BAD_INPUT,
                         "a plan shows one result, but \"%.100s\" gives %d; expected "
                         "one method or pair, such as exact+bre",
                         methods, selection.count);
    else if (!selection.usual && has_no_contours(&selection.choices[0]))
        status = pp_fail(err, PP_BAD_INPUT, "%s %s", selection.choices[0].method->name,
                         has_no_contours(&selection.choices[0]));
    pp_selection_clear(&selection);
    return status;
}

/* ---- values at the points ---- */

static const struct pp_reading *points_of(const struct pp_report *report,
                                          enum pp_component component, const char *name)
{
    const struct pp_column *column = pp_report_find(report, component, name);
    return column ? column->points : NULL;
}

static struct pp_reading sum_of(struct pp_reading a, struct pp_reading b)
{
    return a.why ? a : b.why ? b : pp_reading_of(a.value + b.value);
}

/* Sets the values: a copy of the daylight factor column, or, if `direct` is set, the
 * sum of the sky component and the externally reflected component. */
static enum pp_status set_figures(struct pp_plan_study *study, const char *name,
                                  bool direct, struct pp_error *err)
{
    const struct pp_report *report = &study->report;
    struct pp_column *figures = &study->figures;
    int count = report->receiver_count;
    snprintf(figures->name, sizeof figures->name, "%s", name);
    figures->component = direct ? PP_SC : PP_DF;
    figures->points = calloc((size_t)count + 1, sizeof *figures->points);
    if (!figures->points)
        return pp_fail_memory(err);
    const struct pp_column *column = pp_report_find(report, figures->component, name);
    const struct pp_column *external = pp_report_find(report, PP_ERC, name);
    figures->average =
        direct ? sum_of(column->average, external->average) : column->average;
    for (int i = 0; i < count; i++)
        figures->points[i] = direct ? sum_of(points_of(report, PP_SC, name)[i],
                                             points_of(report, PP_ERC, name)[i])
                                    : points_of(report, PP_DF, name)[i];
    return PP_OK;
}

/* Computes the plane figures from the grid points, which follow the room's own points,
 * and removes the grid points from the report. */
static enum pp_status settle_plan_grid(struct pp_plan_study *study,
                                       const struct pp_study_room *room,
                                       struct pp_error *err)
{
    const struct pp_report *report = &study->report;
    const struct pp_receiver *all = report->receivers;
    enum pp_status status = pp_plane_figures_fill(&study->report, room, err);
    int first = report->grid_of_standard ? room->receiver_count : 0;
    if (status == PP_OK && report->grid_points > 0)
        status = pp_plane_figures_sum_up(&study->figures, study->figures.points + first,
                                         all + first, report->grid_points, err);
    return status;
}

/* ---- contours ---- */

/* Makes a shallow copy of the world. Its plane has holes where objects stand, since
 * contours cannot show light there. The caller clears the plane of the copy. */
static enum pp_status open_world(struct pp_world *open, const struct pp_world *world,
                                 struct pp_error *err)
{
    *open = *world;
    open->plane = (struct pp_region){0};
    return pp_section_open(&open->plane, world, err);
}

/* ---- by hand ---- */

/* Reading of the internally reflected component, which is added at every point: the
 * room's average, or its minimum if the method gives only a minimum. */
static struct pp_reading everywhere(const struct pp_report *report, const char *name)
{
    const struct pp_column *column = pp_report_find(report, PP_IRC, name);
    if (isfinite(column->average.value) || report->receiver_count == 0)
        return column->average;
    return column->points[0];
}

static enum pp_status draw_choice(struct pp_plan_study *study,
                                  const struct pp_choice *choice, const char *name,
                                  double tolerance_m, struct pp_stop stop,
                                  struct pp_error *err)
{
    const char *internal = choice->internal ? choice->internal->name : NULL;
    struct pp_reading irc = pp_reading_of(0.0);
    if (internal)
        irc = everywhere(&study->report, internal);
    if (!isfinite(irc.value))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s cannot be drawn: %s; expected another method, or --simulate",
                       name, irc.why ? irc.why : "there is no value");
    struct pp_world open;
    enum pp_status status = open_world(&open, study->report.world, err);
    if (status == PP_OK)
        status = pp_daylight_curves_by(&study->plan, &open, &study->report.light,
                                       choice->method, irc.value, internal,
                                       (struct pp_daylight_curves_choice){
                                           .tolerance_m = tolerance_m, .stop = stop},
                                       err);
    pp_region_clear(&open.plane);
    return status == PP_OK ? set_figures(study, name, !internal, err) : status;
}

/* Makes a plan by a hand method. tolerance_m: for a sketch, the tolerance of its
 * curves; a sketch has no grid over the plane. 0: a plan, not a sketch. */
static enum pp_status by_hand(struct pp_plan_study *study,
                              const struct pp_study_room *room,
                              const struct pp_study_options *options,
                              double tolerance_m, struct pp_error *err)
{
    struct pp_study_options one = *options;
    struct pp_selection selection;
    enum pp_status status = pp_selection_parse(&selection, options->methods, err);
    if (status == PP_OK && selection.usual) {
        const struct pp_default_methods pair =
            pp_default_methods(room->world, &room->light, NULL, 0);
        if (pair.instead)
            snprintf(study->note, sizeof study->note,
                     "%s is used in place of %s, which does not cover this room (%s).",
                     pair.name, pair.instead, pair.why);
        one.methods = pair.name;
        pp_selection_clear(&selection);
        status = pp_selection_parse(&selection, pair.name, err);
    }
    if (status != PP_OK)
        return status;
    status = tolerance_m > 0.0
                 ? pp_study_report_methods(&study->report, room, &one, err)
                 : pp_study_report_with_plane(&study->report, room, &one, err);
    study->report.options = &options->method_options; /* because `one` goes out of scope
                                                       * here */
    if (status == PP_OK)
        status = draw_choice(study, &selection.choices[0], one.methods, tolerance_m,
                             options->method_options.stop, err);
    pp_selection_clear(&selection);
    return status;
}

/* ---- by simulation ---- */

/* The target error applies to the median and to fractions of the area. Both are means
 * over many points, so the error of each point may initially be greater by this
 * factor. */
static const double coarse = 4.0;

/* Checks the grid. *known is true if the median and the fractions of the area above the
 * levels meet the target error. */
static enum pp_status plane_is_known(bool *known, const struct pp_column *column,
                                     const struct pp_receiver *receivers, int first,
                                     int count, double error, struct pp_error *err)
{
    struct pp_column grid = {.component = PP_DF, .common = column->common};
    *known = true;
    if (count - first < 1)
        return PP_OK;
    enum pp_status status = pp_plane_figures_sum_up(
        &grid, column->points + first, receivers + first, count - first, err);
    if (status != PP_OK || !grid.has_plane)
        return status;
    *known = grid.plane.median.std_error <= error * grid.plane.median.value;
    for (int k = 0; k < PP_PLANE_LEVELS; k++) {
        double variance = 0.0;
        for (int i = first; i < count; i++) {
            const struct pp_reading *point = &column->points[i];
            double off = (point->value - pp_plane_levels[k]) / point->std_error;
            double reaches = 0.5 * erfc(-off / sqrt(2.0));
            variance += point->std_error > 0.0 ? reaches * (1.0 - reaches) : 0.0;
        }
        *known &= sqrt(variance) / (count - first) <= error;
    }
    return PP_OK;
}

/* Simulates the room's points and the grid points. The first run has a larger error;
 * further runs halve it until the plane figures are known. If the number of samples or
 * the time is limited, there is only one run. */
static enum pp_status trace_points(struct pp_report *report,
                                   const struct pp_study_room *room,
                                   const struct pp_study_options *options,
                                   bool *by_clock, struct pp_error *err)
{
    struct pp_study_options own = *options;
    int own_points = room->receiver_count, count = report->receiver_count;
    bool known = false, once = options->error == 0.0 || options->seconds > 0.0;
    own.error = once ? options->error : fmin(coarse * options->error, 1.0);
    for (;;) {
        enum pp_status status = pp_study_report_traced(report, &own, by_clock, err);
        if (status == PP_OK)
            status = plane_is_known(
                &known, pp_report_find(report, PP_DF, traced), report->receivers,
                count > own_points ? own_points : 0, count, options->error, err);
        if (status != PP_OK || known || once || own.error <= options->error
            || !report->finished)
            return status;
        own.error = fmax(0.5 * own.error, options->error);
    }
}

/* Target error of each point for the contours, as a multiple of the target error of the
 * study. A fit uses about twenty points, which have a third of their variance in
 * common. A fitted value therefore has two or three times the target error, which the
 * bands of the contours show. */
static const double error_of_points = 4.0;

/* Simulates the points from which contours are drawn. */
static enum pp_status trace_plane(struct pp_traced_plane **plane,
                                  struct pp_report *report,
                                  const struct pp_study_options *options,
                                  bool *by_clock, struct pp_error *err)
{
    struct pp_study_options of_points = *options;
    of_points.error = fmin(error_of_points * options->error, 1.0);
    enum pp_status status =
        pp_traced_plane_create(plane, &report->more_receivers, &report->receiver_count,
                               report->world, &report->light, err);
    report->receivers = report->more_receivers;
    if (status == PP_OK)
        status = pp_study_report_traced(report, &of_points, by_clock, err);
    if (status != PP_OK)
        return status;
    const struct pp_column *factors = pp_report_find(report, PP_DF, traced);
    const struct pp_column *external = pp_report_find(report, PP_ERC, traced);
    return pp_traced_plane_fill(*plane, factors->points, external->points,
                                factors->common_near, err);
}

/* Writes a note with median and mean by the usual pair of hand methods, if that pair
 * has values. */
static enum pp_status note_by_hand(struct pp_plan_study *study,
                                   const struct pp_study_room *room,
                                   const struct pp_study_options *options,
                                   struct pp_error *err)
{
    struct pp_study_options one = *options;
    struct pp_report report = {.finished = true};
    one.methods = pp_default_methods(room->world, &room->light, NULL, 0).name;
    enum pp_status status = pp_study_report_with_plane(&report, room, &one, err);
    if (status == PP_OK)
        status = pp_study_report_settle(&report, room, err);
    const struct pp_column *column =
        status == PP_OK ? pp_report_find(&report, PP_DF, one.methods) : NULL;
    if (column && column->has_plane)
        snprintf(study->note, sizeof study->note,
                 "Comparison by hand (%s): median %.2f\u00a0%%, mean %.2f\u00a0%%.",
                 one.methods, 100.0 * column->plane.median.value,
                 100.0 * column->plane.average.value);
    pp_report_clear(&report);
    return status;
}

/* Runs two simulations, each with half of the time: one for the room's points and the
 * grid, and one for the points of the contours. */
static enum pp_status by_trace(struct pp_plan_study *study,
                               const struct pp_study_room *room,
                               const struct pp_study_options *options, bool *by_clock,
                               struct pp_error *err)
{
    struct pp_traced_plane *plane = NULL;
    struct pp_study_options half = *options;
    struct pp_report *report = &study->report;
    struct pp_world open;
    struct pp_report contoured = {
        .world = &open, .light = room->light, .finished = true};
    half.seconds *= 0.5;
    report->world = room->world;
    report->light = room->light;
    enum pp_status status = open_world(&open, room->world, err);
    if (status == PP_OK)
        status = pp_plane_figures_receivers(&report->more_receivers,
                                            &report->receiver_count, room, err);
    report->receivers = report->more_receivers;
    if (status == PP_OK)
        status = trace_points(report, room, &half, by_clock, err);
    if (status == PP_OK)
        status = set_figures(study, traced, false, err);
    if (status == PP_OK)
        status = trace_plane(&plane, &contoured, &half, by_clock, err);
    if (status == PP_OK)
        status = note_by_hand(study, room, options, err);
    report->finished &= contoured.finished;
    if (status == PP_OK)
        status =
            pp_daylight_curves_of(&study->plan, &open, traced, pp_traced_plane_value,
                                  pp_traced_plane_error, plane, err);
    pp_traced_plane_destroy(plane);
    pp_report_clear(&contoured);
    pp_region_clear(&open.plane);
    return status;
}

enum pp_status pp_plan_study_make(struct pp_plan_study *study,
                                  const struct pp_study_room *room,
                                  const struct pp_study_options *options,
                                  bool *by_clock, struct pp_error *err)
{
    *study = (struct pp_plan_study){.report = {.finished = true}};
    enum pp_status status =
        pp_plan_study_check(options->methods, options->simulate, err);
    if (status == PP_OK)
        status = options->simulate ? by_trace(study, room, options, by_clock, err)
                                   : by_hand(study, room, options, 0.0, err);
    if (status == PP_OK)
        status = settle_plan_grid(study, room, err);
    if (status != PP_OK)
        pp_plan_study_clear(study);
    return status;
}

enum pp_status pp_plan_study_sketch(struct pp_plan_study *study,
                                    const struct pp_study_room *room,
                                    const struct pp_study_options *options,
                                    double tolerance_m, struct pp_error *err)
{
    *study = (struct pp_plan_study){.report = {.finished = true}};
    enum pp_status status = pp_plan_study_check(options->methods, false, err);
    if (status == PP_OK)
        status = by_hand(study, room, options, tolerance_m, err);
    if (status != PP_OK)
        pp_plan_study_clear(study);
    return status;
}

void pp_plan_study_clear(struct pp_plan_study *study)
{
    pp_daylight_plan_clear(&study->plan);
    pp_report_clear(&study->report);
    free(study->figures.points);
    study->figures.points = NULL;
}
