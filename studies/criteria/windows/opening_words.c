/* opening_words.c - see opening_words.h. */
#include "studies/criteria/windows/opening_words.h"

#include <stdio.h>

void pp_opening_words(char words[PP_OPENING_WORDS], const struct pp_world *world,
                      const struct pp_opening *opening)
{
    const struct pp_surface *face = &world->surfaces[opening->face];
    const char *name = face->name                 ? face->name
                       : face->role == PP_CEILING ? "ceiling"
                                                  : "opening";
    snprintf(words, PP_OPENING_WORDS, "%s, %.24s", opening->label, name);
}
