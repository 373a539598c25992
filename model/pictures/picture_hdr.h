/* picture_hdr.h - Radiance's picture format [WARD91] with a shared exponent per pixel.
 *
 * Header lines, an empty line, the size, and the pixels: four bytes each, red, green
 * and blue with one exponent, encoded by rows. Colours are accurate to about 1 % of the
 * brightest channel, from 1e-38 to 1e38.
 *
 * Pixels are radiances (W/sr/m2 in three channels; luminance in cd/m2 is 179 times the
 * grey of rgb.h), times the exposure in the header.
 */
#ifndef PP_MODEL_PICTURES_PICTURE_HDR_H
#define PP_MODEL_PICTURES_PICTURE_HDR_H

#include <stdio.h>

#include "model/pictures/picture.h"

enum { PP_HDR_VIEW_SIZE = 512 };

/* Contents of the header apart from the size. */
struct pp_hdr_notes {
    double exposure;             /* factor included in the pixels; 0: 1 */
    char view[PP_HDR_VIEW_SIZE]; /* options after VIEW=, for example "-vtv -vp 1 2
                                  * 3"; empty: none */
    char quantity[16];           /* quantity of the pixels after QUANTITY=, "df"; other
                        * programs ignore it; empty: radiance */
    const char
        *software; /* the program that made it, for pp_picture_hdr_write; NULL: not
                    * stated; not owned */
};

/* Writes the picture, run-length encoded if its width allows. Pixels that are not
 * finite are written as black, negative channels as 0. PP_SYSTEM if the stream has
 * failed. */
enum pp_status pp_picture_hdr_write(FILE *out, const struct pp_picture *picture,
                                    const struct pp_hdr_notes *notes,
                                    struct pp_error *err);

/* Reads a picture from memory, in the old or new encoding. If the header has several
 * exposures they are multiplied; of several views the last one is used. Rows may run
 * upwards, and pixels to the left. PP_BAD_INPUT, with the line or row, for a picture on
 * its side and for truncated or invalid data. Bytes after the last row are ignored. */
enum pp_status pp_picture_hdr_read(struct pp_picture *picture,
                                   struct pp_hdr_notes *notes,
                                   const unsigned char *bytes, size_t length,
                                   struct pp_error *err);

#endif
