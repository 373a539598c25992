/* lit_line.h - traces the boundary of the sufficiently lit part of a room.
 *
 * The no-sky line bounds the part of the working plane from which some sky is visible,
 * through any kind of glass (methods/daylight_curves.h). The contour of a sky factor of
 * 0.2 % bounds the area that is adequately lit according to the English law of
 * easements. The sky factor is the fraction of the light of a uniform sky that reaches
 * a horizontal surface directly, without glass, frame or dirt. 0.2 % of 500
 * foot-candles outside is one foot-candle, the minimum for reading ("grumble line",
 * [WW23]). The sky factor is calculated 0.85 m above the floor, whatever the sky and
 * working plane of the room:
 *
 *   SF = (1/pi) integral of sin(gamma) over the visible sky
 *
 *   gamma  altitude of a point of the sky
 *
 * Both lines are traced as curves, to the tolerance of methods/daylight_curves.h.
 */
#ifndef PP_STUDIES_LIT_LINE_H
#define PP_STUDIES_LIT_LINE_H

#include "model/base/error.h"
#include "model/results/lit_area.h"
#include "model/room/world.h"

/* Reason (a static sentence) why the line cannot be traced in this world or its former
 * state: the meshes outside have so many triangles that this would take too long.
 * before NULL: no former state. Returns NULL if the line can be traced. */
const char *pp_lit_line_refuses(const struct pp_world *world,
                                const struct pp_world *before);

/* Finds the lit area. The caller clears *area, which is empty after a failure. If the
 * room has no working plane, the area is empty. PP_BAD_INPUT if the line cannot be
 * traced. */
enum pp_status pp_lit_line_find(struct pp_lit_area *area, const struct pp_world *world,
                                enum pp_lit_line line, struct pp_error *err);

#endif
