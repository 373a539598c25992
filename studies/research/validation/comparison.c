/* comparison.c - calculates bias, spread and worst difference for each column of a
 * report, and over several rooms. */
#include "studies/research/validation/comparison.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/results/common_error.h"
/* Standard error of a reading; 0 if nothing was sampled. */
static double known_error(const struct pp_reading *reading)
{
    return isfinite(reading->std_error) ? reading->std_error : 0.0;
}

/* Reason why a column has no value: the reason at the first point without a value, or
 * else that of the average. */
static const char *reason(const struct pp_report *report,
                          const struct pp_column *column)
{
    for (int i = 0; column->points && i < report->receiver_count; i++)
        if (column->points[i].why)
            return column->points[i].why;
    return column->average.why;
}

/* ---- the parts of a difference ---- */

/* Columns of the values simulated in a method's own world, one for each of `count`
 * components, and the same components of the room. */
struct own_value {
    int count;
    const struct pp_column *own[3], *room[3]; /* own: in the method's world; room: in
                                               * the room's world; NULL: not
                                               * simulated */
};

static struct own_value own_value_of(const struct pp_report *report,
                                     const struct pp_column *column,
                                     const struct pp_own_worlds *worlds)
{
    struct own_value value = {0};
    enum pp_component list[3] = {column->component};
    const struct pp_report *of[3];
    value.count = column->component == PP_DF ? 3 : 1;
    for (int i = 0; i < value.count; i++) {
        if (value.count == 3)
            list[i] = PP_SC + i;
        of[i] = pp_own_world_of(worlds, column, list[i]);
    }
    /* If all components are from one world, the daylight factor of this world is used,
     * which has a smaller error than the sum of the components. */
    if (value.count == 3 && of[0] == of[1] && of[1] == of[2]) {
        value.count = 1;
        list[0] = PP_DF;
    }
    for (int i = 0; i < value.count; i++) {
        value.own[i] = pp_report_find(of[i], list[i], "traced");
        value.room[i] = pp_report_find(report, list[i], "traced");
    }
    return value;
}

/* Reading of a column at a point (-1: the average); NAN if column is NULL. */
static struct pp_reading reading_at(const struct pp_column *column, int point)
{
    if (!column)
        return (struct pp_reading){.value = NAN, .std_error = NAN};
    return point < 0 ? column->average : column->points[point];
}

/* Both parts of a method's difference at a point (-1: of the average), with the squares
 * of their standard errors. */
static struct pp_error_parts parts_of(const struct own_value *value, double method,
                                      int point)
{
    struct pp_error_parts parts = {.formula = method};
    for (int i = 0; i < value->count; i++) {
        struct pp_reading own = reading_at(value->own[i], point);
        double error = known_error(&own);
        parts.formula -= own.value;
        parts.formula_error += error * error;
        if (value->own[i] == value->room[i])
            continue;
        struct pp_reading room = reading_at(value->room[i], point);
        parts.assumption += own.value - room.value;
        parts.assumption_error += error * error + pow(known_error(&room), 2.0);
    }
    return parts;
}

/* Converts sums of n parts to means, with standard errors. */
static void take_mean(struct pp_error_parts *sum, int n)
{
    sum->assumption /= n;
    sum->formula /= n;
    sum->assumption_error =
        isfinite(sum->assumption) ? sqrt(sum->assumption_error) / n : NAN;
    sum->formula_error = isfinite(sum->formula) ? sqrt(sum->formula_error) / n : NAN;
}

struct pp_error_parts pp_comparison_parts(const struct pp_report *report,
                                          const struct pp_column *column,
                                          const struct pp_own_worlds *worlds, int point)
{
    const struct own_value own = own_value_of(report, column, worlds);
    double method = point < 0 ? column->average.value : column->points[point].value;
    struct pp_error_parts parts = parts_of(&own, method, point);
    take_mean(&parts, 1);
    return parts;
}

static void add_parts(struct pp_error_parts *sum, struct pp_error_parts parts)
{
    sum->assumption += parts.assumption;
    sum->formula += parts.formula;
    sum->assumption_error += parts.assumption_error;
    sum->formula_error += parts.formula_error;
}

/* ---- one room ---- */

static bool is_elsewhere(const struct own_value *value)
{
    bool elsewhere = false;
    for (int i = 0; i < value->count; i++)
        elsewhere |= value->own[i] != value->room[i];
    return elsewhere;
}

