/* year_cells.c - rows and columns of squares in the plane of each part, divided where other
 * surfaces stand on them. */
#include "simulate/year/year_cells.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/tolerance.h"
#include "model/room/position.h"
#include "simulate/scene/light_scene_parts.h"

/* True if the part is an inside surface, not a pane, whose given side faces the room
 * and is diffuse. */
static bool has_cells(const struct pp_light_scene *scene, int index, int side)
{
    const struct pp_light_part *part = &scene->parts[index];
    return part->window < 0 && index < scene->world->surface_count && part->matt[side]
           && part->space[side] == PP_INDOORS && (side == 0 || !part->envelope);
}

static double extent(const struct pp_light_scene *scene, int index, struct pp_vec3 axis,
                     double *low)
{
    const struct pp_polygon *outline = &scene->world->surfaces[index].outline;
    double high = -INFINITY;
    *low = INFINITY;
    for (int i = 0; i < outline->count; i++) {
        double at = pp_vec_dot(axis, pp_vec_sub(outline->vertices[i], scene->centre));
        *low = fmin(*low, at);
        high = fmax(high, at);
    }
    return high - *low;
}

/* Surfaces that come nearer to a plane than this share of a cell's size divide the cells
 * there. */
static const double NEAR_SHARE = 0.25;

/* An inside surface, with the box around it. */
struct boxed_surface {
    int index;
    struct pp_bounds3 box;
};

/* Surfaces inside the room, and those that may divide the cells of a part. */
struct cutter_list {
    struct boxed_surface *inside;
    int inside_count, inside_capacity;
    struct pp_cell_cutter *cutters;
    int count, capacity;
};

/* Lists the surfaces inside the room, and its doors and dados. */
static enum pp_status list_inside(struct cutter_list *list, struct pp_year_cells *cells,
                                  struct pp_error *err)
{
    const struct pp_world *world = cells->scene->world;
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->surface_count && status == PP_OK; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        if (!surface->inside)
            continue;
        struct boxed_surface own = {i, pp_bounds3_empty()};
        for (int k = 0; k < surface->outline.count; k++)
            pp_bounds3_add(&own.box, surface->outline.vertices[k]);
        status = pp_array_reserve(&list->inside, &list->inside_capacity,
                                  list->inside_count + 1, sizeof *list->inside, err);
        if (status == PP_OK)
            list->inside[list->inside_count++] = own;
        if (status == PP_OK && surface->role == PP_COVER)
            status = pp_array_append(&cells->covers, cells->cover_count,
                                     sizeof *cells->covers, err);
        if (status == PP_OK && surface->role == PP_COVER)
            cells->covers[cells->cover_count++] = i;
    }
    return status;
}

static bool boxes_are_near(const struct pp_bounds3 *a, const struct pp_bounds3 *b,
                           double near_m)
{
    return a->low.x < b->high.x + near_m && b->low.x < a->high.x + near_m
           && a->low.y < b->high.y + near_m && b->low.y < a->high.y + near_m
           && a->low.z < b->high.z + near_m && b->low.z < a->high.z + near_m;
}

static enum pp_status find_cutters(struct cutter_list *list,
                                   const struct pp_year_cells *cells, int part,
                                   struct pp_error *err)
{
    const struct pp_light_scene *scene = cells->scene;
    double near_m = NEAR_SHARE * cells->size_m;
    const struct boxed_surface *own = list->inside;
    while (own->index != part)
        own++;
    list->count = 0;
    for (int i = 0; i < list->inside_count; i++) {
        const struct boxed_surface *other = &list->inside[i];
        if (other == own || !boxes_are_near(&own->box, &other->box, near_m))
            continue;
        enum pp_status status =
            pp_array_reserve(&list->cutters, &list->capacity, list->count + 2,
                             sizeof *list->cutters, err);
        if (status != PP_OK)
            return status;
        for (int side = 0; side < 2; side++)
            if (has_cells(scene, part, side)
                && pp_cell_cuts_cutter_init(&list->cutters[list->count], scene, part,
                                            side, &scene->world->surfaces[other->index],
                                            near_m))
                list->count++;
    }
    return PP_OK;
}

static void divide_square(struct pp_cell_cuts *cuts, struct pp_cell_point low,
                          const double step_m[2], const struct cutter_list *list)
{
    pp_cell_cuts_init(cuts, low, step_m);
    for (int i = 0; i < list->count; i++) {
        const struct pp_cell_cutter *cutter = &list->cutters[i];
        if (cutter->high.a > low.a && cutter->low.a < low.a + step_m[0]
            && cutter->high.b > low.b && cutter->low.b < low.b + step_m[1])
            pp_cell_cuts_by(cuts, cutter);
    }
}

