/* read_shape.h - reads the plan or the envelope of a room. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_READ_READ_SHAPE_H
#define PP_MODEL_ROOM_READ_READ_SHAPE_H

#include "model/room/read/reader.h"

/* Read an element into the room's plan; an element with a mistake is left out. */
void pp_read_shape_plan(struct pp_reader *r, struct pp_room *room,
                        const struct pp_xml_element *e);
void pp_read_shape_envelope(struct pp_reader *r, struct pp_room *room,
                            const struct pp_xml_element *e);

/* Reports a room `e` with both plan and envelope, or neither. */
void pp_read_shape_check(struct pp_reader *r, const struct pp_xml_element *e);

#endif
