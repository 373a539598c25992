/* elevation.c - draws the opening and the obstructions as rectangles, which
 * elevation_strips.h divides into parts. */
#include "methods/view/elevation.h"

#include <stdlib.h>

#include "methods/view/block_bounds.h"
#include "methods/view/elevation_cover.h"
#include "methods/view/elevation_strips.h"
#include "methods/view/visible.h"
#include "model/base/array.h"
#include "model/geometry/area_moments.h"
#include "model/geometry/frame.h"
#include "model/geometry/min_max.h"

/* The opening's own frame at the point: x along, y out through the glass, z up. */
struct opening_frame {
    struct pp_vec3 point;
    struct pp_frame axes;
};

static struct pp_vec3 in_frame(const struct opening_frame *frame, struct pp_vec3 p)
{
    return pp_frame_in(&frame->axes, pp_vec_sub(p, frame->point));
}

/* Distance of a point from the eye along y. */
static double distance_of(const struct opening_frame *frame, struct pp_vec3 p)
{
    return pp_vec_dot(frame->axes.y, pp_vec_sub(p, frame->point));
}

/* An opening and its obstructions as seen from the point. */
struct opening_drawing {
    const struct pp_world *world;
    const struct pp_opening *opening;
    struct opening_frame frame;
    double face_m, glass_m;        /* distances of the point from wall face and glass */
    struct pp_elevation_part seen; /* the visible part of the opening */
    struct pp_elevation_obstructions obstructions;
    struct pp_elevation_cover *cover; /* areas covered by the obstructions so far; not
                                       * owned */
    int order;                        /* number of the next obstruction; decides between
                                       * equal distances */
};

/* Rectangle of equal area, with the region's centroid and the proportions of its
 * bounding box. The rectangle is raised if it would extend below the horizon. */
static struct pp_elevation_part equal_rectangle(const struct pp_area_moments *extent)
{
    double width = extent->right - extent->left, height = extent->high - extent->low;
    double scale = sqrt(extent->area / (width * height));
    double x = extent->x_moment / extent->area, z = extent->z_moment / extent->area;
    double low = fmax(z - scale * height / 2.0, 0.0);
    return (struct pp_elevation_part){.left = x - scale * width / 2.0,
                                      .right = x + scale * width / 2.0,
                                      .low = low,
                                      .high = low + scale * height};
}

/* True if the point and the whole opening lie on one side of each face and the room is
 * empty, so that nothing inside can hide the opening. */
static bool is_seen_whole(const struct opening_drawing *drawing)
{
    const struct pp_world *world = drawing->world;
    const struct pp_polygon *opening = &drawing->opening->inner;
    if (!world->is_empty)
        return false;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        struct pp_vec3 origin = face->vertices[0];
        double depth =
            pp_vec_dot(pp_vec_sub(drawing->frame.point, origin), face->normal);
        bool behind = depth < -1e-6;
        bool before = depth > 1e-6;
        if (drawing->opening->faces_open_in && !behind)
            continue;
        for (int v = 0; v < opening->count; v++) {
            depth = pp_vec_dot(pp_vec_sub(opening->vertices[v], origin), face->normal);
            behind |= depth < -1e-6;
            before |= depth > 1e-6;
        }
        if (behind && before)
            return false;
    }
    return true;
}

/* The intersection of both outlines of a vertical rectangle, above the horizon. All
 * corners of an outline are at the same distance, so two opposite ones define jambs,
 * sill and head. */
static struct pp_elevation_part through_rectangle(const struct pp_opening *opening,
                                                  const struct opening_frame *frame)
{
    struct pp_elevation_part seen = {
        .left = -INFINITY, .right = INFINITY, .low = 0.0, .high = INFINITY};
    const struct pp_polygon *outlines[2] = {&opening->inner, &opening->outer};
    for (int k = 0; k < 2; k++) {
        struct pp_vec3 a = in_frame(frame, outlines[k]->vertices[0]);
        struct pp_vec3 b = in_frame(frame, outlines[k]->vertices[2]);
        seen.left = pp_max(seen.left, pp_min(a.x, b.x) / a.y);
        seen.right = pp_min(seen.right, pp_max(a.x, b.x) / a.y);
        seen.low = pp_max(seen.low, pp_min(a.z, b.z) / a.y);
        seen.high = pp_min(seen.high, pp_max(a.z, b.z) / a.y);
    }
    return seen;
}

static bool is_empty(const struct pp_elevation_part *upright)
{
    return !(upright->right > upright->left && upright->high > upright->low);
}

