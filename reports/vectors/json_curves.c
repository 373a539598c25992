/* json_curves.c - see json_curves.h. */
#include "reports/vectors/json_curves.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "reports/parts/json.h"

/* Appends one length, such as "1.2346", without trailing zeros. */
static bool append_length(struct json_object *list, double length)
{
    char digits[40];
    double rounded = round(length * 1e4) / 1e4;
    snprintf(digits, sizeof digits, "%.10g", rounded + 0.0);
    return pp_json_append(list, json_object_new_double_s(rounded, digits));
}

static struct json_object *length_list(const double *lengths, int count)
{
    struct json_object *list = json_object_new_array();
    bool good = list != NULL;
    for (int i = 0; i < count && good; i++)
        good = append_length(list, lengths[i]);
    if (good)
        pp_json_on_one_line(list);
    return pp_json_whole(list, good);
}

bool pp_json_curves_lengths(struct json_object *object, const char *key,
                            const double *lengths, int count)
{
    return pp_json_add(object, key, length_list(lengths, count));
}

bool pp_json_curves_list(struct json_object *object, const char *key,
                         const struct pp_curve_list *curves, double scale)
{
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, key, list);
    for (int i = 0; i < curves->count && good; i++) {
        const struct pp_curve *curve = &curves->list[i];
        struct json_object *item = json_object_new_object();
        good = pp_json_append(list, item)
               && (scale == 0.0 || pp_json_number(item, "level", scale * curve->level))
               && pp_json_add(item, "closed", json_object_new_boolean(curve->closed))
               && pp_json_curves_lengths(item, "xy", *curve->xy, 2 * curve->count);
        if (good)
            pp_json_on_one_line(item);
    }
    return good;
}

bool pp_json_curves_region(struct json_object *object, const char *key,
                           const struct pp_region *region)
{
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, key, list);
    for (int i = 0; i < region->count && good; i++)
        good = pp_json_append(
            list, length_list(*region->rings[i].xy, 2 * region->rings[i].count));
    return good;
}
