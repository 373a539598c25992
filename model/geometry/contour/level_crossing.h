/* level_crossing.h - a level's curve across one triangle of a field's mesh. Inside
 * model/geometry/contour/ only.
 *
 * On an edge whose ends are on different sides of the level, the crossing is found by a
 * bracketed secant; between two such places the curve is followed across the triangle,
 * adding points until it deviates from its chords by at most the tolerance.
 */
#ifndef PP_MODEL_GEOMETRY_CONTOUR_LEVEL_CROSSING_H
#define PP_MODEL_GEOMETRY_CONTOUR_LEVEL_CROSSING_H

#include "model/geometry/contour/field.h"

/* Adds the crossing of field->level through the triangle to the field's crossings, if
 * it crosses the triangle. *leaves: on its way the curve leaves the triangle and comes
 * back, which its corners don't tell; there the crossing is a chord. */
enum pp_status pp_level_crossing_follow(struct pp_field *field, int triangle,
                                        bool *leaves, struct pp_error *err);

#endif
