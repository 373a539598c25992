/* rad_transform.h - how shapes are moved: Radiance's xform options as one matrix.
 *
 * Options come from left to right and apply in that order:
 *
 *     -t X Y Z   move          -rx -ry -rz DEG   turn about an axis
 *     -s F       scale         -mx -my -mz       mirror along an axis
 *     -i N       the options up to the next -i or -a, N times
 *     -a N       the same, making N copies: 0 times, 1 time, ... N - 1 times
 */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_TRANSFORM_H
#define PP_FORMATS_RADIANCE_READ_RAD_TRANSFORM_H

#include <stdbool.h>

#include "model/geometry/vec.h"

/* x -> rows . x + move; turning, mirroring and even scaling only. */
struct pp_rad_transform {
    struct pp_vec3 rows[3], move;
    double scale;  /* greater than 0 */
    bool mirrored; /* left and right are exchanged */
};

struct pp_rad_transform pp_rad_transform_identity(void);

/* First `inner`, then `outer`. */
struct pp_rad_transform pp_rad_transform_compose(const struct pp_rad_transform *outer,
                                                 const struct pp_rad_transform *inner);

struct pp_vec3 pp_rad_transform_point(const struct pp_rad_transform *transform,
                                      struct pp_vec3 point);
/* A direction keeps its length. */
struct pp_vec3 pp_rad_transform_direction(const struct pp_rad_transform *transform,
                                          struct pp_vec3 direction);

/* Reads one option that moves (not -i, -a) from words[0]; returns how many words it
 * takes, 0 where it is no such option, -1 where its numbers are wrong or out of
 * range. */
int pp_rad_transform_read_option(struct pp_rad_transform *transform, char *const *words,
                                 int count);

#endif
