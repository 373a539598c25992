/* mean_patterns.h - the step that gives surfaces with a pattern the mean of their
 * reflectance. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_MEAN_PATTERNS_H
#define PP_MODEL_ROOM_BUILD_MEAN_PATTERNS_H

#include "model/room/build/resolve.h"

/* Sets front, back and pattern_mean of surfaces in the room whose finish has a pattern,
 * after all surfaces of the room are made. Reports patterns that give reflectances
 * outside 0 to 1, or no value, and patterns on surfaces outside. */
enum pp_status pp_build_mean_patterns(struct pp_resolver *r, struct pp_error *err);

#endif
