/* validate_parts.h - the two parts of the differences found by `validate`, due to
 * assumption and formula (studies/research/validation/own_world.h). The functions add
 * them to text, JSON and CSV. */
#ifndef PP_REPORTS_VALIDATE_VALIDATE_PARTS_H
#define PP_REPORTS_VALIDATE_VALIDATE_PARTS_H

#include <stdio.h>

#include "reports/parts/json.h"
#include "studies/research/validation/comparison.h"

/* Prints tables of the components that a method calculates for an idealised room or
 * sky, with the two parts of the difference in the average and of the bias. Prints
 * nothing and returns false if there are no such components. */
bool pp_validate_parts_print(const struct pp_comparison *list, int count, FILE *out);

/* Prints the same tables for the comparison over all rooms. */
void pp_validate_parts_print_all(const struct pp_overall *list, int count, FILE *out);

/* Note that explains the tables, to be printed at the end of a text that contains
 * them. */
extern const char pp_validate_parts_note[];

/* Add the known parts to the object of a comparison. Return false if memory is
 * exhausted. */
bool pp_validate_parts_json(struct json_object *object,
                            const struct pp_comparison *one);
bool pp_validate_parts_json_all(struct json_object *object,
                                const struct pp_overall *one);

/* Names of the last fields on a line, and function that writes the fields. Each is
 * preceded by a comma. */
extern const char pp_validate_parts_csv_names[];
void pp_validate_parts_csv(const struct pp_comparison *one, FILE *out);

#endif
