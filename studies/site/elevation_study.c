/* elevation_study.c - see elevation_study.h. */
#include "studies/site/elevation_study.h"

#include <math.h>
#include <stdlib.h>

#include "methods/exact/exterior.h"
#include "model/base/array.h"
#include "model/geometry/bounds.h"
#include "model/geometry/clipper.h"
#include "model/geometry/contour/contour.h"
#include "studies/site/elevation_layers.h"
#include "studies/site/site_trees.h"

#define TOLERANCE_M 0.01
#define INSET_M 0.005 /* inset of points on a wall's edge, m */

/* ---- contours of a wall ---- */

/* Position in the room of the points of a flattened wall. */
struct wall_frame {
    const struct pp_world *world;
    int face;
    struct pp_vec3 out, right; /* unit vectors in the room's axes */
    struct pp_vec3 origin;     /* a point on the outer face of the wall */
    double origin_u;           /* coordinate u of that point */
    double base_z;             /* level of the room's floor in the building, m */
    struct pp_bounds2 box;     /* bounds of the outline */
};

static enum pp_status component_at(void *context, double u, double v, double *value,
                                   struct pp_error *err)
{
    const struct wall_frame *frame = context;
    const struct pp_outside_light light = {.sky = pp_sky_overcast()};
    u = fmin(fmax(u, frame->box.low[0] + INSET_M), frame->box.high[0] - INSET_M);
    v = fmin(fmax(v, frame->box.low[1] + INSET_M), frame->box.high[1] - INSET_M);
    struct pp_vec3 at = pp_vec_along(frame->origin, u - frame->origin_u, frame->right);
    at.z = v - frame->base_z;
    struct pp_exterior_light outside;
    enum pp_status status = pp_exterior_light_on_plane(
        &outside, frame->world, &light, at, frame->out, frame->face, err);
    *value = outside.sky;
    return status;
}

static enum pp_status trace_elevation_wall(struct pp_elevation_wall *wall,
                                           struct wall_frame *frame,
                                           struct pp_error *err)
{
    struct pp_field *field;
    enum pp_status status =
        pp_field_create(&field, &wall->outline, component_at, frame, TOLERANCE_M, err);
    if (status != PP_OK)
        return status;
    for (int i = 0; i < PP_SITE_LEVELS && status == PP_OK; i++) {
        status = pp_contour_curves(field, pp_site_sheet_levels[i], &wall->lines, err);
        if (status == PP_OK)
            status =
                pp_contour_below(field, pp_site_sheet_levels[i], &wall->below, err);
    }
    pp_field_destroy(field);
    return status;
}

/* Distance (m) from the inner face of a wall to its outer face. */
static double outside_of(const struct pp_world *world, int face)
{
    for (int i = 0; i < world->facade_count; i++)
        if (world->facades[i].face == face)
            return world->facades[i].depth_m;
    double depth = 0.0;
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == face)
            depth = fmax(depth, world->openings[i].reveal_m);
    return depth;
}

/* Coordinates u and v in the elevation of a point in a room. */
static void flat_of(const struct pp_site_elevation *elevation,
                    const struct pp_world *world, struct pp_vec3 point, double uv[2])
{
    struct pp_vec3 p = pp_placement_to_building(&world->placement, point);
    uv[0] = pp_vec_dot(p, elevation->right);
    uv[1] = p.z;
}

static enum pp_status add_doors(struct pp_elevation_wall *wall,
                                const struct pp_site_elevation *elevation,
                                const struct pp_world *world, int face,
                                struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = world->face_count; i < world->surface_count && status == PP_OK; i++) {
        const struct pp_surface *door = &world->surfaces[i];
        if (!door->is_door || door->owner != face)
            continue;
        struct pp_bounds2 box = pp_bounds2_empty();
        for (int k = 0; k < door->outline.count; k++) {
            double uv[2];
            flat_of(elevation, world, door->outline.vertices[k], uv);
            pp_bounds2_add(&box, uv[0], uv[1]);
        }
        status =
            pp_array_append(&wall->doors, wall->door_count, sizeof *wall->doors, err);
        if (status == PP_OK)
            wall->doors[wall->door_count++] = box;
    }
    return status;
}

