/* annual_figure.h - a figure with its standard error, as JSON. */
#ifndef PP_REPORTS_ANNUAL_ANNUAL_FIGURE_H
#define PP_REPORTS_ANNUAL_ANNUAL_FIGURE_H

#include <json.h>
#include <stdbool.h>

#include "model/results/sheets/annual_value.h"

/* Adds "key": {"value": 1, "se": 2} on one line, both multiplied by `unit`. If the
 * value is not finite, adds {"value": null, "why": why}. Returns false if memory is
 * exhausted. */
bool pp_annual_figure_json(struct json_object *object, const char *key,
                           const struct pp_annual_value *figure, double unit,
                           const char *why);

#endif
