/* sky_picture.h - a photographed sky: luminance by direction, from one picture or from
 * two that look in opposite directions.
 *
 * Pixels are samples at their centres, with bilinear interpolation between them. At the
 * rim of a fisheye's circle only pixels within the circle count. Luminance is
 * extrapolated there in the distance from the centre (for a hemispherical picture, in
 * the cosine of the angle); extrapolation changes it by at most half. At the horizon,
 * pixels on the other side of the horizon do not count. Overlapping pictures are
 * blended.
 *
 * Directions are x east, y north, z up.
 */
#ifndef PP_MODEL_LIGHT_PHOTOGRAPHS_SKY_PICTURE_H
#define PP_MODEL_LIGHT_PHOTOGRAPHS_SKY_PICTURE_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "model/base/error.h"
#include "model/light/rgb.h"
#include "model/light/photographs/sky_projection.h"

/* One picture and its orientation. */
struct pp_sky_frame {
    int width, height; /* pixels */
    float *luminance;  /* cd/m2; rows from the top, pixels from the left */
    float *rgb; /* three per pixel, arbitrary scale, for the colour only; NULL: grey */
    enum pp_sky_projection projection;
    double half_angle_rad;
    double centre[2]; /* centre of the circle, in pixels from the left and the top */
    double radius[2]; /* in pixels, horizontal and vertical; equal for a circle */
    struct pp_vec3 right, up, toward; /* the picture's axes; unit */
};

/* Table of mean luminances: rows of equal altitude steps from the horizon upwards,
 * columns of equal bearing steps clockwise from north. */
enum {
    PP_SKY_PICTURE_ROWS = 256,
    PP_SKY_PICTURE_COLUMNS = 1024,
    PP_SKY_PICTURE_CELLS = PP_SKY_PICTURE_ROWS * PP_SKY_PICTURE_COLUMNS
};
#define PP_SKY_PICTURE_ROW_RAD (PP_PI / 2.0 / PP_SKY_PICTURE_ROWS)
#define PP_SKY_PICTURE_COLUMN_RAD (2.0 * PP_PI / PP_SKY_PICTURE_COLUMNS)

/* Ways in which simulations find the light of a photograph: its bright parts are
 * sampled directly (sky_bright.h), or a cube of lamps (sky_cube.h), or all light is
 * found by chance. */
enum pp_sky_sampling {
    PP_SKY_SAMPLE_BRIGHT,
    PP_SKY_SAMPLE_LAMPS,
    PP_SKY_SAMPLE_CHANCE
};

/* A photographed sky. The caller sets frames, frame_count, horizon_rad, fill_cd_m2,
 * sampling, lamps, sun_lx, sun and title; pp_sky_picture_settle sets all other
 * members. */
struct pp_sky_picture {
    struct pp_sky_frame frames[2]; /* the picture owns their pixels */
    int frame_count;
    double horizon_rad; /* altitude below which pixels are ignored */
    double fill_cd_m2; /* luminance below the horizon and outside the pictures; NAN: the
                         * nearest valid luminance, at the same bearing or on the rim */
    enum pp_sky_sampling sampling;
    int lamps; /* along an edge of the cube (sky_cube.h); PP_SKY_SAMPLE_LAMPS only */
    double sun_lx; /* normal illuminance from a measured sun, added to the picture; 0:
                    * none */
    struct pp_vec3 sun; /* unit, towards it */

    char *title;          /* file name */
    double horizontal_lx; /* unobstructed horizontal illuminance */
    double filled;        /* fraction of horizontal_lx from filled directions */
    double peak_cd_m2;    /* luminance of the brightest pixel */
    int saturated;   /* number of pixels within 1 % of peak_cd_m2, if they may be a sun
                      * beyond the camera's range; else 0 */
    uint64_t hash;   /* hash of the luminance: frames, horizon and fill */
    float *cells;    /* [PP_SKY_PICTURE_ROWS][PP_SKY_PICTURE_COLUMNS], cd/m2 */
    double step_rad; /* smallest angle of a pixel */
    int holders;     /* see pp_sky_picture_release */
};

/* Calculates the members after `title`. measured_lx: horizontal illuminance (lx; NAN:
 * none), with the measured sun, to which pixels are scaled. PP_BAD_INPUT if a pixel is
 * negative or not finite, the sky gives no light, the sun alone gives measured_lx or
 * more, or the measured sun is not in the picture. */
enum pp_status pp_sky_picture_settle(struct pp_sky_picture *picture, double measured_lx,
                                     struct pp_error *err);

/* Releases one reference; the last one frees the picture. NULL is allowed. A new
 * picture has one reference. A picture must not change after pp_sky_picture_settle. */
void pp_sky_picture_release(struct pp_sky_picture *picture);

/* Luminance (cd/m2) in unit direction u. *filled (may be NULL) is set to true if the
 * direction is below the horizon line or outside the pictures; the luminance is then
 * `fill_cd_m2`, if set. */
double pp_sky_picture_luminance(const struct pp_sky_picture *picture, struct pp_vec3 u,
                                bool *filled);

/* Colour in unit direction u, with luminance 1 (rgb.h). */
struct pp_rgb pp_sky_picture_colour(const struct pp_sky_picture *picture,
                                    struct pp_vec3 u);

/* Illuminance (lx) of an unobstructed plane with unit normal n from the sky above the
 * horizon, from the table of cells; within 1e-4. */
double pp_sky_picture_on_plane(const struct pp_sky_picture *picture, struct pp_vec3 n);

/* Direction (x east, y north, z up) of a position in a frame, in pixels from the left and
 * the top; false outside the picture. */
static inline bool pp_sky_picture_direction(const struct pp_sky_frame *frame, double x,
                                            double y, struct pp_vec3 *to)
{
    double place[2] = {(x - frame->centre[0]) / frame->radius[0],
                       (frame->centre[1] - y) / frame->radius[1]};
    struct pp_vec3 own;
    if (!pp_sky_projection_direction(frame->projection, frame->half_angle_rad, place,
                                     &own))
        return false;
    *to =
        pp_vec_along(pp_vec_along(pp_vec_scale(frame->right, own.x), own.y, frame->up),
                     own.z, frame->toward);
    return true;
}

/* Index of the table's cell in unit direction u, not below the horizon. */
static inline int pp_sky_picture_cell(struct pp_vec3 u)
{
    double bearing = atan2(u.x, u.y);
    int row = (int)(asin(fmax(0.0, fmin(1.0, u.z))) / PP_SKY_PICTURE_ROW_RAD);
    int column = (int)((bearing < 0.0 ? bearing + 2.0 * PP_PI : bearing)
                       / PP_SKY_PICTURE_COLUMN_RAD);
    row = row < PP_SKY_PICTURE_ROWS ? row : PP_SKY_PICTURE_ROWS - 1;
    column = column < PP_SKY_PICTURE_COLUMNS ? column : PP_SKY_PICTURE_COLUMNS - 1;
    return row * PP_SKY_PICTURE_COLUMNS + column;
}

static inline double pp_sky_picture_solid_angle(int cell)
{
    int row = cell / PP_SKY_PICTURE_COLUMNS;
    return PP_SKY_PICTURE_COLUMN_RAD
           * (sin((row + 1) * PP_SKY_PICTURE_ROW_RAD)
              - sin(row * PP_SKY_PICTURE_ROW_RAD));
}

#endif
