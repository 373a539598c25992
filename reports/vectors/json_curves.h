/* json_curves.h - lines and outlines in a plane as JSON: flat lists of coordinates in
 * metres, rounded to 0.1 mm. */
#ifndef PP_REPORTS_VECTORS_JSON_CURVES_H
#define PP_REPORTS_VECTORS_JSON_CURVES_H

#include <json.h>
#include <stdbool.h>

#include "model/geometry/curve.h"
#include "model/geometry/region.h"

/* Each function adds a value under a key. Returns false if memory is exhausted. */

/* Adds a list of lengths in metres, rounded to 0.1 mm. */
bool pp_json_curves_lengths(struct json_object *object, const char *key,
                            const double *lengths, int count);

/* Adds [{ "level": 2, "closed": true, "xy": [x, y, x, y, ...] }]. The level is
 * multiplied by `scale`; it is omitted if scale is 0. */
bool pp_json_curves_list(struct json_object *object, const char *key,
                         const struct pp_curve_list *curves, double scale);

/* Adds [[x, y, ...]], the rings of a region. Holes are clockwise. */
bool pp_json_curves_region(struct json_object *object, const char *key,
                           const struct pp_region *region);

#endif
