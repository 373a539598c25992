/* site_study.c - see site_study.h. */
#include "studies/site/site_study.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/bounds.h"
#include "studies/criteria/pair_rooms.h"
#include "studies/criteria/windows/vertical_sky.h"
#include "studies/site/garden_sun.h"
#include "studies/site/mesh_shapes.h"
#include "studies/site/site_trees.h"

/* Former and present corners closer than this (m) are treated as equal. */
static const double same_m = 0.01;

/* ---- windows ---- */

static double before_of(const struct pp_study_room *before, const int *pairs,
                        int opening, double french_m, enum pp_status *status,
                        struct pp_error *err)
{
    double component = NAN;
    if (before)
        *status = pp_vertical_sky_at_point(&component, before->world,
                                           &before->world->openings[pairs[opening]],
                                           french_m, err);
    return component;
}

static enum pp_status add_window(struct pp_site_sheet *sheet,
                                 const struct pp_world *world, int room_at, int index,
                                 double before, struct pp_error *err)
{
    const struct pp_opening *opening = &world->openings[index];
    const struct pp_placement *place = &world->placement;
    struct pp_site_window window = {.name = opening->name,
                                    .label = opening->label,
                                    .room = world->name,
                                    .room_at = room_at,
                                    .face = opening->face,
                                    .line = opening->line,
                                    .before = before,
                                    .height_m = opening->height_m};
    window.out =
        pp_placement_turn(pp_vec_scale(opening->inner.normal, -1.0), place->rotate_rad);
    struct pp_bounds2 box = pp_bounds2_empty();
    const struct pp_polygon *outline = &opening->outer;
    for (int i = 0; i < outline->count; i++)
        pp_bounds2_add(&box, pp_vec_dot(outline->vertices[i], opening->along),
                       outline->vertices[i].z);
    /* As seen from outside, `along` points to the left. */
    struct pp_vec3 middle = pp_polygon_middle(outline);
    double at = pp_vec_dot(middle, opening->along);
    middle.z = box.low[1];
    window.from = pp_placement_to_building(
        place, pp_vec_along(middle, box.high[0] - at, opening->along));
    window.to = pp_placement_to_building(
        place, pp_vec_along(middle, box.low[0] - at, opening->along));
    enum pp_status status = pp_vertical_sky_at_point(&window.component, world, opening,
                                                     sheet->french_m, err);
    if (status == PP_OK)
        status = pp_array_append(&sheet->windows, sheet->window_count,
                                 sizeof *sheet->windows, err);
    if (status == PP_OK)
        sheet->windows[sheet->window_count++] = window;
    sheet->has_before |= isfinite(before);
    return status;
}

static enum pp_status add_site_windows(struct pp_site_sheet *sheet,
                                       const struct pp_site_rooms *rooms, int room_at,
                                       struct pp_error *err)
{
    const struct pp_study_room *room = &rooms->list[room_at];
    const struct pp_study_room *before = rooms->before[room_at];
    int *pairs = NULL;
    enum pp_status status = PP_OK;
    if (before)
        status = pp_pair_rooms(&pairs, room->world, before->world, err);
    for (int i = 0; i < room->world->opening_count && status == PP_OK; i++) {
        if (!pp_vertical_sky_is_upright(&room->world->openings[i]))
            continue;
        double former = before_of(before, pairs, i, sheet->french_m, &status, err);
        if (status == PP_OK)
            status = add_window(sheet, room->world, room_at, i, former, err);
    }
    free(pairs);
    return status;
}

/* True if window a is above window b in about the same plane. */
static bool is_above(const struct pp_site_window *a, const struct pp_site_window *b)
{
    struct pp_vec3 along = pp_vec_sub(b->to, b->from);
    double width = pp_vec_length(along);
    if (pp_vec_dot(a->out, b->out) < 0.999 || width < same_m
        || a->from.z < b->from.z + 0.5 * b->height_m)
        return false;
    along = pp_vec_scale(along, 1.0 / width);
    double off = pp_vec_dot(pp_vec_sub(a->from, b->from), b->out);
    double from = pp_vec_dot(pp_vec_sub(a->from, b->from), along);
    double to = pp_vec_dot(pp_vec_sub(a->to, b->from), along);
    return fabs(off) < 1.0 && from < width - same_m && to > same_m;
}

static void count_storeys(struct pp_site_sheet *sheet)
{
    /* Numbers storeys upwards: a window is one storey above the highest window below
     * it. */
    for (int pass = 0, changed = 1; changed && pass < sheet->window_count; pass++) {
        changed = 0;
        for (int i = 0; i < sheet->window_count; i++)
            for (int k = 0; k < sheet->window_count; k++) {
                struct pp_site_window *upper = &sheet->windows[i];
                const struct pp_site_window *lower = &sheet->windows[k];
                if (i != k && upper->storey <= lower->storey
                    && is_above(upper, lower)) {
                    upper->storey = lower->storey + 1;
                    changed = 1;
                }
            }
    }
}

