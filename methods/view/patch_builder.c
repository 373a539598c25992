/* patch_builder.c - removes the parts of an opening's outline hidden by occluders
 * inside, and divides the rest among the skylines and obstructions outside.
 *
 * Where half-spaces through the eye suffice (no occluder, at most one skyline), the
 * outline stays one region with half-spaces; else regions are overlaid by GEOS.
 */
#include "methods/view/patch_builder.h"

#include <stdlib.h>

#include "methods/view/convex_patches.h"
#include "methods/view/occluder_rings.h"
#include "methods/view/overlay.h"

void pp_patch_builder_clear(struct pp_patch_builder *builder)
{
    pp_occluders_clear(&builder->inside);
    pp_occluders_clear(&builder->outside);
    pp_region_clear(&builder->open);
    pp_clipper_destroy(builder->clipper);
}

/* Subtracts the occluders inside from builder->open. */
static enum pp_status subtract_inside(struct pp_patch_builder *builder,
                                      struct pp_error *err)
{
    struct pp_region taken, left = {0};
    enum pp_status status =
        pp_overlay_union(builder->clipper, &taken, &builder->inside, err);
    if (status == PP_OK)
        status =
            pp_clipper_difference(builder->clipper, &left, &builder->open, &taken, err);
    pp_region_clear(&taken);
    if (status == PP_OK) {
        pp_region_clear(&builder->open);
        builder->open = left;
        builder->open_is_extent = false;
    }
    return status;
}

/* Moves the region to a new patch, unless it is empty. hider: NULL for sky and
 * ground. */
static void add_patch(struct pp_visible *visible, struct pp_region *region,
                      const struct pp_occluder *hider)
{
    if (region->count == 0)
        return;
    struct pp_visible_patch *patch = &visible->patches[visible->patch_count++];
    *patch = (struct pp_visible_patch){.region = *region, .hidden = hider != NULL};
    if (hider) {
        patch->reflectance = hider->reflectance;
        patch->exitance = hider->exitance;
    }
    *region = (struct pp_region){0};
}

/* True if all pieces give off the same light. */
static bool all_same_light(const struct pp_occluders *pieces)
{
    for (int i = 1; i < pieces->count; i++)
        if (!pp_overlay_same_light(&pieces->list[0], &pieces->list[i]))
            return false;
    return true;
}

/* Finds the union of all pieces outside, and the rest of builder->open, which shows
 * sky. */
static enum pp_status cover(struct pp_patch_builder *builder, struct pp_region *all,
                            struct pp_region *sky, struct pp_error *err)
{
    *sky = (struct pp_region){0};
    enum pp_status status =
        pp_overlay_union(builder->clipper, all, &builder->outside, err);
    if (status == PP_OK)
        status = pp_clipper_difference(builder->clipper, sky, &builder->open, all, err);
    return status;
}

/* True if the areas of `all` and `sky` sum to that of builder->open, and the centre of
 * every piece is in `all`. */
static bool adds_up(const struct pp_patch_builder *builder, const struct pp_region *all,
                    const struct pp_region *sky)
{
    double whole = pp_region_area(&builder->open);
    double rest = whole - pp_region_area(all) - pp_region_area(sky);
    if (!(fabs(rest) <= 1e-13 * whole))
        return false;
    for (int i = 0; i < builder->outside.count; i++) {
        const struct pp_occluder *piece = &builder->outside.list[i];
        double x = 0.0, y = 0.0;
        for (int k = 0; k < piece->count; k++) {
            x += piece->xy[k][0] / piece->count;
            y += piece->xy[k][1] / piece->count;
        }
        if (!pp_region_contains(all, x, y))
            return false;
    }
    return true;
}

/* Divides builder->open if all pieces are visible and have the same light: first
 * without a grid, which is faster, then with the grid if GEOS has lost an area. */
static enum pp_status divide_same_light(struct pp_visible *visible,
                                        struct pp_patch_builder *builder,
                                        struct pp_error *err)
{
    struct pp_region all, sky;
    pp_clipper_set_grid(builder->clipper, 0.0);
    enum pp_status status = cover(builder, &all, &sky, NULL);
    pp_clipper_set_grid(builder->clipper, builder->grid);
    if (status != PP_OK || !adds_up(builder, &all, &sky)) {
        pp_region_clear(&all);
        pp_region_clear(&sky);
        status = cover(builder, &all, &sky, err);
    }
    if (status == PP_OK) {
        add_patch(visible, &sky, NULL);
        add_patch(visible, &all, &builder->outside.list[0]);
    }
    pp_region_clear(&all);
    pp_region_clear(&sky);
    return status;
}

/* Divides builder->open by the pieces outside. */
static enum pp_status divide_open_patches(struct pp_visible *visible,
                                          struct pp_patch_builder *builder,
                                          struct pp_error *err)
{
    const struct pp_occluders *outside = &builder->outside;
    bool one_light = all_same_light(outside);
    enum pp_status status = pp_occluder_rings_drop_hidden(
        &builder->outside, &builder->scene, one_light, err);
    if (status != PP_OK)
        return status;
    visible->patches = calloc((size_t)outside->count + 1, sizeof *visible->patches);
    if (!visible->patches)
        return pp_fail_memory(err);
    visible->allocated = true;
    if (builder->open_is_extent && outside->count > 0 && one_light)
        return divide_same_light(visible, builder, err);

