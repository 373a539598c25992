/* sky_picture_file.h - reads a photographed sky from picture files: Radiance's (.hdr)
 * and portable float maps (.pfm).
 *
 * Unless given, a fisheye's circle is at the centre of its picture and fills the
 * shorter side. A picture of the zenith with north at the top shows west on its right.
 * A latitude-longitude picture is twice as wide as high; bearings increase to its
 * right.
 *
 * If an option is missing, Radiance's header applies. Pixels are divided by EXPOSURE.
 * VIEW gives the direction, top and angle of angular and hemispherical views; x is east
 * and y north. Luminance is 179 lm/W times the grey of the channels (rgb.h; for sRGB
 * primaries 0.2126 R + 0.7152 G + 0.0722 B).
 */
#ifndef PP_MODEL_PICTURES_SKY_PICTURE_FILE_H
#define PP_MODEL_PICTURES_SKY_PICTURE_FILE_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/photographs/sky_picture.h"

/* Orientation and unit of the pictures. NAN or -1: the value of the file, or else the
 * default in parentheses. */
struct pp_sky_picture_options {
    int projection;           /* (latitude-longitude if twice as wide as high, else
                               * equidistant) */
    double view_angle_rad;    /* angle of the whole circle (pi) */
    double top_bearing_rad;   /* bearing of the top, for a picture that looks up or
                               * down (0) */
    double view_bearing_rad;  /* bearing of the centre, for other pictures (0) */
    double view_altitude_rad; /* altitude of the centre (pi/2, or 0 if the bearing is
                               * given; latitude-longitude: 0) */
    bool mirrored;            /* left and right exchanged, as on a map */
    double circle[3];         /* centre from left and top, radius; pixels */
    double horizon_rad;       /* altitude below which the sky is filled; 0: none */
    double fill_cd_m2;        /* NAN: nearest luminance (sky_picture.h) */
    double illuminance_lx;    /* measured horizontal illuminance; NAN: from the
                               * pixels */
    double exposure;          /* factor on all pixels (1) */
    bool srgb;                /* sRGB primaries; else Radiance's */
    enum pp_sky_sampling sampling;
    int lamps;     /* along an edge of the cube of lamps (16) */
    double sun_lx; /* normal illuminance from a measured sun; 0: none */
    double sun_altitude_rad, sun_bearing_rad; /* NAN: not given */
};

struct pp_sky_picture_options pp_sky_picture_options_none(void);

/* Parses "key=value" pairs, each after a comma. Keys are the attributes of <sky> in a
 * room file: projection, view-angle, top-bearing, view-bearing, view-altitude,
 * mirrored, circle, horizon, fill, illuminance, exposure, primaries, sampling, lamps,
 * sun-illuminance, sun-altitude, sun-bearing, and second, the name of another file. The
 * caller frees *second. */
enum pp_status pp_sky_picture_options_parse(struct pp_sky_picture_options *options,
                                            char **second, const char *pairs,
                                            struct pp_error *err);

/* Sets one option. PP_BAD_INPUT names the key and the expected value. */
enum pp_status pp_sky_picture_options_set(struct pp_sky_picture_options *options,
                                          const char *key, const char *value,
                                          struct pp_error *err);

/* Reads a file, and a second one (NULL: none) with the opposite direction of view and
 * the same options. PP_BAD_INPUT names the file. The caller releases *picture. */
enum pp_status pp_sky_picture_file_read(struct pp_sky_picture **picture,
                                        const char *path, const char *second,
                                        const struct pp_sky_picture_options *options,
                                        struct pp_error *err);

#endif
