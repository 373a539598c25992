/* year_cells.c - rows and columns of cells in the plane of each part. */
#include "simulate/year/year_cells.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/scene/light_scene_parts.h"

/* True if the part is an inside surface whose given side is diffuse and reflects. */
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

static void lay_out(struct pp_year_cells *cells, int index)
{
    const struct pp_light_scene *scene = cells->scene;
    struct pp_year_part_cells *part = &cells->parts[index];
    const struct pp_vec3 axes[2] = {scene->parts[index].a, scene->parts[index].b};
    for (int k = 0; k < 2; k++) {
        double length = extent(scene, index, axes[k], &part->low[k]);
        part->count[k] = (int)fmax(1.0, ceil(length / cells->size_m));
        part->step[k] = fmax(length / part->count[k], 1e-9);
    }
    for (int side = 0; side < 2; side++) {
        part->first[side] = -1;
        if (!has_cells(scene, index, side))
            continue;
        part->first[side] = cells->count;
        cells->count += part->count[0] * part->count[1];
    }
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
    for (int i = 0; i < scene->part_count; i++)
        if (i < scene->world->surface_count)
            lay_out(cells, i);
        else
            cells->parts[i].first[0] = cells->parts[i].first[1] = -1;
    cells->part_of = calloc((size_t)cells->count + 1, sizeof *cells->part_of);
    if (!cells->part_of) {
        pp_year_cells_clear(cells);
        return pp_fail_memory(err);
    }
    for (int i = 0; i < scene->part_count; i++)
        for (int side = 0; side < 2; side++)
            for (int k = 0; cells->parts[i].first[side] >= 0
                            && k < cells->parts[i].count[0] * cells->parts[i].count[1];
                 k++)
                cells->part_of[cells->parts[i].first[side] + k] = i;
    return PP_OK;
}

void pp_year_cells_clear(struct pp_year_cells *cells)
{
    free(cells->parts);
    free(cells->part_of);
    cells->parts = NULL;
    cells->part_of = NULL;
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
    int i = index_along(part, 0, pp_vec_dot(plane->a, hit->point));
    int j = index_along(part, 1, pp_vec_dot(plane->b, hit->point));
    return part->first[hit->back] + i * part->count[1] + j;
}

static bool is_on_surface(const struct pp_world *world, int surface,
                          struct pp_vec3 place)
{
    if (pp_polygon_side(&world->surfaces[surface].outline, place, 1e-6) != PP_INSIDE)
        return false;
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == surface
            && pp_polygon_side(&world->openings[i].inner, place, 1e-6) != PP_OUTSIDE)
            return false;
    return true;
}

bool pp_year_cells_point(const struct pp_year_cells *cells, int cell, double u,
                         double v, struct pp_lit_point *point)
{
    int index = cells->part_of[cell];
    const struct pp_year_part_cells *part = &cells->parts[index];
    const struct pp_light_part *plane = &cells->scene->parts[index];
    int per_side = part->count[0] * part->count[1];
    int side =
        part->first[0] < 0 || cell >= part->first[0] + per_side || cell < part->first[0]
            ? 1
            : 0;
    int k = cell - part->first[side];
    double a = part->low[0] + part->step[0] * (k / part->count[1] + u);
    double b = part->low[1] + part->step[1] * (k % part->count[1] + v);
    point->point = pp_light_scene_parts_point(plane, a, b);
    point->normal = side ? pp_vec_scale(plane->normal, -1.0) : plane->normal;
    point->space = PP_INDOORS;
    return is_on_surface(cells->scene->world, index,
                         pp_vec_add(point->point, cells->scene->centre));
}
