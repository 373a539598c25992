/* sky_picture_file.h - a photographed sky from picture files: Radiance's (.hdr) and
 * portable float maps (.pfm).
 *
 * A fisheye's circle lies in the middle of its picture and fills the shorter side,
 * unless given. One that looks at the zenith, top to the north, shows the west on its
 * right. A latitude-longitude picture is twice as wide as high; bearings grow to its
 * right.
 *
 * Radiance's header counts where nothing is given: EXPOSURE divides, VIEW gives angular
 * and hemispherical views, their direction, top and angle, with x east and y north.
 * Luminance is 179 lm/W times the grey of the channels (rgb.h; of sRGB primaries
 * 0.2126 R + 0.7152 G + 0.0722 B).
 */
#ifndef PP_MODEL_PICTURES_SKY_PICTURE_FILE_H
#define PP_MODEL_PICTURES_SKY_PICTURE_FILE_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/photographs/sky_picture.h"

/* Position and unit of the pictures. NAN and -1: as the file says, or else the
 * value in brackets. */
struct pp_sky_picture_options {
    int projection;           /* (latitude-longitude if twice as wide as high, else
                               * equidistant) */
    double view_angle_rad;    /* of the whole circle (pi) */
    double top_bearing_rad;   /* of the top of a picture that looks up or down (0) */
    double view_bearing_rad;  /* of the middle of any other (0) */
    double view_altitude_rad; /* of the middle (pi/2; latitude-longitude 0) */
    bool mirrored;            /* left for right, as a map has it */
    double circle[3];         /* middle from left and top, radius; pixels */
    double horizon_rad;       /* 0: down to the horizon */
    double fill_cd_m2;        /* NAN: the nearest (sky_picture.h) */
    double illuminance_lx;    /* measured horizontal; NAN: as the pixels say */
    double exposure;          /* factor on all pixels, 1 */
    bool srgb;                /* primaries of the channels; else Radiance's */
};

struct pp_sky_picture_options pp_sky_picture_options_none(void);

/* "key=value" pairs behind commas; keys are the attributes of <sky> in a room file:
 * projection, view-angle, top-bearing, view-bearing, view-altitude, mirrored, circle,
 * horizon, fill, illuminance, exposure, primaries; and second, another file. *second is
 * the caller's to free. */
enum pp_status pp_sky_picture_options_parse(struct pp_sky_picture_options *options,
                                            char **second, const char *pairs,
                                            struct pp_error *err);

/* Sets one of them. PP_BAD_INPUT names the key and what was expected. */
enum pp_status pp_sky_picture_options_set(struct pp_sky_picture_options *options,
                                          const char *key, const char *value,
                                          struct pp_error *err);

/* Reads a file, and a second one (NULL: none) that looks the other way and lies
 * likewise. PP_BAD_INPUT names the file. *picture is the caller's to release. */
enum pp_status pp_sky_picture_file_read(struct pp_sky_picture **picture,
                                        const char *path, const char *second,
                                        const struct pp_sky_picture_options *options,
                                        struct pp_error *err);

#endif
