/* likelihood.h - likelihood of the differences between two programs' values at points,
 * for an assumed cause.
 *
 * The gap at point i is g_i = f(theirs) - f(ours), f(v) = ln(v + c); a supposition
 * predicts e_i with variance s_i^2. The remainder is noise:
 *
 *     g = e + theta 1 + n,  n ~ N(0, S + sigma^2 ((1 - k) I + k C))              (1)
 *     C_ij = exp(-(d_ij/l)^2 / 2)
 *
 * sigma is unknown: its logarithm is uniform from ln 0.003 to ln 0.6. Independent noise
 * has k = 0; the noise of an interpolated cache is correlated at neighbouring points, k
 * = 0.9 with a reach l of 0.6 or 1.8 m. Prior probabilities are 1/2, 1/4 and 1/4. theta
 * is the logarithm of a common factor, normally distributed about 0. Its standard
 * deviation is 0.005, the size of common errors of the two programs. If a common factor
 * is assumed, its standard deviation is 0.1 or 0.7, equally likely. The likelihood is
 * the density of g by (1), integrated over all of these.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_LIKELIHOOD_H
#define PP_STUDIES_RESEARCH_COMPARE_LIKELIHOOD_H

#include "model/base/error.h"
#include "model/geometry/vec.h"

struct pp_likelihood_data {
    int count;                    /* number of points */
    const double *gap;            /* g_i */
    const struct pp_vec3 *places; /* m */
};

struct pp_supposition {
    const double *effect;   /* e_i */
    const double *variance; /* s_i^2 */
    bool has_factor;        /* a common factor is assumed */
};

struct pp_likelihood {
    double log_density;
    double sigma; /* expected value */
    double near;  /* probability that the noise of neighbouring points is correlated, 0
                   * to 1 */
    double theta; /* expected value */
};

/* Log density with white noise only: fast, for a first selection. */
double pp_likelihood_white(const struct pp_likelihood_data *data,
                           const struct pp_supposition *supposed);

/* Likelihood by (1), with all kinds of noise. */
enum pp_status pp_likelihood(struct pp_likelihood *likelihood,
                             const struct pp_likelihood_data *data,
                             const struct pp_supposition *supposed,
                             struct pp_error *err);

#endif
