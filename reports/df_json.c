/* df_json.c - builds the JSON object of one room: its points, the average, and the readings
 * of every method there. */
#include "reports/df_json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "methods/method.h"
#include "model/light/sky.h"

/* As numbers and units are written outside: per cent and degrees. */
static bool add_step(struct json_object *object, const struct pp_calculation_step *step)
{
    static const struct {
        double scale;
        const char *name;
    } units[] = {
        [PP_UNIT_SHARE] = {100.0, "%"},   [PP_UNIT_NUMBER] = {1.0, ""},
        [PP_UNIT_COUNT] = {1.0, "count"}, [PP_UNIT_ANGLE] = {1.0 / PP_RAD, "degrees"},
        [PP_UNIT_METRE] = {1.0, "m"},     [PP_UNIT_SQUARE_METRE] = {1.0, "m2"},
        [PP_UNIT_LUX] = {1.0, "lx"},
    };
    return pp_json_text(object, "step", step->what)
           && (!step->symbol[0] || pp_json_text(object, "symbol", step->symbol))
           && (!step->formula[0] || pp_json_text(object, "formula", step->formula))
           && pp_json_number(object, "value", units[step->unit].scale * step->value)
           && pp_json_text(object, "unit", units[step->unit].name)
           && (!step->line
               || pp_json_add(object, "opening", json_object_new_int(step->line)));
}

/* Adds "steps": [{ "step": "...", "symbol": "W", "formula": "...", "value": 1.25,
 * "unit": "%", "opening": 8 }]; symbol and formula where there are any, the line of the
 * opening where it is one's. */
static bool add_steps(struct json_object *object, const struct pp_steps *steps)
{
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, "steps", list);
    for (int i = 0; i < steps->count && good; i++) {
        struct json_object *step = json_object_new_object();
        good = pp_json_append(list, step) && add_step(step, &steps->list[i]);
    }
    return good;
}

/* What a method's figures have in them already; nothing of a pair, which is of two. */
static bool add_contents(struct json_object *object, const char *name)
{
    char contents[160];
    const struct pp_method *method = pp_method_find(name);
    if (!method)
        return true;
    pp_allowance_words(contents, sizeof contents, method->allowances);
    return pp_json_text(object, "contains", contents);
}

/* { "value": 1.25, "se": 0.01 } or { "value": null, "why": "..." }; name is the
 * column's. With external_lux over 0, the illuminance that is its share. */
static struct json_object *entry(const struct pp_reading *reading, const char *name,
                                 double external_lux)
{
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_number(object, "value", 100.0 * reading->value);
    if (good && isfinite(reading->std_error))
        good = pp_json_number(object, "se", 100.0 * reading->std_error);
    if (good && external_lux > 0.0)
        good = pp_json_number(object, "lux", external_lux * reading->value);
    if (good && !isfinite(reading->value))
        good =
            pp_json_text(object, "why", reading->why ? reading->why : "not computed");
    if (good && reading->steps)
        good = add_contents(object, name) && add_steps(object, reading->steps);
    return pp_json_whole(object, good);
}

/* Adds "sc" ... "df" with what every method says at receiver `index`, or of the average
 * for -1; a component that no method speaks of is left out. */
static bool add_readings(struct json_object *object, const struct pp_report *report,
                         int index, double external_lux)
{
    struct json_object *components[PP_COMPONENT_COUNT] = {NULL};
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (index >= 0 && !column->points)
            continue;
        struct json_object **component = &components[column->component];
        if (!*component) {
            *component = json_object_new_object();
            if (!pp_json_add(object, pp_component_names[column->component], *component))
                return false;
            pp_json_on_one_line(*component);
        }
        if (!pp_json_add(*component, column->name,
                         entry(index < 0 ? &column->average : &column->points[index],
                               column->name,
                               column->component == PP_DF ? external_lux : 0.0)))
            return false;
    }
    return true;
}

static struct json_object *point(const struct pp_report *report, int index,
                                 double external_lux)
{
    const struct pp_receiver *receiver = &report->receivers[index];
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_number(object, "x", receiver->position.x)
                && pp_json_number(object, "y", receiver->position.y)
                && pp_json_number(object, "z", receiver->position.z);
    if (good && receiver->normal.z != 1.0)
        good = pp_json_number(object, "nx", receiver->normal.x)
               && pp_json_number(object, "ny", receiver->normal.y)
               && pp_json_number(object, "nz", receiver->normal.z);
    if (good && add_readings(object, report, index, external_lux))
        return object;
    json_object_put(object);
    return NULL;
}

static bool add_points(struct json_object *object, const struct pp_report *report,
                       double external_lux)
{
    struct json_object *points = json_object_new_array();
    bool good = pp_json_add(object, "points", points);
    for (int i = 0; i < report->receiver_count && good; i++)
        good = pp_json_append(points, point(report, i, external_lux));
    return good;
}

static struct json_object *room(const void *all, int index)
{
    const struct pp_results *results = all;
    const struct pp_result *result = &results->list[index];
    const struct pp_report *report = &result->report;
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "format", "pepperpot-df-1");
    if (good && results->more_than_one_file)
        good = pp_json_text(object, "file", result->file);
    if (good)
        good = pp_json_text(object, "room", report->world->name)
               && pp_json_text(object, "sky", pp_sky_name(&report->world->sky));
    double lux = results->options->external_lux;
    if (good && lux > 0.0)
        good = pp_json_number(object, "external", lux);
    if (good && results->options->simulate)
        good = pp_json_simulation(object, results->options, result->by_clock);
    if (good && !report->finished)
        good = pp_json_add(object, "finished", json_object_new_boolean(false));
    struct json_object *average = NULL;
    if (good)
        good = add_points(object, report, lux)
               && pp_json_add(object, "average", average = json_object_new_object())
               && add_readings(average, report, -1, lux);
    return pp_json_whole(object, good);
}

enum pp_status pp_df_json(const struct pp_results *results, FILE *out,
                          struct pp_error *err)
{
    return pp_json_print_rooms(out, room, results, results->count, results->several,
                               err);
}
