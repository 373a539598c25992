/* advice_report.c - writes sentences on the best methods and their bands, and on the
 * next best methods. */
#include "reports/atlas/advice_report.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/text.h"
#include "reports/parts/print.h"
#include "studies/bands/band_words.h"

enum { TEXT = 1600, REGIME = 400, NAMED_POINTS = 4 };

/* A median ratio is reported as a bias if it differs from 1 by at least this. */
static const double bias_least = 0.05;

/* Appends a recommendation: "Use exact+bre for the average, corrected by the median of
 * its range: 2.2 %" or "For 17 points (1.5,0.5: 3.1 %; ...) use exact+bre, corrected by
 * the median of its range". */
static void append_place(char text[TEXT], const struct pp_advice_item *item,
                         const struct pp_report *report)
{
    if (item->of_average) {
        pp_text_append(text, TEXT, "Use %s for the average", item->best.column);
        if (item->corrected)
            pp_text_append(text, TEXT,
                           ", corrected by the median of its range: %.3g %%",
                           100.0 * item->corrected[0]);
        return;
    }
    pp_text_append(text, TEXT, "For %d point%s (", item->point_count,
                   item->point_count == 1 ? "" : "s");
    for (int i = 0; i < item->point_count; i++) {
        struct pp_vec3 at = report->receivers[item->points[i]].position;
        bool last = i == item->point_count - 1;
        if (i == NAMED_POINTS - 1 && !last) {
            pp_text_append(text, TEXT, "; ...");
            i = item->point_count - 2;
            continue;
        }
        pp_text_append(text, TEXT, "%s%.3g,%.3g", i > 0 ? "; " : "", at.x, at.y);
        if (item->corrected)
            pp_text_append(text, TEXT, ": %.3g %%", 100.0 * item->corrected[i]);
    }
    pp_text_append(text, TEXT, ") use %s%s", item->best.column,
                   item->corrected ? ", corrected by the median of its range" : "");
}

static void append_bias(char text[TEXT], const struct pp_band_quantiles *ratio)
{
    if (fabs(ratio->median - 1.0) < bias_least)
        return;
    pp_text_append(text, TEXT,
                   "; the method tends to be too %s there; %.2f times its value is a "
                   "better estimate",
                   ratio->median < 1.0 ? "high" : "low", ratio->median);
}

static void append_parts(char text[TEXT], const struct pp_band_entry *entry)
{
    if (isfinite(entry->formula.low))
        pp_text_append(text, TEXT,
                       "; the formula alone accounts for %.2f to %.2f, the method's "
                       "assumptions about ground and surroundings for %.2f to %.2f",
                       entry->formula.low, entry->formula.high, entry->assumption.low,
                       entry->assumption.high);
}

static void append_others(char text[TEXT], const struct pp_advice_item *item)
{
    for (int i = 0; i < item->other_count; i++) {
        const struct pp_band_quantiles *ratio = &item->others[i].entry.regime.ratio;
        pp_text_append(text, TEXT, "%s%s %.2f to %.2f", i == 0 ? ". Next: " : ", ",
                       item->others[i].column, ratio->low, ratio->high);
    }
}

static void put_item(const struct pp_advice_item *item, const struct pp_report *report,
                     int width, FILE *out)
{
    const struct pp_band_entry *best = &item->best.entry;
    char text[TEXT] = "", regime[REGIME];
    pp_band_words_regime(regime, sizeof regime, &best->regime);
    append_place(text, item, report);
    pp_text_append(text, TEXT,
                   ". In %d similar rooms of the atlas (%s), the simulated value was "
                   "%.2f to %.2f times the method's in 95 %%",
                   best->regime.rooms, regime, best->regime.ratio.low,
                   best->regime.ratio.high);
    append_bias(text, &best->regime.ratio);
    append_parts(text, best);
    append_others(text, item);
    fputs("  - ", out);
    pp_print_wrapped(text, 4, 4, width, out);
}

void pp_advice_report(const struct pp_advice *advice, const struct pp_report *report,
                      int width, FILE *out)
{
    fputs("\n  Recommended methods\n\n", out);
    if (advice->why_not[0]) {
        fputs("  ", out);
        pp_print_wrapped(advice->why_not, 2, 2, width, out);
    }
    for (int i = 0; i < advice->count; i++)
        put_item(&advice->items[i], report, width, out);
}

/* ---- JSON ---- */

static bool add_ratio(struct json_object *object, const char *key,
                      const struct pp_band_quantiles *ratio)
{
    const double ends[] = {ratio->low, ratio->median, ratio->high};
    return !isfinite(ratio->low) || pp_json_numbers(object, key, ends, 3);
}

static bool add_advice_points(struct json_object *object,
                              const struct pp_advice_item *item)
{
    struct json_object *points = json_object_new_array();
    bool good = pp_json_add(object, "points", points);
    if (good)
        pp_json_on_one_line(points);
    for (int i = 0; i < item->point_count && good; i++)
        good = pp_json_append(points, json_object_new_int(item->points[i]));
    return good;
}

/* Adds the corrected values in per cent: a number for the average, a list for
 * points. */
static bool add_corrected(struct json_object *object, const struct pp_advice_item *item)
{
    if (!item->corrected)
        return true;
    if (item->of_average)
        return pp_json_number(object, "corrected", 100.0 * item->corrected[0]);
    double *per_cent = malloc(((size_t)item->point_count + 1) * sizeof *per_cent);
    for (int i = 0; i < item->point_count && per_cent; i++)
        per_cent[i] = 100.0 * item->corrected[i];
    bool good =
        per_cent && pp_json_numbers(object, "corrected", per_cent, item->point_count);
    free(per_cent);
    return good;
}

static bool add_others(struct json_object *object, const struct pp_advice_item *item)
{
    struct json_object *others = json_object_new_object();
    bool good = pp_json_add(object, "others", others);
    for (int i = 0; i < item->other_count && good; i++)
        good = add_ratio(others, item->others[i].column,
                         &item->others[i].entry.regime.ratio);
    return good;
}

static bool add_item(struct json_object *list, const struct pp_advice_item *item)
{
    const struct pp_band_entry *best = &item->best.entry;
    char regime[REGIME];
    struct json_object *object = json_object_new_object();
    pp_band_words_regime(regime, sizeof regime, &best->regime);
    return pp_json_append(list, object)
           && pp_json_text(object, "of", item->of_average ? "average" : "points")
           && (item->of_average || add_advice_points(object, item))
           && pp_json_text(object, "use", item->best.column)
           && add_corrected(object, item) && pp_json_text(object, "regime", regime)
           && pp_json_add(object, "rooms", json_object_new_int(best->regime.rooms))
           && add_ratio(object, "ratio", &best->regime.ratio)
           && add_ratio(object, "formula", &best->formula)
           && add_ratio(object, "assumption", &best->assumption)
           && add_others(object, item);
}

bool pp_advice_report_json(struct json_object *object, const struct pp_advice *advice)
{
    if (advice->why_not[0])
        return pp_json_text(object, "advice", NULL)
               && pp_json_text(object, "no-advice", advice->why_not);
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, "advice", list);
    for (int i = 0; i < advice->count && good; i++)
        good = add_item(list, &advice->items[i]);
    return good;
}
