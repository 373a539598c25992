/* availability_json.c - builds the JSON object of one room. */
#include "reports/availability_json.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "reports/parts/json.h"
#include "model/light/sky.h"

static const char *const origins[] = {
    [PP_LIGHT_ILLUMINANCE] = "weather file, illuminance",
    [PP_LIGHT_IRRADIANCE] = "weather file, irradiance",
    [PP_LIGHT_OVERCAST] = "overcast skies",
};

/* Adds a new object under a key; the object will be printed on one line. */
static struct json_object *line_under(struct json_object *object, const char *key)
{
    struct json_object *line = json_object_new_object();
    if (!pp_json_add(object, key, line))
        return NULL;
    pp_json_on_one_line(line);
    return line;
}

static bool add_light(struct json_object *object,
                      const struct pp_availability_sheet *sheet)
{
    struct json_object *light = json_object_new_object();
    return pp_json_add(object, "light", light)
           && pp_json_text(light, "origin", origins[sheet->origin])
           && pp_json_text(light, "about", sheet->light)
           && pp_json_text(light, "calendar", sheet->calendar)
           && pp_json_number(light, "median", sheet->median_lx);
}

static bool add_periods(struct json_object *object,
                        const struct pp_availability_sheet *sheet)
{
    struct json_object *periods = json_object_new_object();
    bool good = pp_json_add(object, "hours", periods);
    for (int i = 0; i < sheet->period_count && good; i++) {
        const struct pp_availability_period *period = &sheet->periods[i];
        struct json_object *line = line_under(periods, period->words);
        good = line && pp_json_number(line, "counted", period->hours)
               && pp_json_number(line, "unknown", period->missing_h)
               && pp_json_number(line, "light", 100.0 * period->light)
               && pp_json_number(line, "lx_in_50", period->half_lx)
               && pp_json_number(line, "lx_in_85", period->most_lx);
    }
    return good;
}

static bool add_availability_value(struct json_object *object, double value,
                                   double std_error, const char *why)
{
    return pp_json_number(object, "value", value)
           && (!isfinite(std_error) || pp_json_number(object, "se", std_error))
           && (isfinite(value) || pp_json_text(object, "why", why));
}

/* Adds the results of one place by one method: the daylight factor and, for each
 * illuminance, the external illuminance required and the fraction of hours that reach
 * it. row: first of sheet->illuminance_count rows. */
static bool add_method(struct json_object *object,
                       const struct pp_availability_sheet *sheet,
                       const struct pp_availability_row *row)
{
    struct json_object *method = json_object_new_object();
    if (!pp_json_add(object, row->method, method))
        return false;
    struct json_object *df = line_under(method, "df");
    bool good = df
                && add_availability_value(df, 100.0 * row->df.value,
                                          100.0 * row->df.std_error, row->df.why);
    for (int i = 0; i < sheet->illuminance_count && good; i++, row++) {
        char key[32];
        snprintf(key, sizeof key, "%.10g", row->lx);
        struct json_object *wanted = json_object_new_object();
        good = pp_json_add(method, key, wanted)
               && pp_json_number(wanted, "needs", row->needs_lx);
        for (int k = 0; k < sheet->period_count && good; k++) {
            struct json_object *share = line_under(wanted, sheet->periods[k].words);
            good = share
                   && add_availability_value(share, 100.0 * row->share[k],
                                             100.0 * row->std_error[k], row->df.why);
        }
    }
    return good;
}

/* Adds the rows of a place, if there are any. Returns false if memory is exhausted. */
static bool add_place(struct json_object *object,
                      const struct pp_availability_sheet *sheet, int place)
{
    struct json_object *methods = NULL;
    bool good = true;
    for (int i = 0; i < sheet->row_count && good; i += sheet->illuminance_count) {
        if (sheet->rows[i].place != place)
            continue;
        if (!methods)
            good = pp_json_add(object, "by", methods = json_object_new_object());
        good = good && add_method(methods, sheet, &sheet->rows[i]);
    }
    return good;
}

static bool add_availability_points(struct json_object *object,
                                    const struct pp_availability_sheet *sheet)
{
    const struct pp_report *report = sheet->report;
    struct json_object *points = json_object_new_array();
    bool good = pp_json_add(object, "points", points);
    for (int i = 0; i < report->receiver_count && good; i++) {
        struct pp_vec3 at = report->receivers[i].position;
        struct json_object *point = json_object_new_object();
        good = pp_json_append(points, point) && pp_json_number(point, "x", at.x)
               && pp_json_number(point, "y", at.y) && pp_json_number(point, "z", at.z)
               && add_place(point, sheet, i);
    }
    return good;
}

/* Adds the results of a place under `key`. Adds nothing if the place has no rows. */
static bool add_whole_place(struct json_object *object,
                            const struct pp_availability_sheet *sheet, const char *key,
                            int place)
{
    bool there = false;
    for (int i = 0; i < sheet->row_count; i++)
        there |= sheet->rows[i].place == place;
    if (!there)
        return true;
    struct json_object *whole = json_object_new_object();
    return pp_json_add(object, key, whole) && add_place(whole, sheet, place);
}

static struct json_object *room(const void *all, int index)
{
    const struct pp_availability_results *results = all;
    const struct pp_availability_result *result = &results->list[index];
    const struct pp_report *report = &result->report;
    const struct pp_availability_sheet *sheet = &result->sheet;
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "format", "pepperpot-availability-1");
    if (good && results->more_than_one_file)
        good = pp_json_text(object, "file", result->file);
    good = good && pp_json_text(object, "room", report->world->name)
           && pp_json_text(object, "sky", pp_sky_name(&report->light.sky));
    if (good && !report->finished)
        good = pp_json_add(object, "finished", json_object_new_boolean(false));
    good = good && add_light(object, sheet) && add_periods(object, sheet)
           && add_availability_points(object, sheet)
           && add_whole_place(object, sheet, "median", PP_PLACE_MEDIAN)
           && add_whole_place(object, sheet, "average", PP_PLACE_AVERAGE);
    return pp_json_whole(object, good);
}

enum pp_status pp_availability_json(const struct pp_availability_results *results,
                                    FILE *out, struct pp_error *err)
{
    return pp_json_print_rooms(out, room, results, results->count, results->several,
                               err);
}
