/* retained_sky_table.h - the sky that windows or rooms have and retain
 * (studies/sizing/retained_sky.h), in words, as a table and as JSON. */
#ifndef PP_REPORTS_RETAINED_SKY_TABLE_H
#define PP_REPORTS_RETAINED_SKY_TABLE_H

#include <stdbool.h>

#include "reports/parts/json.h"
#include "reports/parts/table.h"
#include "studies/sizing/retained_sky.h"

/* Appends "0.8 of its vertical sky component, or 27 %". */
void pp_retained_sky_table_say(char *text, size_t size,
                               const struct pp_retained_sky_rule *rule);

/* A line each. altitudes_rad: of a plane for each, INFINITY: it has none; NULL: there are
 * no planes. False when memory is out. */
bool pp_retained_sky_table_fill(struct pp_table *table,
                                const struct pp_retained_sky *dues,
                                enum pp_retained_sky_of of, int deciding,
                                const double *altitudes_rad);

/* Adds "windows" or "rooms", an object each. */
bool pp_retained_sky_table_json(struct json_object *object,
                                const struct pp_retained_sky *dues,
                                enum pp_retained_sky_of of, int deciding,
                                const double *altitudes_rad);

/* Below a table: where the components of windows down to the floor are taken, if not at
 * their middle; `width` columns. */
void pp_retained_sky_table_point(const struct pp_retained_sky_rule *rule, int width,
                                 FILE *out);

#endif
