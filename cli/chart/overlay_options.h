/* overlay_options.h - what overlays show, for which lens, how large. */
#ifndef PP_CLI_CHART_OVERLAY_OPTIONS_H
#define PP_CLI_CHART_OVERLAY_OPTIONS_H

#include "cli/options.h"

extern const struct pp_option pp_overlay_options[]; /* of struct pp_overlay_options */

#endif