/* Finds the outline of a face in coordinates u and v. */
static enum pp_status flatten_wall(struct pp_elevation_wall *wall,
                                   const struct pp_site_elevation *elevation,
                                   const struct pp_world *world, int face,
                                   struct pp_error *err)
{
    const struct pp_polygon *outline = &world->surfaces[face].outline;
    double(*xy)[2] = malloc(outline->count * sizeof *xy);
    struct pp_clipper *clipper = NULL;
    if (!xy)
        return pp_fail_memory(err);
    for (int i = 0; i < outline->count; i++)
        flat_of(elevation, world, outline->vertices[i], xy[i]);
    enum pp_status status = pp_clipper_create(&clipper, err);
    if (status == PP_OK)
        status = pp_clipper_of_ring(clipper, &wall->outline, (const double(*)[2])xy,
                                    outline->count, err);
    pp_clipper_destroy(clipper);
    free(xy);
    return status;
}

static enum pp_status fill_elevation_wall(struct pp_site_elevation *elevation,
                                          struct pp_elevation_wall *wall,
                                          const struct pp_world *world,
                                          struct pp_error *err)
{
    int face = wall->face;
    enum pp_status status = flatten_wall(wall, elevation, world, face, err);
    if (status == PP_OK)
        status = add_doors(wall, elevation, world, face, err);
    if (status != PP_OK || wall->outline.count == 0)
        return status;
    const struct pp_placement *place = &world->placement;
    struct wall_frame frame = {
        .world = world,
        .face = face,
        .out = pp_vec_scale(world->surfaces[face].outline.normal, -1.0),
        .right = pp_placement_turn(elevation->right, -place->rotate_rad),
        .base_z = place->z,
        .box = pp_region_bounds(&wall->outline)};
    struct pp_vec3 corner = world->surfaces[face].outline.vertices[0];
    frame.origin_u =
        pp_vec_dot(pp_placement_to_building(place, corner), elevation->right);
    frame.origin = pp_vec_along(corner, outside_of(world, face), frame.out);
    return trace_elevation_wall(wall, &frame, err);
}

/* ---- elevations ---- */

static enum pp_status fill_walls(struct pp_site_elevation *elevation,
                                 const struct pp_site_rooms *rooms,
                                 struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < elevation->wall_count && status == PP_OK; i++) {
        struct pp_elevation_wall *wall = &elevation->walls[i];
        status =
            fill_elevation_wall(elevation, wall, rooms->list[wall->room_at].world, err);
    }
    return status;
}

/* Adds the bounds, in u and v, of a list of corners to a list. */
static enum pp_status add_box(struct pp_bounds2 **list, int *count,
                              const struct pp_site_elevation *elevation,
                              const struct pp_world *world,
                              const struct pp_vec3 *corners, int corner_count,
                              struct pp_error *err)
{
    struct pp_bounds2 box = pp_bounds2_empty();
    enum pp_status status = pp_array_append(list, *count, sizeof **list, err);
    for (int i = 0; i < corner_count; i++) {
        double uv[2];
        flat_of(elevation, world, corners[i], uv);
        pp_bounds2_add(&box, uv[0], uv[1]);
    }
    if (status == PP_OK)
        (*list)[(*count)++] = box;
    return status;
}

/* Finds the elevation that shows a face of a room; NULL: none. */
static struct pp_site_elevation *elevation_of(struct pp_elevation_sheet *sheet,
                                              int room, int face)
{
    for (int i = 0; i < sheet->count; i++)
        for (int k = 0; k < sheet->elevations[i].wall_count; k++)
            if (sheet->elevations[i].walls[k].room_at == room
                && sheet->elevations[i].walls[k].face == face)
                return &sheet->elevations[i];
    return NULL;
}

static enum pp_status add_facades(struct pp_elevation_sheet *sheet,
                                  const struct pp_world *world, int room,
                                  struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->facade_count && status == PP_OK; i++) {
        struct pp_site_elevation *elevation =
            elevation_of(sheet, room, world->facades[i].face);
        if (elevation)
            status = add_box(&elevation->facades, &elevation->facade_count, elevation,
                             world, world->facades[i].corners, 4, err);
    }
    return status;
}

