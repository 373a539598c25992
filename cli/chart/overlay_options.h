/* overlay_options.h - what overlays show, for which lens, how large. */
#ifndef PP_CLI_CHART_OVERLAY_OPTIONS_H
#define PP_CLI_CHART_OVERLAY_OPTIONS_H

#include "cli/options.h"

/* All of struct pp_board_options. */
pp_option_reader pp_overlay_options_read_lens;     /* by name */
pp_option_reader pp_overlay_options_read_diameter; /* mm, 20 to 400 */
pp_option_reader pp_overlay_options_read_show;     /* dots, cells, sun, with commas */

#endif
