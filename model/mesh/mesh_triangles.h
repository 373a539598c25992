/* mesh_triangles.h - triangles in space, as other programs' files hold them.
 *
 * Corners are in the file's own units and axes, finite; triangles are three indices of
 * corners each, not empty but for rounding, either way round.
 */
#ifndef PP_MODEL_MESH_MESH_TRIANGLES_H
#define PP_MODEL_MESH_MESH_TRIANGLES_H

#include "model/base/error.h"
#include "model/geometry/vec.h"

/* The most triangles that are taken of one file, and the most corners. */
enum { PP_MESH_MOST = 1000000, PP_MESH_CORNERS_MOST = 3000000 };

/* Coordinates are less than this, either sign, in any unit: larger ones cannot be those
 * of a building's surroundings. */
#define PP_MESH_COORDINATE_MOST 1e12

/* Begin with all zero; to be cleared. */
struct pp_mesh_triangles {
    struct pp_vec3 *corners;
    int corner_count, corner_space;
    int (*triangles)[3];
    int triangle_count, triangle_space;
    double unit_m; /* of the file's lengths, as it says itself; 0: it does not */
};

void pp_mesh_triangles_clear(struct pp_mesh_triangles *mesh);

/* Reason why a corner or a triangle could not be added, static; NULL: it was added. If
 * memory is exhausted it is this pointer. */
extern const char *const pp_mesh_triangles_no_memory;

const char *pp_mesh_triangles_add_corner(struct pp_mesh_triangles *mesh,
                                         struct pp_vec3 corner);

/* A face with these corners (indices of the mesh's, 3 or more), cut into triangles: a
 * plane one as its outline runs, one that is not as a fan. Corners that repeat and faces
 * without an area are left out. */
const char *pp_mesh_triangles_add_face(struct pp_mesh_triangles *mesh,
                                       const int *corners, int count);

#endif