/* Sets the visible part of the opening, as one rectangle, which may be empty. */
static enum pp_status find_seen(struct opening_drawing *drawing, struct pp_error *err)
{
    if (drawing->opening->rectangle && is_seen_whole(drawing)) {
        drawing->seen = through_rectangle(drawing->opening, &drawing->frame);
        return PP_OK;
    }
    struct pp_region visible = {0};
    enum pp_status status = pp_visible_open_part(
        &visible, drawing->world, drawing->opening, drawing->frame.point, err);
    if (status != PP_OK)
        return status;
    struct pp_area_moments extent = pp_area_moments_above_horizon(&visible);
    if (extent.area > 0.0)
        drawing->seen = equal_rectangle(&extent);
    pp_region_clear(&visible);
    return PP_OK;
}

/* Adds an obstruction, unless nothing of it is visible. */
static enum pp_status add_obstruction(struct opening_drawing *drawing,
                                      struct pp_elevation_obstruction obstruction,
                                      struct pp_error *err)
{
    struct pp_elevation_obstructions *obstructions = &drawing->obstructions;
    const struct pp_elevation_part *outline = &obstruction.outline;
    obstruction.order = drawing->order++;
    if (is_empty(outline)
        || pp_elevation_cover_hides(drawing->cover, outline->left, outline->right,
                                    outline->high, obstruction.distance_m))
        return PP_OK;
    enum pp_status status = pp_array_append(&obstructions->list, obstructions->count,
                                            sizeof *obstructions->list, err);
    if (status == PP_OK) {
        obstructions->list[obstructions->count++] = obstruction;
        pp_elevation_cover_add(drawing->cover, outline, obstruction.distance_m);
    }
    return status;
}

static enum pp_status add_skylines(struct opening_drawing *drawing,
                                   struct pp_error *err)
{
    const struct pp_world *world = drawing->world;
    for (int i = 0; i < world->skyline_count; i++) {
        const struct pp_skyline *skyline = world->skylines + i;
        if (skyline->face != drawing->opening->face)
            continue;
        double high = tan(
            pp_world_skyline_angle(skyline, drawing->frame.point.z, drawing->face_m));
        struct pp_elevation_obstruction obstruction = {
            .outline = {-INFINITY, INFINITY, -INFINITY, high, skyline->reflectance},
            .distance_m = skyline->distance_m + drawing->face_m};
        enum pp_status status = add_obstruction(drawing, obstruction, err);
        if (status != PP_OK)
            return status;
    }
    return PP_OK;
}

/* Draws the part of a surface on the outer side of the glass. Returns the number of
 * points drawn. */
static int draw_outside(double (*drawn)[2], const struct pp_polygon *outline,
                        const struct opening_frame *frame, double glass_m)
{
    int kept = 0;
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 a = in_frame(frame, outline->vertices[i]);
        struct pp_vec3 b = in_frame(frame, outline->vertices[(i + 1) % outline->count]);
        double over_a = a.y - glass_m, over_b = b.y - glass_m;
        if (over_a >= 0.0) {
            drawn[kept][0] = a.x / a.y;
            drawn[kept++][1] = a.z / a.y;
        }
        if ((over_a < 0.0 && over_b > 0.0) || (over_a > 0.0 && over_b < 0.0)) {
            double t = over_a / (over_a - over_b);
            drawn[kept][0] = (a.x + t * (b.x - a.x)) / glass_m;
            drawn[kept++][1] = (a.z + t * (b.z - a.z)) / glass_m;
        }
    }
    return kept;
}

/* The silhouette of one obstruction: the sum over its surfaces that face the point,
 * which do not overlap. */
struct silhouette {
    struct pp_area_moments extent;
    double distance_m; /* distance of the nearest corner */
};

static struct silhouette no_silhouette(void)
{
    return (struct silhouette){pp_area_moments_empty(), INFINITY};
}

static enum pp_status add_to_silhouette(struct silhouette *silhouette,
                                        const struct opening_drawing *drawing,
                                        const struct pp_polygon *outline,
                                        struct pp_error *err)
{
    const struct pp_elevation_part *seen = &drawing->seen;
    enum { CORNERS_ON_STACK = 8 };
    size_t room = (size_t)outline->count * PP_AREA_MOMENTS_POINTS;
    double stack[2 * CORNERS_ON_STACK * PP_AREA_MOMENTS_POINTS][2],
        (*points)[2] = stack;
    if (outline->count > CORNERS_ON_STACK)
        points = malloc(2 * room * sizeof *points);
    if (!points)
        return pp_fail_memory(err);
    int count = draw_outside(points, outline, &drawing->frame, drawing->glass_m);
    struct pp_area_moments extent = pp_area_moments_in_box(
        points, points + room, count, seen->left, seen->right, seen->low, seen->high);
    if (points != stack)
        free(points);

