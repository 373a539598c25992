/* left_over.h - does more remain than the other program's noise? A test of lack of fit.
 *
 * The left-over r at n points is split into its smooth part, the least squares fit by
 * polynomials of the second order in x, y and z, p of them, and the scatter about it:
 *
 *     noise^2 = |r - smooth|^2 / (n - p)                                          (1)
 *     left^2  = |smooth|^2 / n
 *     limit^2 = 3 p/n noise^2 + common^2                                          (2)
 *
 * Noise of single rays puts as much on each of the p as on each of the n - p, and the two
 * parts are independent: left exceeds limit in 5 % of cases at 18 points, p = 6 (3 is the
 * quantile of F). Mistakes in a room are smooth over it: they are in left, and next to
 * nothing of them is in noise. So the noise is not taken from the misfit that it judges.
 * Noise that is alike at neighbours, as of an interpolated cache, cannot be told from a
 * mistake, and counts as one.
 *
 * Where the noise is known otherwise it takes the place of (1), the whole of r that of its
 * smooth part: limit^2 = noise^2 (1 + 3 sqrt(2/n)) + common^2.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_LEFT_OVER_H
#define PP_STUDIES_RESEARCH_COMPARE_LEFT_OVER_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/vec.h"

struct pp_left_over {
    double noise;       /* standard deviation (logarithm); NAN: too few points for it */
    double left, limit; /* NAN with it */
};

/* known_noise: standard deviation (logarithm) as stated; 0: it is not. */
enum pp_status pp_left_over(struct pp_left_over *over, const double *left,
                            const struct pp_vec3 *places, int count, double known_noise,
                            struct pp_error *err);

/* True if noise explains all that is left; false if the noise is not known. */
bool pp_left_over_is_noise(const struct pp_left_over *over);

/* True if more is left than noise explains; false if the noise is not known. */
bool pp_left_over_exceeds(const struct pp_left_over *over);

#endif
