/* visible.h - the view of the outside through an opening, divided into patches.
 *
 * The part of the opening's plane within both its outlines (the outer one projected
 * centrally on to the inner), without the parts that occluders inside hide, is divided
 * into patches that show sky and ground and patches that show an obstruction. Patches
 * do not overlap and are exact: outlines of surfaces are projected and overlaid as
 * polygons. Of two obstructions of different reflectance in one direction the nearer
 * one counts; their border is the straight line of equal distances.
 */
#ifndef PP_METHODS_VIEW_VISIBLE_H
#define PP_METHODS_VIEW_VISIBLE_H

#include <stdbool.h>

#include "model/geometry/projection.h"
#include "model/geometry/region.h"
#include "model/light/sky.h"
#include "model/room/world.h"

/* A part of the view's plane: the part of `region` (in the view's coordinates) within
 * the half-spaces through the eye (in the room's axes). */
struct pp_visible_patch {
    struct pp_region region; /* may be shared with other patches */
    struct pp_vec3 half_spaces[2];
    int half_space_count;
    bool hidden;                  /* true: an obstruction; false: sky and ground */
    double reflectance, exitance; /* properties of the obstruction */
};

enum { PP_CORNERS_FEW = 16 };

/* Must not be copied: members point to other members. Several threads may fill
 * different views at once. */
struct pp_visible {
    struct pp_projection view;
    int patch_count; /* 0: the opening is not seen */
    struct pp_visible_patch *patches;

    /* Storage for the patches of a rectangle without occluders and with at most one
     * skyline; the patches of any other view are allocated. */
    struct pp_visible_patch few[3];
    struct pp_ring ring;
    double corners[PP_CORNERS_FEW][2];
    bool allocated;
};

/* View through an opening from a point inside; no patches if the point is behind the
 * opening or within PP_OCCLUDERS_COPLANAR_M of its plane. On success the caller clears
 * *visible. */
enum pp_status pp_visible_through(struct pp_visible *visible,
                                  const struct pp_world *world,
                                  const struct pp_opening *opening, struct pp_vec3 eye,
                                  struct pp_error *err);

/* View through an opening as by pp_visible_through, but faster, for sums: patches among
 * obstructions outside are sets of adjacent convex rings, not outlines. */
enum pp_status pp_visible_in_parts(struct pp_visible *visible,
                                   const struct pp_world *world,
                                   const struct pp_opening *opening, struct pp_vec3 eye,
                                   struct pp_error *err);

/* As pp_visible_in_parts, but may leave out the patches that show obstructions; faster
 * if there are many obstructions. */
enum pp_status pp_visible_sky(struct pp_visible *visible, const struct pp_world *world,
                              const struct pp_opening *opening, struct pp_vec3 eye,
                              struct pp_error *err);

/* Works like pp_visible_through, without obstructions outside. Gives one patch, the
 * part of the opening that no occluder inside hides, or none. */
enum pp_status pp_visible_opening(struct pp_visible *visible,
                                  const struct pp_world *world,
                                  const struct pp_opening *opening, struct pp_vec3 eye,
                                  struct pp_error *err);

/* Finds the patch of pp_visible_opening as a region on the plane at unit distance: x
 * along opening->along, y along opening->up, both from the foot of the perpendicular
 * and divided by the distance from the face's plane. The region is not cut at the
 * position's horizon. It is empty if the position lies behind the opening or in its
 * plane. The region may consist of adjacent convex rings; the caller clears it. */
enum pp_status pp_visible_open_part(struct pp_region *region,
                                    const struct pp_world *world,
                                    const struct pp_opening *opening,
                                    struct pp_vec3 position, struct pp_error *err);

/* Finds the visible parts, from outside, through a rectangle in the air from low to
 * high along the view's axes. All surfaces in front of the eye are obstructions, except
 * the surface with index `face`; its skylines are included. -1: no such surface. */
enum pp_status pp_visible_in_air(struct pp_visible *visible,
                                 const struct pp_world *world,
                                 const struct pp_projection *view, const double low[2],
                                 const double high[2], int face, struct pp_error *err);

void pp_visible_clear(struct pp_visible *visible);

/* Luminance factor of an obstruction: its luminance divided by that of the sky behind
 * it. Equal to the reflectance under the overcast sky, and to half of the reflectance
 * under other skies. */
double pp_visible_luminance_factor(const struct pp_sky *sky, double reflectance);

#endif
