/* annual_json.c - builds the JSON object of one room. */
#include "reports/annual/annual_json.h"

#include <math.h>
#include <string.h>

#include "model/results/sheets/lm83_grid.h"
#include "model/results/sheets/point_areas.h"
#include "reports/annual/annual_figure.h"
#include "reports/annual/annual_hourly.h"
#include "reports/annual/hand_year_report.h"
#include "reports/annual/lighting_report.h"
#include "reports/parts/json.h"

/* Adds a figure, which may be missing because there are no blinds. */
static bool add_annual_figure(struct json_object *object, const char *key,
                              const struct pp_annual_value *figure, double unit)
{
    return pp_annual_figure_json(object, key, figure, unit,
                                 "not defined without blinds");
}

static bool add_figures(struct json_object *object, const struct pp_annual_sheet *sheet,
                        const struct pp_annual_figures *of)
{
    struct pp_annual_figures figures = *of;
    bool good = true;
    for (int i = 0; i < sheet->illuminance_count && good; i++) {
        char key[32];
        snprintf(key, sizeof key, "da%g", sheet->illuminances_lx[i]);
        good = add_annual_figure(
            object, key,
            pp_annual_sheet_figure(&figures, pp_annual_result_autonomy(i, false)),
            100.0);
        snprintf(key, sizeof key, "cda%g", sheet->illuminances_lx[i]);
        good = good
               && add_annual_figure(
                   object, key,
                   pp_annual_sheet_figure(&figures, pp_annual_result_autonomy(i, true)),
                   100.0);
    }
    for (const struct pp_annual_figure_name *n = pp_annual_result_names;
         n->name && good; n++)
        good = add_annual_figure(object, n->name,
                                 pp_annual_sheet_figure(&figures, n->index), n->unit);
    return good;
}

/* Adds the share with blinds, which is sDA only if they are operated as in LM-83. */
static bool add_sda(struct json_object *to, const struct pp_annual_sheet *sheet)
{
    const struct pp_annual_value *share = &sheet->plane.sda;
    if (sheet->blinds_of_lm83 || !sheet->has_blinds)
        return add_annual_figure(to, "sda300/50", share, 100.0);
    const struct pp_annual_value none = {NAN, NAN};
    return pp_annual_figure_json(to, "sda300/50", &none, 100.0,
                                 "the blinds are not operated as in LM-83")
           && add_annual_figure(to, "blinds-da300/50-area", share, 100.0);
}

static bool add_plane(struct json_object *object, const struct pp_annual_result *result)
{
    const struct pp_annual_sheet *sheet = &result->sheet;
    const struct pp_annual_plane *plane = &sheet->plane;
    struct json_object *to = json_object_new_object();
    bool good = pp_json_add(object, "plane", to)
                && add_annual_figure(to, "da300/50-area", &plane->autonomous, 100.0)
                && add_sda(to, sheet)
                && pp_annual_figure_json(to, "ase1000,250", &plane->ase, 100.0,
                                         "the weather has no direct sun")
                && pp_json_number(to, "near_half", sheet->near_half);
    double area_m2 = pp_point_areas_sum(sheet->receivers, sheet->receiver_count);
    double sun_h = pp_annual_sheet_has_sun(sheet) ? sheet->mean.sun_h.value : NAN;
    if (!isnan(area_m2))
        good = good && pp_json_number(to, "area_m2", area_m2)
               && pp_json_number(to, "sun_hours_mean_h", sun_h)
               && pp_json_number(to, "sun_hours_sum_m2h", sun_h * area_m2);
    for (int i = 0; i < PP_ANNUAL_LEVELS && good; i++) {
        char key[32];
        snprintf(key, sizeof key, "en17037-%g", pp_annual_sheet_levels_lx[i]);
        good = add_annual_figure(to, key, &plane->level[i], 100.0);
    }
    struct pp_annual_leed leed = pp_annual_sheet_leed(sheet);
    struct json_object *credit = json_object_new_object();
    good =
        good && pp_json_add(object, "leed-v4.1", credit)
        && pp_json_number(credit, "points", leed.why_not ? NAN : leed.points)
        && (leed.why_not ? pp_json_text(credit, "why", leed.why_not)
                         : pp_json_add(credit, "ase_to_explain",
                                       json_object_new_boolean(leed.ase_to_explain)));
    char grid[PP_LM83_GRID_WORDS];
    pp_lm83_grid_words(grid, sheet);
    good = good && (leed.why_not || !grid[0] || pp_json_text(credit, "grid", grid));
    struct json_object *mean = json_object_new_object();
    return good && pp_json_add(object, "average", mean)
           && add_figures(mean, sheet, &sheet->mean)
           && pp_lighting_report_json_point(mean, sheet, -1)
           && pp_hand_year_report_json_point(mean, &result->hand, sheet, -1);
}

