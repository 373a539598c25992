/* rad_transform.h - Radiance's xform options as one matrix.
 *
 * Options apply from left to right:
 *
 *     -t X Y Z   move          -rx -ry -rz DEG   rotate about an axis
 *     -s F       scale         -mx -my -mz       mirror along an axis
 *     -i N       the options up to the next -i or -a, N times
 *     -a N       N copies, with the options applied 0, 1, ... N - 1 times
 */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_TRANSFORM_H
#define PP_FORMATS_RADIANCE_READ_RAD_TRANSFORM_H

#include <stdbool.h>

#include "model/geometry/vec.h"

/* x -> rows . x + move; only rotation, mirroring and uniform scaling. */
struct pp_rad_transform {
    struct pp_vec3 rows[3], move;
    double scale;  /* scale factor, greater than 0 */
    bool mirrored; /* orientation is reversed */
};

struct pp_rad_transform pp_rad_transform_identity(void);

/* Applies `inner` first, then `outer`. */
struct pp_rad_transform pp_rad_transform_compose(const struct pp_rad_transform *outer,
                                                 const struct pp_rad_transform *inner);

struct pp_vec3 pp_rad_transform_point(const struct pp_rad_transform *transform,
                                      struct pp_vec3 point);
/* Rotates and mirrors a direction; its length does not change. */
struct pp_vec3 pp_rad_transform_direction(const struct pp_rad_transform *transform,
                                          struct pp_vec3 direction);

/* Reads one transform option (not -i, -a) from words[0]. Returns the number of words
 * used, 0 if words[0] is another option, -1 if its numbers are wrong or out of
 * range. */
int pp_rad_transform_read_option(struct pp_rad_transform *transform, char *const *words,
                                 int count);

#endif
