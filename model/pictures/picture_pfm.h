/* picture_pfm.h - portable float maps: a picture's numbers as they are. */
#ifndef PP_MODEL_PICTURES_PICTURE_PFM_H
#define PP_MODEL_PICTURES_PICTURE_PFM_H

#include <stdio.h>

#include "model/pictures/picture.h"

/* Three floats a pixel, least significant byte first, rows from the bottom.
 * PP_SYSTEM where the stream has failed. */
enum pp_status pp_picture_pfm_write(FILE *out, const struct pp_picture *picture,
                                    struct pp_error *err);

/* Reads a map of one or three channels, of either order of bytes, from memory; one
 * channel becomes three equal ones. Numbers are taken as they are, NaN and infinity
 * too. PP_BAD_INPUT for anything else; bytes after the last row are ignored. */
enum pp_status pp_picture_pfm_read(struct pp_picture *picture,
                                   const unsigned char *bytes, size_t length,
                                   struct pp_error *err);

#endif
