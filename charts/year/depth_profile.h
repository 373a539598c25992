/* depth_profile.h - annual figures of a room's points by their distance from the wall with
 * the most window area. */
#ifndef PP_CHARTS_YEAR_DEPTH_PROFILE_H
#define PP_CHARTS_YEAR_DEPTH_PROFILE_H

#include "model/base/error.h"
#include "model/results/sheets/annual_sheet.h"

/* Means over the points at one distance from the wall. */
struct pp_depth_step {
    double depth_m;
    int count;              /* points */
    double autonomy;        /* share of the occupied hours with 300 lx, blinds open */
    double blinds_autonomy; /* the same with blinds; NAN: no blinds */
    double udi;             /* share of the hours with 300 to 3000 lx */
};

struct pp_depth_profile {
    int count; /* 0: no vertical window, or no point in front of it */
    struct pp_depth_step *steps;
};

/* Distances are ascending; points behind the plane of the wall, as in an L-shaped room,
 * are left out; points within 5 cm of the first of a step belong to it.
 * pp_depth_profile_clear clears it, also after a failure. PP_NO_MEMORY. */
enum pp_status pp_depth_profile_find(struct pp_depth_profile *profile,
                                     const struct pp_annual_sheet *sheet,
                                     struct pp_error *err);
void pp_depth_profile_clear(struct pp_depth_profile *profile);

#endif
