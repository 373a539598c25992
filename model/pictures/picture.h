/* picture.h - a picture as numbers: linear colours, by rows of pixels. */
#ifndef PP_MODEL_PICTURES_PICTURE_H
#define PP_MODEL_PICTURES_PICTURE_H

#include <stddef.h>

#include "model/base/error.h"
#include "model/light/rgb.h"

/* Limits on each side, and on all pixels (768 MiB). */
enum { PP_PICTURE_SIDE_MOST = 65535 };
#define PP_PICTURE_PIXELS_MOST (1 << 26)

struct pp_picture {
    int width, height; /* pixels */
    float *rgb;        /* three per pixel; rows from the top, pixels from the left */
};

/* Makes a black picture; PP_BAD_INPUT if it is empty or exceeds the limits. */
enum pp_status pp_picture_init(struct pp_picture *picture, int width, int height,
                               struct pp_error *err);
void pp_picture_clear(struct pp_picture *picture);

static inline float *pp_picture_at(const struct pp_picture *picture, int x, int y)
{
    return picture->rgb + 3 * ((size_t)y * (size_t)picture->width + (size_t)x);
}

static inline struct pp_rgb pp_picture_rgb(const struct pp_picture *picture, int x,
                                           int y)
{
    const float *at = pp_picture_at(picture, x, y);
    return pp_rgb(at[0], at[1], at[2]);
}

#endif
