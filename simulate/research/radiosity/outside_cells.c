/* outside_cells.c - see outside_cells.h. */
#include "simulate/research/radiosity/outside_cells.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/frame.h"

/* Golden ratio: the fractional parts of its multiples are evenly spread. */
static const double GOLDEN = 0.61803398874989485;

enum { MOST_LEVEL = 40 }; /* wider than the earth */

void pp_outside_cells_clear(struct pp_outside_cells *cells)
{
    for (int i = 0; i < cells->count; i++)
        pp_light_sum_clear(&cells->list[i].taken);
    free(cells->list);
    free(cells->slots);
    *cells = (struct pp_outside_cells){0};
}

/* ---- which cell ---- */

static struct pp_outside_cell cell_at(const struct pp_outside_cells *cells,
                                      const struct pp_light_room *room,
                                      const struct pp_outside_hit *hit)
{
    struct pp_vec3 middle = pp_bounds3_middle(&room->facets->room);
    double away = pp_vec_length(pp_vec_sub(hit->point, middle));
    struct pp_outside_cell cell = {.side = hit->side, .place_count = 0};
    double x = hit->point.x, y = hit->point.y;
    while (cell.level < MOST_LEVEL && away > ldexp(cells->size_m, cell.level + 1))
        cell.level++;
    double width = ldexp(cells->width * cells->size_m, cell.level);
    if (hit->side >= 0) {
        const struct pp_facet *facet = &room->facets->list[hit->side / 2];
        struct pp_vec3 from = pp_vec_sub(hit->point, facet->origin);
        x = pp_vec_dot(from, facet->a);
        y = pp_vec_dot(from, facet->b);
        cell.reflectance = facet->side[hit->side % 2].reflectance;
        cell.exitance = facet->side[hit->side % 2].exitance;
    } else {
        cell.reflectance = room->outdoors->light.ground_reflectance;
    }
    cell.column = (long long)floor(x / width);
    cell.row = (long long)floor(y / width);
    return cell;
}

static bool same_cell(const struct pp_outside_cell *a, const struct pp_outside_cell *b)
{
    return a->side == b->side && a->level == b->level && a->column == b->column
           && a->row == b->row;
}

static uint64_t mixed(uint64_t h, uint64_t more)
{
    h = (h ^ more) * UINT64_C(0x9e3779b97f4a7c15);
    return h ^ (h >> 29);
}

/* The slot of the cell in the hash table, or the empty slot where it belongs. */
static int outside_cell_slot(const struct pp_outside_cells *cells,
                             const struct pp_outside_cell *cell)
{
    uint64_t h =
        mixed(mixed(mixed(mixed(1, (uint64_t)cell->side), (uint64_t)cell->level),
                    (uint64_t)cell->column),
              (uint64_t)cell->row);
    int slot = (int)(h % (uint64_t)cells->slot_count);
    while (cells->slots[slot] >= 0
           && !same_cell(&cells->list[cells->slots[slot]], cell))
        slot = slot + 1 < cells->slot_count ? slot + 1 : 0;
    return slot;
}

/* Enlarges the hash table unless it has more than twice as many slots as cells. */
static enum pp_status widen(struct pp_outside_cells *cells, struct pp_error *err)
{
    if (cells->slot_count > 2 * cells->count + 2)
        return PP_OK;
    int count = 4 * cells->count + 64;
    int *slots = malloc((size_t)count * sizeof *slots);
    if (!slots)
        return pp_fail_memory(err);
    free(cells->slots);
    cells->slots = slots;
    cells->slot_count = count;
    for (int i = 0; i < count; i++)
        slots[i] = -1;
    for (int i = 0; i < cells->count; i++)
        slots[outside_cell_slot(cells, &cells->list[i])] = i;
    return PP_OK;
}

