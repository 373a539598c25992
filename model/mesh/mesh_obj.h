/* mesh_obj.h - the faces of a Wavefront OBJ file.
 *
 * It reads v and f, the latter with v, v/vt, v//vn and v/vt/vn, indices from 1 or,
 * negative, from the last v back, and any number of corners. A line that ends with \
 * continues on the next. Free-form curves and surfaces (curv, curv2, surf) are refused
 * by name; other statements (groups, materials, normals, points, lines, ...) are
 * ignored. The file has no unit.
 */
#ifndef PP_MODEL_MESH_MESH_OBJ_H
#define PP_MODEL_MESH_MESH_OBJ_H

#include "model/mesh/mesh_triangles.h"
#include "model/mesh/mesh_lines.h"

/* Fills an empty mesh, which the caller clears, after a failure too. PP_BAD_INPUT names
 * file and line. */
enum pp_status pp_mesh_obj_read(struct pp_mesh_triangles *mesh,
                                struct pp_mesh_lines *lines, struct pp_error *err);

#endif