/* ---- objects on the site ---- */

static enum pp_status add_shape(struct pp_site_sheet *sheet,
                                const struct pp_polygon *outline,
                                const struct pp_placement *place, const char *name,
                                bool is_room, struct pp_error *err)
{
    struct pp_site_shape shape = {.count = outline->count,
                                  .corners =
                                      malloc(outline->count * sizeof *shape.corners),
                                  .top_m = -INFINITY,
                                  .name = name,
                                  .is_room = is_room,
                                  .is_level = fabs(outline->normal.z) > 1e-6};
    if (!shape.corners)
        return pp_fail_memory(err);
    for (int i = 0; i < shape.count; i++) {
        shape.corners[i] = pp_placement_to_building(place, outline->vertices[i]);
        shape.top_m = fmax(shape.top_m, shape.corners[i].z);
    }
    enum pp_status status =
        pp_array_append(&sheet->shapes, sheet->shape_count, sizeof *sheet->shapes, err);
    if (status != PP_OK) {
        free(shape.corners);
        return status;
    }
    sheet->shapes[sheet->shape_count++] = shape;
    return PP_OK;
}

/* Name of a surface; for a side of a block, name of the block. */
static const char *site_surface_name(const struct pp_world *world,
                                     const struct pp_surface *surface)
{
    return surface->role == PP_BLOCK ? world->blocks[surface->owner].name
                                     : surface->name;
}

static enum pp_status add_shapes(struct pp_site_sheet *sheet,
                                 const struct pp_world *world, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    int count = pp_world_before_meshes(world);
    for (int i = world->face_count; i < count && status == PP_OK; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        if (!surface->inside && surface->role != PP_FACADE
            && surface->role != PP_SKYLINE)
            status = add_shape(sheet, &surface->outline, &world->placement,
                               site_surface_name(world, surface), false, err);
    }
    for (int i = 0; i < world->mesh_count && status == PP_OK; i++)
        status = pp_mesh_shapes_add(sheet, world, &world->meshes[i], err);
    return status;
}

static enum pp_status add_floor(struct pp_site_sheet *sheet,
                                const struct pp_world *world, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->face_count && status == PP_OK; i++)
        if (world->surfaces[i].role == PP_FLOOR)
            status = add_shape(sheet, &world->surfaces[i].outline, &world->placement,
                               world->name, true, err);
    return status;
}

static bool same_site_shape(const struct pp_site_shape *a,
                            const struct pp_site_shape *b)
{
    if (a->count != b->count)
        return false;
    for (int shift = 0; shift < a->count; shift++) {
        int k = 0;
        while (k < a->count
               && pp_vec_length(
                      pp_vec_sub(a->corners[k], b->corners[(k + shift) % b->count]))
                      < same_m)
            k++;
        if (k == a->count)
            return true;
    }
    return false;
}

/* A shape and the x of its middle, by which shapes are sorted. Equal shapes have the
 * same x. */
struct shape_place {
    double x;
    int index;
};

static double middle_x(const struct pp_site_shape *shape)
{
    double sum = 0.0;
    for (int i = 0; i < shape->count; i++)
        sum += shape->corners[i].x;
    return sum / shape->count;
}

static int by_x(const void *left, const void *right)
{
    const struct shape_place *a = left, *b = right;
    return (a->x > b->x) - (a->x < b->x);
}

/* Index of the first entry whose x is at least `least`. */
static int first_from(const struct shape_place *places, int count, double least)
{
    int low = 0, high = count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (places[middle].x < least)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Marks the shapes of the sheet that are equal to a former shape. Returns false if
 * there are none. */
static bool mark_same(struct pp_site_sheet *sheet, const struct shape_place *places,
                      int count, const struct pp_site_shape *former)
{
    bool found = false;
    double x = middle_x(former);
    for (int i = first_from(places, count, x - same_m);
         i < count && places[i].x <= x + same_m; i++)
        if (same_site_shape(&sheet->shapes[places[i].index], former)) {
            sheet->shapes[places[i].index].when = PP_SITE_ALWAYS;
            found = true;
        }
    return found;
}

/* Moves a former shape that no longer exists to the sheet. */
static enum pp_status add_gone(struct pp_site_sheet *sheet,
                               struct pp_site_shape *former, struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&sheet->shapes, sheet->shape_count, sizeof *sheet->shapes, err);
    if (status != PP_OK)
        return status;
    struct pp_site_shape *gone = &sheet->shapes[sheet->shape_count++];
    *gone = *former;
    gone->when = PP_SITE_GONE;
    *former = (struct pp_site_shape){0};
    return PP_OK;
}

