/* rules_list.h - prints the table of rules of countries and schemes. */
#ifndef PP_REPORTS_ASSESS_RULES_LIST_H
#define PP_REPORTS_ASSESS_RULES_LIST_H

#include <stdio.h>

#include "model/base/error.h"

/* Prints all rules, grouped by name. Each row has its state, certainty, source and
 * note. */
void pp_rules_list_text(int width, FILE *out);

/* Print each row of the table as a line of CSV or as a JSON object. */
void pp_rules_list_csv(FILE *out);
enum pp_status pp_rules_list_json(FILE *out, struct pp_error *err);

#endif