/* Finds the cell of the hit, or adds a new cell; *index: index of the cell. */
static enum pp_status find_outside_cell(struct pp_outside_cells *cells,
                                        const struct pp_light_room *room,
                                        const struct pp_outside_hit *hit, int *index,
                                        struct pp_error *err)
{
    enum pp_status status = widen(cells, err);
    if (status == PP_OK)
        status = pp_array_reserve(&cells->list, &cells->room, cells->count + 1,
                                  sizeof *cells->list, err);
    if (status != PP_OK)
        return status;
    struct pp_outside_cell cell = cell_at(cells, room, hit);
    int slot = outside_cell_slot(cells, &cell);
    if (cells->slots[slot] < 0) {
        cells->list[cells->count] = cell;
        cells->slots[slot] = cells->count++;
    }
    *index = cells->slots[slot];
    struct pp_outside_cell *found = &cells->list[*index];
    if (*index >= cells->gathered && found->place_count < PP_OUTSIDE_CELL_PLACES)
        found->places[found->place_count++] = hit->point;
    return PP_OK;
}

enum pp_status pp_outside_cells_resolve(struct pp_outside_cells *cells,
                                        const struct pp_light_room *room,
                                        struct pp_light_sum *sum, struct pp_error *err)
{
    pp_light_sum_tidy(sum);
    for (int i = 0; i < sum->hit_count; i++) {
        int index;
        enum pp_status status =
            find_outside_cell(cells, room, &sum->hits[i], &index, err);
        if (status != PP_OK)
            return status;
        pp_light_sum_add(sum, -1 - index, sum->hits[i].part, sum->hits[i].weight);
    }
    sum->hit_count = 0;
    return sum->failed ? pp_fail_memory(err) : PP_OK;
}

/* ---- light of cells ---- */

void pp_outside_cells_hemisphere(const struct pp_light_room *room,
                                 const struct pp_light_ray_start *place, int directions,
                                 unsigned turn, double weight, enum pp_component part,
                                 struct pp_light_sum *sum)
{
    struct pp_frame frame = {.z = place->to};
    double off = fmod(turn * GOLDEN * GOLDEN, 1.0);
    pp_polygon_plane_axes(frame.z, &frame.x, &frame.y);
    for (int i = 0; i < directions; i++) {
        double u = (i + 0.5) / directions;
        double azimuth = 2.0 * PP_PI * fmod(i * GOLDEN + off, 1.0);
        struct pp_vec3 own =
            pp_vec(sqrt(u) * cos(azimuth), sqrt(u) * sin(azimuth), sqrt(1.0 - u));
        struct pp_light_ray_start ray = *place;
        ray.to = pp_frame_out(&frame, own);
        pp_light_ray_follow(room, &ray, weight / directions, part, sum);
    }
}

struct cell_work {
    struct pp_outside_cells *cells;
    const struct pp_light_room *room;
};

static bool gather_one(void *data, int worker, int index)
{
    const struct cell_work *g = data;
    struct pp_outside_cell *cell = &g->cells->list[index];
    const struct pp_facet *facets = g->room->facets->list;
    struct pp_vec3 normal = pp_vec(0.0, 0.0, 1.0);
    (void)worker;
    if (cell->side >= 0)
        normal = pp_vec_scale(facets[cell->side / 2].normal, cell->side % 2 ? -1 : 1);
    for (int i = 0; i < cell->place_count; i++) {
        struct pp_light_ray_start place = {cell->places[i], normal,
                                           cell->side < 0 ? -1 : cell->side / 2, false};
        pp_outside_cells_hemisphere(g->room, &place,
                                    g->cells->directions / cell->place_count,
                                    (unsigned)(index * PP_OUTSIDE_CELL_PLACES + i),
                                    1.0 / cell->place_count, PP_ERC, &cell->taken);
    }
    return true;
}

enum pp_status pp_outside_cells_gather(struct pp_outside_cells *cells,
                                       const struct pp_light_room *room,
                                       struct pp_thread_pool *pool,
                                       struct pp_error *err)
{
    enum pp_status status = PP_OK;
    while (status == PP_OK && cells->gathered < cells->count) {
        struct cell_work g = {cells, room};
        int first = cells->gathered, end = cells->count;
        pp_thread_pool_run(pool, first, end, gather_one, &g);
        cells->gathered = end;
        for (int i = first; status == PP_OK && i < end; i++) {
            /* The list may be reallocated as cells are added. */
            struct pp_light_sum taken = cells->list[i].taken;
            cells->list[i].taken = (struct pp_light_sum){.failed = false};
            status = pp_outside_cells_resolve(cells, room, &taken, err);
            cells->list[i].taken = taken;
        }
    }
    return status;
}
