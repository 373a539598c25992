/* refusals.h - reasons that several methods have for not answering, in one wording. */
#ifndef PP_METHODS_REFUSALS_H
#define PP_METHODS_REFUSALS_H

#include "model/room/world.h"

/* Sentences of refuses_room(); NULL where there is no such reason. */

/* For methods made for the CIE overcast sky and a plane facing up. receiver may be
 * NULL. */
const char *pp_refusals_unless_overcast_and_up(const struct pp_world *world,
                                               const struct pp_receiver *receiver);

/* For methods made for a plane facing up; receiver may be NULL. */
const char *pp_refusals_unless_up(const struct pp_receiver *receiver);

/* For methods that know no source of light but the sky: does a surface give off light
 * by itself? */
const char *pp_refusals_if_luminous(const struct pp_world *world);

/* refuses_room() itself of those that refuse nothing else. */
const char *pp_refusals_luminous_room(const struct pp_world *world,
                                      const struct pp_receiver *receiver);

/* refuses_room() of the room formulae that were made for the CIE overcast sky, a plane
 * that faces up and no other source of light. */
const char *pp_refusals_formula_room(const struct pp_world *world,
                                     const struct pp_receiver *receiver);

/* The end of a sentence of refuses(): for methods that hold vertical openings only. */
const char *pp_refusals_unless_vertical(const struct pp_opening *opening);

/* refuses() itself of those that refuse nothing else. */
const char *pp_refusals_sloping_opening(const struct pp_world *world,
                                        const struct pp_opening *opening,
                                        const struct pp_receiver *receiver);

#endif
