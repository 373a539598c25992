/* draw_moment.h - plan of a room with the illuminances at one moment instead of
 * daylight factors. */
#ifndef PP_API_DRAW_MOMENT_H
#define PP_API_DRAW_MOMENT_H

#include "api/chart_kind.h"

/* Draws the plan for the moment choice->moment, which must not be NULL. PP_INTERRUPTED:
 * nothing is drawn. */
enum pp_status pp_draw_moment_plan(struct pp_canvas *canvas,
                                   const struct pp_study_room *room,
                                   const struct pp_study_options *study,
                                   const struct pp_chart_choice *choice,
                                   struct pp_error *err);

#endif
