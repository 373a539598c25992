/* cache_octree.c - splits the cells of the octree as records are added, and finds the
 * cells that contain a point. */
#include "simulate/cache/cache_octree.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"

enum { MOST_LEVELS = 20 };

static enum pp_status new_cell(struct pp_cache_octree *tree, int *cell,
                               struct pp_error *err)
{
    enum pp_status status =
        pp_array_reserve(&tree->cells, &tree->cell_capacity, tree->cell_count + 1,
                         sizeof *tree->cells, err);
    if (status != PP_OK)
        return status;
    *cell = tree->cell_count++;
    tree->cells[*cell] = (struct pp_cache_octree_cell){.first = -1};
    return PP_OK;
}

enum pp_status pp_cache_octree_init(struct pp_cache_octree *tree, struct pp_vec3 low,
                                    double size_m, struct pp_error *err)
{
    *tree = (struct pp_cache_octree){.low = low, .size_m = size_m};
    return pp_cache_octree_reset(tree, err);
}

void pp_cache_octree_clear(struct pp_cache_octree *tree)
{
    free(tree->cells);
    free(tree->links);
    *tree = (struct pp_cache_octree){.cells = NULL};
}

enum pp_status pp_cache_octree_reset(struct pp_cache_octree *tree, struct pp_error *err)
{
    int root;
    tree->cell_count = tree->link_count = 0;
    return new_cell(tree, &root, err);
}

static struct pp_cache_octree_cube root_of(const struct pp_cache_octree *tree)
{
    return (struct pp_cache_octree_cube){0, tree->low, tree->size_m};
}

static struct pp_cache_octree_cube child_of(const struct pp_cache_octree *tree,
                                            const struct pp_cache_octree_cube *cube,
                                            int which)
{
    double half = 0.5 * cube->size_m;
    struct pp_vec3 low = cube->low;
    low.x += which & 1 ? half : 0.0;
    low.y += which & 2 ? half : 0.0;
    low.z += which & 4 ? half : 0.0;
    return (struct pp_cache_octree_cube){tree->cells[cube->cell].children[which], low,
                                         half};
}

static bool touches(const struct pp_cache_octree_cube *cube, struct pp_vec3 point,
                    double radius_m)
{
    struct pp_vec3 off = pp_vec_sub(point, cube->low);
    double most = cube->size_m + radius_m;
    return off.x >= -radius_m && off.x <= most && off.y >= -radius_m && off.y <= most
           && off.z >= -radius_m && off.z <= most;
}

static enum pp_status add_link(struct pp_cache_octree *tree, int cell, int record,
                               struct pp_error *err)
{
    enum pp_status status =
        pp_array_reserve(&tree->links, &tree->link_capacity, tree->link_count + 1,
                         sizeof *tree->links, err);
    if (status != PP_OK)
        return status;
    tree->links[tree->link_count] =
        (struct pp_cache_octree_link){record, tree->cells[cell].first};
    tree->cells[cell].first = tree->link_count++;
    return PP_OK;
}

static enum pp_status add_below(struct pp_cache_octree *tree,
                                struct pp_cache_octree_cube cube, int record,
                                struct pp_vec3 point, double radius_m, int level,
                                struct pp_error *err)
{
    if (cube.size_m < 3.0 * radius_m || level >= MOST_LEVELS)
        return add_link(tree, cube.cell, record, err);
    for (int which = 0; which < 8; which++) {
        struct pp_cache_octree_cube child = child_of(tree, &cube, which);
        if (!touches(&child, point, radius_m))
            continue;
        enum pp_status status = PP_OK;
        if (child.cell == 0) {
            status = new_cell(tree, &child.cell, err);
            if (status == PP_OK)
                tree->cells[cube.cell].children[which] = child.cell;
        }
        if (status == PP_OK)
            status = add_below(tree, child, record, point, radius_m, level + 1, err);
        if (status != PP_OK)
            return status;
    }
    return PP_OK;
}

enum pp_status pp_cache_octree_add(struct pp_cache_octree *tree, int record,
                                   struct pp_vec3 point, double radius_m,
                                   struct pp_error *err)
{
    struct pp_cache_octree_cube root = root_of(tree);
    if (!touches(&root, point, 0.0))
        return add_link(tree, 0, record, err);
    return add_below(tree, root, record, point, radius_m, 0, err);
}

struct pp_cache_octree_iterator pp_cache_octree_iterator(
    const struct pp_cache_octree *tree, struct pp_vec3 point)
{
    return (struct pp_cache_octree_iterator){tree, point, root_of(tree),
                                             tree->cells[0].first};
}

bool pp_cache_octree_next(struct pp_cache_octree_iterator *iterator, int *record)
{
    while (iterator->link < 0) {
        struct pp_vec3 off = pp_vec_sub(iterator->point, iterator->at.low);
        double half = 0.5 * iterator->at.size_m;
        struct pp_cache_octree_cube child =
            child_of(iterator->tree, &iterator->at,
                     (off.x > half) | (off.y > half) << 1 | (off.z > half) << 2);
        if (child.cell == 0)
            return false;
        iterator->at = child;
        iterator->link = iterator->tree->cells[child.cell].first;
    }
    *record = iterator->tree->links[iterator->link].record;
    iterator->link = iterator->tree->links[iterator->link].next;
    return true;
}

static void visit_below(const struct pp_cache_octree *tree,
                        struct pp_cache_octree_cube cube, struct pp_vec3 point,
                        double radius_m, void (*visit)(void *context, int record),
                        void *context)
{
    for (int i = tree->cells[cube.cell].first; i >= 0; i = tree->links[i].next)
        visit(context, tree->links[i].record);
    for (int which = 0; which < 8; which++) {
        struct pp_cache_octree_cube child = child_of(tree, &cube, which);
        if (child.cell != 0 && touches(&child, point, radius_m))
            visit_below(tree, child, point, radius_m, visit, context);
    }
}

void pp_cache_octree_visit_near(const struct pp_cache_octree *tree,
                                struct pp_vec3 point, double radius_m,
                                void (*visit)(void *context, int record), void *context)
{
    visit_below(tree, root_of(tree), point, radius_m, visit, context);
}
