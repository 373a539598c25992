/* json_curves.h - lines and outlines in a plane as JSON: flat lists of metres to 0.1 mm. */
#ifndef PP_REPORTS_VECTORS_JSON_CURVES_H
#define PP_REPORTS_VECTORS_JSON_CURVES_H

#include <json.h>
#include <stdbool.h>

#include "model/geometry/curve.h"
#include "model/geometry/region.h"

/* Each function adds a value under a key; false: out of memory. */

/* Lengths in metres, each rounded to 0.1 mm. */
bool pp_json_curves_lengths(struct json_object *object, const char *key,
                            const double *lengths, int count);

/* [{ "level": 2, "closed": true, "xy": [x, y, x, y, ...] }]; the level is multiplied by
 * `scale`. With scale 0 there is no level. */
bool pp_json_curves_list(struct json_object *object, const char *key,
                         const struct pp_curve_list *curves, double scale);

/* [[x, y, ...]]: the rings of a region, holes clockwise. */
bool pp_json_curves_region(struct json_object *object, const char *key,
                           const struct pp_region *region);

#endif
