/* visible.c - the outline of an opening as seen from a point, and the views through an
 * opening and through a rectangle in the air. */
#include "methods/view/visible.h"

#include <stdlib.h>
#include <string.h>

#include "methods/view/patch_builder.h"

static void find_scene_extent(struct pp_occluders_scene *scene)
{
    for (int axis = 0; axis < 2; axis++) {
        scene->low[axis] = scene->high[axis] = scene->outline[0][axis];
        for (int i = 1; i < scene->outline_count; i++) {
            double at = scene->outline[i][axis];
            scene->low[axis] = at < scene->low[axis] ? at : scene->low[axis];
            scene->high[axis] = at > scene->high[axis] ? at : scene->high[axis];
        }
    }
}

/* Intersection of an opening's rectangle with that of the outer end of its reveal; 0
 * corners if empty, else 4. */
static int rectangle_through(double corners[4][2], const double inner[4][2],
                             const double outer[4][2])
{
    double low[2], high[2];
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = fmax(fmin(inner[0][axis], inner[2][axis]),
                         fmin(outer[0][axis], outer[2][axis]));
        high[axis] = fmin(fmax(inner[0][axis], inner[2][axis]),
                          fmax(outer[0][axis], outer[2][axis]));
        if (!(high[axis] > low[axis]))
            return 0;
    }
    const double both[4][2] = {
        {low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
    memcpy(corners, both, sizeof both);
    return 4;
}

/* Projects a polygon from the eye on to the view's plane, as a ring. */
static void project(double (*xy)[2], const struct pp_polygon *outline,
                    const struct pp_projection *view, double depth_m)
{
    double scale = view->distance_m / depth_m;
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 corner = pp_projection_point(view, outline->vertices[i]);
        xy[i][0] = corner.x * scale;
        xy[i][1] = corner.y * scale;
    }
}

/* Sets builder->open to the intersection of both outlines of an opening that is not a
 * rectangle. */
static enum pp_status open_by_overlay(struct pp_patch_builder *builder,
                                      const struct pp_opening *opening,
                                      struct pp_error *err)
{
    const struct pp_projection *view = builder->scene.view;
    int count = opening->inner.count;
    double(*xy)[2] = malloc((size_t)count * sizeof *xy);
    if (!xy)
        return pp_fail_memory(err);
    struct pp_region inner = {0}, outer = {0};
    project(xy, &opening->inner, view, view->distance_m);
    enum pp_status status = pp_clipper_create(&builder->clipper, err);
    if (status == PP_OK)
        status = pp_clipper_of_ring(builder->clipper, &inner, (const double(*)[2])xy,
                                    count, err);
    if (status == PP_OK && !(opening->reveal_m > 0.0)) {
        builder->open = inner;
        free(xy);
        return PP_OK;
    }
    if (status == PP_OK) {
        project(xy, &opening->outer, view, view->distance_m + opening->reveal_m);
        status = pp_clipper_of_ring(builder->clipper, &outer, (const double(*)[2])xy,
                                    count, err);
    }
    if (status == PP_OK)
        status = pp_clipper_intersection(builder->clipper, &builder->open, &inner,
                                         &outer, err);
    free(xy);
    pp_region_clear(&inner);
    pp_region_clear(&outer);
    return status;
}

/* Options of a view. */
struct wanted {
    bool outside, in_parts, sky_only;
};

static enum pp_status through(struct pp_visible *visible, const struct pp_world *world,
                              const struct pp_opening *opening, struct pp_vec3 eye,
                              struct wanted wanted, struct pp_error *err)
{
    visible->patch_count = 0;
    visible->patches = NULL;
    visible->allocated = false;
    struct pp_projection *view = &visible->view;
    *view = (struct pp_projection){eye, opening->along, opening->up,
                                   pp_vec_scale(opening->inner.normal, -1.0), 0.0};
    view->distance_m =
        pp_vec_dot(pp_vec_sub(opening->inner.vertices[0], eye), view->toward);
    if (!(view->distance_m > PP_OCCLUDERS_COPLANAR_M))
        return PP_OK;

