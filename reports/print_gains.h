/* print_gains.h - what holds a room back, and what changes to it would bring: the end
 * of its assessment.
 */
#ifndef PP_CLI_ASSESS_PRINT_GAINS_H
#define PP_CLI_ASSESS_PRINT_GAINS_H

#include <json.h>
#include <stdbool.h>
#include <stdio.h>

#include "studies/sizing/gains.h"

/* As text `width` columns wide (60 or more). */
void pp_print_gains(const struct pp_gains *gains, int width, FILE *out);

/* Adds "gains": { "method", "average", "darkest", "holds_back", "changes": [] }, values
 * in per cent. False when memory is out. */
bool pp_print_gains_json(struct json_object *object, const struct pp_gains *gains);

#endif
