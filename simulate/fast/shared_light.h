/* shared_light.h - the points of each randomisation whose light all receivers share.
 *
 * Each point has an unbiased estimate of the control variate's residual (path.h) at the
 * point. The estimate comes from one step along a path. Light of more than one
 * reflection comes from the points of earlier blocks, which are independent of the new
 * point. Those points light the new point as they light a receiver (shared_density.h).
 *
 * A point depends on the room, the light, the seed, the stage, the randomisation and
 * its own number. A receiver's value therefore does not depend on the other receivers.
 * The errors of receivers of one run are correlated.
 */
#ifndef PP_SIMULATE_FAST_SHARED_LIGHT_H
#define PP_SIMULATE_FAST_SHARED_LIGHT_H

#include "model/base/thread_pool.h"
#include "simulate/fast/path.h"
#include "simulate/fast/shared_density.h"

struct pp_shared_lights;

/* Makes the shared light for paths like `path`. The scene, light, control variate,
 * cells and density of that path (path->shared, not NULL) must outlive *lights; so must
 * sobol. On success the caller destroys *lights. */
enum pp_status pp_shared_light_create(struct pp_shared_lights **lights,
                                      const struct pp_path_state *path,
                                      const struct pp_sobol *sobol, uint64_t seed,
                                      struct pp_error *err);
void pp_shared_light_destroy(struct pp_shared_lights *lights); /* NULL is allowed */

/* Extends randomisations `first` to first + count - 1 of a stage to `wanted` points
 * each. Discards points of other stages, and of calls with another `first`. */
enum pp_status pp_shared_light_extend(struct pp_shared_lights *lights, int stage,
                                      int first, int count, const uint32_t *wanted,
                                      struct pp_thread_pool *pool,
                                      struct pp_error *err);

/* The points of one of these randomisations. */
const struct pp_shared_light *pp_shared_light_list(
    const struct pp_shared_lights *lights, int randomisation);

/* The cell points (gather_cells.h) of one of these randomisations; NULL if the path has
 * no cells, or no points were requested. */
const double *pp_shared_light_net(const struct pp_shared_lights *lights,
                                  int randomisation);

/* Rays traced for points so far, and the number of these rays that leaked. */
void pp_shared_light_work(const struct pp_shared_lights *lights, long long *rays,
                          long long *leaks);

#endif
