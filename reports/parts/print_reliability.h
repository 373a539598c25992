/* print_reliability.h - warnings about unreliable hand calculations, for the text below
 * a table and for JSON. */
#ifndef PP_REPORTS_PARTS_PRINT_RELIABILITY_H
#define PP_REPORTS_PARTS_PRINT_RELIABILITY_H

#include <json-c/json.h>
#include <stdio.h>

#include "studies/reliability.h"

/* Prints notes, each after a dash, on methods that assume another ground reflectance,
 * and on unreliable values. Prints nothing if there are neither. */
void pp_print_reliability(const struct pp_reliability *reliability, int width,
                          FILE *out);

/* Adds "reliability": { "relied_on": false, "why": "...", "kinds": [{ "kind":
 * "outside", "measure": 0.8, "of": "the average", "low": 0.96, "high": 4.6 }],
 * "grounds": "..." }. Members that do not apply are omitted. */
bool pp_print_reliability_json(struct json_object *object,
                               const struct pp_reliability *reliability);

#endif
