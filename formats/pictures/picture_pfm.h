/* picture_pfm.h - portable float maps: a picture's numbers as they are. */
#ifndef PP_FORMATS_PICTURES_PICTURE_PFM_H
#define PP_FORMATS_PICTURES_PICTURE_PFM_H

#include <stdio.h>

#include "model/pictures/picture.h"

/* Three floats a pixel, least significant byte first, rows from the bottom.
 * PP_SYSTEM where the stream has failed. */
enum pp_status pp_picture_pfm_write(FILE *out, const struct pp_picture *picture,
                                    struct pp_error *err);

#endif
