/* curve.h - contours: lines in a plane on which a function has one value. */
#ifndef PP_MODEL_GEOMETRY_CURVE_H
#define PP_MODEL_GEOMETRY_CURVE_H

#include <stdbool.h>

#include "model/base/error.h"

/* A polyline with higher values on its left. */
struct pp_curve {
    double level; /* value of the function, in its unit */
    bool closed;  /* the last point is joined to the first, which is not repeated */
    int count;    /* 2 or more; closed: 3 or more */
    double (*xy)[2];
};

struct pp_curve_list {
    int count;
    struct pp_curve *list;
};

void pp_curve_list_clear(struct pp_curve_list *curves); /* the list is then empty */

/* Appends a point, unless it equals the last one; the curve must have space. */
void pp_curve_add_point(struct pp_curve *curve, const double xy[2]);

/* Adds a curve and takes ownership of its points, which are freed on failure. */
enum pp_status pp_curve_list_add(struct pp_curve_list *curves, struct pp_curve curve,
                                 struct pp_error *err);

/* Length of the line, in the unit of its points. */
double pp_curve_length(const struct pp_curve *curve);

/* Area of closed curves: counter-clockwise minus clockwise. */
double pp_curve_list_area(const struct pp_curve_list *curves);

#endif
