/* convex_patches.c - turns occluders into rings, cuts the open part by each, and gathers
 * the fragments by the light that they show. */
#include "methods/view/convex_patches.h"

#include <stdlib.h>
#include <string.h>

#include "methods/view/fragments.h"
#include "methods/view/overlay.h"

/* Rings of few corners, and the occluder that each is a part of. */
struct occluder_rings {
    int count;
    struct pp_fragment_ring *rings;
    int *of;
    double (*xy)[2];
};

static void clear_rings(struct occluder_rings *rings)
{
    free(rings->rings);
    free(rings->of);
    free(rings->xy);
}

/* Parts of a fan over a ring of `count` corners. */
static int fan_parts(int count)
{
    enum { STEP = PP_FRAGMENT_CORNERS - 2 };
    return count < 3 ? 0 : (count - 2 + STEP - 1) / STEP;
}

static enum pp_status find_rings(struct occluder_rings *rings,
                                 const struct pp_occluders *pieces, double distance_m,
                                 struct pp_error *err)
{
    enum { MOST = PP_FRAGMENT_CORNERS };
    size_t most = 1;
    for (int i = 0; i < pieces->count; i++)
        most += (size_t)fan_parts(pieces->list[i].count);
    *rings = (struct occluder_rings){.rings = malloc(most * sizeof *rings->rings),
                                     .of = malloc(most * sizeof *rings->of),
                                     .xy = malloc(most * MOST * sizeof *rings->xy)};
    if (!rings->rings || !rings->of || !rings->xy)
        return pp_fail_memory(err);
    for (int i = 0; i < pieces->count; i++) {
        const struct pp_occluder *piece = &pieces->list[i];
        for (int from = 1; from + 1 < piece->count; from += MOST - 2) {
            double(*xy)[2] = rings->xy + rings->count * MOST;
            int count = 0;
            memcpy(xy[count++], piece->xy[0], sizeof *xy);
            for (int k = from; k < piece->count && count < MOST; k++)
                memcpy(xy[count++], piece->xy[k], sizeof *xy);
            struct pp_fragment_ring *ring = &rings->rings[rings->count];
            rings->of[rings->count++] = i;
            pp_fragments_close_ring(ring, xy, count);
            ring->depth[0] = -piece->nearness.z * distance_m;
            ring->depth[1] = -piece->nearness.x;
            ring->depth[2] = -piece->nearness.y;
        }
    }
    return PP_OK;
}

/* The open part, before anything hides it. */
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

/* Adds a patch of all fragments that show the light of occluder `hider`, or the sky
 * where that is NULL. */
static enum pp_status add_patch(struct pp_visible *visible,
                                const struct pp_fragments *fragments,
                                const struct occluder_rings *rings,
                                const struct pp_occluders *pieces,
                                const struct pp_occluder *hider, struct pp_error *err)
{
    struct pp_visible_patch *patch = &visible->patches[visible->patch_count];
    *patch = (struct pp_visible_patch){.hidden = hider != NULL};
    if (hider) {
        patch->reflectance = hider->reflectance;
        patch->exitance = hider->exitance;
    }
    struct pp_region *region = &patch->region;
    region->rings = calloc((size_t)fragments->count + 1, sizeof *region->rings);
    if (!region->rings)
        return pp_fail_memory(err);
    visible->patch_count++;
    for (int i = 0; i < fragments->count; i++) {
        const struct pp_fragment *fragment = &fragments->list[i];
        bool sky = fragment->owner == PP_FRAGMENT_FREE;
        if (sky != !hider
            || (hider
                && !pp_overlay_same_light(hider,
                                          &pieces->list[rings->of[fragment->owner]])))
            continue;
        size_t size = (size_t)fragment->count * sizeof *fragment->xy;
        double(*xy)[2] = malloc(size);
        if (!xy)
            return pp_fail_memory(err);
        memcpy(xy, fragment->xy, size);
        region->rings[region->count++] = (struct pp_ring){fragment->count, xy};
    }
    if (region->count == 0) {
        pp_region_clear(region);
        visible->patch_count--;
    }
    return PP_OK;
}

/* The first of the pieces with each light, in their order. */
static bool is_first_of_light(const struct pp_occluders *pieces, int index)
{
    for (int k = 0; k < index; k++)
        if (pp_overlay_same_light(&pieces->list[k], &pieces->list[index]))
            return false;
    return true;
}

enum pp_status pp_convex_patches_fill(struct pp_visible *visible,
                                      const struct pp_patch_builder *builder,
                                      struct pp_error *err)
{
    const struct pp_occluders *inside = &builder->inside, *outside = &builder->outside;
    double distance_m = visible->view.distance_m;
    struct occluder_rings hiding = {0}, rings = {0};
    struct pp_fragments open = {0};
    enum pp_status status = find_rings(&hiding, inside, distance_m, err);
    if (status == PP_OK)
        status = find_rings(&rings, outside, distance_m, err);
    if (status == PP_OK)
        status = add_open(&open, visible, builder, err);
    for (int i = 0; i < hiding.count && open.count > 0 && status == PP_OK; i++)
        status = pp_fragments_subtract(&open, &hiding.rings[i], err);

    int lights = 0;
    for (int i = 0; i < outside->count; i++)
        lights += is_first_of_light(outside, i);
    for (int i = 0; i < rings.count && open.count > 0 && status == PP_OK; i++)
        status = pp_fragments_cover(&open, rings.rings, i, lights < 2, err);

    visible->patches = calloc((size_t)lights + 1, sizeof *visible->patches);
    visible->allocated = true;
    if (!visible->patches)
        status = pp_fail_memory(err);
    if (status == PP_OK)
        status = add_patch(visible, &open, &rings, outside, NULL, err);
    for (int i = 0; i < outside->count && status == PP_OK; i++)
        if (is_first_of_light(outside, i))
            status = add_patch(visible, &open, &rings, outside, &outside->list[i], err);
    clear_rings(&hiding);
    clear_rings(&rings);
    pp_fragments_clear(&open);
    return status;
}
