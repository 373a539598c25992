/* light_scene.h - any scene as light sees it: shapes, materials, sky and lamps.
 *
 * Made from a room's world or from a description (an import). Points and directions are
 * the scene's own throughout; what is moved and rounded for the ray kernels stays
 * within. Once made it is only read: any number of threads may ask.
 *
 * Light of a world is over Eh: radiances per steradian of it, irradiances as daylight
 * factors. Light of a description has the description's unit.
 */
#ifndef PP_SIMULATE_SCENE_LIGHT_SCENE_H
#define PP_SIMULATE_SCENE_LIGHT_SCENE_H

#include <stdbool.h>
#include <stdint.h>

#include "model/base/error.h"
#include "model/light/material.h"
#include "model/light/scene_description.h"
#include "model/room/world.h"

struct pp_light_scene;

/* world must live as long as the scene. Shapes have the index of their surface as tag,
 * panes that of the world's surfaces plus their opening's. */
enum pp_status pp_light_scene_of_world(struct pp_light_scene **scene,
                                       const struct pp_world *world,
                                       struct pp_error *err);

/* The same with every finish diffuse, as the tracer and the hand methods have it. */
enum pp_status pp_light_scene_of_world_matt(struct pp_light_scene **scene,
                                            const struct pp_world *world,
                                            struct pp_error *err);

/* Takes what it needs: the description may be cleared. */
enum pp_status pp_light_scene_of_description(struct pp_light_scene **scene,
                                             const struct pp_scene_description *from,
                                             struct pp_error *err);
void pp_light_scene_destroy(struct pp_light_scene *scene); /* NULL is allowed */

/* Where a ray runs, as far as that is known. In a world, one that is indoors can't see
 * the back of the room's envelope: if it does it has slipped through a crack, and counts
 * nothing. A description's rays run anywhere. */
enum pp_space { PP_ANYWHERE, PP_INDOORS, PP_OUTDOORS };

/* Where a point lies: PP_ANYWHERE in a description's scene. */
enum pp_space pp_light_scene_space(const struct pp_light_scene *scene,
                                   struct pp_vec3 point);

struct pp_light_ray {
    struct pp_vec3 from;
    struct pp_vec3 off; /* unit normal of the surface that it leaves, on the side it
                         * leaves to: it won't meet that surface again where it
                         * starts; zero: from a point in the air */
    struct pp_vec3 to;  /* unit */
    enum pp_space space;
};

/* What a ray meets first. A part is a triangle-cut polygon's, a sphere ...: what has
 * one plane or one curve. */
struct pp_light_hit {
    int part; /* -1: nothing */
    int tag;  /* the shape's */
    struct pp_vec3 point;
    struct pp_vec3 normal; /* unit, on the side that was met */
    bool back;             /* was that its back? */
    double distance_m;
    int material;        /* of that side */
    enum pp_space space; /* of a ray that leaves that side */
};

/* False where it meets nothing, or has come through a crack. */
bool pp_light_scene_first(const struct pp_light_scene *scene,
                          const struct pp_light_ray *ray, struct pp_light_hit *hit);

/* Materials by index, as hits name them. A world's are named after their surfaces
 * ("floor", "ceiling", a wall's name, "reveal", "surface", "block", "glazing"), those
 * of backs with " (outside)" behind. */
int pp_light_scene_material_count(const struct pp_light_scene *scene);
const struct pp_material *pp_light_scene_material(const struct pp_light_scene *scene,
                                                  int material);

/* The box round all that is not infinitely far away; of a world also round the room
 * alone where `room` is wanted. Both zero where there is nothing. */
void pp_light_scene_bounds(const struct pp_light_scene *scene, bool room,
                           struct pp_vec3 *low, struct pp_vec3 *high);

/* How much irradiance so many paths from the point may have missed, of light that they
 * find by chance alone: one path's worth of the brightest, or all that there can be of
 * it if that is less. That light is of extended emitters (but for skies with a pattern),
 * and of concentrated ones in curved mirrors, for which plane ones are taken, and by more
 * reflections than they are aimed at by; of all of them if they are not aimed at. */
struct pp_rgb pp_unsampled_bound(const struct pp_light_scene *scene,
                                 struct pp_vec3 point, bool by_chance, long paths);

/* A number that hangs on every shape, material and light of the scene. */
uint64_t pp_light_scene_hash(const struct pp_light_scene *scene);

#endif
