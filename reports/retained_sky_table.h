/* retained_sky_table.h - the sky before and after a development at windows or rooms
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

/* Adds one line for each place; that of index `deciding` is marked. altitudes_rad:
 * altitude of the plane through each place; INFINITY: no plane there; NULL: no planes
 * at all. False: out of memory. */
bool pp_retained_sky_table_fill(struct pp_table *table,
                                const struct pp_retained_sky *dues,
                                enum pp_retained_sky_of of, int deciding,
                                const double *altitudes_rad);

/* Adds "windows" or "rooms", an array with one object for each. */
bool pp_retained_sky_table_json(struct json_object *object,
                                const struct pp_retained_sky *dues,
                                enum pp_retained_sky_of of, int deciding,
                                const double *altitudes_rad);

/* Prints a note, `width` columns wide, for below a table: the point at which the
 * vertical sky component of French windows is calculated, if that is not their
 * centre. */
void pp_retained_sky_table_point(const struct pp_retained_sky_rule *rule, int width,
                                 FILE *out);

#endif
