/* nomogram_reading.h - the reading of one opening on a nomogram [GEEBELEN]. */
#ifndef PP_METHODS_NOMOGRAM_NOMOGRAM_READING_H
#define PP_METHODS_NOMOGRAM_NOMOGRAM_READING_H

#include "model/light/outside_light.h"
#include "model/results/formula.h"
#include "model/results/nomogram_sheet.h"
#include "model/room/world.h"

/* a = W / S, the ratio to set on scale A. */
extern const struct pp_formula pp_nomogram_reading_ratio;

/* Reason why the room cannot be read with a nomogram, as a static sentence; NULL if it
 * can be read. */
const char *pp_nomogram_reading_refuses_room(const struct pp_world *world);

/* Lays the straight-edge for an opening on A and B, on C and D and, on nomogram II, on
 * E and F. Each value is rounded by pp_nomogram_scale_read. A ratio outside scale A is
 * multiplied by a power of ten; the component, which is proportional to the ratio, is
 * divided by the same power. The mean reflectance must be on scale B. */
enum pp_status pp_nomogram_reading_of_opening(struct pp_nomogram_reading *reading,
                                              const struct pp_nomogram *nomogram,
                                              const struct pp_world *world,
                                              const struct pp_outside_light *light,
                                              const struct pp_opening *opening,
                                              struct pp_error *err);

/* Lays straight-edge `index` on the values of its two stems and reads the third. */
void pp_nomogram_reading_lay(struct pp_nomogram_reading *reading,
                             const struct pp_nomogram *nomogram, int index);

/* Sets W/S times the power of ten that brings it into the range of scale A, and R on
 * scale B. */
void pp_nomogram_reading_set_room(struct pp_nomogram_reading *reading,
                                  const struct pp_nomogram *nomogram, double R);

#endif
