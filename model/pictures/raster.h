/* raster.h - a displayed picture: three bytes per pixel, sRGB [IEC61966]. */
#ifndef PP_MODEL_PICTURES_RASTER_H
#define PP_MODEL_PICTURES_RASTER_H

#include "model/pictures/picture.h"
#include "model/pictures/tone.h"

/* Limit on width and height, as for images in cairo. */
enum { PP_RASTER_SIDE_MOST = 32767 };

struct pp_raster {
    int width, height;  /* pixels */
    unsigned char *rgb; /* three per pixel; rows from the top, pixels from the left */
};

/* Makes a black raster. */
enum pp_status pp_raster_init(struct pp_raster *raster, int width, int height,
                              struct pp_error *err);
void pp_raster_clear(struct pp_raster *raster);

/* Makes the raster of a picture by the tone mapping `tone`. */
enum pp_status pp_raster_of_tone(struct pp_raster *raster,
                                 const struct pp_picture *picture,
                                 const struct pp_tone *tone, struct pp_error *err);

static inline unsigned char *pp_raster_at(const struct pp_raster *raster, int x, int y)
{
    return raster->rgb + 3 * ((size_t)y * (size_t)raster->width + (size_t)x);
}

#endif
