/* ears.h - a polygon cut into triangles of its own corners.
 *
 * By cutting off ears [MEISTERS75]: also polygons whose holes are joined to their rim
 * by a seam, along which the outline runs there and back.
 */
#ifndef PP_SIMULATE_EARS_H
#define PP_SIMULATE_EARS_H

#include "model/vec.h"

/* Triangles of a plane polygon with this normal (any length), counter-clockwise as the
 * corners are: their corners' numbers go to triangles, which has room for count - 2;
 * order is scratch for count. How many there are: fewer where corners lie in a line. An
 * outline that crosses itself gives triangles all the same, of whatever it may mean. */
int pp_cut_ears(const struct pp_vec3 *corners, int count, struct pp_vec3 normal,
                int (*triangles)[3], int *order);

#endif
