/* overlay.c - unions and differences of occluders by GEOS, with the line of equal
 * distance as the border between two intersecting pieces. */
#include "methods/view/overlay.h"

#include <stdlib.h>
#include <string.h>

#include "model/geometry/clip.h"

/* Sets up regions of the pieces. The regions use the pieces' own coordinates, which are
 * put in counter-clockwise order. */
static enum pp_status borrow(struct pp_region **regions, struct pp_ring **rings,
                             const struct pp_occluders *pieces, struct pp_error *err)
{
    size_t room = (size_t)pieces->count + 1;
    *regions = calloc(room, sizeof **regions);
    *rings = calloc(room, sizeof **rings);
    if (!*regions || !*rings)
        return pp_fail_memory(err);
    for (int i = 0; i < pieces->count; i++) {
        const struct pp_occluder *piece = &pieces->list[i];
        (*rings)[i] = (struct pp_ring){piece->count, piece->xy};
        (*regions)[i] = (struct pp_region){1, &(*rings)[i]};
        if (pp_region_area(&(*regions)[i]) < 0.0)
            for (int a = 0, b = piece->count - 1; a < b; a++, b--) {
                double swap[2];
                memcpy(swap, piece->xy[a], sizeof swap);
                memcpy(piece->xy[a], piece->xy[b], sizeof swap);
                memcpy(piece->xy[b], swap, sizeof swap);
            }
    }
    return PP_OK;
}

enum pp_status pp_overlay_union(struct pp_clipper *clipper, struct pp_region *whole,
                                const struct pp_occluders *pieces, struct pp_error *err)
{
    struct pp_region *regions;
    struct pp_ring *rings;
    *whole = (struct pp_region){0};
    enum pp_status status = borrow(&regions, &rings, pieces, err);
    if (status == PP_OK)
        status = pieces->count == 1
                     ? pp_region_copy(whole, &regions[0], err)
                     : pp_clipper_union(clipper, whole, regions, pieces->count, err);
    free(regions);
    free(rings);
    return status;
}

bool pp_overlay_same_light(const struct pp_occluder *a, const struct pp_occluder *b)
{
    return a->reflectance == b->reflectance && a->exitance == b->exitance;
}

/* The part of `hider` in front of `piece`, up to the line on which both are at the same
 * distance. */
static enum pp_status part_in_front(struct pp_occluders *parts,
                                    const struct pp_occluder *hider,
                                    const struct pp_occluder *piece, double distance_m,
                                    struct pp_error *err)
{
    int count = hider->count;
    struct pp_vec3 *from = malloc((size_t)count * sizeof *from);
    struct pp_vec3 *left = malloc(((size_t)count + 1) * sizeof *left);
    double(*xy)[2] = malloc(((size_t)count + 1) * sizeof *xy);
    if (!from || !left || !xy) {
        free(from);
        free(left);
        free(xy);
        return pp_fail_memory(err);
    }
    for (int i = 0; i < count; i++)
        from[i] = pp_vec(hider->xy[i][0], hider->xy[i][1], distance_m);
    count = pp_clip_convex(left, from, count,
                           pp_vec_sub(hider->nearness, piece->nearness), 0.0);
    double extent = 0.0;
    for (int i = 0; i < count; i++) {
        xy[i][0] = left[i].x;
        xy[i][1] = left[i].y;
        extent = fmax(extent, hypot(left[i].x - left[0].x, left[i].y - left[0].y));
    }
    count = pp_clip_tidy(xy, count, 2e-15 * extent);
    free(from);
    free(left);
    if (count == 0) {
        free(xy);
        return PP_OK;
    }
    parts->list[parts->count++] = (struct pp_occluder){.count = count, .xy = xy};
    return PP_OK;
}

static struct pp_bounds2 occluder_bounds(const struct pp_occluder *piece)
{
    struct pp_bounds2 bounds = pp_bounds2_empty();
    for (int i = 0; i < piece->count; i++)
        pp_bounds2_add(&bounds, piece->xy[i][0], piece->xy[i][1]);
    return bounds;
}

static bool are_apart(const struct pp_bounds2 *a, const struct pp_bounds2 *b)
{
    return a->low[0] > b->high[0] || a->high[0] < b->low[0] || a->low[1] > b->high[1]
           || a->high[1] < b->low[1];
}

/* Visible part of piece `index`: its region, less those parts of pieces with different
 * light that are in front of it. */
static enum pp_status seen_part(struct pp_clipper *clipper, struct pp_region *seen,
                                const struct pp_occluders *pieces, int index,
                                double distance_m, struct pp_error *err)
{
    const struct pp_occluder *piece = &pieces->list[index];
    struct pp_occluders nearer = {0}, self = {1, 1, &pieces->list[index]};
    struct pp_region taken = {0}, whole = {0};
    nearer.capacity = pieces->count;
    nearer.list = calloc((size_t)nearer.capacity, sizeof *nearer.list);
    enum pp_status status = nearer.list ? PP_OK : pp_fail_memory(err);
    struct pp_bounds2 own = occluder_bounds(piece);
    for (int k = 0; k < pieces->count && status == PP_OK; k++) {
        struct pp_bounds2 other = occluder_bounds(&pieces->list[k]);
        if (!pp_overlay_same_light(&pieces->list[k], piece) && !are_apart(&own, &other))
            status = part_in_front(&nearer, &pieces->list[k], piece, distance_m, err);
    }
    if (status == PP_OK)
        status = pp_overlay_union(clipper, &whole, &self, err);
    if (status == PP_OK && nearer.count > 0)
        status = pp_overlay_union(clipper, &taken, &nearer, err);
    if (status == PP_OK)
        status = pp_clipper_difference(clipper, seen, &whole, &taken, err);
    pp_region_clear(&taken);
    pp_region_clear(&whole);
    pp_occluders_clear(&nearer);
    return status;
}

enum pp_status pp_overlay_seen(struct pp_clipper *clipper, struct pp_region *seen,
                               const struct pp_occluders *pieces, int index,
                               double distance_m, struct pp_error *err)
{
    int count = pieces->count, found = 0;
    struct pp_region *parts = calloc((size_t)count, sizeof *parts);
    enum pp_status status = parts ? PP_OK : pp_fail_memory(err);
    *seen = (struct pp_region){0};
    for (int i = index; i < count && status == PP_OK; i++)
        if (pp_overlay_same_light(&pieces->list[i], &pieces->list[index])) {
            status = seen_part(clipper, &parts[found], pieces, i, distance_m, err);
            if (status == PP_OK)
                found++;
        }
    if (status == PP_OK)
        status = pp_clipper_union(clipper, seen, parts, found, err);
    for (int i = 0; i < found; i++)
        pp_region_clear(&parts[i]);
    free(parts);
    return status;
}
