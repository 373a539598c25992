/* curve.h - lines in a plane on which something has one value: contours.
 */
#ifndef PP_MODEL_CURVE_H
#define PP_MODEL_CURVE_H

#include <stdbool.h>

/* A polyline. It runs so that higher values lie on its left. */
struct pp_curve {
    double level; /* of the function, in its own unit */
    bool closed;  /* the last point is joined to the first, which is not repeated */
    int count;    /* 2 or more, 3 where closed */
    double (*xy)[2];
};

struct pp_curves {
    int count;
    struct pp_curve *list;
};

void pp_curves_clear(struct pp_curves *curves); /* leaves none */

/* Length of the line, in the unit of its points. */
double pp_curve_length(const struct pp_curve *curve);

#endif