/* Marks new shapes, and adds demolished ones. */
static enum pp_status compare_site_before(struct pp_site_sheet *sheet,
                                          const struct pp_world *before,
                                          struct pp_error *err)
{
    struct pp_site_sheet former = {0};
    int now = sheet->shape_count;
    struct shape_place *places = malloc(((size_t)now + 1) * sizeof *places);
    enum pp_status status =
        places ? add_shapes(&former, before, err) : pp_fail_memory(err);
    for (int i = 0; i < now && places; i++) {
        sheet->shapes[i].when = PP_SITE_NEW;
        places[i] = (struct shape_place){middle_x(&sheet->shapes[i]), i};
    }
    if (places && now > 0)
        qsort(places, (size_t)now, sizeof *places, by_x);
    for (int k = 0; k < former.shape_count && status == PP_OK; k++)
        if (!mark_same(sheet, places, now, &former.shapes[k]))
            status = add_gone(sheet, &former.shapes[k], err);
    pp_site_sheet_clear(&former);
    free(places);
    return status;
}

/* Compares by height; rooms come after all other objects. Rooms are drawn above all
 * objects, since their outlines are floors. */
static int by_height(const void *left, const void *right)
{
    const struct pp_site_shape *a = left, *b = right;
    if (a->is_room != b->is_room)
        return a->is_room - b->is_room;
    return (a->top_m > b->top_m) - (a->top_m < b->top_m);
}

/* ---- gardens ---- */

static enum pp_status add_garden(struct pp_site_sheet *sheet,
                                 const struct pp_world *world,
                                 const struct pp_garden *garden, struct pp_error *err)
{
    enum pp_status status = pp_array_append(&sheet->gardens, sheet->garden_count,
                                            sizeof *sheet->gardens, err);
    if (status != PP_OK)
        return status;
    struct pp_site_garden *added = &sheet->gardens[sheet->garden_count++];
    int count = garden->outline.count;
    *added = (struct pp_site_garden){.count = count,
                                     .corners = malloc(count * sizeof *added->corners),
                                     .share = NAN,
                                     .name = garden->name};
    if (!added->corners)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++) {
        struct pp_vec3 p =
            pp_placement_to_building(&world->placement, garden->outline.vertices[i]);
        added->corners[i][0] = p.x;
        added->corners[i][1] = p.y;
    }
    if (isnan(world->latitude_rad))
        return PP_OK;
    struct pp_garden_sun sun;
    status = pp_garden_sun_find(&sun, world, garden, err);
    if (status != PP_OK)
        return status;
    added->share = sun.sunlit_m2 / sun.area_m2;
    added->dark = sun.dark;
    for (int i = 0; i < added->dark.count; i++)
        for (int k = 0; k < added->dark.list[i].count; k++) {
            double *xy = added->dark.list[i].xy[k];
            struct pp_vec3 p =
                pp_placement_to_building(&world->placement, pp_vec(xy[0], xy[1], 0.0));
            xy[0] = p.x;
            xy[1] = p.y;
        }
    return PP_OK;
}

static enum pp_status make_site_sheet(struct pp_site_sheet *sheet,
                                      const struct pp_site_rooms *rooms,
                                      struct pp_error *err)
{
    const struct pp_world *first = rooms->list[0].world;
    const char *building = pp_building_name(rooms->list[0].building);
    sheet->title = building ? building : first->name;
    sheet->french_m = rooms->french_m;
    sheet->north_rad = first->north_rad + first->placement.rotate_rad;
    sheet->ground_m = first->ground_level_m + first->placement.z;
    enum pp_status status = add_shapes(sheet, first, err);
    const struct pp_world *before = rooms->before[0] ? rooms->before[0]->world : NULL;
    if (status == PP_OK && before)
        status = compare_site_before(sheet, before, err);
    if (status == PP_OK)
        status = pp_site_trees_add(sheet, first, before, err);
    for (int i = 0; i < rooms->count && status == PP_OK; i++) {
        const struct pp_world *world = rooms->list[i].world;
        status = add_floor(sheet, world, err);
        for (int k = 0; k < world->garden_count && status == PP_OK; k++)
            status = add_garden(sheet, world, &world->gardens[k], err);
        if (status == PP_OK)
            status = add_site_windows(sheet, rooms, i, err);
    }
    if (status != PP_OK)
        return status;
    if (sheet->shape_count)
        qsort(sheet->shapes, sheet->shape_count, sizeof *sheet->shapes, by_height);
    count_storeys(sheet);
    return PP_OK;
}

enum pp_status pp_site_study_make(struct pp_site_sheet *sheet,
                                  const struct pp_site_rooms *rooms,
                                  struct pp_error *err)
{
    *sheet = (struct pp_site_sheet){0};
    enum pp_status status = make_site_sheet(sheet, rooms, err);
    if (status != PP_OK)
        pp_site_sheet_clear(sheet);
    return status;
}
