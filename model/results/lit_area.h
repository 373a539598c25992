/* lit_area.h - the sufficiently lit part of a room in planning and rights-of-light
 * cases, bounded by the no-sky line or by a sky-factor contour.
 *
 * studies/lit_line.h defines and traces the lines.
 */
#ifndef PP_MODEL_RESULTS_LIT_AREA_H
#define PP_MODEL_RESULTS_LIT_AREA_H

#include "model/geometry/curve.h"
#include "model/geometry/region.h"

enum pp_lit_line { PP_LIT_NO_SKY, PP_LIT_SKY_FACTOR };

struct pp_lit_area {
    double plane_m;            /* z of the plane */
    struct pp_region plane;    /* section of the room at that height; may be empty */
    struct pp_curve_list line; /* boundary; the lit side is on its left */
    struct pp_curve_list dark; /* closed outlines of the unlit area: outer ones
                                * counter-clockwise, holes clockwise */
    double plane_m2, lit_m2;
    double error_m2; /* error of lit_m2 from the tolerance of the line */
};

void pp_lit_area_clear(struct pp_lit_area *area);

/* Zones of a loss of lit area, as used by rights-of-light surveyors: quarters of the
 * room's area, beginning with the quarter that is lost last. A loss in the front zone
 * leaves less than a quarter of the room lit. */
enum pp_lit_zone {
    PP_ZONE_FRONT,
    PP_ZONE_FIRST,
    PP_ZONE_SECOND,
    PP_ZONE_MAKEWEIGHT,
    PP_ZONE_COUNT
};

struct pp_lit_loss {
    double zones_m2[PP_ZONE_COUNT]; /* area lost, by zone */
    double
        equivalent_m2; /* first-zone equivalent: the zones' areas times 3/2, 1, 1/2 and
                        * 1/4, as in practice (from memory, without a source) */
};

struct pp_lit_loss pp_lit_area_loss(double plane_m2, double before_m2, double now_m2);

/* Lit area of a room, at present and before. */
struct pp_lit_change {
    double plane_m2, lit_m2;
    double before_m2; /* NAN: not known */
    double lost_m2;   /* negative: a gain; NAN (also all of `loss`): not known */
    struct pp_lit_loss loss;
};

/* Calculates loss and zones. before_m2 NAN: not known; lost_m2 and the loss are then
 * NAN. */
struct pp_lit_change pp_lit_area_change(double plane_m2, double before_m2,
                                        double now_m2);

/* Adds a room's values to a sum over rooms, without those that are NAN; initialise the
 * sum with zeros. */
void pp_lit_area_add(struct pp_lit_change *sum, const struct pp_lit_change *room);

/* Name of a zone: "front zone", ... */
const char *pp_lit_area_zone_name(enum pp_lit_zone zone);

#endif
