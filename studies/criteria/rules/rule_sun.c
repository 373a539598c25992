/* rule_sun.c - rules on the hours of sun that a room has on every day of a period,
 * through any of its openings (methods/exact/sunlit_hours.h).
 *
 * The day with the fewest hours decides. If no break is permitted, only the longest
 * interval of sun counts; if one is permitted, the two longest intervals count. If a
 * rule has a least angle in plan between sun and glass, directions beyond two vertical
 * planes count as hidden.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/epw/month_day.h"
#include "methods/exact/sunlit_hours.h"
#include "studies/criteria/rules/rule_quantity.h"
#include "studies/criteria/windows/exposure_point.h"

static struct pp_vec3 rule_point(const struct pp_rule *rule,
                                 const struct pp_opening *opening)
{
    if (strcmp(rule->point, "centre") == 0)
        return pp_exposure_point_centre(opening);
    if (strcmp(rule->point, "sill") == 0)
        return pp_exposure_point(opening, -INFINITY, 0.0);
    return pp_exposure_point(opening, rule->above_m, rule->sill_m);
}

/* Hides the sun where its angle in plan to the glass is less than angle_rad. With the
 * outward normal o and a along the wall, the hidden directions have u.(-cos(angle) o +-
 * sin(angle) a) >= 0. */
static enum pp_status hide_grazing(struct pp_hidden_cones *cones,
                                   const struct pp_opening *opening, double angle_rad,
                                   struct pp_error *err)
{
    struct pp_vec3 out = pp_vec_scale(opening->inner.normal, -1.0);
    enum pp_status status = PP_OK;
    out.z = 0.0;
    if (!(pp_vec_length(out) > 1e-6)) /* a rooflight in a flat roof */
        return PP_OK;
    out = pp_vec_unit(out);
    for (int side = -1; side <= 1 && status == PP_OK; side += 2) {
        struct pp_vec3 n = pp_vec_along(pp_vec_scale(out, -cos(angle_rad)),
                                        side * sin(angle_rad), opening->along);
        status = pp_hidden_cones_add_half_space(cones, n, err);
    }
    return status;
}

/* Directions hidden from each opening's point. On success the caller frees the list. */
static enum pp_status find_hidden(struct pp_hidden_cones **list,
                                  const struct pp_rule *rule,
                                  const struct pp_world *world, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    *list = calloc((size_t)world->opening_count + 1, sizeof **list);
    if (!*list)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        const struct pp_hidden_view view = {rule_point(rule, opening),
                                            pp_vec_scale(opening->inner.normal, -1.0),
                                            opening->face, opening};
        status = pp_hidden_cones_init(&(*list)[i], world, &view, err);
        if (status == PP_OK && rule->plan_angle_deg > 0.0)
            status =
                hide_grazing(&(*list)[i], opening, rule->plan_angle_deg * PP_RAD, err);
    }
    return status;
}

static int compare_lengths(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x < y) - (x > y);
}

/* Hours of a day that the rule counts; -1: no memory. */
static double counted_hours(const struct pp_rule *rule, const struct pp_sunlit_day *day)
{
    double from = isnan(rule->from_h) ? 0.0 : rule->from_h, sum = 0.0;
    double to = isnan(rule->to_h) ? 24.0 : rule->to_h;
    double *hours = calloc((size_t)day->count + 1, sizeof *hours);
    if (!hours)
        return -1.0;
    for (int i = 0; i < day->count; i++)
        hours[i] = fmax(fmin(day->times[i][1] * 12.0 / PP_PI + 12.0, to)
                            - fmax(day->times[i][0] * 12.0 / PP_PI + 12.0, from),
                        0.0);
    qsort(hours, (size_t)day->count, sizeof *hours, compare_lengths);
    int most = isnan(rule->breaks) ? day->count : (int)rule->breaks + 1;
    for (int i = 0; i < day->count && i < most; i++)
        sum += hours[i];
    free(hours);
    return sum;
}

/* Finds the day of the period with the fewest hours. */
static enum pp_status find_worst_day(double *least, struct pp_month_day *worst,
                                     const struct pp_rule *rule,
                                     const struct pp_world *world,
                                     const struct pp_hidden_cones *hidden,
                                     double shortest_h, struct pp_error *err)
{
    const struct pp_sunlit_place place = {world->latitude_rad, world->north_rad,
                                          world->longitude_rad};
    double above_rad = isnan(rule->altitude_deg) ? 0.0 : rule->altitude_deg * PP_RAD;
    struct pp_month_day date = {0}, to = {0};
    sscanf(rule->from, "%d-%d", &date.month, &date.day);
    sscanf(rule->to, "%d-%d", &to.month, &to.day);
    *least = INFINITY;
    for (;; date.day++) {
        if (date.day > pp_month_day_days_of_month(date.month)) {
            date.day = 1;
            date.month++;
        }
        if (pp_month_day_is_before(to, date))
            return PP_OK;
        if (date.month == 2 && date.day == 29) /* the sun's path is that of 2025, which
                                                * has no such day */
            continue;
        struct pp_sunlit_day day = {0};
        enum pp_status status = PP_OK;
        for (int i = 0; i < world->opening_count && status == PP_OK; i++)
            status = pp_sunlit_hours_above(&day, &hidden[i], place, date.month,
                                           date.day, above_rad, err);
        pp_sunlit_hours_drop_short(&day, shortest_h);
        double hours = counted_hours(rule, &day);
        pp_sunlit_hours_clear(&day);
        if (status != PP_OK || hours < 0.0)
            return status != PP_OK ? status : pp_fail_memory(err);
        if (hours < *least) {
            *least = hours;
            *worst = date;
        }
    }
}

static enum pp_status judge_sun_hours(const struct pp_rule *rule,
                                      const struct pp_inquiry *inquiry,
                                      const char *what,
                                      struct pp_finding_list *findings,
                                      struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    if (isnan(world->latitude_rad)) {
        struct pp_finding none =
            pp_finding_not_judged("the room file has no latitude (site)", "%s", what);
        return pp_finding_list_add(findings, &none, err);
    }
    struct pp_hidden_cones *hidden;
    struct pp_month_day worst = {0};
    double least = 0.0;
    char words[32];
    enum pp_status status = find_hidden(&hidden, rule, world, err);
    if (status == PP_OK)
        status = find_worst_day(&least, &worst, rule, world, hidden,
                                inquiry->shortest_h, err);
    for (int i = 0; hidden && i < world->opening_count; i++)
        pp_hidden_cones_clear(&hidden[i]);
    free(hidden);
    if (status != PP_OK)
        return status;
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_HOURS, least, rule->threshold, false, "%s", what);
    if (strcmp(rule->from, rule->to) != 0)
        pp_finding_note(&finding, "least on %s",
                        pp_month_day_words(words, sizeof words, worst));
    return pp_finding_list_add(findings, &finding, err);
}

const struct pp_rule_quantity pp_rule_sun_hours = {"sun-hours", judge_sun_hours};
