/* level_crossing.h - the curve of a level across one triangle of a field's mesh. Inside
 * model/geometry/contour/ only.
 *
 * On an edge whose ends are on different sides of the level, the crossing is found by
 * Brent's method, which keeps it bracketed. Between two such crossings the curve is
 * followed across the triangle; points are added until it deviates from its chords by
 * at most the tolerance.
 */
#ifndef PP_MODEL_GEOMETRY_CONTOUR_LEVEL_CROSSING_H
#define PP_MODEL_GEOMETRY_CONTOUR_LEVEL_CROSSING_H

#include "model/geometry/contour/field.h"

/* Adds the crossing of field->level through the triangle, if there is one. *leaves: the
 * curve leaves the triangle and re-enters it, which the values at its corners do not
 * show; the crossing is then a straight chord there. */
enum pp_status pp_level_crossing_follow(struct pp_field *field, int triangle,
                                        bool *leaves, struct pp_error *err);

#endif
