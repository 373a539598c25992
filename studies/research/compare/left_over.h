/* left_over.h - tests whether more remains than the other program's noise (lack of
 * fit).
 *
 * The remainder r at n points is split into its smooth part, the least squares fit by p
 * polynomials of the second order in x, y and z, and the scatter about it:
 *
 *     noise^2 =
 * r - smooth
 * ^2 / (n - p)                                          (1)
 *     left^2  =
 * smooth
 * ^2 / n
 *     limit^2 = 3 p/n noise^2 + common^2                                          (2)
 *
 * Independent noise at each point has equal variance in each of the p and of the n - p
 * components, and the two parts are independent: left exceeds limit in 5 % of cases at
 * 18 points, p = 6 (3 is the quantile of F). Mistakes in a room vary smoothly over it:
 * they are in left, and almost nothing of them is in noise. So the noise is not
 * estimated from the misfit that it judges. Correlated noise at neighbouring points, as
 * of an interpolated cache, cannot be distinguished from a mistake, and counts as one.
 *
 * If the noise is known it replaces (1), and all of r its smooth part: limit^2 =
 * noise^2 (1 + 3 sqrt(2/n)) + common^2.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_LEFT_OVER_H
#define PP_STUDIES_RESEARCH_COMPARE_LEFT_OVER_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/vec.h"

struct pp_left_over {
    double noise;       /* standard deviation (logarithm); NAN: too few points for it */
    double left, limit; /* NAN if noise is */
};

/* known_noise: stated standard deviation (logarithm); 0: not stated. */
enum pp_status pp_left_over(struct pp_left_over *over, const double *left,
                            const struct pp_vec3 *places, int count, double known_noise,
                            struct pp_error *err);

/* True if noise explains all that is left; false if the noise is not known. */
bool pp_left_over_is_noise(const struct pp_left_over *over);

/* True if more is left than noise explains; false if the noise is not known. */
bool pp_left_over_exceeds(const struct pp_left_over *over);

#endif
