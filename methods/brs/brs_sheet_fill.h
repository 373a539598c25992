/* brs_sheet_fill.h - fills a sheet of the BRS simplified table, blank or with the
 * readings for a point of a room. */
#ifndef PP_METHODS_BRS_BRS_SHEET_FILL_H
#define PP_METHODS_BRS_BRS_SHEET_FILL_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/results/sheets/brs_sheet.h"
#include "model/room/world.h"

void pp_brs_sheet_fill_blank(struct pp_brs_sheet *sheet);

/* Fills the sheet with the readings of pp_method_brs_table and their sums. PP_BAD_INPUT
 * if the method does not apply to the room, an opening or the receiver. On success the
 * caller clears the sheet. */
enum pp_status pp_brs_sheet_fill_room(struct pp_brs_sheet *sheet,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_receiver *receiver,
                                      struct pp_error *err);

#endif
