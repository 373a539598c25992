/* sky_picture.h - a photographed sky: its luminance by direction, from one picture or
 * from two that look in opposite directions.
 *
 * Pixels are samples at their centres. Between centres luminance is bilinear. At the
 * rim of a fisheye's circle, where not all four neighbours are within it, those within
 * count, and luminance goes on linearly in the angle (in its cosine, of a hemispherical
 * picture), by half at most. At the horizon those on the other side of it do not
 * count. Where two pictures overlap they are blended.
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

/* One picture and how it lies. */
struct pp_sky_frame {
    int width, height; /* pixels */
    float *luminance;  /* cd/m2; rows from the top, pixels from the left */
    float *rgb; /* three a pixel, of any scale: colour alone counts; NULL: grey */
    enum pp_sky_projection projection;
    double half_angle_rad;
    double centre[2]; /* of the circle, in pixels from the left and from the top */
    double radius[2]; /* in pixels, across and down; a circle has equal ones */
    struct pp_vec3 right, up, toward; /* the picture's axes; unit */
};

/* The table of mean luminances: rows of equal altitudes from the horizon up, columns of
 * equal bearings clockwise from north. */
enum { PP_SKY_PICTURE_ROWS = 256, PP_SKY_PICTURE_COLUMNS = 1024 };

/* Fill frames, frame_count, horizon_rad and fill_cd_m2; pp_sky_picture_settle does the
 * rest. */
struct pp_sky_picture {
    struct pp_sky_frame frames[2]; /* their pixels are the picture's own */
    int frame_count;
    double horizon_rad; /* altitude below which the picture is not read */
    double fill_cd_m2;  /* luminance there and outside the pictures; NAN: the nearest
                         * that is read: at the same bearing, or on the rim */

    char *title;          /* the file's name */
    double horizontal_lx; /* illuminance of a horizontal plane, unobstructed */
    double filled;        /* share of it that is from filled directions */
    double peak_cd_m2;    /* the brightest pixel */
    int saturated;   /* pixels that share it, where it is so bright that it may be a sun
                    * that the camera has cut off; else 0 */
    uint64_t hash;   /* depends on all above */
    float *cells;    /* [PP_SKY_PICTURE_ROWS][PP_SKY_PICTURE_COLUMNS], cd/m2 */
    double step_rad; /* angle of a pixel, the smallest of the pictures */
    int holders;     /* see pp_sky_picture_release */
};

/* Works out all but frames, horizon and fill. With a measured horizontal illuminance
 * (lx; NAN: none) pixels are scaled to give it. PP_BAD_INPUT if a pixel is negative or
 * no finite number, or the sky gives no light. */
enum pp_status pp_sky_picture_settle(struct pp_sky_picture *picture, double measured_lx,
                                     struct pp_error *err);

/* Ends one use; the last one frees the picture. NULL is allowed. A picture starts with
 * one holder, and is only read after it is settled. */
void pp_sky_picture_release(struct pp_sky_picture *picture);

/* Luminance (cd/m2) in direction u (unit). *filled (may be NULL): not from the
 * pictures. */
double pp_sky_picture_luminance(const struct pp_sky_picture *picture, struct pp_vec3 u,
                                bool *filled);

/* Colour in direction u, of luminance 1 (rgb.h). */
struct pp_rgb pp_sky_picture_colour(const struct pp_sky_picture *picture,
                                    struct pp_vec3 u);

/* Illuminance (lx) of an unobstructed plane with normal n (unit) by the sky above the
 * horizon, from the table of cells; within 1e-4. */
double pp_sky_picture_on_plane(const struct pp_sky_picture *picture, struct pp_vec3 n);

#endif
