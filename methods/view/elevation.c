/* elevation.c - see elevation.h. */
#include "methods/view/elevation.h"

#include <stdlib.h>

#include "model/geometry/area_moments.h"
#include "methods/view/exterior.h"

/* The opening's own axes, from the point: x along, y out through the glass, z up. */
struct opening_frame {
    struct pp_vec3 point, along, out, up;
};

static struct pp_vec3 in_frame(const struct opening_frame *frame, struct pp_vec3 p)
{
    struct pp_vec3 from = pp_vec_sub(p, frame->point);
    return pp_vec(pp_vec_dot(from, frame->along), pp_vec_dot(from, frame->out),
                  pp_vec_dot(from, frame->up));
}

/* An obstruction on the drawing. */
struct obstruction {
    struct pp_elevation_part outline;
    double distance_m; /* of its nearest corner */
};

struct obstructions {
    int count;
    struct obstruction *list;
};

/* What the drawing of an opening is made from. */
struct opening_drawing {
    const struct pp_world *world;
    const struct pp_opening *opening;
    struct opening_frame frame;
    double face_m, glass_m;        /* distances of the point from wall face and glass */
    struct pp_elevation_part seen; /* of the opening */
    struct obstructions obstructions;
};

/* The rectangle of equal area with the bounding box' proportions, same centroid. */
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

/* Does nothing inside the room stand between any point and any opening? */
static bool is_convex_and_empty(const struct pp_world *world)
{
    for (int i = 0; i < world->surface_count; i++)
        if (world->surfaces[i].inside && world->surfaces[i].role == PP_FREE_SURFACE)
            return false;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        for (int k = 0; k < world->face_count; k++)
            for (int v = 0; v < world->surfaces[k].outline.count; v++) {
                struct pp_vec3 from = pp_vec_sub(world->surfaces[k].outline.vertices[v],
                                                 face->vertices[0]);
                if (pp_vec_dot(from, face->normal) < -1e-6)
                    return false;
            }
    }
    return true;
}

/* What both outlines of an upright rectangle leave, above the horizon. */
static struct pp_elevation_part through_rectangle(const struct pp_opening *opening,
                                                  const struct opening_frame *frame)
{
    struct pp_elevation_part seen = {
        .left = -INFINITY, .right = INFINITY, .low = 0.0, .high = INFINITY};
    const struct pp_polygon *outlines[2] = {&opening->inner, &opening->outer};
    for (int k = 0; k < 2; k++) {
        struct pp_area_moments extent = pp_area_moments_empty();
        for (int i = 0; i < outlines[k]->count; i++) {
            struct pp_vec3 p = in_frame(frame, outlines[k]->vertices[i]);
            double xz[2] = {p.x / p.y, p.z / p.y};
            pp_area_moments_add_edge(&extent, xz, xz);
        }
        seen.left = fmax(seen.left, extent.left);
        seen.right = fmin(seen.right, extent.right);
        seen.low = fmax(seen.low, extent.low);
        seen.high = fmin(seen.high, extent.high);
    }
    return seen;
}

static bool is_empty(const struct pp_elevation_part *upright)
{
    return !(upright->right > upright->left && upright->high > upright->low);
}

/* What the point sees of the opening, as one rectangle; empty where it sees nothing. */
static enum pp_status see(struct opening_drawing *drawing, struct pp_error *err)
{
    if (drawing->opening->rectangle && is_convex_and_empty(drawing->world)) {
        drawing->seen = through_rectangle(drawing->opening, &drawing->frame);
        return PP_OK;
    }
    struct pp_region visible = {0};
    enum pp_status status = pp_exterior_visible_part(
        &visible, drawing->world, drawing->opening, drawing->frame.point, err);
    if (status != PP_OK)
        return status;
    struct pp_area_moments extent = pp_area_moments_above_horizon(&visible);
    if (extent.area > 0.0)
        drawing->seen = equal_rectangle(&extent);
    pp_region_clear(&visible);
    return PP_OK;
}

static enum pp_status note(struct opening_drawing *drawing,
                           struct obstruction obstruction, struct pp_error *err)
{
    struct obstructions *obstructions = &drawing->obstructions;
    if (is_empty(&obstruction.outline))
        return PP_OK;
    size_t size = (size_t)obstructions->count + 1;
    struct obstruction *list = realloc(obstructions->list, size * sizeof *list);
    if (!list)
        return pp_fail_memory(err);
    obstructions->list = list;
    /* Nearest first; of two as near the one noted first. */
    int at = obstructions->count++;
    for (; at > 0 && list[at - 1].distance_m > obstruction.distance_m; at--)
        list[at] = list[at - 1];
    list[at] = obstruction;
    return PP_OK;
}

