/* read_cover.h - reads doors and dados. Inside model/room/read/ only. */
#ifndef PP_MODEL_ROOM_READ_READ_COVER_H
#define PP_MODEL_ROOM_READ_READ_COVER_H

#include "model/room/read/reader.h"
#include "model/room/room_parts.h"

void pp_read_cover_door(struct pp_reader *r, struct pp_room *room,
                        const struct pp_xml_element *e);
void pp_read_cover_dado(struct pp_reader *r, struct pp_room *room,
                        const struct pp_xml_element *e);

#endif
