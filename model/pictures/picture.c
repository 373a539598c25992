/* picture.c - see picture.h. */
#include "model/pictures/picture.h"

#include <stdlib.h>

enum pp_status pp_picture_init(struct pp_picture *picture, int width, int height,
                               struct pp_error *err)
{
    *picture = (struct pp_picture){0};
    if (width < 1 || height < 1 || width > PP_PICTURE_SIDE_MOST
        || height > PP_PICTURE_SIDE_MOST || height > PP_PICTURE_PIXELS_MOST / width)
        return pp_fail(err, PP_BAD_INPUT,
                       "a picture has %d x %d pixels; expected 1 to %d in each "
                       "direction and at most %d million in all",
                       width, height, PP_PICTURE_SIDE_MOST,
                       PP_PICTURE_PIXELS_MOST / 1000000);
    float *rgb = calloc((size_t)width * (size_t)height, 3 * sizeof *rgb);
    if (!rgb)
        return pp_fail_memory(err);
    *picture = (struct pp_picture){width, height, rgb};
    return PP_OK;
}

void pp_picture_clear(struct pp_picture *picture)
{
    free(picture->rgb);
    *picture = (struct pp_picture){0};
}
