/* waldram_site.c - the view from a wall in two vertical projections, to the right and
 * to the left of its normal. The projections end close to the zenith, where the diagram
 * has almost no area. */
#include "methods/waldram/waldram_site.h"

#include <stdlib.h>

#include "methods/waldram/waldram_squares.h"
#include "model/base/array.h"
#include "model/geometry/clipper.h"

/* Coordinates are rounded to multiples of this value when regions are joined. Areas
 * change by less than 1e-8. */
#define SITE_GRID 0x1p-32

struct site_view {
    struct pp_projection projection;
    double low[2], high[2];
};

static struct pp_projection looking(struct pp_vec3 eye, struct pp_vec3 toward,
                                    struct pp_vec3 up)
{
    return (struct pp_projection){eye, pp_vec_cross(toward, up), up, toward, 1.0};
}

enum { SITE_VIEWS = 2 };

/* Tangent of the greatest altitude of the views. Above it, the diagram of the overcast
 * sky has an area of 6 sqrt(2)/(7 pi) 1000^-3, or 4e-10. */
#define SITE_TOP 1000.0

static void find_views(struct site_view views[SITE_VIEWS], struct pp_vec3 eye,
                       struct pp_vec3 facing)
{
    const struct pp_vec3 zenith = {0.0, 0.0, 1.0};
    struct pp_vec3 right = pp_vec_cross(facing, zenith);
    for (int i = 0; i < SITE_VIEWS; i++) {
        struct pp_vec3 toward = pp_vec_unit(pp_vec_along(facing, 2 * i - 1, right));
        views[i] = (struct site_view){
            looking(eye, toward, zenith), {-1.0, 0.0}, {1.0, SITE_TOP}};
    }
}

/* Adds the region of an outer ring, or subtracts a hole from the last region. */
static enum pp_status add_figure(struct pp_region *figures, int *count,
                                 const struct pp_ring *ring, struct pp_clipper *clipper,
                                 struct pp_error *err)
{
    const double(*xy)[2] = (const double(*)[2])ring->xy;
    struct pp_region figure, rest;
    enum pp_status status =
        pp_clipper_by_crossings(clipper, &figure, xy, ring->count, err);
    if (status != PP_OK)
        return status;
    if (*count == 0 || pp_region_ring_area(xy, ring->count) > 0.0) {
        figures[(*count)++] = figure;
        return PP_OK;
    }
    struct pp_region *last = &figures[*count - 1];
    status = pp_clipper_difference(clipper, &rest, last, &figure, err);
    pp_region_clear(&figure);
    if (status != PP_OK)
        return status;
    pp_region_clear(last);
    *last = rest;
    return PP_OK;
}

/* Merges adjacent regions. */
static enum pp_status join_rings(struct pp_region *region, struct pp_clipper *clipper,
                                 struct pp_error *err)
{
    struct pp_region joined = {0};
    if (region->count < 2)
        return PP_OK;
    struct pp_region *figures = calloc((size_t)region->count + 1, sizeof *figures);
    int count = 0;
    enum pp_status status = figures ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < region->count && status == PP_OK; i++)
        status = add_figure(figures, &count, &region->rings[i], clipper, err);
    if (status == PP_OK)
        status = pp_clipper_union(clipper, &joined, figures, count, err);
    for (int i = 0; i < count; i++)
        pp_region_clear(&figures[i]);
    free(figures);
    if (status != PP_OK)
        return status;
    pp_region_clear(region);
    *region = joined;
    return PP_OK;
}

/* Moves the rings of an outline to the end of the region's rings. */
static enum pp_status add_rings(struct pp_region *region, struct pp_region *outline,
                                struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int r = 0; r < outline->count && status == PP_OK; r++) {
        status =
            pp_array_append(&region->rings, region->count, sizeof *region->rings, err);
        if (status == PP_OK) {
            region->rings[region->count++] = outline->rings[r];
            outline->rings[r] = (struct pp_ring){0};
        }
    }
    pp_region_clear(outline);
    return status;
}

/* In the plan, y points ahead, opposite to the view's `up`. */
static enum pp_status plan_outline(struct pp_region *outline,
                                   const struct pp_region *region, struct pp_error *err)
{
    enum pp_status status = pp_region_copy(outline, region, err);
    for (int r = 0; r < outline->count; r++)
        for (int i = 0; i < outline->rings[r].count; i++)
            outline->rings[r].xy[i][1] = -outline->rings[r].xy[i][1];
    return status;
}

/* The drawing surface of a site; waldram is NULL for the plan. */
struct site_paper {
    const struct pp_waldram *waldram;
    struct pp_clipper *clipper;
    int face;
};