static struct pp_comparison compare_column(const struct pp_report *report,
                                           const struct pp_column *column,
                                           const struct pp_column *traced,
                                           const struct pp_own_worlds *worlds)
{
    const struct own_value own = own_value_of(report, column, worlds);
    struct pp_comparison result = {.component = column->component,
                                   .name = column->name,
                                   .average = NAN,
                                   .of_average = {NAN, NAN, NAN, NAN},
                                   .own_world = is_elsewhere(&own),
                                   .traced_average = traced->average.value,
                                   .traced_average_error =
                                       known_error(&traced->average)};
    double sum = 0.0, squares = 0.0, errors = 0.0, noise = 0.0, truth = 0.0;
    for (int i = 0; column->points && i < report->receiver_count; i++) {
        double off = column->points[i].value - traced->points[i].value;
        double error = known_error(&traced->points[i]);
        if (!isfinite(off))
            continue;
        result.points++;
        sum += off;
        squares += off * off;
        errors += error;
        noise += error * error;
        truth += traced->points[i].value;
        add_parts(&result.of_bias, parts_of(&own, column->points[i].value, i));
        if (result.points == 1 || fabs(off) > fabs(result.worst)) {
            result.worst = off;
            result.worst_error = error;
            result.worst_point = i;
        }
    }
    if (result.points > 0) {
        int n = result.points;
        result.traced = truth / n;
        result.bias = sum / n;
        result.bias_error = pp_common_error(errors, noise, traced->common) / n;
        result.spread = sqrt(fmax((squares - noise) / n, 0.0));
        take_mean(&result.of_bias, n);
    }
    if (!column->of_all_surfaces)
        result.average = column->average.value;
    if (isfinite(result.average)) {
        result.of_average = parts_of(&own, result.average, -1);
        take_mean(&result.of_average, 1);
    }
    if (result.points == 0 && !isfinite(result.average))
        result.why =
            column->of_all_surfaces
                ? "the method gives the average over all surfaces of the room, not "
                  "over the working plane"
                : reason(report, column);
    return result;
}

enum pp_status pp_comparison_of_report(struct pp_comparison **list, int *count,
                                       const struct pp_report *report,
                                       const struct pp_own_worlds *worlds,
                                       struct pp_error *err)
{
    *count = 0;
    *list = calloc((size_t)report->column_count + 1, sizeof **list);
    if (!*list)
        return pp_fail_memory(err);
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        const struct pp_column *traced =
            pp_report_find(report, column->component, "traced");
        if (traced && traced != column)
            (*list)[(*count)++] = compare_column(report, column, traced, worlds);
    }
    return PP_OK;
}

/* ---- over several rooms ---- */

static void add_compared_points(struct pp_overall *overall,
                                const struct pp_comparison *one, int room)
{
    if (one->points == 0 || !(one->traced > 0.0))
        return;
    double n = one->points;
    overall->rooms++;
    overall->points += one->points;
    overall->own_world |= one->own_world;
    overall->bias += n * one->bias / one->traced;
    overall->assumption += n * one->of_bias.assumption / one->traced;
    overall->formula += n * one->of_bias.formula / one->traced;
    overall->spread += n * pow(one->spread / one->traced, 2.0);
    double worst = one->worst / one->traced;
    if (!overall->worst_comparison || fabs(worst) > fabs(overall->worst)) {
        overall->worst = worst;
        overall->worst_room = room;
        overall->worst_comparison = one;
    }
}

static void add_average(struct pp_overall *overall, const struct pp_comparison *one)
{
    double off = one->average / one->traced_average - 1.0;
    if (!isfinite(off))
        return;
    overall->averages++;
    overall->own_world |= one->own_world;
    overall->average_assumption += one->of_average.assumption / one->traced_average;
    overall->average_formula += one->of_average.formula / one->traced_average;
    overall->average_bias += off;
    overall->average_spread += off * off;
}

static struct pp_overall *find_overall(struct pp_overall *list, int *count,
                                       const struct pp_comparison *one)
{
    for (int i = 0; i < *count; i++)
        if (list[i].component == one->component && strcmp(list[i].name, one->name) == 0)
            return &list[i];
    struct pp_overall *added = &list[(*count)++];
    added->component = one->component;
    added->name = one->name;
    return added;
}

enum pp_status pp_comparison_overall(struct pp_overall **list, int *count,
                                     struct pp_comparison *const *rooms,
                                     const int *counts, int room_count,
                                     struct pp_error *err)
{
    int most = 1;
    for (int i = 0; i < room_count; i++)
        most += counts[i];
    *count = 0;
    *list = calloc((size_t)most, sizeof **list);
    if (!*list)
        return pp_fail_memory(err);
    for (int i = 0; i < room_count; i++)
        for (int k = 0; k < counts[i]; k++) {
            struct pp_overall *overall = find_overall(*list, count, &rooms[i][k]);
            add_compared_points(overall, &rooms[i][k], i);
            add_average(overall, &rooms[i][k]);
        }
    for (int i = 0; i < *count; i++) {
        struct pp_overall *overall = &(*list)[i];
        if (overall->points > 0) {
            overall->bias /= overall->points;
            overall->assumption /= overall->points;
            overall->formula /= overall->points;
            overall->spread = sqrt(overall->spread / overall->points);
        }
        if (overall->averages > 0) {
            overall->average_bias /= overall->averages;
            overall->average_assumption /= overall->averages;
            overall->average_formula /= overall->averages;
            overall->average_spread = sqrt(overall->average_spread / overall->averages);
        }
    }
    return PP_OK;
}
