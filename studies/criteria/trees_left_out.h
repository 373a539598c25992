/* trees_left_out.h - criteria that leave trees out, in a room with a view of trees. */
#ifndef PP_STUDIES_CRITERIA_TREES_LEFT_OUT_H
#define PP_STUDIES_CRITERIA_TREES_LEFT_OUT_H

#include "studies/criteria/assessment.h"

/* The crown that rises highest in front of a window, seen from the middle of its outer
 * face, whether or not anything hides it. */
struct pp_trees_left_out {
    const struct pp_opening *opening;
    int line;            /* of the tree */
    double altitude_rad; /* of the crown's upper edge */
    const struct pp_criterion *criteria[PP_CRITERIA_MOST]; /* that leave trees out */
    int count;
};

/* False if no crown rises above the horizon in front of a window, or no assessed
 * criterion leaves trees out. */
bool pp_trees_left_out_find(struct pp_trees_left_out *trees,
                            const struct pp_assessment *assessment);

#endif
