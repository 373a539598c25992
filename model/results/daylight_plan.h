/* daylight_plan.h - data of a plan of a room's daylight.
 *
 * All curves are in the working plane, in the room's own x and y (m). A method fills
 * the plan (methods/daylight_curves.h); a chart draws it (charts/room/plan_chart.h).
 */
#ifndef PP_MODEL_RESULTS_DAYLIGHT_PLAN_H
#define PP_MODEL_RESULTS_DAYLIGHT_PLAN_H

#include "model/geometry/curve.h"

struct pp_daylight_plan {
    char name[48]; /* column that is contoured: "exact+bre" */
    bool direct;   /* true: sky and externally reflected component, without light
                    * reflected in the room; false: daylight factor */
    struct pp_curve_list
        contours;                /* levels are daylight factors, fractions; ascending */
    struct pp_curve_list below;  /* outlines of the areas below each level, like
                                 * `dark` */
    struct pp_curve_list bands;  /* sampled values only: closed outlines by level. An
                                 * even-odd fill of all outlines of a level covers
                                 * the points within one standard error of the
                                 * level */
    struct pp_curve_list no_sky; /* no-sky line; sky is visible on its left */
    struct pp_curve_list dark;   /* closed outlines of areas without a view of the
                                  * sky: outer ones counter-clockwise, holes
                                  * clockwise */
    double lowest, highest;      /* daylight factors over the plane, fractions */
    double lowest_xy[2], highest_xy[2]; /* positions of these values */
    double sky_share;                   /* share of the plane's area that sees some
                                         * sky */
};

void pp_daylight_plan_clear(struct pp_daylight_plan *plan);

#endif
