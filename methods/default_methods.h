/* default_methods.h - the pair of methods used for daylight factors if the user has
 * chosen none.
 *
 * The pair is exact+bre. If bre does not cover the room (a sky other than the overcast
 * one, glass that is not vertical, receivers that do not face up) it is
 * exact+split-flux, which covers these cases. The command line, criteria, sizing and
 * charts all use this pair.
 */
#ifndef PP_METHODS_DEFAULT_METHODS_H
#define PP_METHODS_DEFAULT_METHODS_H

#include "model/light/outside_light.h"
#include "model/room/world.h"

struct pp_default_methods {
    const char *name;    /* as in a selection: "exact+bre"; static */
    const char *instead; /* the first choice (static) if `name` replaces it; NULL if
                          * `name` is the first choice */
    char why[256];       /* reason why the first choice was replaced: "bre: window W1
                          * slopes ..."; empty if `instead` is NULL */
};

/* The pair for the room and the receivers (NULL and 0: for the room as a whole). */
struct pp_default_methods pp_default_methods(const struct pp_world *world,
                                             const struct pp_outside_light *light,
                                             const struct pp_receiver *receivers,
                                             int count);

#endif
