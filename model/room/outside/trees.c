/* trees.c - see trees.h. */
#include "model/room/outside/trees.h"

#include <math.h>

#include "model/base/array.h"
#include "model/geometry/tolerance.h"
#include "model/room/build/device_states.h"
#include "model/room/position.h"

enum { SIDES = 12 };

/* Greatest difference in height (m) between neighbouring points of a crown that are
 * tested. */
static const double CHECKED_M = 0.25;

/* Corner of the crown. The cross-section has the area of a circle of the crown's width:
 * n/2 R^2 sin(2 pi/n) = pi r^2. */
static struct pp_vec3 crown_corner(const struct pp_tree *tree, int side, double z)
{
    double step = 2.0 * PP_PI / SIDES;
    double radius = 0.5 * tree->crown_width_m * sqrt(step / sin(step));
    return pp_vec(tree->foot.x + radius * cos(step * side),
                  tree->foot.y + radius * sin(step * side), tree->foot.z + z);
}

static enum pp_status add_crown_face(struct pp_world *world, int tree,
                                     const struct pp_vec3 *corners, int count,
                                     struct pp_error *err)
{
    enum pp_status status = pp_array_append(
        &world->outer_panes, world->outer_pane_count, sizeof *world->outer_panes, err);
    if (status != PP_OK)
        return status;
    struct pp_outer_pane *pane = &world->outer_panes[world->outer_pane_count];
    *pane = (struct pp_outer_pane){.up = {0.0, 0.0, 1.0}, .opening = -1, .tree = tree};
    status = pp_polygon_of(&pane->outline, corners, count, err);
    world->outer_pane_count += status == PP_OK;
    return status;
}

static enum pp_status add_crown(struct pp_world *world, int index, struct pp_error *err)
{
    const struct pp_tree *tree = &world->trees[index];
    double low = tree->crown_base_m, high = tree->height_m;
    struct pp_vec3 under[SIDES], over[SIDES];
    enum pp_status status = PP_OK;
    for (int i = 0; i < SIDES; i++) {
        over[i] = crown_corner(tree, i, high);
        under[i] = crown_corner(tree, SIDES - i, low);
    }
    for (int i = 0; i < SIDES && status == PP_OK; i++)
        status = add_crown_face(world, index,
                                (struct pp_vec3[]){crown_corner(tree, i, low),
                                                   crown_corner(tree, i + 1, low),
                                                   crown_corner(tree, i + 1, high),
                                                   crown_corner(tree, i, high)},
                                4, err);
    if (status == PP_OK)
        status = add_crown_face(world, index, over, SIDES, err);
    /* The ground closes a crown that stands on it. */
    if (status == PP_OK && low > PP_SAME_M)
        status = add_crown_face(world, index, under, SIDES, err);
    return status;
}

/* True if the point is within the crown. */
static bool is_in_crown(const struct pp_tree *tree, struct pp_vec3 point)
{
    double up = point.z - tree->foot.z;
    return up > tree->crown_base_m && up < tree->height_m
           && hypot(point.x - tree->foot.x, point.y - tree->foot.y)
                  < 0.5 * tree->crown_width_m;
}

/* True if part of the crown is in the room. Tests the corners of the room, and points
 * around the crown at heights up to CHECKED_M apart. */
static bool reaches_into_room(const struct pp_world *world, const struct pp_tree *tree)
{
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++)
            if (is_in_crown(tree, world->surfaces[i].outline.vertices[k]))
                return true;
    struct pp_bounds3 room = pp_position_bounds(world);
    double low = fmax(tree->crown_base_m, room.low.z - tree->foot.z);
    double high = fmin(tree->height_m, room.high.z - tree->foot.z);
    if (!(high > low))
        return false;
    int levels = 1 + (int)((high - low) / CHECKED_M);
    for (int i = 0; i <= levels; i++)
        for (int side = 0; side < SIDES; side++) {
            double z = low + (high - low) * i / levels;
            if (pp_position_in_room(world, crown_corner(tree, side, z))
                || pp_position_in_room(
                    world, pp_vec(tree->foot.x, tree->foot.y, tree->foot.z + z)))
                return true;
        }
    return false;
}

enum pp_status pp_build_trees(struct pp_resolver *r, struct pp_error *err)
{
    struct pp_world *world = r->world;
    enum pp_status status = PP_OK;
    for (int i = 0; i < r->room->tree_count && status == PP_OK; i++) {
        const struct pp_tree_part *part = &r->room->trees[i];
        struct pp_tree tree = part->tree;
        tree.foot.z = world->ground_level_m;
        if (!r->watertight)
            continue;
        if (reaches_into_room(world, &tree)) {
            pp_mistakes_add(r->mistakes, tree.line,
                            "tree: its crown reaches into the room; expected a crown "
                            "outside");
            continue;
        }
        status = pp_array_append(&world->trees, world->tree_count, sizeof *world->trees,
                                 err);
        if (status == PP_OK)
            world->trees[world->tree_count++] = tree;
    }
    for (int i = 0; i < world->tree_count && status == PP_OK; i++)
        status = add_crown(world, i, err);
    return status;
}

bool pp_trees_are_bare(const struct pp_world *world, int month)
{
    int from = world->bare_from, to = world->bare_to;
    return from <= to ? month >= from && month <= to : month >= from || month <= to;
}

bool pp_trees_change(const struct pp_world *world)
{
    for (int i = 0; i < world->tree_count; i++)
        if (world->trees[i].winter_transmittance != world->trees[i].transmittance)
            return true;
    return false;
}

enum pp_status pp_trees_in_season(struct pp_world **state, const struct pp_world *world,
                                  bool is_bare, struct pp_error *err)
{
    enum pp_status status = pp_device_states_copy(state, world, err);
    if (status == PP_OK)
        (*state)->trees_are_bare = is_bare;
    return status;
}
