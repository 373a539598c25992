/* read_sky.h - reads the sky of a room or a building, including picture files. Inside
 * model/room/read/ only. */
#ifndef PP_MODEL_ROOM_READ_READ_SKY_H
#define PP_MODEL_ROOM_READ_READ_SKY_H

#include "model/room/read/reader.h"

void pp_read_sky(struct pp_reader *r, struct pp_sky_part *sky,
                 const struct pp_xml_element *e);

#endif
