/* outside_cells.h - the places outside whose light enters the room: surfaces, the
 * outside of the room's own walls, and the ground, in cells of uniform radiosity.
 *
 * Cells exist only where a ray has arrived. Each surface is divided into squares that
 * grow with the distance from the room. The light of a square is gathered at the first
 * few places that rays hit within the square, from `directions` directions of the
 * hemisphere. These rays may reach further cells, which are added as well, until no new
 * cell is reached.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_OUTSIDE_CELLS_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_OUTSIDE_CELLS_H

#include "model/base/thread_pool.h"
#include "simulate/research/radiosity/light_ray.h"

enum { PP_OUTSIDE_CELL_PLACES = 4 };

struct pp_outside_cell {
    int side; /* index of a facet's side; -1: the ground */
    int level;
    long long column, row; /* indices of the cell's square, whose width is 2^level times
                            * the least width */
    struct pp_vec3 places[PP_OUTSIDE_CELL_PLACES];
    int place_count;
    double reflectance, exitance;
    double radiosity;
    struct pp_light_sum taken;
};

struct pp_outside_cells {
    struct pp_outside_cell *list;
    int count, room;
    int *slots; /* hash table: indices of cells, -1: empty */
    int slot_count;
    int gathered;   /* index of the first cell that has not gathered light */
    double size_m;  /* extent of the room, above 0 */
    double width;   /* ratio of a square's width to size_m at the distance size_m from
                     * the room's middle */
    int directions; /* number of directions from each cell */
};

void pp_outside_cells_clear(struct pp_outside_cells *cells);

/* Converts the hits of the sum to terms. Adds cells for hits that are in no existing
 * cell. */
enum pp_status pp_outside_cells_resolve(struct pp_outside_cells *cells,
                                        const struct pp_light_room *room,
                                        struct pp_light_sum *sum, struct pp_error *err);

/* Gathers light for all cells that have none yet, including the cells that their rays
 * reach. */
enum pp_status pp_outside_cells_gather(struct pp_outside_cells *cells,
                                       const struct pp_light_room *room,
                                       struct pp_thread_pool *pool,
                                       struct pp_error *err);

/* Gathers light at a place outdoors from `directions` directions; `turn` rotates them
 * relative to the directions at other places. part: as in light_ray.h. */
void pp_outside_cells_hemisphere(const struct pp_light_room *room,
                                 const struct pp_light_ray_start *place, int directions,
                                 unsigned turn, double weight, enum pp_component part,
                                 struct pp_light_sum *sum);

#endif
