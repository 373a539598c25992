/* json_steps.h - the steps of a calculation as JSON. */
#ifndef PP_REPORTS_PARTS_JSON_STEPS_H
#define PP_REPORTS_PARTS_JSON_STEPS_H

#include <json.h>
#include <stdbool.h>

#include "model/results/steps.h"
#include "model/room/world.h"

/* Adds KEY: [{ "step": "...", "symbol": "W", "formula": "...", "value": 1.25, "unit":
 * "%", "opening": 8, "label": "W1" }]. symbol and formula are omitted if the step has
 * none. opening and label are present if the step is for one opening. */
bool pp_json_steps_add(struct json_object *object, const char *key,
                       const struct pp_world *world, const struct pp_steps *steps);

#endif
