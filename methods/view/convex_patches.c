/* convex_patches.c - turns occluders into rings, cuts the open part by each, and
 * gathers the fragments by the light that they show. */
#include "methods/view/convex_patches.h"

#include <stdlib.h>
#include <string.h>

#include "methods/view/fragments.h"
#include "methods/view/occluder_rings.h"
#include "methods/view/overlay.h"
#include "methods/view/ring_cells.h"

/* Adds the open part before any obstruction is removed. */
static enum pp_status add_open(struct pp_fragments *open,
                               const struct pp_visible *visible,
                               const struct pp_patch_builder *builder,
                               struct pp_error *err)
{
    if (builder->open.count == 0)
        return pp_fragments_add(open, (const double(*)[2])visible->ring.xy,
                                visible->ring.count, err);
    double(*triangles)[3][2] = NULL;
    int count = 0;
    enum pp_status status = pp_clipper_triangulate(builder->clipper, &triangles, &count,
                                                   &builder->open, err);
    for (int i = 0; i < count && status == PP_OK; i++)
        status = pp_fragments_add(open, (const double(*)[2])triangles[i], 3, err);
    free(triangles);
    return status;
}

/* The distinct lights of the pieces. A light is a pair of reflectance and exitance. */
struct lights {
    int count;
    int *first; /* index of the first piece with each light */
    int *of;    /* index of the light of each piece */
};

/* Lists the lights in the order of the pieces; the caller frees both arrays. */
static enum pp_status find_lights(struct lights *lights,
                                  const struct pp_occluders *pieces,
                                  struct pp_error *err)
{
    size_t room = ((size_t)pieces->count + 1) * sizeof *lights->first;
    *lights = (struct lights){.first = malloc(room), .of = malloc(room)};
    if (!lights->first || !lights->of)
        return pp_fail_memory(err);
    for (int i = 0; i < pieces->count; i++) {
        int k = 0;
        while (k < lights->count
               && !pp_overlay_same_light(&pieces->list[lights->first[k]],
                                         &pieces->list[i]))
            k++;
        if (k == lights->count)
            lights->first[lights->count++] = i;
        lights->of[i] = k;
    }
    return PP_OK;
}

/* Changes the owner of each fragment from the index of a ring to that of its light. */
static void name_lights(struct pp_fragments *fragments,
                        const struct pp_occluder_rings *rings,
                        const struct lights *lights)
{
    for (int i = 0; i < fragments->count; i++) {
        int *owner = &fragments->list[i].owner;
        if (*owner != PP_FRAGMENT_FREE)
            *owner = lights->of[rings->of[*owner]];
    }
}

/* Copies a fragment to a patch, which has room for it. */
static enum pp_status add_fragment(struct pp_visible_patch *patch,
                                   const struct pp_fragment *fragment,
                                   struct pp_error *err)
{
    size_t size = (size_t)fragment->count * sizeof *fragment->xy;
    double(*xy)[2] = malloc(size);
    if (!xy)
        return pp_fail_memory(err);
    memcpy(xy, fragment->xy, size);
    struct pp_region *region = &patch->region;
    region->rings[region->count++] = (struct pp_ring){fragment->count, xy};
    return PP_OK;
}

/* Adds a patch with room for `count` fragments. hider: a piece with the patch's light;
 * NULL for the sky. */
static enum pp_status begin_patch(struct pp_visible *visible, int count,
                                  const struct pp_occluder *hider, struct pp_error *err)
{
    struct pp_visible_patch *patch = &visible->patches[visible->patch_count];
    *patch = (struct pp_visible_patch){.hidden = hider != NULL};
    if (hider) {
        patch->reflectance = hider->reflectance;
        patch->exitance = hider->exitance;
    }
    patch->region.rings = calloc((size_t)count, sizeof *patch->region.rings);
    if (!patch->region.rings)
        return pp_fail_memory(err);
    visible->patch_count++;
    return PP_OK;
}

/* Adds a patch for the sky and one for each light, if there are fragments that show it.
 * The owner of a fragment is the index of its light. */
