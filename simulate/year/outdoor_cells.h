/* outdoor_cells.h - cells of outdoor surfaces, made where light paths meet the
 * surfaces.
 *
 * A cell is a cube of space with one of six main directions of the normal; cubes are
 * larger at a greater distance from the room. In tests of the sun, the cell is
 * represented by one of the places that paths met, drawn in proportion to their
 * weights.
 */
#ifndef PP_SIMULATE_YEAR_OUTDOOR_CELLS_H
#define PP_SIMULATE_YEAR_OUTDOOR_CELLS_H

#include <stdint.h>

#include "simulate/path_tracer/path_trace.h"

enum { PP_OUTDOOR_SLOTS = 1024 };

struct pp_outdoor_cells {
    double reach_m; /* half the longest side of the room, at least 1 m; cubes up to
                     * twice this distance are a third of it wide */
    int count, most;
    struct pp_lit_point *points;      /* by cell; not owned */
    double weights[PP_OUTDOOR_SLOTS]; /* by cell */
    uint64_t keys[PP_OUTDOOR_SLOTS];
    int cells[PP_OUTDOOR_SLOTS]; /* by slot; -1: free */
    uint64_t dice;
};

/* points: has space for `most` cells, at most half of PP_OUTDOOR_SLOTS. */
void pp_outdoor_cells_init(struct pp_outdoor_cells *cells,
                           const struct pp_light_scene *scene,
                           struct pp_lit_point *points, int most, uint64_t seed);

/* The cell of a place that a path met with this weight. Places farther than 32 reach_m
 * from the room's centre share the last six cells, one for each main direction; so do
 * new places when all other cells are in use. */
int pp_outdoor_cells_find(struct pp_outdoor_cells *cells, const struct pp_lit_point *at,
                          double weight);

#endif
