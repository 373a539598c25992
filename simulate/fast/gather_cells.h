/* gather_cells.h - the control variate of path.h, integrated by area sampling of cells
 * of the room's surfaces, combined with cosine sampling by the balance heuristic.
 *
 * The contribution of G to a receiver at x is its mean over the cosine lobe, or the
 * integral over the room's surfaces of G(y) k(x, y), k = cos cos' / (pi r2). Rays of
 * the lobe find small, far and bright areas only by chance, such as the floor at the
 * window from the depth of a room. A point in each cell of the surfaces, of area A,
 * always finds them, except near ones, where k is large and varies within the cell. So
 * cells gather
 *
 *     (G - g) / (1 + c k A)                                                            (1)
 *
 * and the rest of G is left to the lobe's rays, by the balance heuristic of [VG95] as
 * if with c rays per cell. g is the least value of G: a uniform part makes no noise in
 * the lobe. The sum has no bias, whatever c and g. In all cells of a net the point has
 * the same relative position, mirrored from cell to cell, which cancels linear errors;
 * the values of G at these points are used by all receivers.
 *
 * Used only in rooms where shared_density.h is used, since all points there are
 * visible. Sides of niches have no cells.
 */
#ifndef PP_SIMULATE_FAST_GATHER_CELLS_H
#define PP_SIMULATE_FAST_GATHER_CELLS_H

#include "model/base/error.h"
#include "simulate/fast/control_variate.h"
#include "simulate/transport/radiance_state.h"

struct pp_gather_cells;

/* Makes cells for the convex room of a scene with a known G; both must outlive *cells.
 * On success *cells is the caller's. */
enum pp_status pp_gather_cells_create(struct pp_gather_cells **cells,
                                      const struct pp_light_scene *scene,
                                      const struct pp_control_variate *variate,
                                      struct pp_error *err);
void pp_gather_cells_destroy(struct pp_gather_cells *cells); /* NULL is allowed */

/* Number of doubles in a net of points. */
size_t pp_gather_cells_size(const struct pp_gather_cells *cells);

/* A net for two numbers in (0, 1): points with their G over Eh, which is 0 in an
 * opening and outside the outline. `light` traces rays. net: pp_gather_cells_size()
 * numbers. */
void pp_gather_cells_draw(const struct pp_gather_cells *cells,
                          struct pp_radiance_state *light, const double u[2],
                          double *net);

/* True if the part has cells; all of them are visible from anywhere on it. */
bool pp_gather_cells_are_on(const struct pp_gather_cells *cells, int part);

/* Sum (1) over the cells of a net, over Eh, at a point in the room with normal
 * `normal`. */
double pp_gather_cells_taken(const struct pp_gather_cells *cells, const double *net,
                             struct pp_vec3 point, struct pp_vec3 normal);

/* The part of a value G (over Eh) that (1) leaves to a ray of the lobe that reaches it
 * directly; all of it if the part has no cells. */
double pp_gather_cells_left(const struct pp_gather_cells *cells,
                            const struct pp_light_ray *ray,
                            const struct pp_light_hit *met, double guess);

#endif
