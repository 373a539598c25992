/* site_crowns.h - draws the crowns of trees on site plans and elevations.
 *
 * A crown is hatched with vertical lines, which are closer the less light it transmits:
 * the left half with leaves, the right half without.
 */
#ifndef PP_CHARTS_SITE_SITE_CROWNS_H
#define PP_CHARTS_SITE_SITE_CROWNS_H

#include "charts/room/room_plan.h"
#include "model/results/sheets/site_sheet.h"

/* Draws a tree in plan: crown and trunk. A tree that is to be removed is dashed. */
void pp_site_crowns_draw_plan(cairo_t *cr, const struct pp_style *style,
                              const struct pp_room_plan *frame,
                              const struct pp_site_tree *tree);

/* Draws the crowns of an elevation, cut off at its edges, and the trunks below them.
 * frame: u and v of the elevation. */
void pp_site_crowns_draw_front(cairo_t *cr, const struct pp_style *style,
                               const struct pp_room_plan *frame,
                               const struct pp_site_elevation *elevation,
                               const struct pp_site_sheet *site);

/* Appends an explanation of the crowns to the text. has_former: trees that are to be
 * removed are drawn as well. */
void pp_site_crowns_say(char *text, size_t room, bool has_former);

#endif
