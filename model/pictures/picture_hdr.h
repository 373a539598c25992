/* picture_hdr.h - Radiance's picture format [WARD91]: a shared exponent a pixel.
 *
 * A header of lines, an empty line, the size, and the pixels: four bytes each, red,
 * green and blue with one exponent, packed row by row. It keeps colours to about 1 % of
 * the brightest channel, from 1e-38 to 1e38.
 *
 * Pixels are radiances (W/sr/m2 in three channels; their luminance is 179 times the
 * grey of rgb.h, in cd/m2), times the exposure that the header gives.
 */
#ifndef PP_MODEL_PICTURES_PICTURE_HDR_H
#define PP_MODEL_PICTURES_PICTURE_HDR_H

#include <stdio.h>

#include "model/pictures/picture.h"

enum { PP_HDR_VIEW_SIZE = 512 };

/* Contents of the header besides the size. */
struct pp_hdr_notes {
    double exposure; /* factor that the radiances have been multiplied by; 0: 1 */
    char view[PP_HDR_VIEW_SIZE]; /* the options behind VIEW=, e.g. "-vtv -vp 1 2 3";
                                  * empty: none */
    char quantity[16]; /* of the pixels, where they are no radiances: "df"; behind
                        * QUANTITY=, which other programs pass over; empty: not said */
    const char
        *software; /* the program that made it, for pp_picture_hdr_write; NULL: not
                           * said; not owned */
};

/* Writes the picture, in run lengths where its width allows. A pixel that is no finite
 * number is written black, a negative channel as 0. PP_SYSTEM where the stream
 * has failed. */
enum pp_status pp_picture_hdr_write(FILE *out, const struct pp_picture *picture,
                                    const struct pp_hdr_notes *notes,
                                    struct pp_error *err);

/* Reads a picture from memory, packed as by old or new programs. Exposures multiply,
 * the last view counts. Rows may run up, and pixels to the left. A picture on its side
 * is PP_BAD_INPUT, as are truncated or invalid data: the message gives the line or row.
 * Bytes after the last row are ignored. */
enum pp_status pp_picture_hdr_read(struct pp_picture *picture,
                                   struct pp_hdr_notes *notes,
                                   const unsigned char *bytes, size_t length,
                                   struct pp_error *err);

#endif
