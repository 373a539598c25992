/* daylight_plan.h - the data of a plan of a room's daylight.
 *
 * Everything lies in the working plane, in metres of the room's own x and y. A method
 * fills it (methods/daylight_curves.h); a chart draws it (charts/room/plan_chart.h).
 */
#ifndef PP_MODEL_RESULTS_DAYLIGHT_PLAN_H
#define PP_MODEL_RESULTS_DAYLIGHT_PLAN_H

#include "model/geometry/curve.h"

struct pp_daylight_plan {
    char name[48]; /* of the figures contoured: "exact+bre" */
    bool direct;   /* true: the sky and externally reflected component, without light
                    * reflected in the room; false: daylight factors */
    struct pp_curve_list
        contours;               /* levels are daylight factors, fractions; ascending */
    struct pp_curve_list below; /* outlines of the parts below each level, as in dark */
    struct pp_curve_list bands; /* of sampled figures: closed outlines with the level of
                                 * their band; an even-odd fill of all outlines of a
                                 * level covers places whose figure is within one
                                 * standard error of the level */
    struct pp_curve_list no_sky; /* the no-sky line: sky can be seen from its left */
    struct pp_curve_list dark;   /* closed outlines of the parts that see no sky at all:
                                * outer ones counter-clockwise, holes clockwise */
    double lowest, highest;      /* daylight factor over the plane, fractions */
    double lowest_xy[2], highest_xy[2]; /* where these are */
    double sky_share;                   /* of the plane's area that sees some sky */
};

void pp_daylight_plan_clear(struct pp_daylight_plan *plan);

#endif
