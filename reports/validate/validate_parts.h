/* validate_parts.h - the parts of the differences found by `validate` that are due to
 * assumption and formula (studies/research/validation/own_world.h), within its text,
 * JSON and CSV. */
#ifndef PP_REPORTS_VALIDATE_VALIDATE_PARTS_H
#define PP_REPORTS_VALIDATE_VALIDATE_PARTS_H

#include <stdio.h>

#include "reports/parts/json.h"
#include "studies/research/validation/comparison.h"

/* Prints tables of the components that a method calculates for an idealised room or
 * sky, with the shares of the average's difference and of the bias. Prints nothing and
 * returns false if there are none. */
bool pp_validate_parts_print(const struct pp_comparison *list, int count, FILE *out);

/* Prints the same tables over all rooms. */
void pp_validate_parts_print_all(const struct pp_overall *list, int count, FILE *out);

/* Note that explains the tables, for the end of a text that has any. */
extern const char pp_validate_parts_note[];

/* Adds the known parts to the object of a comparison; false: out of memory. */
bool pp_validate_parts_json(struct json_object *object,
                            const struct pp_comparison *one);
bool pp_validate_parts_json_all(struct json_object *object,
                                const struct pp_overall *one);

/* Names of the fields at the end of a line, and the fields, each after a comma. */
extern const char pp_validate_parts_csv_names[];
void pp_validate_parts_csv(const struct pp_comparison *one, FILE *out);

#endif
