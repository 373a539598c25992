/* read_outside.h - reads the objects outside a room, or outside all rooms of a
 * building. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_READ_READ_OUTSIDE_H
#define PP_MODEL_ROOM_READ_READ_OUTSIDE_H

#include "model/room/read/reader.h"

void pp_read_outside_garden(struct pp_reader *r, struct pp_room *room,
                            const struct pp_xml_element *e);
void pp_read_outside_skyline(struct pp_reader *r, struct pp_room *room,
                             const struct pp_xml_element *e);
void pp_read_outside_facade(struct pp_reader *r, struct pp_room *room,
                            const struct pp_xml_element *e);

/* Reads a block. A block without a base is placed on the ground later. Roofs, and walls
 * over a footprint, become surfaces. */
void pp_read_outside_block(struct pp_reader *r, struct pp_room *room,
                           const struct pp_xml_element *e);
void pp_read_outside_surface(struct pp_reader *r, struct pp_room *room,
                             const struct pp_xml_element *e);

/* Reads the trees within a site. */
void pp_read_outside_trees(struct pp_reader *r, struct pp_room *room,
                           const struct pp_xml_element *site);

/* Reads a mesh and its file. Mistakes in the mesh file are reported on the line of the
 * element; the message gives their line in the mesh file. */
void pp_read_outside_mesh(struct pp_reader *r, struct pp_room *room,
                          const struct pp_xml_element *e);

/* Moves objects without a base to ground level, and extends outlines down to it, once
 * the ground level is known. */
void pp_read_outside_stand_on_ground(struct pp_room *room);

#endif
