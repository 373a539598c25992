/* occluders.c - clips surfaces (as triangles if they are not convex), and skylines
 * without a distance, to the extent of a view and projects them. */
#include "methods/view/occluders.h"

#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/clip.h"
#include "model/geometry/min_max.h"

/* Coordinates in the view's plane that differ by less than this fraction of its extent
 * count as equal; the value is a few rounding errors. */
#define GRAIN 2e-15

/* Room for the planes that may cut a polygon: four of the pyramid, two of depth. */
enum { CUTS = 6, ON_STACK = 32 };

void pp_occluders_clear(struct pp_occluders *pieces)
{
    for (int i = 0; i < pieces->count; i++)
        free(pieces->list[i].xy);
    free(pieces->list);
    *pieces = (struct pp_occluders){0};
}

/* Moves a coordinate that was cut at the edge of the extent exactly on to the edge. */
static double snap(double at, double low, double high)
{
    double grain = GRAIN * fmax(fabs(low), fabs(high));
    return fabs(at - low) <= grain ? low : fabs(at - high) <= grain ? high : at;
}

static enum pp_status add_occluder_piece(struct pp_occluders *pieces,
                                         const struct pp_occluder *like,
                                         const struct pp_vec3 *corners, int count,
                                         const struct pp_occluders_scene *scene,
                                         struct pp_error *err)
{
    double(*xy)[2] = malloc((size_t)count * sizeof *xy);
    if (!xy)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++) {
        double scale = scene->view->distance_m / corners[i].z;
        xy[i][0] = snap(corners[i].x * scale, scene->low[0], scene->high[0]);
        xy[i][1] = snap(corners[i].y * scale, scene->low[1], scene->high[1]);
    }
    double extent =
        fmax(scene->high[0] - scene->low[0], scene->high[1] - scene->low[1]);
    count = pp_clip_tidy(xy, count, GRAIN * extent);
    if (count == 0) {
        free(xy);
        return PP_OK;
    }
    enum pp_status status = pp_array_reserve(
        &pieces->list, &pieces->capacity, pieces->count + 1, sizeof *pieces->list, err);
    if (status != PP_OK) {
        free(xy);
        return status;
    }
    struct pp_occluder *piece = &pieces->list[pieces->count++];
    *piece = *like;
    piece->count = count;
    piece->xy = xy;
    return PP_OK;
}

/* Four sides of the pyramid through the extent, and a range of depth: a point v inside
 * has normal.v > offset for all of them. */
struct sides {
    struct pp_vec3 normal[CUTS];
    double offset[CUTS];
};

static struct sides sides_of(const struct pp_occluders_scene *scene, double near,
                             double far)
{
    double d = scene->view->distance_m;
    return (struct sides){{{0.0, 0.0, 1.0},
                           {0.0, 0.0, -1.0},
                           {d, 0.0, -scene->low[0]},
                           {-d, 0.0, scene->high[0]},
                           {0.0, d, -scene->low[1]},
                           {0.0, -d, scene->high[1]}},
                          {near, -far, 0.0, 0.0, 0.0, 0.0}};
}

/* Adds a convex polygon, clipped to the sides. */
static enum pp_status add_convex(struct pp_occluders *pieces,
                                 const struct pp_occluder *like,
                                 const struct pp_vec3 *corners, int count,
                                 const struct sides *sides,
                                 const struct pp_occluders_scene *scene,
                                 struct pp_error *err)
{
    /* A polygon wholly outside one side adds nothing; a side that contains the whole
     * polygon does not cut it. */
    bool cuts[CUTS];
    for (int s = 0; s < CUTS; s++) {
        int within = 0;
        for (int i = 0; i < count; i++)
            within += pp_vec_dot(sides->normal[s], corners[i]) > sides->offset[s];
        if (within == 0)
            return PP_OK;
        cuts[s] = within < count;
    }

    struct pp_vec3 stack[2][ON_STACK + CUTS], *buffer[2] = {stack[0], stack[1]};
    struct pp_vec3 *heap = NULL;
    if (count > ON_STACK) {
        heap = malloc(2 * (size_t)(count + CUTS) * sizeof *heap);
        if (!heap)
            return pp_fail_memory(err);
        buffer[0] = heap;
        buffer[1] = heap + count + CUTS;
    }
    const struct pp_vec3 *from = corners;
    int left = count;
    for (int s = 0, turn = 0; s < CUTS && left > 0; s++) {
        if (!cuts[s])
            continue;
        left = pp_clip_convex(buffer[turn], from, left, sides->normal[s],
                              sides->offset[s]);
        from = buffer[turn];
        turn = 1 - turn;
    }
    enum pp_status status =
        left > 0 ? add_occluder_piece(pieces, like, from, left, scene, err) : PP_OK;
    free(heap);
    return status;
}

