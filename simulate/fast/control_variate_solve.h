/* control_variate_solve.h - solves the coarse radiosity of a room. */
#ifndef PP_SIMULATE_FAST_CONTROL_VARIATE_SOLVE_H
#define PP_SIMULATE_FAST_CONTROL_VARIATE_SOLVE_H

#include "model/base/error.h"
#include "simulate/sampling/sobol.h"
#include "simulate/scene/environment.h"
#include "simulate/fast/control_variate.h"

/* Solves the radiosity. On success the caller owns *variate. *variate is NULL if the
 * world has no inside surfaces, or so many that a solution would save no time. */
enum pp_status pp_control_variate_solve(struct pp_control_variate **variate,
                                        const struct pp_light_scene *scene,
                                        const struct pp_environment *environment,
                                        const struct pp_sobol *sobol, uint64_t seed,
                                        int threads, struct pp_error *err);

#endif
