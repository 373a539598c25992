/* variant_scene.h - daylight factors of an imported scene as if it were another: traced.
 *
 * Reflections, glass, frames and dirt, colours, the points' height and a factor can be
 * switched; its sky, ground and surroundings are shapes among others, and stay.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_VARIANT_SCENE_H
#define PP_STUDIES_RESEARCH_COMPARE_VARIANT_SCENE_H

#include "model/light/scene_description.h"
#include "model/room/world.h"
#include "studies/research/compare/room_variant.h"

/* Values at the points over what the scene's sky gives the open level ground, fractions,
 * with their standard errors. PP_BAD_INPUT where a switch does not make sense of a
 * scene, or where the sky gives nothing. */
enum pp_status pp_variant_scene_values(double *values, double *errors,
                                       const struct pp_scene_description *scene,
                                       const struct pp_receiver *points, int count,
                                       const struct pp_room_variant *variant,
                                       const struct pp_variant_tracing *tracing,
                                       struct pp_error *err);

#endif
