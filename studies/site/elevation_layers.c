/* elevation_layers.c - see elevation_layers.h. */
#include "studies/site/elevation_layers.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/bounds.h"

#define SAME_WAY_RAD (2.0 * PP_RAD)
#define OVERLAP_M 0.01 /* walls that overlap by less are treated as adjacent */

/* On an elevation, greatest distance in depth between a wall without windows and a wall
 * with windows, unless both belong to the same room. */
static const double near_m = 3.0;

/* A wall that could be drawn on an elevation. */
struct seen_wall {
    struct pp_elevation_wall wall; /* only room, room_at, face and front_m are set */
    struct pp_bounds2 box;         /* in coordinates u and v */
    bool has_windows;
    int index;
};

struct seen_walls {
    struct seen_wall *list;
    int count;
};

static bool faces(struct pp_vec3 out, struct pp_vec3 way)
{
    return pp_vec_dot(out, way) > cos(SAME_WAY_RAD);
}

static bool has_windows(const struct pp_site_sheet *site, int room, int face)
{
    for (int i = 0; i < site->window_count; i++)
        if (site->windows[i].room_at == room && site->windows[i].face == face)
            return true;
    return false;
}

/* Compares walls: walls with windows come first, then walls in front. */
static int by_importance(const void *left, const void *right)
{
    const struct seen_wall *a = left, *b = right;
    if (a->has_windows != b->has_windows)
        return a->has_windows ? -1 : 1;
    long front =
        lround(b->wall.front_m / OVERLAP_M) - lround(a->wall.front_m / OVERLAP_M);
    return front != 0 ? (front > 0 ? 1 : -1) : a->index - b->index;
}

static enum pp_status add_seen(struct seen_walls *seen,
                               const struct pp_elevation_sheet *sheet,
                               const struct pp_world *world, int room, int face,
                               struct pp_vec3 way, struct pp_error *err)
{
    struct seen_wall one = {
        .wall = {.room = world->name, .room_at = room, .face = face},
        .box = pp_bounds2_empty(),
        .has_windows = has_windows(&sheet->site, room, face),
        .index = seen->count};
    const struct pp_polygon *outline = &world->surfaces[face].outline;
    for (int k = 0; k < outline->count; k++) {
        struct pp_vec3 p =
            pp_placement_to_building(&world->placement, outline->vertices[k]);
        pp_bounds2_add(&one.box, pp_vec_dot(p, pp_vec(-way.y, way.x, 0.0)), p.z);
        one.wall.front_m = pp_vec_dot(p, way);
    }
    enum pp_status status =
        pp_array_append(&seen->list, seen->count, sizeof *seen->list, err);
    if (status == PP_OK)
        seen->list[seen->count++] = one;
    return status;
}

/* True if the wall is on any elevation. */
static bool is_drawn(const struct pp_elevation_sheet *sheet, int room, int face)
{
    for (int i = 0; i < sheet->count; i++)
        for (int k = 0; k < sheet->elevations[i].wall_count; k++)
            if (sheet->elevations[i].walls[k].room_at == room
                && sheet->elevations[i].walls[k].face == face)
                return true;
    return false;
}

/* Lists the outer vertical walls that face `way` and are not yet on an elevation, the
 * most important first. */
static enum pp_status find_seen(struct seen_walls *seen,
                                const struct pp_elevation_sheet *sheet,
                                const struct pp_site_rooms *rooms, struct pp_vec3 way,
                                struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int r = 0; r < rooms->count; r++) {
        const struct pp_world *world = rooms->list[r].world;
        for (int i = 0; i < world->face_count && status == PP_OK; i++) {
            const struct pp_surface *face = &world->surfaces[i];
            struct pp_vec3 out = pp_placement_turn(
                pp_vec_scale(face->outline.normal, -1.0), world->placement.rotate_rad);
            if (face->role == PP_WALL && !face->is_inner
                && fabs(face->outline.normal.z) <= 0.02 && faces(out, way)
                && !is_drawn(sheet, r, i))
                status = add_seen(seen, sheet, world, r, i, way, err);
        }
    }
    if (status == PP_OK && seen->count > 0)
        qsort(seen->list, seen->count, sizeof *seen->list, by_importance);
    return status;
}

static bool overlap(const struct pp_bounds2 *a, const struct pp_bounds2 *b)
{
    for (int k = 0; k < 2; k++)
        if (fmin(a->high[k], b->high[k]) - fmax(a->low[k], b->low[k]) < OVERLAP_M)
            return false;
    return true;
}

/* True if a wall can be drawn on the layer together with those of the first `count`
 * walls that are already on it. layers: layer of each wall; -1: none. */
