/* left_over.h - tests whether a remaining difference is larger than the other program's
 * noise can explain (a lack-of-fit test).
 *
 * The remainder r at n points is split into its smooth part and the scatter about it.
 * The smooth part s is the least squares fit by p polynomials of the second order in x,
 * y and z:
 *
 *     noise^2 = (r - s).(r - s) / (n - p)                                         (1)
 *     left^2  = s.s / n
 *     limit^2 = 3 p/n noise^2 + common^2                                          (2)
 *
 * Independent noise of the points has equal variance in each of the p components of s
 * and in each of the n - p other components. Both parts are independent. With 18 points
 * and p = 6, left exceeds limit by chance in 5 % of cases (3 is the quantile of F). The
 * effect of a mistake varies smoothly over the room. It is contained in left, and
 * hardly changes noise. The noise estimate therefore does not contain the misfit that
 * is tested. Noise that is correlated at neighbouring points, as in an interpolated
 * cache, cannot be distinguished from a mistake, and counts as one.
 *
 * If the noise is known, it replaces (1), and r replaces s:
 *
 *     limit^2 = noise^2 (1 + 3 sqrt(2/n)) + common^2
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_LEFT_OVER_H
#define PP_STUDIES_RESEARCH_COMPARE_LEFT_OVER_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/vec.h"

struct pp_left_over {
    double noise;       /* standard deviation (logarithm); NAN: there are too few points
                         * to estimate it */
    double left, limit; /* both NAN if noise is NAN */
};

/* known_noise: stated standard deviation (logarithm); 0: not stated. */
enum pp_status pp_left_over(struct pp_left_over *over, const double *left,
                            const struct pp_vec3 *places, int count, double known_noise,
                            struct pp_error *err);

/* True if noise explains the remainder; false if the noise is not known. */
bool pp_left_over_is_noise(const struct pp_left_over *over);

/* True if the remainder is larger than noise explains; false if the noise is not
 * known. */
bool pp_left_over_exceeds(const struct pp_left_over *over);

#endif
