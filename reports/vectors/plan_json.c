/* plan_json.c - makes the JSON object of a plan. */
#include "reports/vectors/plan_json.h"

#include "reports/parts/json.h"
#include "reports/vectors/json_curves.h"

/* Adds the value and position of an extreme: { "value": 0.6, "x": 1.5, "y": 8.5 }. */
static bool add_extreme(struct json_object *object, const char *key, double factor,
                        const double xy[2])
{
    struct json_object *item = json_object_new_object();
    bool good = pp_json_add(object, key, item)
                && pp_json_number(item, "value", 100.0 * factor)
                && pp_json_number(item, "x", xy[0]) && pp_json_number(item, "y", xy[1]);
    if (good)
        pp_json_on_one_line(item);
    return good;
}

enum pp_status pp_plan_json(const struct pp_plan_study *study, FILE *out,
                            struct pp_error *err)
{
    const struct pp_daylight_plan *plan = &study->plan;
    struct json_object *object = json_object_new_object();
    bool good =
        object && pp_json_text(object, "format", "pepperpot-plan-1")
        && pp_json_text(object, "room", study->report.world->name)
        && pp_json_text(object, "method", plan->name)
        && (!study->note[0] || pp_json_text(object, "note", study->note))
        && pp_json_add(object, "direct", json_object_new_boolean(plan->direct))
        && add_extreme(object, "lowest", plan->lowest, plan->lowest_xy)
        && add_extreme(object, "highest", plan->highest, plan->highest_xy)
        && pp_json_number(object, "average", 100.0 * study->figures.average.value)
        && pp_json_number(object, "sky-share", 100.0 * plan->sky_share)
        && pp_json_curves_list(object, "contours", &plan->contours, 100.0)
        && pp_json_curves_list(object, "below", &plan->below, 100.0)
        && pp_json_curves_list(object, "no-sky", &plan->no_sky, 0.0)
        && pp_json_curves_list(object, "dark", &plan->dark, 0.0);
    return pp_json_print(out, pp_json_whole(object, good), err);
}
