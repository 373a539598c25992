/* mesh_obj.h - the faces of a Wavefront OBJ file.
 *
 * The reader uses v and f; faces may have v, v/vt, v//vn and v/vt/vn, and any number of
 * corners. Indices count from 1 or, if negative, backwards from the last v. A line that
 * ends with \ continues on the next. Free-form curves and surfaces (curv, curv2, surf,
 * ...) and inserted files (call) are an error; other statements (groups, materials,
 * normals, points, lines, ...) are ignored. The file has no unit.
 */
#ifndef PP_MODEL_MESH_MESH_OBJ_H
#define PP_MODEL_MESH_MESH_OBJ_H

#include "model/mesh/mesh_triangles.h"
#include "model/mesh/mesh_lines.h"

/* Fills an empty mesh, which the caller clears even after a failure. PP_BAD_INPUT names
 * file and line. */
enum pp_status pp_mesh_obj_read(struct pp_mesh_triangles *mesh,
                                struct pp_mesh_lines *lines, struct pp_error *err);

#endif
