/* raster.c - see raster.h. */
#include "model/pictures/raster.h"

#include <stdlib.h>

enum pp_status pp_raster_init(struct pp_raster *raster, int width, int height,
                              struct pp_error *err)
{
    *raster =
        (struct pp_raster){width, height, calloc((size_t)width * (size_t)height, 3)};
    return raster->rgb ? PP_OK : pp_fail_memory(err);
}

void pp_raster_clear(struct pp_raster *raster)
{
    free(raster->rgb);
    *raster = (struct pp_raster){0};
}

enum pp_status pp_raster_of_tone(struct pp_raster *raster,
                                 const struct pp_picture *picture,
                                 const struct pp_tone *tone, struct pp_error *err)
{
    enum pp_status status =
        pp_raster_init(raster, picture->width, picture->height, err);
    for (int y = 0; status == PP_OK && y < picture->height; y++)
        for (int x = 0; x < picture->width; x++)
            pp_tone_apply(tone, pp_picture_rgb(picture, x, y),
                          pp_raster_at(raster, x, y));
    return status;
}
