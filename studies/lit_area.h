/* lit_area.h - the part of a room that has light enough, by one of the two lines that planners
 * and courts draw across it.
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
#ifndef PP_STUDIES_LIT_AREA_H
#define PP_STUDIES_LIT_AREA_H

#include "model/base/error.h"
#include "model/geometry/curve.h"
#include "model/geometry/region.h"
#include "model/room/world.h"

enum pp_lit_line { PP_LIT_NO_SKY, PP_LIT_SKY_FACTOR };

struct pp_lit_area {
    double plane_m;            /* z of the plane */
    struct pp_region plane;    /* of the room at that height; may be empty */
    struct pp_curve_list line; /* lit to its left */
    struct pp_curve_list dark; /* closed outlines of what is not lit: outer ones
                                * counter-clockwise, holes clockwise */
    double plane_m2, lit_m2;
    double error_m2; /* of lit_m2, by the tolerance of the line */
};

/* Fills area, which the caller clears; empty on failure. No plane: nothing is lit. */
enum pp_status pp_lit_area_find(struct pp_lit_area *area, const struct pp_world *world,
                                enum pp_lit_line line, struct pp_error *err);
void pp_lit_area_clear(struct pp_lit_area *area);

/* What is lost between two shares of a room that are lit, by the zones in which surveyors of
 * rights of light count it: quarters of the room's area, in the order in which the last of
 * them would be lost. A loss in the front zone leaves less than a quarter lit. */
enum pp_lit_zone {
    PP_ZONE_FRONT,
    PP_ZONE_FIRST,
    PP_ZONE_SECOND,
    PP_ZONE_MAKEWEIGHT,
    PP_ZONE_COUNT
};

struct pp_lit_loss {
    double zones_m2[PP_ZONE_COUNT]; /* 0 where nothing is lost */
    double
        equivalent_m2; /* of first zone: the zones' areas times 3/2, 1, 1/2 and 1/4, as
                           * practice has it (recalled; no text at hand) */
};

struct pp_lit_loss pp_lit_area_loss(double plane_m2, double before_m2, double now_m2);

/* "front zone", ... */
const char *pp_lit_area_zone_name(enum pp_lit_zone zone);

#endif
