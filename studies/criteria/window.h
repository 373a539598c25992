/* window.h - how criteria name an opening. */
#ifndef PP_STUDIES_CRITERIA_WINDOW_H
#define PP_STUDIES_CRITERIA_WINDOW_H

#include "model/room/world.h"

enum { PP_WINDOW_WORDS = 64 };

/* "south, line 9": its face and its line in the room file. */
const char *pp_window_words(char words[PP_WINDOW_WORDS], const struct pp_world *world,
                            const struct pp_opening *opening);

/* Is its glass upright, to a degree? What is wanted of windows in walls does not hold
 * for rooflights. */
bool pp_window_is_upright(const struct pp_opening *opening);

#endif
