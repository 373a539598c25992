/* site_trees.c - see site_trees.h. */
#include "studies/site/site_trees.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"

/* Trees are equal if none of their lengths differs by this much (m). */
static const double same_m = 0.01;

static struct pp_site_tree tree_of(const struct pp_world *world, int index)
{
    const struct pp_tree *tree = &world->trees[index];
    return (struct pp_site_tree){
        .foot = pp_placement_to_building(&world->placement, tree->foot),
        .crown_base_m = tree->crown_base_m,
        .height_m = tree->height_m,
        .crown_width_m = tree->crown_width_m,
        .transmittance = tree->transmittance,
        .winter_transmittance = tree->winter_transmittance};
}

static bool is_same_tree(const struct pp_site_tree *a, const struct pp_site_tree *b)
{
    return pp_vec_length(pp_vec_sub(a->foot, b->foot)) < same_m
           && fabs(a->crown_base_m - b->crown_base_m) < same_m
           && fabs(a->height_m - b->height_m) < same_m
           && fabs(a->crown_width_m - b->crown_width_m) < same_m;
}

static bool has_tree(const struct pp_world *world, const struct pp_site_tree *tree)
{
    for (int i = 0; i < world->tree_count; i++) {
        struct pp_site_tree other = tree_of(world, i);
        if (is_same_tree(&other, tree))
            return true;
    }
    return false;
}

static enum pp_status add_tree(struct pp_site_sheet *sheet, struct pp_site_tree tree,
                               enum pp_site_when when, struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&sheet->trees, sheet->tree_count, sizeof *sheet->trees, err);
    tree.when = when;
    if (status == PP_OK)
        sheet->trees[sheet->tree_count++] = tree;
    return status;
}

enum pp_status pp_site_trees_add(struct pp_site_sheet *sheet,
                                 const struct pp_world *world,
                                 const struct pp_world *before, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->tree_count && status == PP_OK; i++) {
        struct pp_site_tree tree = tree_of(world, i);
        bool is_new = before && !has_tree(before, &tree);
        status = add_tree(sheet, tree, is_new ? PP_SITE_NEW : PP_SITE_ALWAYS, err);
    }
    for (int i = 0; before && i < before->tree_count && status == PP_OK; i++) {
        struct pp_site_tree tree = tree_of(before, i);
        if (!has_tree(world, &tree))
            status = add_tree(sheet, tree, PP_SITE_GONE, err);
    }
    return status;
}

/* True if the tree stands in front of all walls that its crown covers; if it covers
 * none, in front of any wall. */
static bool is_in_front(const struct pp_site_elevation *elevation,
                        const struct pp_bounds2 *crown, double front_m)
{
    double least = INFINITY;
    for (int i = 0; i < elevation->wall_count; i++) {
        const struct pp_elevation_wall *wall = &elevation->walls[i];
        struct pp_bounds2 box = pp_region_bounds(&wall->outline);
        if (crown->low[0] < box.high[0] && crown->high[0] > box.low[0]
            && front_m <= wall->front_m)
            return false;
        least = fmin(least, wall->front_m);
    }
    return front_m > least;
}

/* Position of a crown's tree along the direction that the walls face. */
static double front_of(const struct pp_site_elevation *elevation,
                       const struct pp_site_sheet *site, int crown)
{
    return pp_vec_dot(site->trees[elevation->crown_trees[crown]].foot, elevation->out);
}

enum pp_status pp_site_trees_in_front(struct pp_site_elevation *elevation,
                                      const struct pp_site_sheet *site,
                                      struct pp_error *err)
{
    size_t most = (size_t)site->tree_count + 1;
    elevation->crowns = malloc(most * sizeof *elevation->crowns);
    elevation->crown_trees = malloc(most * sizeof *elevation->crown_trees);
    if (!elevation->crowns || !elevation->crown_trees)
        return pp_fail_memory(err);
    for (int i = 0; i < site->tree_count; i++) {
        const struct pp_site_tree *tree = &site->trees[i];
        double u = pp_vec_dot(tree->foot, elevation->right);
        double radius = 0.5 * tree->crown_width_m;
        double front_m = pp_vec_dot(tree->foot, elevation->out);
        struct pp_bounds2 crown = {{u - radius, tree->foot.z + tree->crown_base_m},
                                   {u + radius, tree->foot.z + tree->height_m}};
        if (tree->when == PP_SITE_GONE || crown.high[0] <= elevation->low[0]
            || crown.low[0] >= elevation->high[0]
            || !is_in_front(elevation, &crown, front_m))
            continue;
        int at = elevation->crown_count++;
        for (; at > 0 && front_of(elevation, site, at - 1) < front_m; at--) {
            elevation->crowns[at] = elevation->crowns[at - 1];
            elevation->crown_trees[at] = elevation->crown_trees[at - 1];
        }
        elevation->crowns[at] = crown;
        elevation->crown_trees[at] = i;
    }
    return PP_OK;
}
