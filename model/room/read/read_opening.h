/* read_opening.h - reads windows, rooflights and openings. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_READ_READ_OPENING_H
#define PP_MODEL_ROOM_READ_READ_OPENING_H

#include "model/room/read/reader.h"

/* Reads an element of that kind, by its rule, into the room's openings. */
void pp_read_opening(struct pp_reader *r, struct pp_room *room,
                     const struct pp_xml_element *e, enum pp_opening_kind kind,
                     const struct pp_element_rule *rule);

#endif
