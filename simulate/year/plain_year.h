/* plain_year.h - plain implementation of the hours of a point, without patches and
 * cells.
 *
 * A set of light paths is stored as the places where the paths meet sky, ground and
 * sunlit surfaces. For every hour, the sky is evaluated in the direction in which each
 * path leaves, and the sun is tested at each place. The only error is noise. Tests
 * compare this method with year_coefficients.h; it takes much longer.
 */
#ifndef PP_SIMULATE_YEAR_PLAIN_YEAR_H
#define PP_SIMULATE_YEAR_PLAIN_YEAR_H

#include "simulate/year/year_coefficients.h"

struct pp_plain_year;

/* paths: number of paths of a point in each of PP_YEAR_BATCHES randomisations. Other
 * arguments as for pp_year_coefficients_create. */
enum pp_status pp_plain_year_create(struct pp_plain_year **plain,
                                    const struct pp_light_scene *scene,
                                    const struct pp_environment *environment,
                                    const struct pp_receiver *receivers,
                                    const int *group_of_opening, int group_count,
                                    int paths, uint64_t seed, struct pp_error *err);
void pp_plain_year_destroy(struct pp_plain_year *plain); /* NULL is allowed */

/* Fills both parts of a point (lx): all light of sky and ground, including direct
 * light; and sunlight that surfaces reflect or panes scatter. by_patch: the sky's
 * luminance is uniform in each patch, with the value at the patch's centre; the paths
 * are the same. */
enum pp_status pp_plain_year_point(const struct pp_plain_year *plain, int receiver,
                                   const struct pp_light_columns *light, bool by_patch,
                                   struct pp_year_point *point, struct pp_error *err);

#endif
