/* estimate.h - from randomisations to a value, its standard error, and how many more.
 *
 * The randomisations of a point are independent and alike, each a sum over a scrambled
 * net. Their mean is the value; the standard error is
 *
 *     s / sqrt(R) sqrt((R - 1)/(R - 3)),
 *
 * s their standard deviation: the root is the spread of Student's t with R - 1 degrees
 * of freedom, so that one and two standard errors hold 69 and 95 % although s is itself
 * estimated. Where all randomisations agree to the last bit, and light could come, the
 * error is an upper bound: the light of one path among all if openings stood free.
 */
#ifndef PP_SIMULATE_TRACER_ESTIMATE_H
#define PP_SIMULATE_TRACER_ESTIMATE_H

#include "model/results/reading.h"
#include "simulate/tracer/randomisation.h"

enum {
    PP_RANDOMISATIONS = 32, /* at least, a point */
    PP_MOST_PATHS = 1 << 24 /* of one estimator in one randomisation */
};

/* The least standard error that is asked for, over Eh: 0.002 % daylight factor. */
extern const double PP_LEAST_ERROR;

/* Each component, roughly and on the safe side, if nothing stood before the openings;
 * 0: no light path exists. */
struct pp_component_bound {
    double part[3];
};

struct pp_component_bound pp_estimate_bound(const struct pp_ray_scene *scene,
                                            const struct pp_start *start);

/* The factor sqrt((R - 1)/(R - 3)) above, of a mean of `count` figures (more than
 * 3). */
double pp_estimate_student_factor(int count);

/* The value and standard error of one component over the begun ones of `count`
 * randomisations; NAN with a reason while there are fewer than four. */
struct pp_reading pp_estimate(const struct pp_randomisation *randomisations, int count,
                              int component, const struct pp_component_bound *most);

/* How to reach a standard error of the daylight factor of `error`, judging by these
 * randomisations (all done to the same counts): the cheapest counts, no less than
 * `least`, and number of randomisations. */
struct pp_plan {
    struct pp_counts counts;
    int randomisations;
};
struct pp_plan pp_estimate_plan(const struct pp_randomisation *randomisations,
                                int count, double error, struct pp_counts least);

#endif
