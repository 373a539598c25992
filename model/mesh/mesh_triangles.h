/* mesh_triangles.h - triangles in space, from files of other programs.
 *
 * Corners are finite, in the units and axes of the file. A triangle is three corner
 * indices, in either orientation; its area is more than rounding error.
 */
#ifndef PP_MODEL_MESH_MESH_TRIANGLES_H
#define PP_MODEL_MESH_MESH_TRIANGLES_H

#include "model/base/error.h"
#include "model/geometry/vec.h"

/* Limits on the triangles and corners of a file. */
enum { PP_MESH_MOST = 1000000, PP_MESH_CORNERS_MOST = 3000000 };

/* Limit on the absolute value of coordinates in any unit; larger ones cannot be the
 * surroundings of a building. */
#define PP_MESH_COORDINATE_MOST 1e12

/* Initialise with zeros; clear after use. */
struct pp_mesh_triangles {
    struct pp_vec3 *corners;
    int corner_count, corner_space;
    int (*triangles)[3];
    int triangle_count, triangle_space;
    double unit_m; /* metres per unit, if the file states it; else 0 */
};

void pp_mesh_triangles_clear(struct pp_mesh_triangles *mesh);

/* The functions below return NULL on success, or the reason why a corner or face could
 * not be added (a static string). If memory runs out, they return this pointer. */
extern const char *const pp_mesh_triangles_no_memory;

const char *pp_mesh_triangles_add_corner(struct pp_mesh_triangles *mesh,
                                         struct pp_vec3 corner);

/* Splits a face (3 or more corner indices) into triangles and adds them. Faces may be
 * concave. Faces that are convex, or that cross themselves, become a fan from the first
 * corner. Consecutive equal corners, and triangles without area, are left out. */
const char *pp_mesh_triangles_add_face(struct pp_mesh_triangles *mesh,
                                       const int *corners, int count);

#endif