    struct pp_region all, sky;
    status = cover(builder, &all, &sky, err);
    if (status == PP_OK)
        add_patch(visible, &sky, NULL);
    for (int i = 0; i < outside->count && status == PP_OK; i++) {
        bool first = true;
        for (int k = 0; k < i; k++)
            first =
                first && !pp_overlay_same_light(&outside->list[k], &outside->list[i]);
        if (!first)
            continue;
        struct pp_region light = {0}, within = {0};
        status = pp_overlay_seen(builder->clipper, &light, &builder->outside, i,
                                 builder->scene.view->distance_m, err);
        if (status == PP_OK)
            status = pp_clipper_intersection(builder->clipper, &within, &light,
                                             &builder->open, err);
        if (status == PP_OK)
            add_patch(visible, &within, &outside->list[i]);
        pp_region_clear(&light);
        pp_region_clear(&within);
    }
    pp_region_clear(&all);
    pp_region_clear(&sky);
    return status;
}

/* Divides one region by at most one skyline without a distance, whose edges are
 * half-spaces through the eye. */
static void divide_by_skyline(struct pp_visible *visible, struct pp_region region,
                              const struct pp_world *world,
                              const struct pp_skyline *skyline)
{
    visible->patch_count = 1;
    visible->patches[0] = (struct pp_visible_patch){.region = region};
    if (!skyline)
        return;
    struct pp_band band = pp_occluders_band(world, skyline);
    struct pp_vec3 not_above = pp_vec_scale(band.above, -1.0);
    struct pp_vec3 not_below = pp_vec_scale(band.below, -1.0);
    struct pp_visible_patch above = {
        .region = region, .half_spaces = {band.above}, .half_space_count = 1};
    struct pp_visible_patch under = {.region = region,
                                     .half_spaces = {not_above, band.below},
                                     .half_space_count = 2};
    struct pp_visible_patch hidden = {.region = region,
                                      .half_spaces = {not_above, not_below},
                                      .half_space_count = 2,
                                      .hidden = true,
                                      .reflectance = skyline->reflectance};
    visible->patch_count = 3;
    visible->patches[0] = above;
    visible->patches[1] = under;
    visible->patches[2] = hidden;
}

/* The grid on which regions are overlaid: a power of two, about 2^-50 of the largest
 * coordinate. */
static double grid_of(const struct pp_occluders_scene *scene)
{
    int exponent;
    frexp(fmax(fmax(fabs(scene->low[0]), fabs(scene->high[0])),
               fmax(fabs(scene->low[1]), fabs(scene->high[1]))),
          &exponent);
    return ldexp(1.0, exponent - 50);
}

enum pp_status pp_patch_builder_fill(struct pp_visible *visible,
                                     struct pp_patch_builder *builder,
                                     bool with_outside, struct pp_error *err)
{
    struct pp_occluders_scene *scene = &builder->scene;
    const struct pp_world *world = scene->world;
    bool by_ring = builder->open.count == 0;
    enum pp_status status =
        pp_occluders_collect(&builder->inside, &builder->outside, scene, err);
    if (status != PP_OK)
        return status;

    int skylines = 0;
    const struct pp_skyline *skyline = NULL;
    for (int i = 0; with_outside && i < world->skyline_count; i++)
        if (pp_world_skyline_is_far(&world->skylines[i], scene->face)) {
            skyline = &world->skylines[i];
            skylines++;
        }
    bool overlay_outside = with_outside && (builder->outside.count > 0 || skylines > 1);

    if (by_ring && builder->inside.count == 0 && !overlay_outside) {
        visible->patches = visible->few;
        divide_by_skyline(visible, (struct pp_region){1, &visible->ring}, world,
                          skyline);
        return PP_OK;
    }

    /* With a non-convex open part a skyline is treated as a further occluder. */
    if (builder->in_parts && with_outside && builder->inside.count > 0)
        overlay_outside = true;
    for (int i = 0; overlay_outside && i < world->skyline_count && status == PP_OK; i++)
        if (pp_world_skyline_is_far(&world->skylines[i], scene->face))
            status = pp_occluders_add_skyline(&builder->outside, scene,
                                              &world->skylines[i], err);
    if (!with_outside)
        pp_occluders_clear(&builder->outside);
    if (status == PP_OK && builder->in_parts
        && (overlay_outside || builder->inside.count > 0))
        return pp_convex_patches_fill(visible, builder, err);
    if (!builder->clipper && status == PP_OK)
        status = pp_clipper_create(&builder->clipper, err);
    builder->grid = grid_of(scene);
    if (status == PP_OK)
        pp_clipper_set_grid(builder->clipper, builder->grid);
    if (status == PP_OK && by_ring) {
        struct pp_region ring = {1, &visible->ring};
        status = pp_region_copy(&builder->open, &ring, err);
        builder->open_is_extent = true;
    }
    if (status == PP_OK && builder->inside.count > 0)
        status = subtract_inside(builder, err);
    if (status != PP_OK || builder->open.count == 0)
        return status;

    if (!overlay_outside) {
        visible->patches = calloc(3, sizeof *visible->patches);
        if (!visible->patches)
            return pp_fail_memory(err);
        visible->allocated = true;
        divide_by_skyline(visible, builder->open, world, skyline);
        builder->open = (struct pp_region){0};
        return PP_OK;
    }
    return divide_open_patches(visible, builder, err);
}
