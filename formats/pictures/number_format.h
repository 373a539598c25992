/* number_format.h - the list of formats that store a picture's numbers.
 *
 * Formats that only show a picture (PNG, PDF, SVG) belong to charts/ instead. A new
 * format needs a file model/pictures/picture_NAME.c that writes it, an entry and a line
 * in number_format.c, and a declaration below.
 */
#ifndef PP_FORMATS_PICTURES_NUMBER_FORMAT_H
#define PP_FORMATS_PICTURES_NUMBER_FORMAT_H

#include <stdio.h>

#include "model/pictures/picture_hdr.h"
#include "model/base/error.h"
#include "model/pictures/picture.h"

struct pp_number_format {
    const char *extension;       /* without the dot: "hdr" */
    const char *other_extension; /* alternative extension; NULL: none */
    const char *summary;         /* one line, without a full stop */

    /* Writes the picture. Formats without a place for notes ignore them (notes NULL: no
     * notes). PP_SYSTEM if the stream has failed. */
    enum pp_status (*write)(FILE *out, const struct pp_picture *picture,
                            const struct pp_hdr_notes *notes, struct pp_error *err);
};

/* Number formats in list order; NULL for the first index past the end. */
const struct pp_number_format *pp_number_format_at(int index);

/* The format with that extension, in either case ("hdr", "PIC"); NULL if none. */
const struct pp_number_format *pp_number_format_find(const char *extension);

extern const struct pp_number_format pp_number_format_hdr;
extern const struct pp_number_format pp_number_format_pfm;

#endif
