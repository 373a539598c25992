/* pepper_pot_sheet_fill.h - fills a sheet of the pepper-pot diagram
 * (model/results/board_sheets.h): dots, and the windows of a room with their counted
 * dots. */
#ifndef PP_METHODS_PEPPER_POT_PEPPER_POT_SHEET_FILL_H
#define PP_METHODS_PEPPER_POT_PEPPER_POT_SHEET_FILL_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/results/board_sheets.h"
#include "model/room/world.h"

/* Fills a sheet without windows, for a horizontal receiver or a vertical one that faces
 * the window. Refuses skies other than overcast and uniform, and a worth outside 1e-5
 * ... 0.1. The caller clears the sheet; empty on failure. */
enum pp_status pp_pepper_pot_sheet_fill_blank(struct pp_pepper_pot_sheet *sheet,
                                              const struct pp_sky *sky, bool glazed,
                                              bool upright, double worth,
                                              struct pp_error *err);

/* Fills the sheet with the room's windows as seen from the receiver: a panel for each
 * direction that windows face, with glass and without. A room without openings has one
 * blank panel. If `pepper-pot` refuses the room, the dots are those of
 * `pepper-pot-sky`. If both methods refuse the room, the result is PP_BAD_INPUT with
 * the reason of `pepper-pot`. With a worth of 0.1 % the sums are the components by the
 * method used. */
enum pp_status pp_pepper_pot_sheet_fill_room(struct pp_pepper_pot_sheet *sheet,
                                             const struct pp_world *world,
                                             const struct pp_outside_light *light,
                                             const struct pp_receiver *receiver,
                                             double worth, struct pp_error *err);

/* Removes the windows from a sheet again, for an exercise in which they are drawn by
 * hand. */
void pp_pepper_pot_sheet_fill_unsolved(struct pp_pepper_pot_sheet *sheet);

#endif
