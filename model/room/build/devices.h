/* devices.h - blinds, screens and curtains of a room's openings. Inside model/room/
 * only. */
#ifndef PP_MODEL_ROOM_BUILD_DEVICES_H
#define PP_MODEL_ROOM_BUILD_DEVICES_H

#include "model/room/build/resolve.h"

/* Adds the device of the part to the opening. A curtain replaces the glass by a
 * diffusing pane; its transmittance is the product of the transmittances of glass and
 * curtain for diffuse light. The data of a blind are calculated, or shared with an
 * earlier opening that has the same blind and glass. Reports a device that is not
 * possible. */
enum pp_status pp_devices_put(struct pp_resolver *r, struct pp_opening *opening,
                              const struct pp_opening_part *part, struct pp_error *err);

/* True if the opening is within 15 degrees of the vertical. */
bool pp_devices_is_upright(const struct pp_opening *opening);

/* Gives an opening the blind of its device and glass, shared with one of `openings` that
 * has the same. PP_BAD_INPUT if its slats touch each other. */
enum pp_status pp_devices_hang(struct pp_opening *opening,
                               const struct pp_opening *openings, int count,
                               struct pp_error *err);

#endif
