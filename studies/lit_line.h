/* lit_line.h - traces the line that bounds the part of a room that has light enough.
 *
 * The no-sky line bounds the part of the working plane from which some sky is seen, through
 * whatever glass (methods/daylight_curves.h). The contour of a sky factor of 0.2 % bounds what
 * is adequately lit in the English law of easements: the sky factor is the share of a uniform
 * sky's light that reaches a level point directly, without glass, frame or dirt; 0.2 % of
 * 500 foot-candles outside is one foot-candle, the least to read by ("grumble line", [WW23]).
 * It is taken at 0.85 m above the floor, whatever the room's own sky and working plane:
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

/* Why the line is not found in that world or in the one before (NULL: there is none), a static
 * sentence: the meshes outside are too fine for their view from everywhere to be cut within
 * seconds. NULL: it is. */
const char *pp_lit_line_refuses(const struct pp_world *world,
                                const struct pp_world *before);

/* Fills area, which the caller clears; empty on failure. No plane: nothing is lit.
 * PP_BAD_INPUT where the line is refused. */
enum pp_status pp_lit_line_find(struct pp_lit_area *area, const struct pp_world *world,
                                enum pp_lit_line line, struct pp_error *err);

#endif