    struct pp_area_moments *sum = &silhouette->extent;
    sum->area += fabs(extent.area);
    sum->left = fmin(sum->left, extent.left);
    sum->right = fmax(sum->right, extent.right);
    sum->low = fmin(sum->low, extent.low);
    sum->high = fmax(sum->high, extent.high);
    for (int i = 0; i < outline->count; i++)
        silhouette->distance_m =
            fmin(silhouette->distance_m,
                 pp_vec_length(pp_vec_sub(outline->vertices[i], drawing->frame.point)));
    return PP_OK;
}

static enum pp_status add_silhouette(struct opening_drawing *drawing,
                                     const struct silhouette *silhouette,
                                     double reflectance, struct pp_error *err)
{
    const struct pp_area_moments *extent = &silhouette->extent;
    double width = extent->right - extent->left;
    if (!(extent->area > 0.0 && width > 0.0))
        return PP_OK;
    struct pp_elevation_obstruction obstruction = {
        .outline = {extent->left, extent->right, extent->low,
                    extent->low + extent->area / width, reflectance},
        .distance_m = silhouette->distance_m};
    return add_obstruction(drawing, obstruction, err);
}

/* True if part of the surface is beyond the glass, or if it lies in the glass's
 * plane. */
static bool reaches_outside(const struct pp_polygon *outline,
                            const struct opening_drawing *drawing)
{
    bool is_near = false;
    for (int i = 0; i < outline->count; i++) {
        double y = distance_of(&drawing->frame, outline->vertices[i]);
        if (y > drawing->glass_m)
            return true;
        is_near = is_near || y < drawing->glass_m;
    }
    return !is_near;
}

static bool faces(const struct pp_polygon *outline, struct pp_vec3 point)
{
    return pp_vec_dot(pp_vec_sub(point, outline->vertices[0]), outline->normal) > 0.0;
}

/* True if the surface is the skyline of a face other than the opening's. */
static bool is_skyline_aside(const struct pp_surface *surface,
                             const struct opening_drawing *drawing)
{
    return surface->role == PP_SKYLINE
           && drawing->world->skylines[surface->owner].face != drawing->opening->face;
}

/* Adds the free-standing surfaces outside, skylines of other walls, and the building's
 * own outer faces. */
static enum pp_status add_surfaces(struct opening_drawing *drawing,
                                   struct pp_error *err)
{
    const struct pp_world *world = drawing->world;
    enum pp_status status = PP_OK;
    for (int i = drawing->opening->faces_open_out ? world->face_count : 0;
         i < world->surface_count && status == PP_OK;
         i = pp_world_next_but_blocks(world, i)) {
        const struct pp_surface *surface = world->surfaces + i;
        bool free_outside = (surface->role == PP_FREE_SURFACE && !surface->inside)
                            || is_skyline_aside(surface, drawing);
        if (i == drawing->opening->face || !(i < world->face_count || free_outside)
            || !reaches_outside(&surface->outline, drawing))
            continue;
        struct silhouette silhouette = no_silhouette();
        bool front = faces(&surface->outline, drawing->frame.point);
        status = add_to_silhouette(&silhouette, drawing, &surface->outline, err);
        if (status == PP_OK)
            status = add_silhouette(drawing, &silhouette,
                                    front ? surface->front : surface->back, err);
    }
    return status;
}

/* Adds the bands of sky that the opening's own facade hides: infinite rectangles to the
 * left, to the right, above and below its hole. */
static enum pp_status add_hole_bands(struct opening_drawing *drawing,
                                     double reflectance, struct pp_error *err)
{
    const struct pp_opening *opening = drawing->opening;
    if (!(opening->recess_m > 0.0))
        return PP_OK;
    double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
    for (int i = 0; i < opening->outer.count; i++) {
        struct pp_vec3 p = in_frame(&drawing->frame, opening->outer.vertices[i]);
        double y = p.y + opening->recess_m;
        left = fmin(left, p.x / y);
        right = fmax(right, p.x / y);
        low = fmin(low, p.z / y);
        high = fmax(high, p.z / y);
    }
    double all = INFINITY;
    const struct pp_elevation_part bands[4] = {{-all, left, -all, all, reflectance},
                                               {right, all, -all, all, reflectance},
                                               {left, right, high, all, reflectance},
                                               {left, right, -all, low, reflectance}};
    enum pp_status status = PP_OK;
    for (int i = 0; i < 4 && status == PP_OK; i++)
        status = add_obstruction(
            drawing, (struct pp_elevation_obstruction){.outline = bands[i]}, err);
    return status;
}

