/* sheet_options.h - options for the sheet of paper, shared by several commands. */
#ifndef PP_CLI_CHART_SHEET_OPTIONS_H
#define PP_CLI_CHART_SHEET_OPTIONS_H

#include "pepperpot.h"
#include "cli/options.h"

pp_option_reader pp_sheet_options_read_paper;       /* enum pp_paper (canvas.h) */
pp_option_reader pp_sheet_options_read_orientation; /* enum pp_orientation */
pp_option_reader pp_sheet_options_read_dpi;         /* double, 20 to 1200 */

#endif
