/* variant_scene.h - simulated daylight factors of a changed imported scene.
 *
 * Switches can change the number of reflections, glass, frames and dirt, colours, and
 * the height of the points, and can multiply the results by a factor. The switches
 * sky, ground and outside are refused, since in a scene these are ordinary shapes.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_VARIANT_SCENE_H
#define PP_STUDIES_RESEARCH_COMPARE_VARIANT_SCENE_H

#include "model/light/scene_description.h"
#include "model/room/world.h"
#include "studies/research/compare/room_variant.h"

/* Values at the points, with their standard errors: illuminance divided by that of open
 * level ground under the scene's sky, fractions. PP_BAD_INPUT if a switch is not
 * possible in a scene, or if the sky gives no light. */
enum pp_status pp_variant_scene_values(double *values, double *errors,
                                       const struct pp_scene_description *scene,
                                       const struct pp_receiver *points, int count,
                                       const struct pp_room_variant *variant,
                                       const struct pp_variant_tracing *tracing,
                                       struct pp_error *err);

#endif
