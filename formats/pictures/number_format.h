/* number_format.h - the formats that keep a picture's numbers, in one list.
 *
 * Formats that show a picture (PNG, PDF, SVG) belong to charts/ instead. A new format
 * is a file model/pictures/picture_NAME.c that writes it, and an entry and a line in
 * number_format.c.
 */
#ifndef PP_FORMATS_PICTURES_NUMBER_FORMAT_H
#define PP_FORMATS_PICTURES_NUMBER_FORMAT_H

#include <stdio.h>

#include "model/pictures/picture_hdr.h"
#include "model/base/error.h"
#include "model/pictures/picture.h"

struct pp_number_format {
    const char *ending;       /* of its files, without the point: "hdr" */
    const char *other_ending; /* that its files may have too; NULL: none */
    const char *summary;      /* one line, without a full stop */

    /* Writes the picture; a format that has no place for a note leaves it out (notes
     * NULL: there are none). PP_SYSTEM where the stream has failed. */
    enum pp_status (*write)(FILE *out, const struct pp_picture *picture,
                            const struct pp_hdr_notes *notes, struct pp_error *err);
};

/* Number formats in list order; NULL for the index just past the end, the largest
 * allowed. */
const struct pp_number_format *pp_number_format_at(int index);

/* The format of that ending, in either case ("hdr", "PIC"), or NULL. */
const struct pp_number_format *pp_number_format_find(const char *ending);

extern const struct pp_number_format pp_number_format_hdr;
extern const struct pp_number_format pp_number_format_pfm;

#endif