/* Draws a region given in the coordinates of a view, and clears it. */
static enum pp_status draw_figure(struct pp_region *drawn, struct pp_region *figure,
                                  const struct site_paper *paper,
                                  const struct pp_window_axes *axes,
                                  struct pp_error *err)
{
    struct pp_region outline = {0};
    enum pp_status status = join_rings(figure, paper->clipper, err);
    if (status == PP_OK)
        status = paper->waldram ? pp_waldram_squares_outline(&outline, paper->waldram,
                                                             axes, figure, err)
                                : plan_outline(&outline, figure, err);
    if (status == PP_OK)
        status = add_rings(drawn, &outline, err);
    pp_region_clear(figure);
    return status;
}

static enum pp_status add_drawing(struct pp_waldram_site *site,
                                  const struct site_paper *paper,
                                  struct pp_window_drawing *drawing,
                                  struct pp_error *err)
{
    struct pp_region figures[2] = {{0}, {0}}; /* regions of the sky and of the
                                               * obstructions */
    enum pp_status status = PP_OK;
    for (int i = 0; status == PP_OK && i < drawing->count; i++) {
        struct pp_drawn_part *part = &drawing->parts[i];
        if (paper->waldram && !part->hidden)
            site->sky_component +=
                pp_waldram_scale_area(paper->waldram, &drawing->axes, &part->region);
        status = add_rings(&figures[part->hidden], &part->region, err);
    }
    if (status == PP_OK)
        status = draw_figure(&site->sky, &figures[0], paper, &drawing->axes, err);
    if (status == PP_OK)
        status = draw_figure(&site->hidden, &figures[1], paper, &drawing->axes, err);
    for (int i = 0; i < 2; i++)
        pp_region_clear(&figures[i]);
    return status;
}

static enum pp_status add_view(struct pp_waldram_site *site,
                               const struct site_paper *paper,
                               const struct pp_world *world,
                               const struct site_view *view, struct pp_error *err)
{
    const struct pp_sky sky = pp_sky_overcast();
    struct pp_visible visible;
    struct pp_window_drawing drawing;
    enum pp_status status = pp_visible_in_air(&visible, world, &view->projection,
                                              view->low, view->high, paper->face, err);
    if (status != PP_OK)
        return status;
    status = pp_window_drawing_of_view(&drawing, &visible, &sky, err);
    pp_visible_clear(&visible);
    if (status == PP_OK)
        status = add_drawing(site, paper, &drawing, err);
    pp_window_drawing_clear(&drawing);
    return status;
}

static enum pp_status add_views(struct pp_waldram_site *site,
                                const struct pp_waldram *waldram,
                                const struct pp_world *world,
                                const struct site_view *views, int count, int face,
                                struct pp_error *err)
{
    struct site_paper paper = {.waldram = waldram, .face = face};
    *site = (struct pp_waldram_site){0};
    enum pp_status status = pp_clipper_create(&paper.clipper, err);
    if (status != PP_OK)
        return status;
    pp_clipper_set_grid(paper.clipper, SITE_GRID);
    for (int i = 0; i < count && status == PP_OK; i++)
        status = add_view(site, &paper, world, &views[i], err);
    pp_clipper_destroy(paper.clipper);
    if (status != PP_OK)
        pp_waldram_site_clear(site);
    return status;
}

enum pp_status pp_waldram_site_init(struct pp_waldram_site *site,
                                    const struct pp_waldram *waldram,
                                    const struct pp_world *world,
                                    struct pp_vec3 position, int face,
                                    struct pp_error *err)
{
    struct site_view views[SITE_VIEWS];
    find_views(views, position, waldram->facing);
    return add_views(site, waldram, world, views, SITE_VIEWS, face, err);
}

enum pp_status pp_waldram_site_init_plan(struct pp_waldram_site *site,
                                         const struct pp_world *world,
                                         struct pp_vec3 position, struct pp_vec3 facing,
                                         int face, double reach, struct pp_error *err)
{
    const struct site_view above = {
        looking(position, pp_vec(0.0, 0.0, 1.0), pp_vec_scale(facing, -1.0)),
        {-reach, -reach},
        {reach, 0.0}};
    return add_views(site, NULL, world, &above, 1, face, err);
}

enum pp_status pp_waldram_site_join(struct pp_waldram_site *site, struct pp_error *err)
{
    struct pp_clipper *clipper;
    enum pp_status status = pp_clipper_create(&clipper, err);
    if (status != PP_OK)
        return status;
    pp_clipper_set_grid(clipper, SITE_GRID);
    status = join_rings(&site->sky, clipper, err);
    if (status == PP_OK)
        status = join_rings(&site->hidden, clipper, err);
    pp_clipper_destroy(clipper);
    return status;
}

void pp_waldram_site_clear(struct pp_waldram_site *site)
{
    pp_region_clear(&site->sky);
    pp_region_clear(&site->hidden);
}
