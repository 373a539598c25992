/* waldram_sheet_fill.h - fills a sheet of Waldram's diagram (model/results/board_sheets.h):
 * its scales, its droop lines, and a room's windows with their squares counted. */
#ifndef PP_METHODS_WALDRAM_WALDRAM_SHEET_FILL_H
#define PP_METHODS_WALDRAM_WALDRAM_SHEET_FILL_H

#include "model/base/error.h"
#include "model/results/board_sheets.h"
#include "model/room/world.h"

/* A blank one. A sky with azimuth dependence is refused. The sheet is to be cleared by
 * the caller; empty on failure. */
enum pp_status pp_waldram_sheet_fill_blank(struct pp_waldram_sheet *sheet,
                                           const struct pp_sky *sky, bool glazed,
                                           struct pp_error *err);

/* With the room's windows as seen from the receiver: a panel for each way they face,
 * with glass and without; one blank panel for a room without openings. What the method
 * `waldram` refuses is PP_BAD_INPUT and why. Its sums are what the method gives. */
enum pp_status pp_waldram_sheet_fill_room(struct pp_waldram_sheet *sheet,
                                          const struct pp_world *world,
                                          const struct pp_receiver *receiver,
                                          struct pp_error *err);

#endif
