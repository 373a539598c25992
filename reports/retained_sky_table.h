/* retained_sky_table.h - prints the sky before and after a development at windows or
 * rooms (studies/sizing/retained_sky.h), as text, table and JSON. */
#ifndef PP_REPORTS_RETAINED_SKY_TABLE_H
#define PP_REPORTS_RETAINED_SKY_TABLE_H

#include <stdbool.h>

#include "reports/parts/json.h"
#include "reports/parts/table.h"
#include "studies/sizing/retained_sky.h"

/* Appends the rule, such as "0.8 of its vertical sky component, or 27 %". */
void pp_retained_sky_table_say(char *text, size_t size,
                               const struct pp_retained_sky_rule *rule);

/* Adds one line for each place. The place with index `deciding` is marked.
 * altitudes_rad: altitude of the plane through each place; INFINITY: no plane there;
 * NULL: there are no planes. Returns false if memory is exhausted. */
bool pp_retained_sky_table_fill(struct pp_table *table,
                                const struct pp_retained_sky *dues,
                                enum pp_retained_sky_of of, int deciding,
                                const double *altitudes_rad);

/* Adds "windows" or "rooms", an array with one object for each place. */
bool pp_retained_sky_table_json(struct json_object *object,
                                const struct pp_retained_sky *dues,
                                enum pp_retained_sky_of of, int deciding,
                                const double *altitudes_rad);

/* Prints a note, in lines of `width` columns, to be placed below a table. The note
 * states the point for the vertical sky component of French windows, if it is not the
 * centre. */
void pp_retained_sky_table_point(const struct pp_retained_sky_rule *rule, int width,
                                 FILE *out);

#endif