/* Adds any surface, with corners in the view's axes, clipped to the view. */
static enum pp_status add_occluder_surface(struct pp_occluders *pieces,
                                           const struct pp_occluder *like,
                                           const struct pp_surface *surface,
                                           const struct pp_vec3 *corners,
                                           const struct sides *sides,
                                           const struct pp_occluders_scene *scene,
                                           struct pp_error *err)
{
    if (!surface->triangles)
        return add_convex(pieces, like, corners, surface->outline.count, sides, scene,
                          err);
    enum pp_status status = PP_OK;
    for (int t = 0; status == PP_OK && t < surface->triangle_count; t++) {
        const int *of = surface->triangles[t];
        struct pp_vec3 three[3] = {corners[of[0]], corners[of[1]], corners[of[2]]};
        status = add_convex(pieces, like, three, 3, sides, scene, err);
    }
    return status;
}

/* True if the eye and the outline lie on one side of the plane normal.v = offset
 * (view's axes). A surface in that plane then hides no part of the outline. */
static bool cannot_hide(const struct pp_occluders_scene *scene, struct pp_vec3 normal,
                        double offset)
{
    double side = offset < 0.0 ? 1.0 : -1.0;
    for (int i = 0; i < scene->outline_count; i++) {
        struct pp_vec3 corner = {scene->outline[i][0], scene->outline[i][1],
                                 scene->view->distance_m};
        if (side * (pp_vec_dot(normal, corner) - offset) < -PP_OCCLUDERS_COPLANAR_M)
            return false;
    }
    return true;
}

static enum pp_status collect_surface(struct pp_occluders *inside,
                                      struct pp_occluders *outside,
                                      const struct pp_occluders_scene *scene,
                                      const struct pp_surface *surface,
                                      struct pp_error *err)
{
    const struct pp_polygon *outline = &surface->outline;
    const struct pp_projection *view = scene->view;
    double plane_m = view->distance_m;

    /* The range of depths of the surface. */
    double nearest = INFINITY, farthest = -INFINITY;
    for (int i = 0; i < outline->count; i++) {
        double depth =
            pp_vec_dot(pp_vec_sub(outline->vertices[i], view->eye), view->toward);
        nearest = pp_min(depth, nearest);
        farthest = pp_max(depth, farthest);
    }
    if (!(farthest > PP_OCCLUDERS_COPLANAR_M))
        return PP_OK;
    bool hides_inside = false, hides_outside = true;
    struct pp_vec3 normal = pp_projection_direction(view, outline->normal);
    double offset =
        pp_vec_dot(outline->normal, pp_vec_sub(outline->vertices[0], view->eye));
    if (scene->from_inside) {
        hides_inside = nearest < plane_m - PP_OCCLUDERS_COPLANAR_M
                       && !cannot_hide(scene, normal, offset);
        hides_outside = farthest > plane_m + PP_OCCLUDERS_COPLANAR_M;
        /* A free-standing plate that lies in the plane itself is outside. */
        if (!hides_inside && !hides_outside
            && nearest >= plane_m - PP_OCCLUDERS_COPLANAR_M)
            hides_outside =
                surface->role == PP_FREE_SURFACE || surface->role == PP_BLOCK;
    }
    if ((!hides_inside && !hides_outside) || fabs(offset) <= PP_OCCLUDERS_COPLANAR_M)
        return PP_OK; /* hides nothing, or is seen edge on */

    bool front = offset < 0.0;
    struct pp_occluder like = {.nearness = pp_vec_scale(normal, 1.0 / offset),
                               .reflectance = front ? surface->front : surface->back,
                               .exitance = surface->exitance};
    struct pp_vec3 stack[ON_STACK], *corners = stack;
    if (outline->count > ON_STACK) {
        corners = malloc((size_t)outline->count * sizeof *corners);
        if (!corners)
            return pp_fail_memory(err);
    }
    for (int i = 0; i < outline->count; i++)
        corners[i] = pp_projection_point(view, outline->vertices[i]);
    enum pp_status status = PP_OK;
    double hair = 1e-9 * fmin(plane_m, 1.0);
    if (hides_inside) {
        struct sides sides = sides_of(scene, hair, plane_m);
        status =
            add_occluder_surface(inside, &like, surface, corners, &sides, scene, err);
    }
    if (hides_outside && status == PP_OK) {
        double from = hair;
        if (scene->from_inside)
            from = nearest >= plane_m - PP_OCCLUDERS_COPLANAR_M
                       ? nearest - PP_OCCLUDERS_COPLANAR_M
                       : plane_m;
        struct sides sides = sides_of(scene, from, 2.0 * farthest);
        status =
            add_occluder_surface(outside, &like, surface, corners, &sides, scene, err);
    }
    if (corners != stack)
        free(corners);
    return status;
}

/* A block in the view's axes: its corner and the edges from there. */
struct block_in_view {
    struct pp_vec3 corner, edges[3];
};

static struct block_in_view block_in_view(const struct pp_projection *view,
                                          const struct pp_block *block)
{
    return (struct block_in_view){
        pp_projection_point(view, block->corner),
        {pp_projection_direction(view, block->along),
         pp_projection_direction(view, block->across),
         pp_projection_direction(view, pp_vec(0.0, 0.0, block->height_m))}};
}

