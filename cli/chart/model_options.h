/* model_options.h - the scale of a model, and the artificial sky that it is for. */
#ifndef PP_CLI_CHART_MODEL_OPTIONS_H
#define PP_CLI_CHART_MODEL_OPTIONS_H

#include "cli/options.h"

extern const struct pp_option pp_model_options[]; /* of struct pp_model_options */

#endif
