/* receivers.c - see receivers.h.
 *
 * A grid covers the extent of the working plane less the margin on all sides, with
 * equal cells no larger than the spacing. A cell counts if its centre is in the plane,
 * and at least the margin away from the edge of the plane.
 */
#include "model/room/build/receivers.h"

#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/cell_areas.h"
#include "model/geometry/tolerance.h"
#include "model/room/position.h"

/* Spacing and margin of the default grid. */
static const double default_spacing_m = 0.5;

/* Limits on the receivers of a room, and on comparisons, since each receiver is
 * compared with each surface. */
enum { RECEIVERS_MOST = 100000 };
static const double comparisons_most = 1e8;

struct receiver_list {
    struct pp_receiver *items;
    int count, space;
};

static enum pp_status add_receiver(struct receiver_list *list,
                                   struct pp_receiver receiver, struct pp_error *err)
{
    enum pp_status status = pp_array_reserve(&list->items, &list->space,
                                             list->count + 1, sizeof *list->items, err);
    if (status != PP_OK)
        return status;
    list->items[list->count++] = receiver;
    return PP_OK;
}

/* Reports a part whose points would exceed the limit of the room. */
static bool has_too_many(struct pp_resolver *r, const struct receiver_list *list,
                         const struct pp_receiver_part *part, double count)
{
    static const char *const kinds[] = {"point", "line", "grid"};
    double most =
        fmin(RECEIVERS_MOST, comparisons_most / fmax(r->world->surface_count, 1.0));
    if (list->count + count <= most)
        return false;
    int line = part->line ? part->line : r->room->line;
    if (part->kind == PP_GRID)
        pp_mistakes_add(r->mistakes, line,
                        "grid: %s of %g m gives %.0f points%s; expected at most %.0f "
                        "points in this room",
                        part->line ? "its spacing" : "the default spacing",
                        part->spacing_m, count,
                        list->count ? ", in addition to other points" : "", most);
    else
        pp_mistakes_add(
            r->mistakes, line,
            "%s: with these, the room has %.0f points; expected at most %.0f",
            kinds[part->kind], list->count + count, most);
    return true;
}

/* Reports the points of a part that are not at valid positions, in one message. */
static void check_places(struct pp_resolver *r, const char *what, int line,
                         const struct pp_receiver *receivers, int count)
{
    int bad = 0;
    const char *first_fault = NULL;
    struct pp_vec3 first = {0};
    for (int i = 0; i < count && r->watertight; i++) {
        const char *fault = pp_position_receiver_fault(r->world, receivers[i].position,
                                                       receivers[i].normal);
        if (fault && bad++ == 0) {
            first_fault = fault;
            first = receivers[i].position;
        }
    }
    if (bad > 0 && count == 1)
        pp_mistakes_add(r->mistakes, line,
                        "%s: (%g, %g, %g) %s; expected a point in the free space of "
                        "the room",
                        what, first.x, first.y, first.z, first_fault);
    else if (bad > 0)
        pp_mistakes_add(r->mistakes, line,
                        "%s: %d of its %d points cannot be used; the first, (%g, %g, "
                        "%g), %s; expected all points in the free space of the room",
                        what, bad, count, first.x, first.y, first.z, first_fault);
}

static enum pp_status resolve_point(struct pp_resolver *r, struct receiver_list *list,
                                    const struct pp_receiver_part *part,
                                    struct pp_error *err)
{
    double length = pp_vec_length(part->normal);
    if (!isfinite(part->x) || !isfinite(part->y) || !isfinite(length))
        return PP_OK;
    if (!(length > 0.0)) {
        pp_mistakes_add(r->mistakes, part->line,
                        "point: its normal is 0 0 0; expected a direction");
        return PP_OK;
    }
    if (has_too_many(r, list, part, 1.0))
        return PP_OK;
    double z = isnan(part->z) ? r->room->working_plane_m : part->z;
    struct pp_receiver receiver = {.position = pp_vec(part->x, part->y, z),
                                   .normal = pp_vec_scale(part->normal, 1.0 / length),
                                   .line = part->line};
    check_places(r, "point", part->line, &receiver, 1);
    return add_receiver(list, receiver, err);
}

