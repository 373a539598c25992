#include "studies/criteria/window.h"

#include <math.h>
#include <stdio.h>

const char *pp_window_words(char words[PP_WINDOW_WORDS], const struct pp_world *world,
                            const struct pp_opening *opening)
{
    const struct pp_surface *face = &world->surfaces[opening->face];
    const char *name = face->name                 ? face->name
                       : face->role == PP_CEILING ? "ceiling"
                                                  : "opening";
    snprintf(words, PP_WINDOW_WORDS, "%.40s, line %d", name, opening->line);
    return words;
}

bool pp_window_is_upright(const struct pp_opening *opening)
{
    return fabs(opening->slope_rad - PP_PI / 2.0) < 1.0 * PP_RAD;
}
