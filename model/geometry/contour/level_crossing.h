/* level_crossing.h - a level's curve across one triangle of a field's mesh. Inside
 * model/geometry/contour/ only.
 *
 * Where an edge has its ends on different sides of the level, the place of the level on
 * it is found by a bracketed secant; between two such places the curve is followed
 * across the triangle, points being added until it strays from its chords by no more
 * than the tolerance.
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
