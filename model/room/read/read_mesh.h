/* read_mesh.h - a mesh: from its element, and the file that this names, to a part. Inside
 * model/room/ only. */
#ifndef PP_MODEL_ROOM_READ_READ_MESH_H
#define PP_MODEL_ROOM_READ_READ_MESH_H

#include "model/room/read/reader.h"

/* Mistakes in the mesh file are reported on the element's line, with the line of that
 * file. */
void pp_read_mesh(struct pp_reader *r, struct pp_room *room,
                  const struct pp_xml_element *e);

#endif
