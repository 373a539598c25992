/* read_shape.h - the plan or the envelope of a room, as the file has it. Inside
 * model/room/ only. */
#ifndef PP_MODEL_ROOM_READ_READ_SHAPE_H
#define PP_MODEL_ROOM_READ_READ_SHAPE_H

#include "model/room/read/reader.h"

/* Each reads its element into the room's plan, and leaves out one with a mistake. */
void pp_read_shape_plan(struct pp_reader *r, struct pp_room *room,
                        const struct pp_xml_element *e);
void pp_read_shape_envelope(struct pp_reader *r, struct pp_room *room,
                            const struct pp_xml_element *e);

/* Notes where the room `e` has both plan and envelope, or neither. */
void pp_read_shape_check(struct pp_reader *r, const struct pp_xml_element *e);

#endif
