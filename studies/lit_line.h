/* lit_line.h - traces the line that bounds the part of a room with enough light.
 *
 * The no-sky line bounds the part of the working plane from which some sky is seen,
 * through any kind of glass (methods/daylight_curves.h). The contour of a sky factor of
 * 0.2 % bounds the area that is adequately lit in the English law of easements. The sky
 * factor is the share of a uniform sky's light that reaches a level point directly,
 * without glass, frame or dirt; 0.2 % of 500 foot-candles outside is one foot-candle,
 * the least to read by ("grumble line", [WW23]). It is calculated 0.85 m above the
 * floor, whatever the room's own sky and working plane:
 *
 *   SF = (1/pi) integral of sin(gamma) over the visible sky
 *
 *   gamma  altitude of a point of the sky
 *
 * Both are true curves, to the tolerance of methods/daylight_curves.h.
 */
#ifndef PP_STUDIES_LIT_LINE_H
#define PP_STUDIES_LIT_LINE_H

#include "model/base/error.h"
#include "model/results/lit_area.h"
#include "model/room/world.h"

/* Reason why the line is not traced in that world or in the former one (NULL: none), a
 * static sentence: the meshes outside have too many triangles to be cut within seconds.
 * NULL: it can be traced. */
const char *pp_lit_line_refuses(const struct pp_world *world,
                                const struct pp_world *before);

/* Fills area, which the caller clears; empty on failure. Without a plane the area is
 * empty. PP_BAD_INPUT if the line is refused. */
enum pp_status pp_lit_line_find(struct pp_lit_area *area, const struct pp_world *world,
                                enum pp_lit_line line, struct pp_error *err);

#endif
