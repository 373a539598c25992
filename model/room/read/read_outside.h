/* read_outside.h - what stands outside a room, or outside all rooms of a building: from
 * elements to parts. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_READ_READ_OUTSIDE_H
#define PP_MODEL_ROOM_READ_READ_OUTSIDE_H

#include "model/room/read/reader.h"

void pp_read_outside_garden(struct pp_reader *r, struct pp_room *room,
                            const struct pp_xml_element *e);
void pp_read_outside_skyline(struct pp_reader *r, struct pp_room *room,
                             const struct pp_xml_element *e);
void pp_read_outside_facade(struct pp_reader *r, struct pp_room *room,
                            const struct pp_xml_element *e);

/* A block whose base is not given waits for the ground's level. Roofs and walls over a
 * footprint become surfaces. */
void pp_read_outside_block(struct pp_reader *r, struct pp_room *room,
                           const struct pp_xml_element *e);
void pp_read_outside_surface(struct pp_reader *r, struct pp_room *room,
                             const struct pp_xml_element *e);

/* Reads the mesh file, too. Its mistakes are reported on the element's line, with the line
 * of that file. */
void pp_read_outside_mesh(struct pp_reader *r, struct pp_room *room,
                          const struct pp_xml_element *e);

/* Puts what waits for it on the ground, whose level is known. */
void pp_read_outside_stand_on_ground(struct pp_room *room);

#endif
