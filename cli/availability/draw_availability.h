/* draw_availability.h - from the light outside, and a room or none, to its chart. */
#ifndef PP_CLI_AVAILABILITY_DRAW_AVAILABILITY_H
#define PP_CLI_AVAILABILITY_DRAW_AVAILABILITY_H

#include "charts/sheet/canvas.h"
#include "cli/availability/availability_options.h"
#include "cli/rooms.h"

/* room NULL: the light outside alone. *finished becomes false where the simulation was
 * interrupted. */
enum pp_status pp_draw_availability(struct pp_canvas *canvas,
                                    const struct pp_study_room *room,
                                    const struct pp_room_options *room_options,
                                    const struct pp_availability_options *options,
                                    bool *finished, struct pp_error *err);

#endif
