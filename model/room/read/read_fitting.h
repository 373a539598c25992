/* read_fitting.h - reads furniture, columns and partitions. Inside model/room/read/
 * only. */
#ifndef PP_MODEL_ROOM_READ_READ_FITTING_H
#define PP_MODEL_ROOM_READ_READ_FITTING_H

#include "model/room/read/reader.h"
#include "model/room/room_parts.h"

void pp_read_fitting_furniture(struct pp_reader *r, struct pp_room *room,
                               const struct pp_xml_element *e);
void pp_read_fitting_column(struct pp_reader *r, struct pp_room *room,
                            const struct pp_xml_element *e);
void pp_read_fitting_partition(struct pp_reader *r, struct pp_room *room,
                               const struct pp_xml_element *e);

#endif
