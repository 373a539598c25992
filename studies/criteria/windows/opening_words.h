/* opening_words.h - names of openings in findings. */
#ifndef PP_STUDIES_CRITERIA_WINDOWS_OPENING_WORDS_H
#define PP_STUDIES_CRITERIA_WINDOWS_OPENING_WORDS_H

#include "model/room/world.h"

enum { PP_OPENING_WORDS = 64 };

/* Words for an opening: its label and its face: "W1, south". */
void pp_opening_words(char words[PP_OPENING_WORDS], const struct pp_world *world,
                      const struct pp_opening *opening);

#endif