static enum pp_status resolve_line(struct pp_resolver *r, struct receiver_list *list,
                                   const struct pp_receiver_part *part,
                                   struct pp_error *err)
{
    double dx = part->to[0] - part->from[0], dy = part->to[1] - part->from[1];
    if (!isfinite(dx) || !isfinite(dy) || part->points < 1)
        return PP_OK;
    if (part->points > 1 && hypot(dx, dy) < PP_SAME_M) {
        pp_mistakes_add(r->mistakes, part->line,
                        "line: its ends are %g m apart; expected 1 mm or more",
                        hypot(dx, dy));
        return PP_OK;
    }
    if (has_too_many(r, list, part, part->points))
        return PP_OK;
    int first = list->count;
    for (int i = 0; i < part->points; i++) {
        double t = part->points > 1 ? (double)i / (part->points - 1) : 0.0;
        bool last = i > 0 && i == part->points - 1;
        struct pp_receiver receiver = {
            .position = pp_vec(last ? part->to[0] : part->from[0] + t * dx,
                               last ? part->to[1] : part->from[1] + t * dy,
                               r->room->working_plane_m),
            .normal = pp_vec(0.0, 0.0, 1.0),
            .line = part->line};
        if (add_receiver(list, receiver, err) != PP_OK)
            return PP_SYSTEM;
    }
    check_places(r, "line", part->line, list->items + first, list->count - first);
    return PP_OK;
}

/* Counts cells in both directions. Returns their product; 0 if the margin leaves
 * none. */
static double count_cells(const double low[2], const double high[2],
                          const struct pp_receiver_part *grid, double cells[2])
{
    for (int k = 0; k < 2; k++) {
        double extent = high[k] - low[k] - 2.0 * grid->margin_m;
        if (extent < -PP_ROUNDING_M)
            return 0.0;
        /* An extent of 3.0000000001 spacings has three cells. */
        cells[k] = fmax(ceil(extent / grid->spacing_m - 1e-6), 1.0);
    }
    return cells[0] * cells[1];
}

/* Adds the points at the centres of cells. is_point, areas: room for every cell. */
static enum pp_status add_centres(struct pp_resolver *r, struct receiver_list *list,
                                  const struct pp_cell_grid *grid,
                                  const struct pp_position_surfaces *surfaces, int line,
                                  bool *is_point, double *areas, struct pp_error *err)
{
    const struct pp_world *world = r->world;
    const struct pp_region *plane = &world->plane;
    int first = list->count;
    enum pp_status status = PP_OK;
    for (int cell = 0; cell < grid->columns * grid->rows && status == PP_OK; cell++) {
        double x = grid->low[0] + (cell % grid->columns + 0.5) * grid->step[0];
        double y = grid->low[1] + (cell / grid->columns + 0.5) * grid->step[1];
        struct pp_receiver receiver = {.position = pp_vec(x, y, world->working_plane_m),
                                       .normal = pp_vec(0.0, 0.0, 1.0),
                                       .line = line};
        is_point[cell] =
            pp_region_contains(plane, x, y)
            && pp_region_edge_distance(plane, x, y) >= grid->margin - PP_ROUNDING_M
            && !pp_position_fault_among(world, surfaces, receiver.position,
                                        receiver.normal);
        if (is_point[cell])
            status = add_receiver(list, receiver, err);
    }
    if (status != PP_OK)
        return status;
    pp_cell_areas_find(areas, is_point, plane, grid);
    for (int cell = 0; cell < grid->columns * grid->rows; cell++)
        if (is_point[cell])
            list->items[first++].area_m2 = areas[cell];
    return PP_OK;
}

static enum pp_status add_grid(struct pp_resolver *r, struct receiver_list *list,
                               const double low[2], const double high[2],
                               const double cells[2], double margin_m, int line,
                               struct pp_error *err)
{
    const struct pp_world *world = r->world;
    const struct pp_bounds3 plane = {pp_vec(low[0], low[1], world->working_plane_m),
                                     pp_vec(high[0], high[1], world->working_plane_m)};
    struct pp_position_surfaces surfaces;
    struct pp_cell_grid grid = {
        .columns = (int)cells[0], .rows = (int)cells[1], .margin = margin_m};
    for (int k = 0; k < 2; k++) {
        grid.low[k] = low[k] + margin_m;
        grid.step[k] = fmax(high[k] - low[k] - 2.0 * margin_m, 0.0) / cells[k];
    }
    size_t count = (size_t)grid.columns * (size_t)grid.rows;
    bool *is_point = calloc(count, sizeof *is_point);
    double *areas = calloc(count, sizeof *areas);
    enum pp_status status =
        is_point && areas ? pp_position_find_surfaces(&surfaces, world, &plane, err)
                          : pp_fail_memory(err);
    if (status == PP_OK) {
        status = add_centres(r, list, &grid, &surfaces, line, is_point, areas, err);
        free(surfaces.list);
    }
    free(areas);
    free(is_point);
    return status;
}