    struct pp_patch_builder builder = {.scene = {.world = world,
                                                 .view = view,
                                                 .face = opening->face,
                                                 .from_inside = true},
                                       .in_parts = wanted.in_parts,
                                       .sky_only = wanted.sky_only};
    enum pp_status status = PP_OK;
    const double(*outline)[2] = (const double(*)[2])visible->corners;
    if (opening->rectangle) {
        double outer[4][2];
        project(visible->corners, &opening->inner, view, view->distance_m);
        int count = 4;
        if (opening->reveal_m > 0.0) {
            project(outer, &opening->outer, view, view->distance_m + opening->reveal_m);
            count =
                rectangle_through(visible->corners, outline, (const double(*)[2])outer);
            if (count == 0)
                return PP_OK;
        }
        visible->ring = (struct pp_ring){count, visible->corners};
        builder.scene.outline = outline;
        builder.scene.outline_count = count;
    } else {
        status = open_by_overlay(&builder, opening, err);
        if (status != PP_OK || builder.open.count == 0) {
            pp_patch_builder_clear(&builder);
            return status;
        }
        /* The corners of the bounding box serve as the outline. */
        struct pp_occluders_scene all = builder.scene;
        builder.scene.low[0] = builder.scene.low[1] = INFINITY;
        builder.scene.high[0] = builder.scene.high[1] = -INFINITY;
        for (int r = 0; r < builder.open.count; r++) {
            all.outline = (const double(*)[2])builder.open.rings[r].xy;
            all.outline_count = builder.open.rings[r].count;
            find_scene_extent(&all);
            for (int axis = 0; axis < 2; axis++) {
                builder.scene.low[axis] = fmin(builder.scene.low[axis], all.low[axis]);
                builder.scene.high[axis] =
                    fmax(builder.scene.high[axis], all.high[axis]);
            }
        }
        const double *low = builder.scene.low, *high = builder.scene.high;
        const double extent[4][2] = {
            {low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
        memcpy(visible->corners, extent, sizeof extent);
        builder.scene.outline = outline;
        builder.scene.outline_count = 4;
    }
    find_scene_extent(&builder.scene);
    status = pp_patch_builder_fill(visible, &builder, wanted.outside, err);
    pp_patch_builder_clear(&builder);
    if (status != PP_OK)
        pp_visible_clear(visible);
    return status;
}

enum pp_status pp_visible_through(struct pp_visible *visible,
                                  const struct pp_world *world,
                                  const struct pp_opening *opening, struct pp_vec3 eye,
                                  struct pp_error *err)
{
    return through(visible, world, opening, eye, (struct wanted){.outside = true}, err);
}

enum pp_status pp_visible_in_parts(struct pp_visible *visible,
                                   const struct pp_world *world,
                                   const struct pp_opening *opening, struct pp_vec3 eye,
                                   struct pp_error *err)
{
    return through(visible, world, opening, eye,
                   (struct wanted){.outside = true, .in_parts = true}, err);
}

enum pp_status pp_visible_sky(struct pp_visible *visible, const struct pp_world *world,
                              const struct pp_opening *opening, struct pp_vec3 eye,
                              struct pp_error *err)
{
    return through(visible, world, opening, eye,
                   (struct wanted){.outside = true, .in_parts = true, .sky_only = true},
                   err);
}

enum pp_status pp_visible_opening(struct pp_visible *visible,
                                  const struct pp_world *world,
                                  const struct pp_opening *opening, struct pp_vec3 eye,
                                  struct pp_error *err)
{
    return through(visible, world, opening, eye, (struct wanted){0}, err);
}

enum pp_status pp_visible_open_part(struct pp_region *region,
                                    const struct pp_world *world,
                                    const struct pp_opening *opening,
                                    struct pp_vec3 position, struct pp_error *err)
{
    struct pp_visible visible;
    *region = (struct pp_region){0};
    enum pp_status status = through(&visible, world, opening, position,
                                    (struct wanted){.in_parts = true}, err);
    if (status != PP_OK)
        return status;
    if (visible.patch_count == 0) {
        pp_visible_clear(&visible);
        return PP_OK;
    }
    status = pp_region_copy(region, &visible.patches[0].region, err);
    for (int r = 0; r < region->count; r++)
        for (int i = 0; i < region->rings[r].count; i++)
            for (int axis = 0; axis < 2; axis++)
                region->rings[r].xy[i][axis] /= visible.view.distance_m;
    pp_visible_clear(&visible);
    return status;
}

enum pp_status pp_visible_in_air(struct pp_visible *visible,
                                 const struct pp_world *world,
                                 const struct pp_projection *view, const double low[2],
                                 const double high[2], int face, struct pp_error *err)
{
    visible->patch_count = 0;
    visible->patches = NULL;
    visible->allocated = false;
    visible->view = *view;
    const double corners[4][2] = {
        {low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
    memcpy(visible->corners, corners, sizeof corners);
    visible->ring = (struct pp_ring){4, visible->corners};
    struct pp_patch_builder builder = {
        .scene = {.world = world,
                  .view = &visible->view,
                  .face = face,
                  .from_inside = false,
                  .outline = (const double(*)[2])visible->corners,
                  .outline_count = 4},
        .in_parts = true};
    find_scene_extent(&builder.scene);
    enum pp_status status = pp_patch_builder_fill(visible, &builder, true, err);
    pp_patch_builder_clear(&builder);
    if (status != PP_OK)
        pp_visible_clear(visible);
    return status;
}

void pp_visible_clear(struct pp_visible *visible)
{
    if (!visible->allocated)
        return;
    /* The patches of a skyline share one region, which is freed once. */
    for (int i = visible->patch_count - 1; i >= 0; i--)
        if (i == 0
            || visible->patches[i].region.rings != visible->patches[i - 1].region.rings)
            pp_region_clear(&visible->patches[i].region);
    free(visible->patches);
    visible->patches = NULL;
    visible->patch_count = 0;
    visible->allocated = false;
}

double pp_visible_luminance_factor(const struct pp_sky *sky, double reflectance)
{
    return sky->kind == PP_SKY_OVERCAST ? reflectance : reflectance / 2.0;
}