static struct pp_year_cell cell_of_piece(const struct pp_cell_piece *piece, int part,
                                         int square)
{
    struct pp_year_cell cell = {part, square, piece->corners[0], {0.0, 0.0}};
    struct pp_cell_point high = cell.low;
    for (int i = 1; i < piece->count; i++) {
        cell.low.a = fmin(cell.low.a, piece->corners[i].a);
        cell.low.b = fmin(cell.low.b, piece->corners[i].b);
        high.a = fmax(high.a, piece->corners[i].a);
        high.b = fmax(high.b, piece->corners[i].b);
    }
    cell.size = (struct pp_cell_point){high.a - cell.low.a, high.b - cell.low.b};
    return cell;
}

/* Adds the pieces of one square as cells of one side. */
static enum pp_status add_year_square(struct pp_year_cells *cells, int part, int k,
                                      const struct cutter_list *list,
                                      struct pp_error *err)
{
    struct pp_year_part_cells *own = &cells->parts[part];
    struct pp_year_square *square = &own->squares[k];
    struct pp_cell_cuts cuts;
    const struct pp_cell_point low = {own->low[0] + own->step[0] * (k / own->count[1]),
                                      own->low[1] + own->step[1] * (k % own->count[1])};
    divide_square(&cuts, low, own->step, list);
    square->first = own->per_side;
    square->cut_count = cuts.cut_count;
    own->per_side += cuts.piece_count;
    if (cuts.cut_count > 0) {
        square->cuts = malloc((size_t)cuts.cut_count * sizeof *square->cuts);
        if (!square->cuts)
            return pp_fail_memory(err);
        memcpy(square->cuts, cuts.cuts, (size_t)cuts.cut_count * sizeof *square->cuts);
    }
    enum pp_status status =
        pp_array_reserve(&cells->cells, &cells->capacity,
                         cells->count + cuts.piece_count, sizeof *cells->cells, err);
    for (int i = 0; i < cuts.piece_count && status == PP_OK; i++)
        cells->cells[cells->count++] = cell_of_piece(&cuts.pieces[i], part, k);
    return status;
}

/* Lays out the cells of a part; its second side has the same cells as the first. */
static enum pp_status lay_out(struct pp_year_cells *cells, int index,
                              struct cutter_list *list, struct pp_error *err)
{
    const struct pp_light_scene *scene = cells->scene;
    struct pp_year_part_cells *part = &cells->parts[index];
    const struct pp_vec3 axes[2] = {scene->parts[index].a, scene->parts[index].b};
    bool has[2] = {has_cells(scene, index, 0), has_cells(scene, index, 1)};
    if (!has[0] && !has[1])
        return PP_OK;
    for (int k = 0; k < 2; k++) {
        double length = extent(scene, index, axes[k], &part->low[k]);
        part->count[k] = (int)fmax(1.0, ceil(length / cells->size_m));
        part->step[k] = fmax(length / part->count[k], 1e-9);
    }
    int first = cells->count, squares = part->count[0] * part->count[1];
    part->squares = calloc((size_t)squares, sizeof *part->squares);
    enum pp_status status =
        part->squares ? find_cutters(list, cells, index, err) : pp_fail_memory(err);
    for (int k = 0; k < squares && status == PP_OK; k++)
        status = add_year_square(cells, index, k, list, err);
    if (status != PP_OK)
        return status;
    part->first[has[0] ? 0 : 1] = first;
    if (!has[0] || !has[1])
        return PP_OK;
    part->first[1] = cells->count;
    status = pp_array_reserve(&cells->cells, &cells->capacity,
                              cells->count + part->per_side, sizeof *cells->cells, err);
    for (int k = 0; k < part->per_side && status == PP_OK; k++)
        cells->cells[cells->count++] = cells->cells[first + k];
    return status;
}

