/* convex_room.h - intersection of a ray with an empty convex room, by its planes alone.
 *
 * Any two points of such a room see each other, and a ray in it ends on the nearest
 * plane in front of it: on a pane in that plane or on its face. A few multiplications
 * in double precision replace the ray kernels.
 *
 * The niche of an opening with a reveal is not part of the room in this sense; the
 * mouth of the niche is in the face. A ray through a rectangular mouth ends on the pane
 * or on one of the niche's four sides. The ray kernels process sides of other niches,
 * and rays that start in a niche.
 */
#ifndef PP_SIMULATE_SCENE_CONVEX_ROOM_H
#define PP_SIMULATE_SCENE_CONVEX_ROOM_H

#include "model/base/error.h"
#include "simulate/sampling/lanes.h"
#include "simulate/scene/light_scene.h"
#include "simulate/scene/openings.h"

struct pp_convex_room;
struct pp_world;

/* True if any two points in the room (outside niches) see each other: the room is
 * empty, and no vertex lies behind the plane of a face. */
bool pp_convex_room_is(const struct pp_world *world);

/* Links the sides of every box-shaped niche to its pane, and vice versa. For any room;
 * call after the scene's parts and panes are added. */
void pp_convex_room_find_niches(struct pp_light_scene *scene);

static inline bool pp_convex_room_has_niche(const struct pp_pane *pane)
{
    return pane->sides[0] >= 0;
}

/* The part met by a ray in direction `to` that enters the pane's niche at point `at` of
 * its mouth, and the distance from that point. */
int pp_convex_room_behind_mouth(const struct pp_pane *pane, struct pp_vec3 at,
                                struct pp_vec3 to, double *further_m);

/* Creates the room after the scene's parts and panes are added. On success the caller
 * owns *room. *room is NULL if the scene's world has no such room, or if two faces lie
 * in one plane. */
enum pp_status pp_convex_room_create(struct pp_convex_room **room,
                                     const struct pp_light_scene *scene,
                                     struct pp_error *err);
void pp_convex_room_destroy(struct pp_convex_room *room); /* NULL is allowed */

/* True if the point is in the room and not in a niche. */
bool pp_convex_room_encloses(const struct pp_convex_room *room, struct pp_vec3 point);

/* A ray from the middle of the room, from which the whole room is visible, to a point
 * of its surfaces. */
struct pp_light_ray pp_convex_room_sight(const struct pp_convex_room *room,
                                         struct pp_vec3 point);

/* Index of the first plane that a ray meets, and its distance. -1: none, or the ray
 * starts outside, in a niche, or near the mouth of a niche. */
struct pp_convex_nearest {
    int plane;
    double distance_m;
};

/* Finds the nearest hits of rays that start at one point, in `count` directions (at
 * most PP_RUN_MOST). Elements up to the next multiple of PP_LANES are overwritten.
 * False if the point is outside the room. */
bool pp_convex_room_nearest(const struct pp_convex_room *room, struct pp_vec3 from,
                            const struct pp_lanes_directions *to, int count,
                            struct pp_convex_nearest nearest[PP_RUN_MOST]);

/* The part met by a ray that runs indoors, and its distance. *point: where the ray
 * meets the part's plane. -1 if the ray kernels must be used: the ray starts outside,
 * in a niche or near its mouth, or enters a niche that is not a box. known: the nearest
 * plane of this ray; NULL: unknown. */
int pp_convex_room_meet(const struct pp_convex_room *room,
                        const struct pp_light_scene *scene,
                        const struct pp_light_ray *ray,
                        const struct pp_convex_nearest *known, double *distance_m,
                        struct pp_vec3 *point);

#endif
