/* df_json.c - makes the JSON object of one room: its points and the average, with the
 * values by every method. */
#include "reports/df_json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reports/atlas/advice_report.h"
#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "reports/parts/json_steps.h"
#include "reports/parts/print_band.h"
#include "reports/parts/print_reliability.h"
#include "methods/variant.h"
#include "reports/parts/json_room.h"
#include "methods/method.h"
#include "model/light/sky.h"
#include "studies/engines/engine.h"

/* Adds the corrections that a method's figures include. Adds nothing for a pair of two
 * methods. */
static bool add_contents(struct json_object *object, const char *name)
{
    char contents[160];
    const struct pp_method *method = pp_method_find(name);
    if (!method)
        return true;
    pp_allowance_words(contents, sizeof contents, method->allowances);
    return pp_json_text(object, "contains", contents);
}

/* Makes { "value": 1.25, "se": 0.01 } or { "value": null, "why": "..." }, with "band":
 * [1.1, 1.6] if known. name: name of the column; truth: reading of the reference engine
 * at the same place; NULL: none. If truth is given, adds "apart", the difference
 * between both readings divided by the standard error of that difference. If
 * external_lux is above 0, adds the illuminance. */
static struct json_object *entry(const struct pp_world *world,
                                 const struct pp_reading *reading, const char *name,
                                 const struct pp_reading *truth,
                                 struct pp_band_ends band, double external_lux)
{
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_number(object, "value", 100.0 * reading->value);
    if (good && isfinite(reading->std_error))
        good = pp_json_number(object, "se", 100.0 * reading->std_error);
    if (good && truth && isfinite(pp_reading_apart(reading, truth)))
        good = pp_json_number(object, "apart", pp_reading_apart(reading, truth));
    good = good && pp_print_band_json(object, band);
    if (good && external_lux > 0.0)
        good = pp_json_number(object, "lux", external_lux * reading->value);
    if (good && !isfinite(reading->value))
        good =
            pp_json_text(object, "why", reading->why ? reading->why : "not computed");
    if (good && reading->steps)
        good = add_contents(object, name)
               && pp_json_steps_add(object, "steps", world, reading->steps);
    return pp_json_whole(object, good);
}

/* Indices that stand for an average instead of a receiver. */
enum { OF_AVERAGE = -1, OF_MARGIN_AVERAGE = -2 };

static const struct pp_reading *df_reading(const struct pp_column *column, int index)
{
    return index == OF_AVERAGE          ? &column->average
           : index == OF_MARGIN_AVERAGE ? &column->margin_average
                                        : &column->points[index];
}

static struct pp_band_ends band_of(const struct pp_column *column, int index)
{
    return index == OF_AVERAGE           ? column->average_band
           : index >= 0 && column->bands ? column->bands[index]
                                         : pp_band_none();
}

/* Column to which an engine's daylight factors are compared. NULL: `column` is the
 * reference, or has no daylight factors of an engine. */
static const struct pp_column *truth_for(const struct pp_report *report,
                                         const struct pp_column *column)
{
    const struct pp_column *truth = pp_engine_truth(report);
    return column->component == PP_DF && column != truth
                   && pp_engine_of_column(column->name)
               ? truth
               : NULL;
}