enum pp_status pp_year_cells_init(struct pp_year_cells *cells,
                                  const struct pp_light_scene *scene, int wanted,
                                  struct pp_error *err)
{
    double area_m2 = 0.0;
    *cells = (struct pp_year_cells){.scene = scene};
    for (int i = 0; i < scene->part_count; i++)
        for (int side = 0; side < 2; side++)
            if (has_cells(scene, i, side))
                area_m2 += scene->parts[i].area_m2;
    cells->size_m = fmax(sqrt(area_m2 / wanted), 0.05);
    cells->parts = calloc((size_t)scene->part_count + 1, sizeof *cells->parts);
    if (!cells->parts)
        return pp_fail_memory(err);
    struct cutter_list list = {0};
    enum pp_status status = list_inside(&list, cells, err);
    for (int i = 0; i < scene->part_count; i++)
        cells->parts[i].first[0] = cells->parts[i].first[1] = -1;
    for (int i = 0; i < scene->part_count && status == PP_OK; i++)
        status = lay_out(cells, i, &list, err);
    free(list.inside);
    free(list.cutters);
    if (status != PP_OK)
        pp_year_cells_clear(cells);
    return status;
}

void pp_year_cells_clear(struct pp_year_cells *cells)
{
    for (int i = 0; cells->parts && i < cells->scene->part_count; i++) {
        const struct pp_year_part_cells *part = &cells->parts[i];
        for (int k = 0; part->squares && k < part->count[0] * part->count[1]; k++)
            free(part->squares[k].cuts);
        free(part->squares);
    }
    free(cells->parts);
    free(cells->cells);
    free(cells->covers);
    cells->parts = NULL;
    cells->cells = NULL;
    cells->covers = NULL;
}

static int index_along(const struct pp_year_part_cells *part, int axis, double at)
{
    int index = (int)floor((at - part->low[axis]) / part->step[axis]);
    return index < 0 ? 0 : index >= part->count[axis] ? part->count[axis] - 1 : index;
}

int pp_year_cells_of(const struct pp_year_cells *cells, const struct pp_light_hit *hit)
{
    if (hit->part < 0)
        return -1;
    const struct pp_year_part_cells *part = &cells->parts[hit->part];
    const struct pp_light_part *plane = &cells->scene->parts[hit->part];
    if (part->first[hit->back] < 0)
        return -1;
    const struct pp_cell_point at = {pp_vec_dot(plane->a, hit->point),
                                     pp_vec_dot(plane->b, hit->point)};
    int i = index_along(part, 0, at.a), j = index_along(part, 1, at.b);
    const struct pp_year_square *square = &part->squares[i * part->count[1] + j];
    return part->first[hit->back] + square->first
           + pp_cell_cuts_piece(square->cuts, square->cut_count, at);
}

/* True if a point is on the surface, neither in an opening nor behind a door or
 * dado. */
static bool is_open_surface(const struct pp_year_cells *cells, int surface,
                            struct pp_vec3 place)
{
    const struct pp_world *world = cells->scene->world;
    if (pp_polygon_side(&world->surfaces[surface].outline, place, 1e-6) != PP_INSIDE)
        return false;
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == surface
            && pp_polygon_side(&world->openings[i].inner, place, 1e-6) != PP_OUTSIDE)
            return false;
    for (int i = 0; i < cells->cover_count; i++) {
        const struct pp_surface *cover = &world->surfaces[cells->covers[i]];
        if (cover->owner == surface
            && pp_polygon_side(&cover->outline, place, 1e-6) == PP_INSIDE)
            return false;
    }
    return true;
}

bool pp_year_cells_point(const struct pp_year_cells *cells, int index, double u,
                         double v, struct pp_lit_point *point)
{
    const struct pp_year_cell *cell = &cells->cells[index];
    const struct pp_year_part_cells *part = &cells->parts[cell->part];
    const struct pp_year_square *square = &part->squares[cell->square];
    const struct pp_light_part *plane = &cells->scene->parts[cell->part];
    int side = part->first[0] >= 0 && index < part->first[0] + part->per_side ? 0 : 1;
    const struct pp_cell_point at = {cell->low.a + cell->size.a * u,
                                     cell->low.b + cell->size.b * v};
    if (part->first[side] + square->first
            + pp_cell_cuts_piece(square->cuts, square->cut_count, at)
        != index)
        return false;
    const struct pp_world *world = cells->scene->world;
    point->point = pp_light_scene_parts_point(plane, at.a, at.b);
    point->normal = side ? pp_vec_scale(plane->normal, -1.0) : plane->normal;
    point->space = PP_INDOORS;
    struct pp_vec3 place = pp_vec_add(point->point, cells->scene->centre);
    return is_open_surface(cells, cell->part, place)
           && !pp_position_in_fitting(
               world, pp_vec_along(place, 2.0 * PP_TOUCH_M, point->normal));
}
