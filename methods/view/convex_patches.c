/* convex_patches.c - turns occluders into rings, cuts the open part by each, and gathers
 * the fragments by the light that they show. */
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

/* True if a fragment shows the light of `hider`, or the sky if that is NULL. rings:
 * owners of fragments, parts of the pieces. */
static bool shows(const struct pp_fragment *fragment,
                  const struct pp_occluder_rings *rings,
                  const struct pp_occluders *pieces, const struct pp_occluder *hider)
{
    bool sky = fragment->owner == PP_FRAGMENT_FREE;
    return sky == !hider
           && (sky
               || pp_overlay_same_light(hider,
                                        &pieces->list[rings->of[fragment->owner]]));
}

/* Adds a patch of the fragments that show the light of `hider`, or the sky if hider is
 * NULL. Without rings the patch has all fragments. */
static enum pp_status add_patch(struct pp_visible *visible,
                                const struct pp_fragments *fragments,
                                const struct pp_occluder_rings *rings,
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
        if (rings && !shows(fragment, rings, pieces, hider))
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

/* Finds, for each different light, the first piece with that light, in order; the
 * caller frees *first. */
static enum pp_status find_lights(int **first, int *count,
                                  const struct pp_occluders *pieces,
                                  struct pp_error *err)
{
    *count = 0;
    *first = malloc(((size_t)pieces->count + 1) * sizeof **first);
    if (!*first)
        return pp_fail_memory(err);
    for (int i = 0; i < pieces->count; i++) {
        int k = 0;
        while (k < *count
               && !pp_overlay_same_light(&pieces->list[(*first)[k]], &pieces->list[i]))
            k++;
        if (k == *count)
            (*first)[(*count)++] = i;
    }
    return PP_OK;
}

struct hiding {
    const struct pp_occluder_rings *rings;
    struct pp_fragments *hidden;
};

/* pp_ring_cells_do */
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

/* Divides the open part if all pieces have the same light, so that any may hide
 * another. */
static enum pp_status divide_by_one_light(struct pp_visible *visible,
                                          struct pp_fragments *open,
                                          struct pp_occluder_rings *rings,
                                          const struct pp_occluders *pieces,
                                          struct pp_error *err)
{
    struct pp_fragments hidden = {0};
    enum pp_status status = pp_occluder_rings_sort(rings, err);
    if (status == PP_OK)
        status = pp_ring_cells(open, rings->rings, rings->count, hide_cell,
                               &(struct hiding){rings, &hidden}, err);
    if (status == PP_OK)
        status = add_patch(visible, open, NULL, pieces, NULL, err);
    if (status == PP_OK && hidden.count > 0)
        status = add_patch(visible, &hidden, NULL, pieces, &pieces->list[0], err);
    pp_fragments_clear(&hidden);
    return status;
}

/* Divides the open part among the lights, given the first piece of each. */
static enum pp_status divide_by_lights(struct pp_visible *visible,
                                       struct pp_fragments *open,
                                       const struct pp_occluder_rings *rings,
                                       const struct pp_occluders *pieces,
                                       const int *first, int lights,
                                       struct pp_error *err)
{
    enum pp_status status = pp_occluder_rings_cover(open, rings, err);
    if (status == PP_OK)
        status = add_patch(visible, open, rings, pieces, NULL, err);
    for (int k = 0; k < lights && status == PP_OK; k++)
        status = add_patch(visible, open, rings, pieces, &pieces->list[first[k]], err);
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
    int *first = NULL, lights = 0;
    enum pp_status status = pp_occluder_rings_find(&hiding, inside, distance_m, err);
    if (status == PP_OK)
        status = pp_occluder_rings_find(&rings, outside, distance_m, err);
    if (status == PP_OK)
        status = add_open(&open, visible, builder, err);
    for (int i = 0; i < hiding.count && open.count > 0 && status == PP_OK; i++)
        status = pp_fragments_subtract(&open, &hiding.rings[i], err);
    if (status == PP_OK)
        status = find_lights(&first, &lights, outside, err);

    visible->patches = calloc((size_t)lights + 1, sizeof *visible->patches);
    visible->allocated = true;
    if (!visible->patches)
        status = pp_fail_memory(err);
    if (status == PP_OK)
        status = lights < 2 ? divide_by_one_light(visible, &open, &rings, outside, err)
                            : divide_by_lights(visible, &open, &rings, outside, first,
                                               lights, err);
    free(first);
    pp_occluder_rings_clear(&hiding);
    pp_occluder_rings_clear(&rings);
    pp_fragments_clear(&open);
    return status;
}