/* Adds a facade: the opening's own as bands around its hole, any other as a whole. */
static enum pp_status add_facade(struct opening_drawing *drawing, int index,
                                 struct pp_error *err)
{
    struct pp_facade *of = &drawing->world->facades[index];
    struct pp_polygon sheet = {.count = 4, .vertices = of->corners};
    struct silhouette solid = no_silhouette();
    if (index == drawing->opening->facade)
        return add_hole_bands(drawing, of->reflectance, err);
    enum pp_status status = add_to_silhouette(&solid, drawing, &sheet, err);
    return status ? status : add_silhouette(drawing, &solid, of->reflectance, err);
}

/* Adds a block, as the silhouette of its sides that face the point. */
static enum pp_status add_block(struct opening_drawing *drawing,
                                const struct pp_block *block, struct pp_error *err)
{
    const struct pp_surface *sides = drawing->world->surfaces + block->first_side;
    struct silhouette silhouette = no_silhouette();
    enum pp_status status = PP_OK;
    for (int i = 0; i < block->side_count && status == PP_OK; i++)
        if (faces(&sides[i].outline, drawing->frame.point))
            status = add_to_silhouette(&silhouette, drawing, &sides[i].outline, err);
    return status ? status
                  : add_silhouette(drawing, &silhouette, block->reflectance, err);
}

/* Adds the blocks, roughly the nearer ones first. Blocks hidden by blocks already added
 * are not drawn. */
static enum pp_status add_blocks(struct opening_drawing *drawing, struct pp_error *err)
{
    const struct pp_world *world = drawing->world;
    const struct pp_elevation_part *seen = &drawing->seen;
    const struct pp_block_view view = {drawing->frame.point, drawing->frame.axes,
                                       drawing->glass_m,     seen->left,
                                       seen->right,          seen->low};
    struct pp_block_bounds bounds = {0};
    enum pp_status status = pp_block_bounds_find(&bounds, world, &view, err);
    int first = drawing->order;
    for (int i = 0; i < bounds.count && status == PP_OK; i++) {
        const struct pp_block_bound *bound = &bounds.list[i];
        if (pp_elevation_cover_hides(drawing->cover, bound->left, bound->right,
                                     bound->high, bound->distance_m))
            continue;
        drawing->order = first + bound->block;
        status = add_block(drawing, &world->blocks[bound->block], err);
    }
    drawing->order = first + world->block_count;
    pp_block_bounds_clear(&bounds);
    return status;
}

/* Removes obstructions that are hidden by obstructions added later. */
static void drop_hidden(struct opening_drawing *drawing)
{
    struct pp_elevation_obstructions *obstructions = &drawing->obstructions;
    int kept = 0;
    for (int i = 0; i < obstructions->count; i++) {
        const struct pp_elevation_obstruction *of = &obstructions->list[i];
        if (!pp_elevation_cover_hides(drawing->cover, of->outline.left,
                                      of->outline.right, of->outline.high,
                                      of->distance_m))
            obstructions->list[kept++] = *of;
    }
    obstructions->count = kept;
}

enum pp_status pp_elevation_init(struct pp_elevation *elevation,
                                 const struct pp_world *world,
                                 const struct pp_opening *opening, struct pp_vec3 point,
                                 struct pp_error *err)
{
    *elevation = (struct pp_elevation){0};
    struct pp_elevation_cover cover; /* 16 kB; only the columns in use are written */
    struct opening_drawing drawing = {
        .world = world,
        .cover = &cover,
        .opening = opening,
        .frame = {point,
                  {opening->along, pp_vec_scale(opening->inner.normal, -1.0),
                   opening->up}},
    };
    drawing.face_m = distance_of(&drawing.frame, opening->inner.vertices[0]);
    drawing.glass_m = distance_of(&drawing.frame, opening->outer.vertices[0]);
    if (drawing.face_m < 1e-9)
        return PP_OK;

    enum pp_status status = find_seen(&drawing, err);
    if (status != PP_OK || is_empty(&drawing.seen))
        return status;
    pp_elevation_cover_init(drawing.cover, &drawing.seen);
    status = add_skylines(&drawing, err);
    if (status == PP_OK)
        status = add_surfaces(&drawing, err);
    if (status == PP_OK)
        status = add_blocks(&drawing, err);
    for (int i = 0; i < world->facade_count && status == PP_OK; i++)
        status = add_facade(&drawing, i, err);
    drop_hidden(&drawing);
    if (status == PP_OK)
        status = pp_elevation_strips_cut(elevation, &drawing.seen,
                                         &drawing.obstructions, err);
    free(drawing.obstructions.list);
    if (status != PP_OK)
        pp_elevation_clear(elevation);
    return status;
}

void pp_elevation_clear(struct pp_elevation *elevation)
{
    free(elevation->parts);
    *elevation = (struct pp_elevation){0};
}
