/* outdoor_cells.c - a hash table of cubes. */
#include "simulate/year/outdoor_cells.h"

#include <math.h>

#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_parts.h"

void pp_outdoor_cells_init(struct pp_outdoor_cells *cells,
                           const struct pp_light_scene *scene,
                           struct pp_lit_point *points, int most, uint64_t seed)
{
    *cells = (struct pp_outdoor_cells){.reach_m = fmax(scene->size_m, 1.0),
                                       .most = most,
                                       .points = points,
                                       .dice = seed};
    for (int i = 0; i < PP_OUTDOOR_SLOTS; i++)
        cells->cells[i] = -1;
}

/* Index 0 to 5: the axis nearest to the normal, and its sign. */
static int main_direction(struct pp_vec3 n)
{
    double x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    if (z >= x && z >= y)
        return n.z < 0.0;
    if (x >= y)
        return 2 + (n.x < 0.0);
    return 4 + (n.y < 0.0);
}

/* 0 if the place is less than 2 reach_m from the room's centre; 1 up to 4 reach_m, 2 up
 * to 8, and so on. */
static int level_of(const struct pp_outdoor_cells *cells, const struct pp_lit_point *at)
{
    double far = pp_vec_length(at->point) / cells->reach_m;
    return far > 1.0 ? ilogb(far) : 0;
}

static uint64_t key_of(const struct pp_outdoor_cells *cells,
                       const struct pp_lit_point *at, int level)
{
    double size = ldexp(cells->reach_m / 3.0, level);
    uint64_t key = (uint64_t)(main_direction(at->normal) + 8 * level);
    const double xyz[3] = {at->point.x, at->point.y, at->point.z};
    for (int i = 0; i < 3; i++)
        key = pp_hash(key, (uint64_t)(int64_t)floor(xyz[i] / size + 0.5));
    return key;
}

/* The slot of the key, or the free slot where the key belongs. */
static int slot_of(const struct pp_outdoor_cells *cells, uint64_t key)
{
    int slot = (int)(key % PP_OUTDOOR_SLOTS);
    while (cells->cells[slot] >= 0 && cells->keys[slot] != key)
        slot = (slot + 1) % PP_OUTDOOR_SLOTS;
    return slot;
}

int pp_outdoor_cells_find(struct pp_outdoor_cells *cells, const struct pp_lit_point *at,
                          double weight)
{
    enum { SHARED = 6, FAR_LEVEL = 5 };
    int level = level_of(cells, at);
    uint64_t key = key_of(cells, at, level);
    int slot = slot_of(cells, key), index = cells->cells[slot];
    if (index < 0 && level < FAR_LEVEL && cells->count < cells->most - SHARED) {
        cells->keys[slot] = key;
        index = cells->cells[slot] = cells->count++;
    } else if (index < 0) {
        index = cells->most - SHARED + main_direction(at->normal);
    }
    cells->weights[index] += weight;
    cells->dice = pp_hash(cells->dice, key);
    double u = (double)(cells->dice >> 11) * 0x1p-53;
    if (u * cells->weights[index] < weight)
        cells->points[index] = *at;
    return index;
}
