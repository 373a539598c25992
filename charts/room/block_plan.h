/* block_plan.h - plan of the room and of the blocks outside, with coordinates and
 * heights, so that an exercise can be solved from the sheet alone. */
#ifndef PP_CHARTS_ROOM_BLOCK_PLAN_H
#define PP_CHARTS_ROOM_BLOCK_PLAN_H

#include "charts/room/room_plan.h"

/* Draws the block plan into the box, with axes and a caption. */
void pp_block_plan_draw(cairo_t *cr, const struct pp_style *style,
                        const struct pp_world *world, struct pp_box box);

/* Draws the axes x and y from the origin of the room's coordinates. If the origin is
 * outside the plan, draws them from the low corner of the plan and states the
 * coordinates of that corner. */
void pp_block_plan_axes(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_plan *plan);

#endif
