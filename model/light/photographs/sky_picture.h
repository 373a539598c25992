/* sky_picture.h - a photographed sky: luminance by direction, from one picture or from
 * two that look in opposite directions.
 *
 * Pixels are samples at their centres, with bilinear interpolation between them. At the
 * rim of a fisheye's circle only pixels within the circle count. Luminance is
 * extrapolated there in the angle (for a hemispherical picture, in the cosine of the
 * angle); extrapolation changes it by at most half. At the horizon, pixels on the other
 * side of the horizon do not count. Overlapping pictures are blended.
 *
 * Directions are x east, y north, z up.
 */
#ifndef PP_MODEL_LIGHT_PHOTOGRAPHS_SKY_PICTURE_H
#define PP_MODEL_LIGHT_PHOTOGRAPHS_SKY_PICTURE_H

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
enum { PP_SKY_PICTURE_ROWS = 256, PP_SKY_PICTURE_COLUMNS = 1024 };

/* A photographed sky. The caller sets frames, frame_count, horizon_rad and fill_cd_m2;
 * pp_sky_picture_settle sets all other members. */
struct pp_sky_picture {
    struct pp_sky_frame frames[2]; /* the picture owns their pixels */
    int frame_count;
    double horizon_rad; /* altitude below which pixels are ignored */
    double fill_cd_m2; /* luminance below the horizon and outside the pictures; NAN: the
                         * nearest valid luminance, at the same bearing or on the rim */

    char *title;          /* file name */
    double horizontal_lx; /* unobstructed horizontal illuminance */
    double filled;        /* fraction of horizontal_lx from filled directions */
    double peak_cd_m2;    /* luminance of the brightest pixel */
    int saturated;   /* number of pixels with peak_cd_m2, if they may be a sun beyond
                      * the camera's range; else 0 */
    uint64_t hash;   /* hash of all members above */
    float *cells;    /* [PP_SKY_PICTURE_ROWS][PP_SKY_PICTURE_COLUMNS], cd/m2 */
    double step_rad; /* smallest angle of a pixel */
    int holders;     /* see pp_sky_picture_release */
};

/* Calculates all members but frames, horizon and fill. measured_lx: horizontal
 * illuminance (lx; NAN: none) to which pixels are scaled. PP_BAD_INPUT if a pixel is
 * negative or not finite, or the sky gives no light. */
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

#endif
