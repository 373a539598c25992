/* variant_scene.h - simulated daylight factors of a changed imported scene.
 *
 * Reflections, glass, frames and dirt, colours, the points' height and a factor can be
 * changed by switches. The scene's sky, ground and surroundings are ordinary shapes and
 * do not change.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_VARIANT_SCENE_H
#define PP_STUDIES_RESEARCH_COMPARE_VARIANT_SCENE_H

#include "model/light/scene_description.h"
#include "model/room/world.h"
#include "studies/research/compare/room_variant.h"

/* Values at the points over the illuminance of open level ground from the scene's sky,
 * fractions, with their standard errors. PP_BAD_INPUT if a switch is not possible in a
 * scene, or if the sky gives no light. */
enum pp_status pp_variant_scene_values(double *values, double *errors,
                                       const struct pp_scene_description *scene,
                                       const struct pp_receiver *points, int count,
                                       const struct pp_room_variant *variant,
                                       const struct pp_variant_tracing *tracing,
                                       struct pp_error *err);

#endif
