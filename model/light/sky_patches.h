/* sky_patches.h - the sky divided into 145, 577 or 2305 patches, after Tregenza
 * [TREG87] and Reinhart.
 *
 * Rows are alpha = 90/(7 n + 0.5) degrees high, n = 1, 2, 4. Row r, from the horizon
 * upwards, covers the altitudes r alpha to (r + 1) alpha. Tregenza's rows (n = 1) have
 * 30, 30, 24, 24, 18, 12 and 6 patches; row r has n times as many as Tregenza's row
 * r/n. The first patch of a row is centred on north, the others follow clockwise. The
 * last patch is the cap around the zenith.
 */
#ifndef PP_MODEL_LIGHT_SKY_PATCHES_H
#define PP_MODEL_LIGHT_SKY_PATCHES_H

#include <stdbool.h>

#include "model/geometry/vec.h"

enum { PP_SKY_PATCHES_ROWS_MOST = 29 };

struct pp_sky_patches {
    int count; /* 145, 577 or 2305 */
    int row_count;
    double row_height_rad; /* alpha */
    int first[PP_SKY_PATCHES_ROWS_MOST
              + 1];   /* first patch of each row; the cap is the last */
    double north_rad; /* bearing of the y axis of directions, clockwise from north */
};

/* Returns false for any other number of patches. */
bool pp_sky_patches_init(struct pp_sky_patches *patches, int count, double north_rad);

/* Index of the patch that contains a unit direction above the horizon. */
int pp_sky_patches_of(const struct pp_sky_patches *patches, struct pp_vec3 u);

/* Centre of a patch (unit vector): the middle of its altitudes and azimuths. */
struct pp_vec3 pp_sky_patches_centre(const struct pp_sky_patches *patches, int index);

/* Solid angle of a patch, sr. */
double pp_sky_patches_solid_angle(const struct pp_sky_patches *patches, int index);

#endif
