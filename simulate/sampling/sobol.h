/* sobol.h - Owen-scrambled Sobol points, drawn vertex by vertex along a path.
 *
 * Each vertex of a path uses six dimensions of the Sobol sequence with the direction
 * numbers of Joe and Kuo [JK08]. Vertices are padded: each has its own shuffle of the
 * order and its own scramble, so that vertices are independent of each other. Scrambles
 * are nested uniform ones [OWEN97] by hashing [LK11], as described by Burley
 * [BURLEY20], with Vegdahl's hash [VEGDAHL21]. An aligned run of 2^k points is a net in
 * the first two dimensions of every vertex. A sum over the points 0, 1, 2, ... may
 * therefore be extended.
 */
#ifndef PP_SIMULATE_SAMPLING_SOBOL_H
#define PP_SIMULATE_SAMPLING_SOBOL_H

#include <stdint.h>

#include "simulate/sampling/lanes.h"

enum {
    PP_SOBOL_DIMENSIONS = 6,
    PP_SOBOL_KEPT = 3, /* the seeds of so many first vertices are stored, since light
                        * paths draw most of their numbers there */
};

/* The sequence itself: the summand for each dimension and each byte of the index (with
 * the bits of both reversed). Shared by all randomisations; 24 kB. */
struct pp_sobol {
    uint32_t table[PP_SOBOL_DIMENSIONS][4][256];
};

/* One randomisation of the sequence. */
struct pp_sobol_sequence {
    const struct pp_sobol *sobol; /* not owned */
    uint64_t seed;
    uint32_t kept[PP_SOBOL_KEPT][PP_INT_LANES]; /* PP_SOBOL_DIMENSIONS + 1 in use */
};

void pp_sobol_init(struct pp_sobol *sobol);

/* sobol must outlive the sequence. */
void pp_sobol_sequence_init(struct pp_sobol_sequence *sequence,
                            const struct pp_sobol *sobol, uint64_t seed);

/* The first `count` (at most PP_SOBOL_DIMENSIONS) coordinates of point `index` at path
 * vertex `vertex`, each in (0, 1). */
void pp_sobol_sequence_draw(const struct pp_sobol_sequence *sequence, uint32_t index,
                            int vertex, int count, double u[]);

/* Draws `count` points from index `first` at once: u[k][i] is coordinate k of point
 * first + i. count: 1, 2, 4, 8 or 16; first: a multiple of count. The part of u after
 * the last point may be overwritten. */
void pp_sobol_sequence_draw_run(const struct pp_sobol_sequence *sequence,
                                uint32_t first, int count, int vertex, int dimensions,
                                double u[][PP_RUN_MOST]);

/* Owen scramble of a number whose bits are reversed (the first binary digit lowest);
 * digit k of the result depends on digits 0 to k only. */
uint32_t pp_sobol_owen_scramble_reversed(uint32_t reversed, uint32_t seed);

#endif
