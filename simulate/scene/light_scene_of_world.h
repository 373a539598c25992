/* light_scene_of_world.h - a light scene made from a room's world. */
#ifndef PP_SIMULATE_SCENE_LIGHT_SCENE_OF_WORLD_H
#define PP_SIMULATE_SCENE_LIGHT_SCENE_OF_WORLD_H

#include "model/light/outside_light.h"
#include "model/room/world.h"
#include "simulate/scene/light_scene.h"

/* world must outlive the scene. Tags of shapes are indices of surfaces; tags of panes
 * are the number of the world's surfaces plus the index of the opening. */
enum pp_status pp_light_scene_of_world(struct pp_light_scene **scene,
                                       const struct pp_world *world,
                                       struct pp_error *err);

/* Makes a scene with the sun as a distant source (per_sky 0: none), for pictures. */
enum pp_status pp_light_scene_of_world_sunlit(struct pp_light_scene **scene,
                                              const struct pp_world *world,
                                              const struct pp_outside_sun *sun,
                                              struct pp_error *err);

/* Makes the scene with every finish diffuse, as used by the tracer and the hand
 * methods. */
enum pp_status pp_light_scene_of_world_matt(struct pp_light_scene **scene,
                                            const struct pp_world *world,
                                            struct pp_error *err);

/* Makes the same scene, but physically rough surfaces keep their own scattering. */
enum pp_status pp_light_scene_of_world_grey(struct pp_light_scene **scene,
                                            const struct pp_world *world,
                                            struct pp_error *err);

/* A point of the world's working plane, uniform by area for two numbers in (0, 1),
 * measured from the scene's centre. */
struct pp_vec3 pp_light_scene_of_world_plane_point(const struct pp_light_scene *scene,
                                                   double u, double v);

#endif
