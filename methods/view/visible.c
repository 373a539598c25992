/* visible.c - see visible.h. */
#include "methods/view/visible.h"

#include <stdlib.h>
#include <string.h>

#include "methods/view/occluders.h"
#include "methods/view/overlay.h"

/* What is gathered on the way. */
struct patch_builder {
    struct pp_occluders_scene scene;
    struct pp_occluders inside, outside;
    struct pp_clipper *clipper;
    struct pp_region open; /* the part that is not hidden inside */
    bool open_is_extent;   /* all of the scene's low to high? */
    double grid;           /* on which figures are overlaid */
};

static void clear_work(struct patch_builder *work)
{
    pp_occluders_clear(&work->inside);
    pp_occluders_clear(&work->outside);
    pp_region_clear(&work->open);
    pp_region_clipper_destroy(work->clipper);
}

/* ---- the outline ---- */

static void find_extent(struct pp_occluders_scene *scene)
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

/* A rectangle seen through the rectangle of its reveal's other end: what is in both. */
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

/* The ring of a polygon in the view's plane, from the eye. */
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

/* What is seen through both outlines of an opening that is no plain rectangle goes to
 * work->open. */
static enum pp_status open_by_overlay(struct patch_builder *work,
                                      const struct pp_opening *opening,
                                      struct pp_error *err)
{
    const struct pp_projection *view = work->scene.view;
    int count = opening->inner.count;
    double(*xy)[2] = malloc((size_t)count * sizeof *xy);
    if (!xy)
        return pp_fail_memory(err);
    struct pp_region inner = {0}, outer = {0};
    project(xy, &opening->inner, view, view->distance_m);
    enum pp_status status = pp_region_clipper_create(&work->clipper, err);
    if (status == PP_OK)
        status = pp_region_of_ring(work->clipper, &inner, (const double(*)[2])xy, count,
                                   err);
    if (status == PP_OK && !(opening->reveal_m > 0.0)) {
        work->open = inner;
        free(xy);
        return PP_OK;
    }
    if (status == PP_OK) {
        project(xy, &opening->outer, view, view->distance_m + opening->reveal_m);
        status = pp_region_of_ring(work->clipper, &outer, (const double(*)[2])xy, count,
                                   err);
    }
    if (status == PP_OK)
        status =
            pp_region_intersection(work->clipper, &work->open, &inner, &outer, err);
    free(xy);
    pp_region_clear(&inner);
    pp_region_clear(&outer);
    return status;
}

/* Replaces work->open by what is left of it without the pieces inside. */
static enum pp_status take_inside_away(struct patch_builder *work, struct pp_error *err)
{
    struct pp_region taken, left = {0};
    enum pp_status status = pp_overlay_union(work->clipper, &taken, &work->inside, err);
    if (status == PP_OK)
        status = pp_region_difference(work->clipper, &left, &work->open, &taken, err);
    pp_region_clear(&taken);
    if (status == PP_OK) {
        pp_region_clear(&work->open);
        work->open = left;
        work->open_is_extent = false;
    }
    return status;
}

/* ---- patches ---- */

/* Hands region over to a new patch, unless it is empty. */
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

static bool all_alike(const struct pp_occluders *pieces)
{
    for (int i = 1; i < pieces->count; i++)
        if (!pp_overlay_same_light(&pieces->list[0], &pieces->list[i]))
            return false;
    return true;
}

/* The union of all pieces and what it leaves of work->open. */
static enum pp_status cover(struct patch_builder *work, struct pp_region *all,
                            struct pp_region *sky, struct pp_error *err)
{
    *sky = (struct pp_region){0};
    enum pp_status status = pp_overlay_union(work->clipper, all, &work->outside, err);
    if (status == PP_OK)
        status = pp_region_difference(work->clipper, sky, &work->open, all, err);
    return status;
}

