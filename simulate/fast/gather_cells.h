/* gather_cells.h - integrates the control variate of path.h over the room's surfaces,
 * by one random point in each of many cells, combined with cosine sampling by the
 * balance heuristic.
 *
 * The contribution of G to a receiver at x is its mean over the cosine lobe, or the
 * integral over the room's surfaces of G(y) k(x, y), with k = cos cos' / (pi r2). Rays
 * of the lobe rarely meet small, distant and bright areas, such as the floor near the
 * window seen from the back of a room. A point in each cell always samples such areas.
 * Near the receiver, however, k is large and varies within a cell. In the sum over the
 * cells, whose terms are k A G with A the area of a cell, G is therefore replaced by
 *
 *     (G - g) / (1 + c k A)                                                         (1)
 *
 * and the rays of the lobe sample the rest of G. This is the balance heuristic [VG95]
 * with c rays per cell. g is the least value of G: a uniform part causes no noise in
 * the lobe. The result is unbiased for all c and g. The points of one randomisation
 * have the same relative position in all cells, mirrored from cell to cell, which
 * cancels linear errors. All receivers use the values of G at these points.
 *
 * Cells are used only in rooms that use shared_density.h, since all points of such a
 * room see each other. Sides of niches have no cells.
 */
#ifndef PP_SIMULATE_FAST_GATHER_CELLS_H
#define PP_SIMULATE_FAST_GATHER_CELLS_H

#include "model/base/error.h"
#include "simulate/fast/control_variate.h"
#include "simulate/transport/radiance_state.h"

struct pp_gather_cells;

/* Makes cells for the convex room of a scene with a known G; both must outlive *cells.
 * On success the caller owns *cells. */
enum pp_status pp_gather_cells_create(struct pp_gather_cells **cells,
                                      const struct pp_light_scene *scene,
                                      const struct pp_control_variate *variate,
                                      struct pp_error *err);
void pp_gather_cells_destroy(struct pp_gather_cells *cells); /* NULL is allowed */

/* Number of doubles in an array of cell points. */
size_t pp_gather_cells_size(const struct pp_gather_cells *cells);

/* Draws the cell points of one randomisation from two numbers in (0, 1), with G - g
 * over Eh at each point; 0 in an opening and outside the outline. `light` traces rays.
 * net: receives pp_gather_cells_size() numbers. */
void pp_gather_cells_draw(const struct pp_gather_cells *cells,
                          struct pp_radiance_state *light, const double u[2],
                          double *net);

/* True if the part has cells. From any point of such a part, all cells are visible. */
bool pp_gather_cells_are_on(const struct pp_gather_cells *cells, int part);

/* Sum over cell points of (1) times k A, divided by Eh, at a point in the room with
 * normal `normal`. */
double pp_gather_cells_taken(const struct pp_gather_cells *cells, const double *net,
                             struct pp_vec3 point, struct pp_vec3 normal);

/* The part of a value G (`guess`, over Eh) that the cells do not cover, for a ray of
 * the lobe that reaches the point directly. If the surface has no cells, the result is
 * `guess`. */
double pp_gather_cells_left(const struct pp_gather_cells *cells,
                            const struct pp_light_ray *ray,
                            const struct pp_light_hit *met, double guess);

#endif
