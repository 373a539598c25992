/* waldram_sheet_fill.h - fills a sheet of Waldram's diagram
 * (model/results/board_sheets.h): scales, droop lines, and the windows of a room with
 * their counted squares. */
#ifndef PP_METHODS_WALDRAM_WALDRAM_SHEET_FILL_H
#define PP_METHODS_WALDRAM_WALDRAM_SHEET_FILL_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/results/board_sheets.h"
#include "model/room/world.h"

/* Fills a sheet without windows. Refuses a sky with azimuth dependence. The caller
 * clears the sheet; empty on failure. */
enum pp_status pp_waldram_sheet_fill_blank(struct pp_waldram_sheet *sheet,
                                           const struct pp_sky *sky, bool glazed,
                                           struct pp_error *err);

/* Fills the sheet with the room's windows as seen from the receiver: a panel for each
 * direction that windows face, with glass and without. A room without openings has one
 * blank panel. PP_BAD_INPUT with the reason if the method `waldram` refuses the room.
 * The sums are the components by that method. */
enum pp_status pp_waldram_sheet_fill_room(struct pp_waldram_sheet *sheet,
                                          const struct pp_world *world,
                                          const struct pp_outside_light *light,
                                          const struct pp_receiver *receiver,
                                          struct pp_error *err);

/* Fills a sheet for a vertical receiver, without windows. Refuses a sky with azimuth
 * dependence. */
enum pp_status pp_waldram_sheet_fill_upright(struct pp_waldram_sheet *sheet,
                                             const struct pp_sky *sky,
                                             struct pp_error *err);

/* Fills the sheet for a point on the outside of a vertical opening, given by its index,
 * under the CIE overcast sky. The sheet has one window of two pieces, sky and
 * obstructions; only the squares of sky are counted. The sum is the vertical sky
 * component. */
enum pp_status pp_waldram_sheet_fill_site(struct pp_waldram_sheet *sheet,
                                          const struct pp_world *world, int opening,
                                          struct pp_vec3 point, struct pp_error *err);

/* Replaces the droop lines of perpendicular edges by those of horizontal edges at an
 * angle to the window in plan, on all panels of a filled sheet. incline_rad is the
 * azimuth at which the edge is nearest, -pi/2 to pi/2, positive to the right. The lines
 * are labelled with the altitude at that azimuth. */
enum pp_status pp_waldram_sheet_fill_inclined(struct pp_waldram_sheet *sheet,
                                              double incline_rad, struct pp_error *err);

#endif
