/* board_options.h - options of the charts that are worked at the drawing board. */
#ifndef PP_CLI_CHART_BOARD_OPTIONS_H
#define PP_CLI_CHART_BOARD_OPTIONS_H

#include "charts/chart_kind.h"
#include "cli/room_options.h"
#include "model/light/glass.h"
#include "model/results/nomogram_sheet.h"
#include "model/light/sky.h"

enum pp_yes_no { PP_UNSAID, PP_YES, PP_NO };

struct pp_board_options {
    enum pp_yes_no glazed;   /* a blank: with clear single glass? unsaid: yes */
    bool fine;               /* pepper-pot: dots worth 0.01 % */
    enum pp_yes_no vertical; /* a blank pepper-pot's receiver; unsaid: no */
    double viewing_mm; /* pepper-pot: from the eye to the drawing; 0: 30, fine 60 */
    struct pp_sky sky; /* of a blank; set by pp_board_options_check */

    int number;          /* a blank protractor of the ten; 0: not said */
    const char *glazing; /* or of any glazing, "none" too; NULL: not said */
    double slope_deg;    /* of that glazing, by --slope, */
    bool slope_said;     /* if it was */
    bool any_protractor; /* not one of the ten by number: what follows is it; set by
                          * pp_board_options_check */
    struct pp_glass glass;
    double slope_rad;
    char glass_words[72];

    enum pp_nomogram_kind nomogram; /* by --which, */
    bool nomogram_said;             /* if it was */
};

pp_option_reader pp_board_options_read_yes_no; /* enum pp_yes_no, "yes" or "no" */
pp_option_reader
    pp_board_options_read_receiver; /* the same, "vertical" or "horizontal" */
pp_option_reader pp_board_options_read_protractor; /* int, 1 to 10 */
pp_option_reader pp_board_options_read_slope;    /* struct pp_board_options, 0 to 90 */
pp_option_reader pp_board_options_read_nomogram; /* struct pp_board_options, by name */
pp_option_reader pp_board_options_read_viewing_mm; /* double, 5 to 200 */

/* Do the options make sense for the kind, blank or with a room? Sets what is left open
 * and the blank's sky. */
enum pp_status pp_board_options_check(struct pp_board_options *board,
                                      const struct pp_room_options *options,
                                      const struct pp_chart_kind *kind, bool blank,
                                      struct pp_error *err);

#endif
