/* picture_pfm.h - portable float maps: a picture's numbers without loss. */
#ifndef PP_MODEL_PICTURES_PICTURE_PFM_H
#define PP_MODEL_PICTURES_PICTURE_PFM_H

#include <stdio.h>

#include "model/pictures/picture.h"

/* Writes three floats per pixel, little-endian, rows from the bottom. PP_SYSTEM if the
 * stream has failed. */
enum pp_status pp_picture_pfm_write(FILE *out, const struct pp_picture *picture,
                                    struct pp_error *err);

/* Reads a map of one or three channels, of either byte order, from memory. A single
 * channel becomes three equal channels. NaN and infinity are kept. PP_BAD_INPUT for
 * other data; bytes after the last row are ignored. */
enum pp_status pp_picture_pfm_read(struct pp_picture *picture,
                                   const unsigned char *bytes, size_t length,
                                   struct pp_error *err);

#endif
