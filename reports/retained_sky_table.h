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

/* Adds one line for each place. altitudes_rad: of a plane for each, INFINITY: none;
 * NULL: there are no planes. False: out of memory. */
bool pp_retained_sky_table_fill(struct pp_table *table,
                                const struct pp_retained_sky *dues,
                                enum pp_retained_sky_of of, int deciding,
                                const double *altitudes_rad);

/* Adds "windows" or "rooms", with one object each. */
bool pp_retained_sky_table_json(struct json_object *object,
                                const struct pp_retained_sky *dues,
                                enum pp_retained_sky_of of, int deciding,
                                const double *altitudes_rad);

/* Prints below a table at which point the components of full-height windows are
 * calculated, if not at their centre; `width` columns. */
void pp_retained_sky_table_point(const struct pp_retained_sky_rule *rule, int width,
                                 FILE *out);

#endif