/* Adds the balconies, overhangs and fins of the room's windows. */
static enum pp_status add_elevation_shades(struct pp_elevation_sheet *sheet,
                                           const struct pp_world *world, int room,
                                           struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = world->face_count; i < world->surface_count && status == PP_OK; i++) {
        const struct pp_surface *shade = &world->surfaces[i];
        if (!shade->is_shade || shade->owner < 0 || shade->inside)
            continue;
        struct pp_site_elevation *elevation =
            elevation_of(sheet, room, world->openings[shade->owner].face);
        if (elevation)
            status = add_box(&elevation->shades, &elevation->shade_count, elevation,
                             world, shade->outline.vertices, shade->outline.count, err);
    }
    return status;
}

/* Facades, shading and trees are drawn up to this distance (m) outside the walls. */
static const double beyond_m = 1.5;

/* Extends the elevation so that it shows facades, shading and trees. The extension is
 * limited, since facades may be much larger than the walls. */
static void extend_elevation(struct pp_site_elevation *elevation,
                             const struct pp_bounds2 *boxes, int count)
{
    double low[2], high[2];
    for (int k = 0; k < 2; k++) {
        low[k] = elevation->low[k] - (k ? 0.0 : beyond_m);
        high[k] = elevation->high[k] + beyond_m;
    }
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 2; k++) {
            elevation->low[k] = fmin(elevation->low[k], fmax(boxes[i].low[k], low[k]));
            elevation->high[k] =
                fmax(elevation->high[k], fmin(boxes[i].high[k], high[k]));
        }
}

static enum pp_status measure_elevation(struct pp_site_elevation *elevation,
                                        const struct pp_site_sheet *site,
                                        struct pp_error *err)
{
    for (int i = 0; i < elevation->wall_count; i++) {
        struct pp_bounds2 box = pp_region_bounds(&elevation->walls[i].outline);
        for (int k = 0; k < 2; k++) {
            elevation->low[k] = fmin(elevation->low[k], box.low[k]);
            elevation->high[k] = fmax(elevation->high[k], box.high[k]);
        }
    }
    extend_elevation(elevation, elevation->facades, elevation->facade_count);
    extend_elevation(elevation, elevation->shades, elevation->shade_count);
    enum pp_status status = pp_site_trees_in_front(elevation, site, err);
    if (status == PP_OK)
        extend_elevation(elevation, elevation->crowns, elevation->crown_count);
    return status;
}

static enum pp_status make_elevation_sheet(struct pp_elevation_sheet *sheet,
                                           const struct pp_site_rooms *rooms,
                                           struct pp_error *err)
{
    enum pp_status status = pp_site_study_make(&sheet->site, rooms, err);
    if (status == PP_OK)
        status = pp_elevation_layers_make(sheet, rooms, err);
    if (status == PP_OK && sheet->count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "no elevation: the room has no vertical windows");
    for (int i = 0; i < sheet->count && status == PP_OK; i++)
        status = fill_walls(&sheet->elevations[i], rooms, err);
    for (int i = 0; i < rooms->count && status == PP_OK; i++) {
        status = add_facades(sheet, rooms->list[i].world, i, err);
        if (status == PP_OK)
            status = add_elevation_shades(sheet, rooms->list[i].world, i, err);
    }
    for (int i = 0; i < sheet->count && status == PP_OK; i++)
        status = measure_elevation(&sheet->elevations[i], &sheet->site, err);
    return status;
}

/* Limit of triangles in meshes: 2,000 triangles in front of one room take 4.7 s. */
enum { MESH_TRIANGLES_MOST = 2000 };

enum pp_status pp_elevation_study_make(struct pp_elevation_sheet *sheet,
                                       const struct pp_site_rooms *rooms,
                                       struct pp_error *err)
{
    *sheet = (struct pp_elevation_sheet){0};
    for (int i = 0; i < rooms->count; i++) {
        const struct pp_world *world = rooms->list[i].world;
        int triangles = world->surface_count - pp_world_before_meshes(world);
        if (triangles > MESH_TRIANGLES_MOST)
            return pp_fail(err, PP_BAD_INPUT,
                           "the external meshes have %d triangles, too many for the "
                           "elevation with the view of the sky; expected at most %d",
                           triangles, MESH_TRIANGLES_MOST);
    }
    enum pp_status status = make_elevation_sheet(sheet, rooms, err);
    if (status != PP_OK)
        pp_site_sheet_clear_elevations(sheet);
    return status;
}
