/* draw_board.h - from a room and a point, or from options alone, to a diagram of the
 * drawing board on a canvas. */
#ifndef PP_CLI_CHART_DRAW_BOARD_H
#define PP_CLI_CHART_DRAW_BOARD_H

#include "charts/sheet/canvas.h"
#include "model/light/glass.h"
#include "model/light/sky.h"
#include "model/results/nomogram_sheet.h"
#include "studies/study_room.h"

/* What a diagram shows where there is a choice. */
enum pp_yes_no { PP_UNSAID, PP_YES, PP_NO };

struct pp_board_options {
    enum pp_yes_no glazed;   /* a blank: with clear single glass? unsaid: yes */
    bool fine;               /* pepper-pot: dots worth 0.01 % */
    enum pp_yes_no vertical; /* a blank pepper-pot's receiver; unsaid: no */
    double viewing_mm; /* pepper-pot: from the eye to the drawing; 0: 30, fine 60 */
    struct pp_sky sky; /* of a blank; set by whoever asks */

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

/* room NULL: a blank; else it has one receiver, where the diagram is drawn from a
 * point. */
typedef enum pp_status pp_board_drawer(struct pp_canvas *canvas,
                                       const struct pp_study_room *room,
                                       const struct pp_board_options *options,
                                       struct pp_error *err);

pp_board_drawer pp_draw_board_waldram;
pp_board_drawer pp_draw_board_pepper_pot;
pp_board_drawer pp_draw_board_protractor;
pp_board_drawer pp_draw_board_nomogram;

#endif
