/* refusals.h - the reasons, shared by several methods, why a method does not apply to a
 * room, a receiver or an opening.
 *
 * pp_refusals_unless_... and pp_refusals_if_... return one reason or NULL; the others
 * have the signature of a method's refuses_room or refuses (method.h). */
#ifndef PP_METHODS_REFUSALS_H
#define PP_METHODS_REFUSALS_H

#include "model/light/outside_light.h"
#include "model/room/world.h"

/* Sentences for refuses_room. */

/* For methods made for the CIE overcast sky and a plane that faces up. receiver may be
 * NULL. */
const char *pp_refusals_unless_overcast_and_up(const struct pp_outside_light *light,
                                               const struct pp_receiver *receiver);

/* For methods made for a plane that faces up; receiver may be NULL. */
const char *pp_refusals_unless_up(const struct pp_receiver *receiver);

/* For methods without other sources of light than the sky: refuses a world with a
 * self-luminous surface. */
const char *pp_refusals_if_luminous(const struct pp_world *world);

/* Refuses a world with meshes, for methods that draw obstructions as vertical
 * rectangles. */
const char *pp_refusals_if_mesh(const struct pp_world *world);

/* Refuses fine meshes, which would take more than about 5 s, for methods that cut the
 * view of each receiver by obstructions. */
const char *pp_refusals_if_fine_mesh(const struct pp_world *world);

/* refuses_room of methods that refuse self-luminous surfaces only. */
const char *pp_refusals_luminous_room(const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_receiver *receiver);

/* refuses_room of the room formulae, which were made for the CIE overcast sky, a plane
 * that faces up and no other source of light. */
const char *pp_refusals_formula_room(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_receiver *receiver);

/* Reason for `refuses`, as the end of a sentence: the opening is not vertical, for
 * methods made for vertical openings only. */
const char *pp_refusals_unless_vertical(const struct pp_opening *opening);

/* `refuses` of methods whose only condition is a vertical opening. */
const char *pp_refusals_sloping_opening(const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        const struct pp_opening *opening,
                                        const struct pp_receiver *receiver);

#endif
