/* read_material.h - reads the <material> elements of a room file. Inside model/room/
 * only. */
#ifndef PP_MODEL_ROOM_READ_READ_MATERIAL_H
#define PP_MODEL_ROOM_READ_READ_MATERIAL_H

#include "model/room/read/reader.h"

/* Reads all materials of the root and of its rooms into r->materials, before any other
 * element. All rooms of the file can use these materials. */
void pp_read_materials(struct pp_reader *r, const struct pp_xml_element *root);

#endif
