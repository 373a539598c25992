/* picture_format.h - file formats of a picture: numeric formats, which keep its values
 * (formats/pictures/number_format.h), and formats of charts, which display it. */
#ifndef PP_CLI_RENDER_PICTURE_FORMAT_H
#define PP_CLI_RENDER_PICTURE_FORMAT_H

#include <stdbool.h>
#include <stddef.h>

#include "formats/pictures/number_format.h"
#include "pepperpot.h"

struct pp_picture_format {
    const struct pp_number_format *numbers; /* numeric format; NULL: the picture is
                                             * displayed */
    enum pp_chart_format shown;             /* format of the displayed picture */
};

/* Format by its typed name ("hdr"); false: there is none. */
bool pp_picture_format_named(struct pp_picture_format *format, const char *name);

/* Format by the ending of a file's name, in either case; false: none. */
bool pp_picture_format_of(struct pp_picture_format *format, const char *path);

/* Writes "FILE.hdr, FILE.pfm, FILE.png, FILE.pdf or FILE.svg", or the numeric formats
 * only, to text, cut to its size. `before` is "FILE.". Returns text. */
const char *pp_picture_format_list(char *text, size_t size, const char *before,
                                   bool numbers_only);

#endif
