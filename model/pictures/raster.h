/* raster.h - a picture as it is shown: three bytes a pixel, sRGB [IEC61966]. */
#ifndef PP_MODEL_PICTURES_RASTER_H
#define PP_MODEL_PICTURES_RASTER_H

#include "model/pictures/picture.h"
#include "model/pictures/tone.h"

/* Limit of both sides: the limit of cairo's images. */
enum { PP_RASTER_SIDE_MOST = 32767 };

struct pp_raster {
    int width, height;  /* pixels */
    unsigned char *rgb; /* three a pixel; rows from the top, pixels from the left */
};

/* A black one, of a picture's size. */
enum pp_status pp_raster_init(struct pp_raster *raster, int width, int height,
                              struct pp_error *err);
void pp_raster_clear(struct pp_raster *raster);

/* The picture as `tone` shows it. */
enum pp_status pp_raster_of_tone(struct pp_raster *raster,
                                 const struct pp_picture *picture,
                                 const struct pp_tone *tone, struct pp_error *err);

static inline unsigned char *pp_raster_at(const struct pp_raster *raster, int x, int y)
{
    return raster->rgb + 3 * ((size_t)y * (size_t)raster->width + (size_t)x);
}

#endif
