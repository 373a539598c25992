/* trees.h - crowns of trees, through which part of the light passes straight.
 *
 * A crown is an upright prism of twelve sides, whose cross-section has the area of a
 * circle of the crown's width. Each face is a pane that transmits the square root of
 * the crown's transmittance at every angle, so that a ray through the crown is
 * multiplied by the transmittance once. The rest is absorbed. Leaves reflect and
 * scatter no light, and there is no trunk.
 *
 * Trees have leaves, except in the months without leaves (pp_trees_are_bare). A world
 * has the trees of one season.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_TREES_H
#define PP_MODEL_ROOM_OUTSIDE_TREES_H

#include "model/room/build/resolve.h"

/* Adds the panes of the crowns, after those of the coarse model. Reports crowns that
 * reach into the room. */
enum pp_status pp_build_trees(struct pp_resolver *r, struct pp_error *err);

/* True if the trees have no leaves in that month, 1 to 12. */
bool pp_trees_are_bare(const struct pp_world *world, int month);

/* True if the transmittance of a tree depends on the season. */
bool pp_trees_change(const struct pp_world *world);

/* The world with its trees in one season. It shares everything except the openings with
 * the world, which must outlive it. The caller destroys *state by
 * pp_device_states_destroy. */
enum pp_status pp_trees_in_season(struct pp_world **state, const struct pp_world *world,
                                  bool is_bare, struct pp_error *err);

#endif