/* Do the areas of a cover add up, and is every piece in it? */
static bool adds_up(const struct patch_builder *work, const struct pp_region *all,
                    const struct pp_region *sky)
{
    double whole = pp_region_area(&work->open);
    double missing = whole - pp_region_area(all) - pp_region_area(sky);
    if (!(fabs(missing) <= 1e-13 * whole))
        return false;
    for (int i = 0; i < work->outside.count; i++) {
        const struct pp_occluder *piece = &work->outside.list[i];
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

/* Where every piece is in sight and gives off the same light. Without a grid first,
 * which is five times as fast; then with it if GEOS has lost something on the way. */
static enum pp_status divide_alike(struct pp_visible *visible,
                                   struct patch_builder *work, struct pp_error *err)
{
    struct pp_region all, sky;
    pp_region_clipper_set_grid(work->clipper, 0.0);
    enum pp_status status = cover(work, &all, &sky, NULL);
    pp_region_clipper_set_grid(work->clipper, work->grid);
    if (status != PP_OK || !adds_up(work, &all, &sky)) {
        pp_region_clear(&all);
        pp_region_clear(&sky);
        status = cover(work, &all, &sky, err);
    }
    if (status == PP_OK) {
        add_patch(visible, &sky, NULL);
        add_patch(visible, &all, &work->outside.list[0]);
    }
    pp_region_clear(&all);
    pp_region_clear(&sky);
    return status;
}

/* Divides work->open by the pieces outside. */
static enum pp_status divide(struct pp_visible *visible, struct patch_builder *work,
                             struct pp_error *err)
{
    const struct pp_occluders *outside = &work->outside;
    visible->patches = calloc((size_t)outside->count + 1, sizeof *visible->patches);
    if (!visible->patches)
        return pp_fail_memory(err);
    visible->allocated = true;
    if (work->open_is_extent && outside->count > 0 && all_alike(outside))
        return divide_alike(visible, work, err);

    struct pp_region all, sky;
    enum pp_status status = cover(work, &all, &sky, err);
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
        status = pp_overlay_seen(work->clipper, &light, &work->outside, i,
                                 work->scene.view->distance_m, err);
        if (status == PP_OK)
            status = pp_region_intersection(work->clipper, &within, &light, &work->open,
                                            err);
        if (status == PP_OK)
            add_patch(visible, &within, &outside->list[i]);
        pp_region_clear(&light);
        pp_region_clear(&within);
    }
    pp_region_clear(&all);
    pp_region_clear(&sky);
    return status;
}

/* One region, with at most one skyline before it: half-spaces do, nothing is laid over
 * anything. */
static void divide_by_skyline(struct pp_visible *visible, struct pp_region region,
                              const struct pp_world *world,
                              const struct pp_skyline *skyline)
{
    visible->patch_count = 1;
    visible->patches[0] = (struct pp_visible_patch){.region = region};
    if (!skyline)
        return;
    struct pp_band band = pp_occluders_band(world, skyline, visible->view.eye);
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

/* The grid on which figures are overlaid: a power of two, 2^-50 of the largest
 * coordinate. */
static double grid_of(const struct pp_occluders_scene *scene)
{
    int exponent;
    frexp(fmax(fmax(fabs(scene->low[0]), fabs(scene->high[0])),
               fmax(fabs(scene->low[1]), fabs(scene->high[1]))),
          &exponent);
    return ldexp(1.0, exponent - 50);
}

/* Fills visible from a scene whose outline is known: as work->open, or (rectangles) as
 * the ring in visible. */
static enum pp_status fill(struct pp_visible *visible, struct patch_builder *work,
                           bool with_outside, struct pp_error *err)
{
    struct pp_occluders_scene *scene = &work->scene;
    const struct pp_world *world = scene->world;
    bool by_ring = work->open.count == 0;
    enum pp_status status =
        pp_occluders_collect(&work->inside, &work->outside, scene, err);
    if (status != PP_OK)
        return status;

    int skylines = 0;
    const struct pp_skyline *skyline = NULL;
    for (int i = 0; with_outside && i < world->skyline_count; i++)
        if (world->skylines[i].face == scene->face) {
            skyline = &world->skylines[i];
            skylines++;
        }
    bool overlay_outside = with_outside && (work->outside.count > 0 || skylines > 1);

    if (by_ring && work->inside.count == 0 && !overlay_outside) {
        visible->patches = visible->few;
        divide_by_skyline(visible, (struct pp_region){1, &visible->ring}, world,
                          skyline);
        return PP_OK;
    }

    if (!work->clipper)
        status = pp_region_clipper_create(&work->clipper, err);
    work->grid = grid_of(scene);
    if (status == PP_OK)
        pp_region_clipper_set_grid(work->clipper, work->grid);
    if (status == PP_OK && by_ring) {
        struct pp_region ring = {1, &visible->ring};
        status = pp_region_copy(&work->open, &ring, err);
        work->open_is_extent = true;
    }
    if (status == PP_OK && work->inside.count > 0)
        status = take_inside_away(work, err);
    if (status != PP_OK || work->open.count == 0)
        return status;

    if (!overlay_outside) {
        visible->patches = calloc(3, sizeof *visible->patches);
        if (!visible->patches)
            return pp_fail_memory(err);
        visible->allocated = true;
        divide_by_skyline(visible, work->open, world, skyline);
        work->open = (struct pp_region){0};
        return PP_OK;
    }
    for (int i = 0; i < world->skyline_count && status == PP_OK; i++)
        if (world->skylines[i].face == scene->face)
            status = pp_occluders_add_skyline(&work->outside, scene,
                                              &world->skylines[i], err);
    if (status == PP_OK)
        status = divide(visible, work, err);
    return status;
}

static enum pp_status through(struct pp_visible *visible, const struct pp_world *world,
                              const struct pp_opening *opening, struct pp_vec3 eye,
                              bool with_outside, struct pp_error *err)
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

    struct patch_builder work = {
        .scene = {
            .world = world, .view = view, .face = opening->face, .from_inside = true}};
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
        work.scene.outline = outline;
        work.scene.outline_count = count;
    } else {
        status = open_by_overlay(&work, opening, err);
        if (status != PP_OK || work.open.count == 0) {
            clear_work(&work);
            return status;
        }
        /* Its extent's corners stand for it. */
        struct pp_occluders_scene all = work.scene;
        work.scene.low[0] = work.scene.low[1] = INFINITY;
        work.scene.high[0] = work.scene.high[1] = -INFINITY;
        for (int r = 0; r < work.open.count; r++) {
            all.outline = (const double(*)[2])work.open.rings[r].xy;
            all.outline_count = work.open.rings[r].count;
            find_extent(&all);
            for (int axis = 0; axis < 2; axis++) {
                work.scene.low[axis] = fmin(work.scene.low[axis], all.low[axis]);
                work.scene.high[axis] = fmax(work.scene.high[axis], all.high[axis]);
            }
        }
        const double *low = work.scene.low, *high = work.scene.high;
        const double extent[4][2] = {
            {low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
        memcpy(visible->corners, extent, sizeof extent);
        work.scene.outline = outline;
        work.scene.outline_count = 4;
    }
    find_extent(&work.scene);
    status = fill(visible, &work, with_outside, err);
    clear_work(&work);
    if (status != PP_OK)
        pp_visible_clear(visible);
    return status;
}

enum pp_status pp_visible_through(struct pp_visible *visible,
                                  const struct pp_world *world,
                                  const struct pp_opening *opening, struct pp_vec3 eye,
                                  struct pp_error *err)
{
    return through(visible, world, opening, eye, true, err);
}

enum pp_status pp_visible_opening(struct pp_visible *visible,
                                  const struct pp_world *world,
                                  const struct pp_opening *opening, struct pp_vec3 eye,
                                  struct pp_error *err)
{
    return through(visible, world, opening, eye, false, err);
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
    struct patch_builder work = {
        .scene = {.world = world,
                  .view = &visible->view,
                  .face = face,
                  .from_inside = false,
                  .outline = (const double(*)[2])visible->corners,
                  .outline_count = 4}};
    find_extent(&work.scene);
    enum pp_status status = fill(visible, &work, true, err);
    clear_work(&work);
    if (status != PP_OK)
        pp_visible_clear(visible);
    return status;
}

void pp_visible_clear(struct pp_visible *visible)
{
    if (!visible->allocated)
        return;
    /* A skyline's patches share one region. */
    for (int i = visible->patch_count - 1; i >= 0; i--)
        if (i == 0
            || visible->patches[i].region.rings != visible->patches[i - 1].region.rings)
            pp_region_clear(&visible->patches[i].region);
    free(visible->patches);
    visible->patches = NULL;
    visible->patch_count = 0;
    visible->allocated = false;
}
