/* rules_list.h - the table of rules of countries and schemes, for readers. */
#ifndef PP_REPORTS_ASSESS_RULES_LIST_H
#define PP_REPORTS_ASSESS_RULES_LIST_H

#include <stdio.h>

#include "model/base/error.h"

/* Prints all rules by name, each with its rows, certainty and source. */
void pp_rules_list_text(int width, FILE *out);

/* Prints a line for each row, or an object. */
void pp_rules_list_csv(FILE *out);
enum pp_status pp_rules_list_json(FILE *out, struct pp_error *err);

#endif
