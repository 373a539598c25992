/* known_values.h - values of a function at places where it was evaluated before. Inside
 * model/geometry/contour/ only. */
#ifndef PP_MODEL_GEOMETRY_CONTOUR_KNOWN_VALUES_H
#define PP_MODEL_GEOMETRY_CONTOUR_KNOWN_VALUES_H

#include <stdbool.h>

#include "model/base/error.h"

/* Zeroed at first. */
struct pp_known_values {
    struct pp_known_value {
        double xy[2], value;
    } * list;
    int count, capacity;
    int *slots; /* in the list, by places: open addressing; -1: free */
    int room;
};

void pp_known_values_clear(struct pp_known_values *known);

/* False: nothing is known of the place. */
bool pp_known_values_find(const struct pp_known_values *known, const double xy[2],
                          double *value);

/* Adds the value at a place that is not in the table. */
enum pp_status pp_known_values_add(struct pp_known_values *known, const double xy[2],
                                   double value, struct pp_error *err);

#endif