static enum pp_status add_patches(struct pp_visible *visible,
                                  const struct pp_fragments *fragments,
                                  const struct lights *lights,
                                  const struct pp_occluders *pieces,
                                  struct pp_error *err)
{
    enum { SKY = PP_FRAGMENT_FREE };
    size_t groups = (size_t)lights->count + 1;
    int *counts = calloc(groups, sizeof *counts),
        *patch = calloc(groups, sizeof *patch);
    visible->patches = calloc(groups, sizeof *visible->patches);
    visible->allocated = true;
    enum pp_status status =
        counts && patch && visible->patches ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < fragments->count && status == PP_OK; i++)
        counts[fragments->list[i].owner - SKY]++;
    for (int k = SKY; k < lights->count && status == PP_OK; k++) {
        patch[k - SKY] = visible->patch_count;
        if (counts[k - SKY] > 0)
            status =
                begin_patch(visible, counts[k - SKY],
                            k == SKY ? NULL : &pieces->list[lights->first[k]], err);
    }
    for (int i = 0; i < fragments->count && status == PP_OK; i++) {
        const struct pp_fragment *fragment = &fragments->list[i];
        status = add_fragment(&visible->patches[patch[fragment->owner - SKY]], fragment,
                              err);
    }
    free(counts);
    free(patch);
    return status;
}

struct hiding {
    const struct pp_occluder_rings *rings;
    struct pp_fragments *hidden;
};

/* Callback (pp_ring_cells_do): removes the parts that rings hide in one cell. */
static enum pp_status hide_cell(void *data, struct pp_fragments *open, const int *rings,
                                int count, struct pp_error *err)
{
    const struct hiding *hiding = data;
    enum pp_status status = PP_OK;
    for (int i = 0; i < count && open->count > 0 && status == PP_OK; i++)
        status = pp_fragments_move(hiding->hidden, open,
                                   &hiding->rings->rings[rings[i]], err);
    return status;
}

/* Removes the parts that pieces hide, and adds them to `hidden` unless it is NULL. The
 * order of the pieces does not matter. */
static enum pp_status hide_parts(struct pp_fragments *open, struct pp_fragments *hidden,
                                 struct pp_occluder_rings *rings, struct pp_error *err)
{
    enum pp_status status = pp_occluder_rings_sort(rings, err);
    if (status == PP_OK)
        status = pp_ring_cells(open, rings->rings, rings->count, hide_cell,
                               &(struct hiding){rings, hidden}, err);
    return status;
}

/* Divides the open part if all pieces have the same light, so that any may hide
 * another. */
static enum pp_status divide_by_one_light(struct pp_fragments *open,
                                          struct pp_occluder_rings *rings,
                                          struct pp_error *err)
{
    struct pp_fragments hidden = {0};
    enum pp_status status = hide_parts(open, &hidden, rings, err);
    for (int i = 0; i < hidden.count; i++)
        hidden.list[i].owner = 0;
    if (status == PP_OK)
        status = pp_fragments_append(open, &hidden, err);
    pp_fragments_clear(&hidden);
    return status;
}

/* Divides the open part among the lights of the pieces. The indices of the lights
 * become the owners of the fragments. */
static enum pp_status divide_by_lights(struct pp_fragments *open,
                                       struct pp_occluder_rings *rings,
                                       const struct lights *lights,
                                       struct pp_error *err)
{
    if (lights->count == 1)
        return divide_by_one_light(open, rings, err);
    enum pp_status status = pp_occluder_rings_cover(open, rings, err);
    if (status == PP_OK)
        name_lights(open, rings, lights);
    return status;
}

enum pp_status pp_convex_patches_fill(struct pp_visible *visible,
                                      const struct pp_patch_builder *builder,
                                      struct pp_error *err)
{
    const struct pp_occluders *inside = &builder->inside, *outside = &builder->outside;
    double distance_m = visible->view.distance_m;
    struct pp_occluder_rings hiding = {0}, rings = {0};
    struct pp_fragments open = {0};
    struct lights lights = {0};
    enum pp_status status = pp_occluder_rings_find(&hiding, inside, distance_m, err);
    if (status == PP_OK)
        status = pp_occluder_rings_find(&rings, outside, distance_m, err);
    if (status == PP_OK)
        status = add_open(&open, visible, builder, err);
    for (int i = 0; i < hiding.count && open.count > 0 && status == PP_OK; i++)
        status = pp_fragments_subtract(&open, &hiding.rings[i], err);
    if (status == PP_OK && builder->sky_only)
        status = hide_parts(&open, NULL, &rings, err);
    else if (status == PP_OK && outside->count > 0) {
        status = find_lights(&lights, outside, err);
        if (status == PP_OK)
            status = divide_by_lights(&open, &rings, &lights, err);
    }
    if (status == PP_OK)
        status = add_patches(visible, &open, &lights, outside, err);
    free(lights.first);
    free(lights.of);
    pp_occluder_rings_clear(&hiding);
    pp_occluder_rings_clear(&rings);
    pp_fragments_clear(&open);
    return status;
}
