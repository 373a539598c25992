/* depth_profile.h - annual results at a room's points, by distance from the wall with
 * the largest window area. */
#ifndef PP_CHARTS_YEAR_DEPTH_PROFILE_H
#define PP_CHARTS_YEAR_DEPTH_PROFILE_H

#include "model/base/error.h"
#include "model/results/sheets/annual_sheet.h"

/* Means over the points at one distance from the wall. */
struct pp_depth_step {
    double depth_m;
    int count;              /* number of points */
    double autonomy;        /* fraction of the occupied hours with 300 lx, blinds
                             * open */
    double blinds_autonomy; /* fraction of the occupied hours with 300 lx, with blinds;
                             * NAN: no blinds */
    double udi;             /* fraction of the occupied hours with 300 to 3000 lx */
};

struct pp_depth_profile {
    int count; /* 0: no vertical window, or no point in front of it */
    struct pp_depth_step *steps;
};

/* Makes the profile, in order of distance. Points less than 5 cm farther than the first
 * point of an entry belong to that entry. Points behind the plane of the wall, as in an
 * L-shaped room, are omitted. Always call pp_depth_profile_clear, even after a failure
 * (PP_SYSTEM). */
enum pp_status pp_depth_profile_find(struct pp_depth_profile *profile,
                                     const struct pp_annual_sheet *sheet,
                                     struct pp_error *err);
void pp_depth_profile_clear(struct pp_depth_profile *profile);

#endif