static enum pp_status resolve_grid(struct pp_resolver *r, struct receiver_list *list,
                                   const struct pp_receiver_part *part,
                                   struct pp_error *err)
{
    const struct pp_region *plane = &r->world->plane;
    if (plane->count == 0 || !isfinite(part->spacing_m) || !isfinite(part->margin_m))
        return PP_OK;
    struct pp_bounds2 bounds = pp_region_bounds(plane);
    const double *low = bounds.low, *high = bounds.high;
    double cells[2];
    int first = list->count;
    double count = count_cells(low, high, part, cells);
    if (has_too_many(r, list, part, count))
        return PP_OK;
    if (count > 0.0
        && add_grid(r, list, low, high, cells, part->margin_m, part->line, err)
               != PP_OK)
        return PP_SYSTEM;
    if (list->count == first && part->line > 0)
        pp_mistakes_add(
            r->mistakes, part->line,
            "grid: no point is clear of fittings and %g m or more from the walls; "
            "expected a smaller margin or spacing in a plan of %g m by %g m",
            part->margin_m, high[0] - low[0], high[1] - low[1]);
    return PP_OK;
}

/* Adds one receiver in a room that is too small for the default grid: the point of a
 * fine mesh that is farthest from the edges of the plane. */
static enum pp_status add_inmost(struct pp_resolver *r, struct receiver_list *list,
                                 struct pp_error *err)
{
    enum { MESH = 33 }; /* odd, so that it includes the centre */
    const struct pp_world *world = r->world;
    struct pp_bounds2 bounds = pp_region_bounds(&world->plane);
    const double *low = bounds.low, *high = bounds.high;
    double farthest = 0.0;
    struct pp_receiver best = {.normal = pp_vec(0.0, 0.0, 1.0)};
    for (int k = 0; k < MESH * MESH; k++) {
        /* Begins at the centre, which is preferred among equally distant points. */
        int i = (k % MESH + MESH / 2) % MESH, j = (k / MESH + MESH / 2) % MESH;
        double x = low[0] + (i + 0.5) / MESH * (high[0] - low[0]);
        double y = low[1] + (j + 0.5) / MESH * (high[1] - low[1]);
        struct pp_vec3 place = pp_vec(x, y, world->working_plane_m);
        double distance = pp_region_edge_distance(&world->plane, x, y);
        if (distance > farthest * (1.0 + 1e-9)
            && pp_region_contains(&world->plane, x, y)
            && !pp_position_receiver_fault(world, place, best.normal)) {
            farthest = distance;
            best.position = place;
        }
    }
    return farthest > 0.0 ? add_receiver(list, best, err) : PP_OK;
}

static enum pp_status resolve_default(struct pp_resolver *r, struct receiver_list *list,
                                      struct pp_error *err)
{
    struct pp_receiver_part grid = {
        .kind = PP_GRID, .spacing_m = default_spacing_m, .margin_m = default_spacing_m};
    if (resolve_grid(r, list, &grid, err) != PP_OK)
        return PP_SYSTEM;
    if (list->count > 0 || r->world->plane.count == 0)
        return PP_OK;
    if (add_inmost(r, list, err) != PP_OK)
        return PP_SYSTEM;
    if (list->count == 0)
        pp_mistakes_add(r->mistakes, r->room->line,
                        "room: the fittings leave no space for points on the working "
                        "plane; expected <point> elements elsewhere, or a different "
                        "working-plane");
    return PP_OK;
}

/* Several grids would count the area of the plane several times: each grid represents
 * an equal part of the plane instead. */
static void divide_plane(const struct receiver_list *list, int grids)
{
    for (int i = 0; i < list->count && grids > 1; i++)
        list->items[i].area_m2 /= grids;
}

enum pp_status pp_build_receivers(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    struct receiver_list list = {0};
    enum pp_status status = PP_OK;
    int grids = 0;
    for (int i = 0; i < room->receiver_count && status == PP_OK; i++) {
        const struct pp_receiver_part *part = &room->receivers[i];
        grids += part->kind == PP_GRID;
        status = part->kind == PP_POINT  ? resolve_point(r, &list, part, err)
                 : part->kind == PP_LINE ? resolve_line(r, &list, part, err)
                                         : resolve_grid(r, &list, part, err);
    }
    if (status == PP_OK && room->receiver_count == 0)
        status = resolve_default(r, &list, err);
    divide_plane(&list, grids);
    r->world->receivers = list.items;
    r->world->receiver_count = list.count;
    return status;
}