static enum pp_status note_skylines(struct opening_drawing *drawing,
                                    struct pp_error *err)
{
    const struct pp_world *world = drawing->world;
    for (int i = 0; i < world->skyline_count; i++) {
        const struct pp_skyline *skyline = world->skylines + i;
        if (skyline->face != drawing->opening->face)
            continue;
        double distance_m = skyline->distance_m + drawing->face_m;
        double high = isfinite(distance_m)
                          ? (skyline->head_z_m - drawing->frame.point.z) / distance_m
                          : tan(skyline->angle_rad);
        struct obstruction obstruction = {
            .outline = {-INFINITY, INFINITY, -INFINITY, high, skyline->reflectance},
            .distance_m = distance_m};
        enum pp_status status = note(drawing, obstruction, err);
        if (status != PP_OK)
            return status;
    }
    return PP_OK;
}

/* The part of a surface beyond the glass, drawn. Returns the number of its points. */
static int draw_beyond(double (*drawn)[2], const struct pp_polygon *outline,
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

/* What is seen of one thing outside, surface by surface: none of its surfaces that face
 * the point hides another. */
struct silhouette {
    struct pp_area_moments extent;
    double distance_m; /* of the nearest corner */
};

static struct silhouette no_silhouette(void)
{
    return (struct silhouette){pp_area_moments_empty(), INFINITY};
}

static enum pp_status add_surface(struct silhouette *silhouette,
                                  const struct opening_drawing *drawing,
                                  const struct pp_polygon *outline,
                                  struct pp_error *err)
{
    const struct pp_elevation_part *seen = &drawing->seen;
    size_t room = (size_t)outline->count * PP_AREA_MOMENTS_POINTS;
    double(*points)[2] = malloc(2 * room * sizeof *points);
    if (!points)
        return pp_fail_memory(err);
    int count = draw_beyond(points, outline, &drawing->frame, drawing->glass_m);
    struct pp_area_moments extent = pp_area_moments_in_box(
        points, points + room, count, seen->left, seen->right, seen->low, seen->high);
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

static enum pp_status note_silhouette(struct opening_drawing *drawing,
                                      const struct silhouette *silhouette,
                                      double reflectance, struct pp_error *err)
{
    const struct pp_area_moments *extent = &silhouette->extent;
    double width = extent->right - extent->left;
    if (!(extent->area > 0.0 && width > 0.0))
        return PP_OK;
    struct obstruction obstruction = {
        .outline = {extent->left, extent->right, extent->low,
                    extent->low + extent->area / width, reflectance},
        .distance_m = silhouette->distance_m};
    return note(drawing, obstruction, err);
}

static bool faces(const struct pp_polygon *outline, struct pp_vec3 point)
{
    return pp_vec_dot(pp_vec_sub(point, outline->vertices[0]), outline->normal) > 0.0;
}

/* Loose surfaces outside and the building's own outer faces, one by one. */
static enum pp_status note_surfaces(struct opening_drawing *drawing,
                                    struct pp_error *err)
{
    const struct pp_world *world = drawing->world;
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->surface_count && status == PP_OK; i++) {
        const struct pp_surface *surface = world->surfaces + i;
        bool loose_outside = surface->role == PP_FREE_SURFACE && !surface->inside;
        if (i == drawing->opening->face || !(i < world->face_count || loose_outside))
            continue;
        struct silhouette silhouette = no_silhouette();
        bool front = faces(&surface->outline, drawing->frame.point);
        status = add_surface(&silhouette, drawing, &surface->outline, err);
        if (status == PP_OK)
            status = note_silhouette(drawing, &silhouette,
                                     front ? surface->front : surface->back, err);
    }
    return status;
}

/* Blocks: of each the sides that face the point. */
static enum pp_status note_blocks(struct opening_drawing *drawing, struct pp_error *err)
{
    const struct pp_world *world = drawing->world;
    enum pp_status status = PP_OK;
    for (int b = 0; b < world->block_count && status == PP_OK; b++) {
        struct silhouette silhouette = no_silhouette();
        for (int i = 0; i < world->surface_count && status == PP_OK; i++) {
            const struct pp_surface *side = world->surfaces + i;
            if (side->role == PP_BLOCK && side->owner == b
                && faces(&side->outline, drawing->frame.point))
                status = add_surface(&silhouette, drawing, &side->outline, err);
        }
        if (status == PP_OK)
            status = note_silhouette(drawing, &silhouette, world->blocks[b].reflectance,
                                     err);
    }
    return status;
}

/* Edges of what is seen and of all that stands before it, in order, along one axis. */
static int edges_of(double *edges, const struct opening_drawing *drawing, bool across)
{
    const struct pp_elevation_part *seen = &drawing->seen;
    double first = across ? seen->left : seen->low;
    double last = across ? seen->right : seen->high;
    int count = 0;
    edges[count++] = first;
    edges[count++] = last;
    for (int i = 0; i < drawing->obstructions.count; i++) {
        const struct pp_elevation_part *o = &drawing->obstructions.list[i].outline;
        double both[2] = {across ? o->left : o->low, across ? o->right : o->high};
        for (int k = 0; k < 2; k++)
            if (both[k] > first && both[k] < last)
                edges[count++] = both[k];
    }
    for (int i = 1; i < count; i++)
        for (int k = i; k > 0 && edges[k - 1] > edges[k]; k--) {
            double swap = edges[k];
            edges[k] = edges[k - 1];
            edges[k - 1] = swap;
        }
    return count;
}

/* Reflectance of the nearest obstruction at a point of the drawing; NAN: sky. */
static double behind(const struct opening_drawing *drawing, double x, double z)
{
    for (int i = 0; i < drawing->obstructions.count; i++) {
        const struct pp_elevation_part *o = &drawing->obstructions.list[i].outline;
        if (x > o->left && x < o->right && z > o->low && z < o->high)
            return o->reflectance;
    }
    return NAN;
}

/* Cuts what is seen along all edges; each part has one thing behind it. */
static enum pp_status cut_up(struct pp_elevation *elevation,
                             const struct opening_drawing *drawing,
                             struct pp_error *err)
{
    size_t most = 2 * (size_t)drawing->obstructions.count + 2;
    double *across = malloc(2 * most * sizeof *across);
    struct pp_elevation_part *parts = malloc(most * most * sizeof *parts);
    if (!across || !parts) {
        free(across);
        free(parts);
        return pp_fail_memory(err);
    }
    int columns = edges_of(across, drawing, true) - 1;
    double *up = across + most;
    int rows = edges_of(up, drawing, false) - 1;
    for (int i = 0; i < columns; i++)
        for (int k = 0; k < rows; k++) {
            struct pp_elevation_part part = {across[i], across[i + 1], up[k], up[k + 1],
                                             NAN};
            if (is_empty(&part))
                continue;
            part.reflectance = behind(drawing, (part.left + part.right) / 2.0,
                                      (part.low + part.high) / 2.0);
            parts[elevation->count++] = part;
        }
    elevation->parts = parts;
    free(across);
    return PP_OK;
}

enum pp_status pp_elevation_create(struct pp_elevation *elevation,
                                   const struct pp_world *world,
                                   const struct pp_opening *opening,
                                   struct pp_vec3 point, struct pp_error *err)
{
    *elevation = (struct pp_elevation){0};
    struct opening_drawing drawing = {
        .world = world,
        .opening = opening,
        .frame = {point, opening->along, pp_vec_scale(opening->inner.normal, -1.0),
                  opening->up},
    };
    drawing.face_m = in_frame(&drawing.frame, opening->inner.vertices[0]).y;
    drawing.glass_m = in_frame(&drawing.frame, opening->outer.vertices[0]).y;
    if (drawing.face_m < 1e-9)
        return PP_OK;

    enum pp_status status = see(&drawing, err);
    if (status != PP_OK || is_empty(&drawing.seen))
        return status;
    status = note_skylines(&drawing, err);
    if (status == PP_OK)
        status = note_surfaces(&drawing, err);
    if (status == PP_OK)
        status = note_blocks(&drawing, err);
    if (status == PP_OK)
        status = cut_up(elevation, &drawing, err);
    free(drawing.obstructions.list);
    return status;
}

void pp_elevation_clear(struct pp_elevation *elevation)
{
    free(elevation->parts);
    *elevation = (struct pp_elevation){0};
}
