/* visible.h - what is seen of the outside through an opening, and what hides the rest.
 *
 * The part of the opening's plane within both its outlines (the outer one projected
 * centrally on to the inner), less what occluders inside hide, is divided into patches:
 * where nothing hides the sky and the ground, and where something does. Patches do not
 * overlap and are exact: outlines of surfaces are projected and overlaid as polygons,
 * and where two things of different reflectance lie behind each other the nearer one
 * counts, the border being the straight line on which they are equally far.
 */
#ifndef PP_METHODS_VIEW_VISIBLE_H
#define PP_METHODS_VIEW_VISIBLE_H

#include <stdbool.h>

#include "model/geometry/projection.h"
#include "model/geometry/region.h"
#include "model/room/world.h"

/* Part of the view's plane: what lies of `region` (its coordinates) within the
 * half-spaces through the eye (room's axes). */
struct pp_visible_patch {
    struct pp_region region; /* may be shared with other patches */
    struct pp_vec3 half_spaces[2];
    int half_space_count;
    bool hidden;                  /* or are sky and ground seen? */
    double reflectance, exitance; /* of what hides them */
};

enum { PP_CORNERS_FEW = 16 };

/* Keep it where it was filled: parts of it point to others. Several threads may each
 * fill their own. */
struct pp_visible {
    struct pp_projection view;
    int patch_count; /* 0: nothing is seen */
    struct pp_visible_patch *patches;

    /* Storage: within for an opening with nothing in front of it but a skyline, so that
     * nothing is allocated; else allocated. */
    struct pp_visible_patch few[3];
    struct pp_ring ring;
    double corners[PP_CORNERS_FEW][2];
    bool allocated;
};

/* Through an opening, from a point inside; no patches if the point lies behind the
 * opening or within PP_OCCLUDERS_COPLANAR_M of its plane. On failure nothing needs to be cleared. */
enum pp_status pp_visible_through(struct pp_visible *visible,
                                  const struct pp_world *world,
                                  const struct pp_opening *opening, struct pp_vec3 eye,
                                  struct pp_error *err);

/* The same without what stands outside: one patch, the part that is open to the
 * outside, or none. */
enum pp_status pp_visible_opening(struct pp_visible *visible,
                                  const struct pp_world *world,
                                  const struct pp_opening *opening, struct pp_vec3 eye,
                                  struct pp_error *err);

/* Through a rectangle in the air, low to high along the view's axes, from outside: all
 * that stands in front of the eye hides. `face` is left out, its skylines count; -1:
 * neither. */
enum pp_status pp_visible_in_air(struct pp_visible *visible,
                                 const struct pp_world *world,
                                 const struct pp_projection *view, const double low[2],
                                 const double high[2], int face, struct pp_error *err);

void pp_visible_clear(struct pp_visible *visible);

#endif
