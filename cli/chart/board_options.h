/* board_options.h - options of drawing-board charts. */
#ifndef PP_CLI_CHART_BOARD_OPTIONS_H
#define PP_CLI_CHART_BOARD_OPTIONS_H

#include "api/chart_kind.h"
#include "cli/room_options.h"

pp_option_reader pp_board_options_read_yes_no; /* enum pp_yes_no: "yes" or "no" */
pp_option_reader
    pp_board_options_read_receiver; /* enum pp_yes_no: "vertical" or "horizontal" */
pp_option_reader pp_board_options_read_protractor; /* int, 1 to 10 */
pp_option_reader pp_board_options_read_slope; /* struct pp_board_options: 0 to 90 */
pp_option_reader
    pp_board_options_read_inclined;           /* struct pp_board_options: -90 to 90 */
pp_option_reader pp_board_options_read_slats; /* struct pp_board_options */
pp_option_reader pp_board_options_read_nomogram;   /* struct pp_board_options: name of a
                                                  * nomogram */
pp_option_reader pp_board_options_read_viewing_mm; /* double, 5 to 200 */

/* Checks the options for this kind of chart, which is blank or for a room. Sets
 * defaults, and the sky of a blank chart. */
enum pp_status pp_board_options_check(struct pp_board_options *board,
                                      const struct pp_room_options *options,
                                      const struct pp_chart_kind *kind, bool blank,
                                      struct pp_error *err);

#endif