/* Greatest coordinate of the block along a direction. */
static double reach(const struct block_in_view *block, struct pp_vec3 along)
{
    double far = pp_vec_dot(block->corner, along);
    for (int e = 0; e < 3; e++) {
        double on = pp_vec_dot(block->edges[e], along);
        far += on > 0.0 ? on : 0.0;
    }
    return far;
}

/* True if the block is entirely outside the pyramid through the extent, or behind the
 * eye. */
static bool lies_beside(const struct block_in_view *block, const struct sides *pyramid)
{
    for (int s = 0; s < CUTS; s++)
        if (!(reach(block, pyramid->normal[s]) > pyramid->offset[s]))
            return true;
    return false;
}

/* Adds a block by its sides. Sides that face away from the eye are left out if the
 * block is entirely in front of the eye or, in a view from inside, entirely beyond the
 * view's plane: the other sides then hide the same area. */
static enum pp_status collect_block(struct pp_occluders *inside,
                                    struct pp_occluders *outside,
                                    const struct pp_occluders_scene *scene,
                                    const struct pp_block *block,
                                    const struct sides *pyramid, struct pp_error *err)
{
    const struct pp_projection *view = scene->view;
    const struct block_in_view box = block_in_view(view, block);
    if (lies_beside(&box, pyramid))
        return PP_OK;
    double nearest = -reach(&box, pp_vec(0.0, 0.0, -1.0));
    bool is_clear = nearest > (scene->from_inside ? view->distance_m : 0.0)
                                  + PP_OCCLUDERS_COPLANAR_M;
    const struct pp_surface *sides = scene->world->surfaces + block->first_side;
    enum pp_status status = PP_OK;
    for (int i = 0; i < block->side_count && status == PP_OK; i++) {
        const struct pp_polygon *side = &sides[i].outline;
        double facing =
            pp_vec_dot(side->normal, pp_vec_sub(side->vertices[0], view->eye));
        if (facing < 0.0 || !is_clear)
            status = collect_surface(inside, outside, scene, &sides[i], err);
    }
    return status;
}

static enum pp_status collect_blocks(struct pp_occluders *inside,
                                     struct pp_occluders *outside,
                                     const struct pp_occluders_scene *scene,
                                     struct pp_error *err)
{
    const struct pp_world *world = scene->world;
    struct sides pyramid = sides_of(scene, PP_OCCLUDERS_COPLANAR_M, INFINITY);
    enum pp_status status = PP_OK;
    for (int b = 0; b < world->block_count && status == PP_OK; b++)
        status =
            collect_block(inside, outside, scene, &world->blocks[b], &pyramid, err);
    return status;
}

enum pp_status pp_occluders_collect(struct pp_occluders *inside,
                                    struct pp_occluders *outside,
                                    const struct pp_occluders_scene *scene,
                                    struct pp_error *err)
{
    const struct pp_world *world = scene->world;
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->surface_count && status == PP_OK;
         i = pp_world_next_but_blocks(world, i)) {
        const struct pp_surface *surface = &world->surfaces[i];
        if (surface->role == PP_BLOCK)
            status = collect_blocks(inside, outside, scene, err);
        else if (i != scene->face && surface->role != PP_REVEAL
                 && surface->role != PP_COVER)
            status = collect_surface(inside, outside, scene, surface, err);
    }
    return status;
}

struct pp_band pp_occluders_band(const struct pp_world *world,
                                 const struct pp_skyline *skyline)
{
    const struct pp_polygon *wall = &world->surfaces[skyline->face].outline;
    struct pp_vec3 zenith = {0.0, 0.0, 1.0};
    struct pp_vec3 out = pp_vec_unit(pp_vec(-wall->normal.x, -wall->normal.y, 0.0));
    return (struct pp_band){pp_vec_along(pp_vec_scale(zenith, cos(skyline->angle_rad)),
                                         -sin(skyline->angle_rad), out),
                            pp_vec(0.0, 0.0, -1.0)};
}

enum pp_status pp_occluders_add_skyline(struct pp_occluders *outside,
                                        const struct pp_occluders_scene *scene,
                                        const struct pp_skyline *skyline,
                                        struct pp_error *err)
{
    const struct pp_projection *view = scene->view;
    double d = view->distance_m;
    struct pp_band band = pp_occluders_band(scene->world, skyline);
    struct pp_vec3 whole[4] = {{scene->low[0], scene->low[1], d},
                               {scene->high[0], scene->low[1], d},
                               {scene->high[0], scene->high[1], d},
                               {scene->low[0], scene->high[1], d}};
    struct pp_vec3 under[5], left[6];
    int count = pp_clip_convex(
        under, whole, 4, pp_projection_direction(view, pp_vec_scale(band.above, -1.0)),
        0.0);
    count = pp_clip_convex(
        left, under, count,
        pp_projection_direction(view, pp_vec_scale(band.below, -1.0)), 0.0);
    if (count == 0)
        return PP_OK;
    struct pp_occluder like = {.reflectance = skyline->reflectance};
    return add_occluder_piece(outside, &like, left, count, scene, err);
}
