/* mesh_file.h - reads a file of triangles: OBJ or DXF, by the extension of its name. */
#ifndef PP_MODEL_MESH_MESH_FILE_H
#define PP_MODEL_MESH_MESH_FILE_H

#include "model/mesh/mesh_triangles.h"

/* Limit on the bytes of a file. */
enum { PP_MESH_FILE_BYTES_MOST = 512 << 20 };

/* Reads the file into an empty mesh, which the caller clears even after a failure.
 * PP_BAD_INPUT names file and line. */
enum pp_status pp_mesh_file_read(struct pp_mesh_triangles *mesh, const char *path,
                                 struct pp_error *err);

/* Reads from memory. The bytes are NUL-terminated and are changed; name ends with .obj
 * or .dxf. */
enum pp_status pp_mesh_file_parse(struct pp_mesh_triangles *mesh, char *bytes,
                                  size_t length, const char *name,
                                  struct pp_error *err);

#endif
