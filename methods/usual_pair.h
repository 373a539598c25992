/* usual_pair.h - the pair of methods whose daylight factors stand for a room where the user
 * has chosen none.
 *
 * It is exact+bre, and where bre does not cover the room (another sky than the overcast
 * one, glass that is not vertical, receivers that do not face up) exact+split-flux, which
 * covers all. Command line, criteria, sizing and charts ask here, so that none of them
 * judges a room by another pair than the next.
 */
#ifndef PP_METHODS_USUAL_PAIR_H
#define PP_METHODS_USUAL_PAIR_H

#include "model/light/outside_light.h"
#include "model/room/world.h"

struct pp_usual_pair {
    const char *name;    /* as a selection has it: "exact+bre"; static */
    const char *instead; /* the pair in whose place it stands, static; NULL: it is the
                          * first choice */
    char why[256];       /* the reason: "bre: the opening on line 12 slopes ..."; empty
                          * without `instead` */
};

/* The pair for the room and the receivers (NULL and 0: the room alone). */
struct pp_usual_pair pp_usual_pair(const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_receiver *receivers, int count);

#endif