static bool add_points(struct json_object *object,
                       const struct pp_annual_result *result)
{
    const struct pp_annual_sheet *sheet = &result->sheet;
    struct json_object *points = json_object_new_array();
    bool good = pp_json_add(object, "points", points);
    for (int x = 0; x < sheet->receiver_count && good; x++) {
        struct pp_vec3 at = sheet->receivers[x].position;
        struct json_object *point = json_object_new_object();
        double area_m2 = sheet->receivers[x].area_m2;
        good = pp_json_append(points, point) && pp_json_number(point, "x", at.x)
               && pp_json_number(point, "y", at.y) && pp_json_number(point, "z", at.z)
               && (!(area_m2 > 0.0) || pp_json_number(point, "area_m2", area_m2))
               && add_figures(point, sheet, &sheet->points[x])
               && pp_lighting_report_json_point(point, sheet, x)
               && pp_hand_year_report_json_point(point, &result->hand, sheet, x);
    }
    return good;
}

static bool add_groups(struct json_object *object, const struct pp_annual_sheet *sheet)
{
    struct json_object *groups = json_object_new_array();
    bool good = pp_json_add(object, "window_groups", groups);
    for (int g = 0; g < sheet->group_count && good; g++) {
        const struct pp_annual_group *group = &sheet->groups[g];
        struct json_object *to = json_object_new_object();
        good = pp_json_append(groups, to) && pp_json_text(to, "name", group->name)
               && (!group->device || pp_json_text(to, "device", group->device))
               && (!sheet->has_blinds
                   || (pp_json_number(to, "closed_h", group->closed_h)
                       && pp_json_number(to, "unmet_h", group->unmet_h)))
               && add_annual_figure(to, "year-klxh", &group->light_lxh, 0.001);
    }
    return good;
}

static bool add_warnings(struct json_object *object,
                         const struct pp_annual_sheet *sheet)
{
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, "warnings", list);
    for (int i = 0; i < sheet->warning_count && good; i++)
        good = pp_json_append(list, json_object_new_string(sheet->warnings[i]));
    return good;
}

static bool add_discretisation(struct json_object *object,
                               const struct pp_annual_sheet *sheet)
{
    const struct pp_annual_discretisation *d = &sheet->discretisation;
    if (d->points == 0)
        return true;
    struct json_object *to = json_object_new_object();
    return pp_json_add(object, "discretisation", to)
           && pp_json_number(to, "points", d->points)
           && pp_json_number(to, "hours", d->hours)
           && add_annual_figure(to, "sky-percent", &d->sky, 100.0)
           && pp_json_number(to, "sky_rms_percent", 100.0 * d->sky_rms)
           && add_annual_figure(to, "all-percent", &d->all, 100.0);
}

static struct json_object *annual_room(const void *all, int index)
{
    const struct pp_annual_results *results = all;
    const struct pp_annual_result *result = &results->list[index];
    const struct pp_annual_sheet *sheet = &result->sheet;
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "format", "pepperpot-annual-1");
    if (good && results->more_than_one_file)
        good = pp_json_text(object, "file", result->file);
    good = good && pp_json_text(object, "room", sheet->world->name)
           && pp_json_text(object, "weather", sheet->weather)
           && pp_json_number(object, "sun_shift_minutes", sheet->sun_shift_min)
           && pp_json_text(object, "hours", sheet->period)
           && pp_json_number(object, "occupied_h", sheet->occupied_h)
           && pp_json_number(object, "daylit_h", sheet->daylit_h)
           && pp_json_number(object, "diffuse_median_lux", sheet->diffuse_median_lx)
           && pp_json_text(object, "records", sheet->notes)
           && pp_json_text(object, "calculation", sheet->method)
           && pp_json_text(object, "blinds", sheet->blinds)
           && add_warnings(object, sheet)
           && pp_json_add(object, "grid", json_object_new_boolean(sheet->is_grid))
           && pp_json_add(object, "finished", json_object_new_boolean(sheet->finished));
    if (good && sheet->finished)
        good = add_plane(object, result) && add_discretisation(object, sheet)
               && add_groups(object, sheet) && pp_lighting_report_json(object, sheet)
               && pp_hand_year_report_json(object, &result->hand, sheet)
               && add_points(object, result)
               && (!results->hourly || pp_annual_hourly_add_json(object, sheet));
    return pp_json_whole(object, good);
}

enum pp_status pp_annual_json(const struct pp_annual_results *results, FILE *out,
                              struct pp_error *err)
{
    return pp_json_print_rooms(out, annual_room, results, results->count,
                               results->several, err);
}
