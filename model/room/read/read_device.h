/* read_device.h - reads the blind, screen or curtain of an opening. Inside model/room/
 * only. */
#ifndef PP_MODEL_ROOM_READ_READ_DEVICE_H
#define PP_MODEL_ROOM_READ_READ_DEVICE_H

#include "model/room/read/reader.h"
#include "model/light/slats/window_device.h"

/* Reads the device among the children of an opening; PP_DEVICE_NONE if there is none.
 * Returns false, with a report, after a mistake or if there are two devices. */
bool pp_read_device(struct pp_reader *r, struct pp_window_device *device,
                    const struct pp_xml_element *opening);

#endif