static bool fits_layer(const struct seen_walls *seen, const int *layers, int count,
                       int layer)
{
    const struct seen_wall *wall = &seen->list[count];
    bool is_near = wall->has_windows;
    for (int i = 0; i < count; i++) {
        const struct seen_wall *other = &seen->list[i];
        if (layers[i] != layer)
            continue;
        if (overlap(&wall->box, &other->box))
            return false;
        is_near |= other->wall.room_at == wall->wall.room_at
                   || (other->has_windows
                       && fabs(other->wall.front_m - wall->wall.front_m) <= near_m);
    }
    return is_near;
}

static enum pp_status add_layer(struct pp_elevation_sheet *sheet, struct pp_vec3 out,
                                int layer, struct pp_error *err)
{
    enum pp_status status = pp_array_append(&sheet->elevations, sheet->count,
                                            sizeof *sheet->elevations, err);
    if (status != PP_OK)
        return status;
    double bearing = fmod(atan2(out.x, out.y) + sheet->site.north_rad, 2.0 * PP_PI);
    sheet->elevations[sheet->count++] = (struct pp_site_elevation){
        .out = out,
        .right = pp_vec(-out.y, out.x, 0.0),
        .layer = layer,
        .bearing_rad = bearing < -1e-9 ? bearing + 2.0 * PP_PI : fmax(bearing, 0.0),
        .low = {INFINITY, sheet->site.ground_m},
        .high = {-INFINITY, sheet->site.ground_m}};
    return PP_OK;
}

static enum pp_status add_to_layer(struct pp_site_elevation *elevation,
                                   const struct pp_site_sheet *site,
                                   const struct pp_elevation_wall *wall,
                                   struct pp_error *err)
{
    enum pp_status status = pp_array_append(&elevation->walls, elevation->wall_count,
                                            sizeof *elevation->walls, err);
    if (status == PP_OK)
        elevation->walls[elevation->wall_count++] = *wall;
    for (int i = 0; i < site->window_count && status == PP_OK; i++) {
        if (site->windows[i].room_at != wall->room_at
            || site->windows[i].face != wall->face)
            continue;
        status = pp_array_append(&elevation->windows, elevation->window_count,
                                 sizeof *elevation->windows, err);
        if (status == PP_OK)
            elevation->windows[elevation->window_count++] = i;
    }
    return status;
}

/* Adds the elevations for one direction. */
static enum pp_status make_layers(struct pp_elevation_sheet *sheet,
                                  const struct pp_site_rooms *rooms, struct pp_vec3 way,
                                  struct pp_error *err)
{
    struct seen_walls seen = {0};
    int first = sheet->count;
    enum pp_status status = find_seen(&seen, sheet, rooms, way, err);
    int *layers = calloc((size_t)seen.count + 1, sizeof *layers);
    if (status == PP_OK && !layers)
        status = pp_fail_memory(err);
    for (int i = 0; i < seen.count && status == PP_OK; i++) {
        int layer = 0, count = sheet->count - first;
        while (layer < count && !fits_layer(&seen, layers, i, layer))
            layer++;
        layers[i] = layer < count || seen.list[i].has_windows ? layer : -1;
        if (layers[i] == count)
            status = add_layer(sheet, way, layer, err);
        if (status == PP_OK && layers[i] >= 0)
            status = add_to_layer(&sheet->elevations[first + layer], &sheet->site,
                                  &seen.list[i].wall, err);
    }
    free(layers);
    free(seen.list);
    return status;
}

static bool has_direction(const struct pp_elevation_sheet *sheet, struct pp_vec3 way)
{
    for (int i = 0; i < sheet->count; i++)
        if (faces(sheet->elevations[i].out, way))
            return true;
    return false;
}

static int by_bearing(const void *left, const void *right)
{
    const struct pp_site_elevation *a = left, *b = right;
    if (a->bearing_rad != b->bearing_rad)
        return a->bearing_rad > b->bearing_rad ? 1 : -1;
    return a->layer - b->layer;
}

enum pp_status pp_elevation_layers_make(struct pp_elevation_sheet *sheet,
                                        const struct pp_site_rooms *rooms,
                                        struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < sheet->site.window_count && status == PP_OK; i++)
        if (!has_direction(sheet, sheet->site.windows[i].out))
            status = make_layers(sheet, rooms, sheet->site.windows[i].out, err);
    if (status == PP_OK && sheet->count > 0)
        qsort(sheet->elevations, sheet->count, sizeof *sheet->elevations, by_bearing);
    return status;
}
