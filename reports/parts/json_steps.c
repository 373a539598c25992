/* json_steps.c - see json_steps.h. */
#include "reports/parts/json_steps.h"

#include "reports/parts/json.h"
#include "reports/parts/json_room.h"

/* Adds a step. Values are in per cent and degrees where applicable. */
static bool add_step(struct json_object *object, const struct pp_world *world,
                     const struct pp_calculation_step *step)
{
    static const char *const units[] = {
        [PP_UNIT_DAYLIGHT_FACTOR] = "%",
        [PP_UNIT_NUMBER] = "",
        [PP_UNIT_COUNT] = "count",
        [PP_UNIT_ANGLE] = "degrees",
        [PP_UNIT_METRE] = "m",
        [PP_UNIT_SQUARE_METRE] = "m2",
        [PP_UNIT_LUX] = "lx",
    };
    return pp_json_text(object, "step", step->what)
           && (!step->symbol[0] || pp_json_text(object, "symbol", step->symbol))
           && (!step->formula[0] || pp_json_text(object, "formula", step->formula))
           && pp_json_number(object, "value",
                             pp_steps_printed_unit(step->unit) * step->value)
           && pp_json_text(object, "unit", units[step->unit])
           && (!step->line
               || (pp_json_add(object, "opening", json_object_new_int(step->line))
                   && pp_json_room_add_opening_names(object, world, step->line)));
}

bool pp_json_steps_add(struct json_object *object, const char *key,
                       const struct pp_world *world, const struct pp_steps *steps)
{
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, key, list);
    for (int i = 0; i < steps->count && good; i++) {
        struct json_object *step = json_object_new_object();
        good = pp_json_append(list, step) && add_step(step, world, &steps->list[i]);
    }
    return good;
}
