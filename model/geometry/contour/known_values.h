/* known_values.h - stored values of a function, by point. Inside
 * model/geometry/contour/ only. */
#ifndef PP_MODEL_GEOMETRY_CONTOUR_KNOWN_VALUES_H
#define PP_MODEL_GEOMETRY_CONTOUR_KNOWN_VALUES_H

#include <stdbool.h>

#include "model/base/error.h"

/* Initialise with zeros. */
struct pp_known_values {
    struct pp_known_value {
        double xy[2], value;
    } * list;
    int count, capacity;
    int *slots; /* list indices by hash of the point, open addressing; -1: free */
    int room;
};

void pp_known_values_clear(struct pp_known_values *known);

/* Finds the value at a point; false if it is not stored. */
bool pp_known_values_find(const struct pp_known_values *known, const double xy[2],
                          double *value);

/* Stores the value at a point that is not yet in the table. */
enum pp_status pp_known_values_add(struct pp_known_values *known, const double xy[2],
                                   double value, struct pp_error *err);

#endif