/* Adds "sc" ... "df" with the value of each method at a place. A component without any
 * column is omitted. */
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
        const struct pp_column *truth = truth_for(report, column);
        if (!pp_json_add(*component, column->name,
                         entry(report->world, df_reading(column, index), column->name,
                               truth ? df_reading(truth, index) : NULL,
                               band_of(column, index),
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

static bool add_df_points(struct json_object *object, const struct pp_report *report,
                          double external_lux)
{
    struct json_object *points = json_object_new_array();
    bool good = pp_json_add(object, "points", points);
    for (int i = 0; i < report->receiver_count && good; i++)
        good = pp_json_append(points, point(report, i, external_lux));
    return good;
}

/* Adds "variants": a list of objects such as { "column": "bre-variant", "method":
 * "bre", "formula": "irc = ..." }.
 */
static bool add_variants(struct json_object *object,
                         const struct pp_variant_list *variants)
{
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, "variants", list);
    for (int i = 0; i < variants->count && good; i++) {
        const struct pp_variant *variant = &variants->list[i];
        struct json_object *one = json_object_new_object();
        char text[sizeof variant->formula + 8];
        snprintf(text, sizeof text, "%s = %s", variant->formula.symbol,
                 variant->formula.sum);
        good = pp_json_append(list, one) && pp_json_text(one, "column", variant->name)
               && pp_json_text(one, "method", variant->method->name)
               && pp_json_text(one, "formula", text);
    }
    return good;
}

/* Makes the object of a value and its standard error: { "value": 1.25, "se": 0.01 }. */
static struct json_object *plane_entry(const struct pp_reading *reading)
{
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_number(object, "value", 100.0 * reading->value);
    if (good && isfinite(reading->std_error))
        good = pp_json_number(object, "se", 100.0 * reading->std_error);
    return pp_json_whole(object, good);
}

static struct json_object *plane_reading_object(const struct pp_plane_reading *plane)
{
    struct json_object *object = json_object_new_object();
    struct json_object *over = json_object_new_array();
    bool good = object && pp_json_add(object, "minimum", plane_entry(&plane->minimum))
                && pp_json_add(object, "median", plane_entry(&plane->median))
                && pp_json_add(object, "mean", plane_entry(&plane->average))
                && pp_json_number(object, "uniformity", plane->uniformity);
    if (!good)
        json_object_put(over);
    else
        good = pp_json_add(object, "over", over);
    for (int i = 0; i < PP_PLANE_LEVELS && good; i++) {
        struct json_object *share = json_object_new_object();
        good = pp_json_append(over, share)
               && pp_json_number(share, "level", 100.0 * pp_plane_levels[i])
               && pp_json_number(share, "share", 100.0 * plane->over[i]);
    }
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

/* Adds "grid": statistics over the plane, calculated from the daylight factors at the
 * points of a grid. */
static bool add_grid(struct json_object *object, const struct pp_report *report)
{
    struct json_object *grid = json_object_new_object();
    struct json_object *factors = json_object_new_object();
    bool good = pp_json_add(object, "grid", grid);
    if (!good)
        json_object_put(factors);
    else
        good = pp_json_add(grid, "points", json_object_new_int(report->grid_points))
               && pp_json_text(grid, "standard",
                               report->grid_of_standard ? "EN 17037" : NULL)
               && pp_json_add(grid, pp_component_names[PP_DF], factors);
    for (int i = 0; i < report->column_count && good; i++)
        if (report->columns[i].has_plane)
            good = pp_json_add(factors, report->columns[i].name,
                               plane_reading_object(&report->columns[i].plane));
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
               && pp_json_text(object, "sky", pp_sky_name(&report->light.sky));
    good = good && pp_json_warnings(object, result->doubts);
    if (good && results->options->method_options.variants)
        good = add_variants(object, results->options->method_options.variants);
    if (good && report->stand_in)
        good = pp_json_text(object, "stand-in", report->stand_in);
    if (good && report->missed_error)
        good = pp_json_text(object, "missed-error", report->missed_error);
    if (good && report->no_bands)
        good = pp_json_text(object, "no-bands", report->no_bands);
    double lux = results->options->external_lux;
    if (good && lux > 0.0)
        good = pp_json_number(object, "external", lux);
    if (good && results->options->simulate)
        good = pp_json_simulation(object, results->options, result->by_clock);
    if (good && !report->finished)
        good = pp_json_add(object, "finished", json_object_new_boolean(false));
    struct pp_reliability reliability = pp_reliability_of(report);
    good = good && pp_print_reliability_json(object, &reliability);
    if (good && result->has_advice)
        good = pp_advice_report_json(object, &result->advice);
    struct json_object *average = NULL;
    if (good)
        good = add_df_points(object, report, lux)
               && pp_json_add(object, "average", average = json_object_new_object())
               && add_readings(average, report, OF_AVERAGE, lux);
    if (good && report->column_count > 0 && report->columns[0].has_margin_average)
        good = pp_json_add(object, "average-margin", average = json_object_new_object())
               && add_readings(average, report, OF_MARGIN_AVERAGE, lux);
    if (good && report->grid_points > 0)
        good = add_grid(object, report);
    if (good)
        good = pp_json_room_add(object, report->world, &report->light);
    return pp_json_whole(object, good);
}

enum pp_status pp_df_json(const struct pp_results *results, FILE *out,
                          struct pp_error *err)
{
    return pp_json_print_rooms(out, room, results, results->count, results->several,
                               err);
}
