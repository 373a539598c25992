/* traced_windows.h - simulated illuminance of the outsides of a room's windows. */
#ifndef PP_STUDIES_CRITERIA_WINDOWS_TRACED_WINDOWS_H
#define PP_STUDIES_CRITERIA_WINDOWS_TRACED_WINDOWS_H

#include "model/light/outside_light.h"
#include "model/results/reading.h"
#include "model/room/world.h"
#include "studies/study_options.h"

/* Simulates the illuminance at the centre of the outside of each vertical opening, from
 * the sky and from all surfaces outside, over Eh. *readings has one entry for each
 * opening (NAN if the opening is not vertical), which the caller frees, even after a
 * failure. *finished: false if the watch stopped the simulation; *by_clock: true if the
 * time limit of the study (study->seconds) did. Both are unchanged otherwise. */
enum pp_status pp_traced_windows_light(struct pp_reading **readings,
                                       const struct pp_world *world,
                                       const struct pp_outside_light *light,
                                       const struct pp_study_options *study,
                                       bool *finished, bool *by_clock,
                                       struct pp_error *err);

#endif
