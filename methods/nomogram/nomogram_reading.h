/* nomogram_reading.h - what a person reads of one opening on a nomogram. */
#ifndef PP_METHODS_NOMOGRAM_NOMOGRAM_READING_H
#define PP_METHODS_NOMOGRAM_NOMOGRAM_READING_H

#include "model/results/nomogram_sheet.h"
#include "model/room/world.h"

/* Why the room cannot be set on a nomogram: a static sentence, or NULL. */
const char *pp_nomogram_reading_refuses_room(const struct pp_world *world);

/* Lays the straight-edge for an opening: A and B, C and D, E and F (II), each value set
 * and read to what pp_nomogram_scale_read grants. A ratio off scale A is set ten times
 * smaller or larger and the result shifted back, as the component is proportional to
 * it. The mean reflectance must be on scale B. */
enum pp_status pp_nomogram_reading_of_opening(struct pp_nomogram_reading *reading,
                                              const struct pp_nomogram *nomogram,
                                              const struct pp_world *world,
                                              const struct pp_opening *opening,
                                              struct pp_error *err);

#endif
