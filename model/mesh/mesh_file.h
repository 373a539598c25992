/* mesh_file.h - a file of triangles, OBJ or DXF by the end of its name. */
#ifndef PP_MODEL_MESH_MESH_FILE_H
#define PP_MODEL_MESH_MESH_FILE_H

#include "model/mesh/mesh_triangles.h"

/* The most bytes that are read of one. */
enum { PP_MESH_FILE_BYTES_MOST = 512 << 20 };

/* Reads the file into an empty mesh, which the caller clears, after a failure too.
 * PP_BAD_INPUT names file and line. */
enum pp_status pp_mesh_file_read(struct pp_mesh_triangles *mesh, const char *path,
                                 struct pp_error *err);

/* The same of bytes in memory, which are written to and have a 0 behind them; name ends with
 * .obj or .dxf. */
enum pp_status pp_mesh_file_parse(struct pp_mesh_triangles *mesh, char *bytes,
                                  size_t length, const char *name,
                                  struct pp_error *err);

#endif
