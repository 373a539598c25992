/* picture_format.h - file formats of pictures: numeric formats
 * (formats/pictures/number_format.h), which store the values, and chart formats, which
 * display them. */
#ifndef PP_CLI_RENDER_PICTURE_FORMAT_H
#define PP_CLI_RENDER_PICTURE_FORMAT_H

#include <stdbool.h>
#include <stddef.h>

#include "formats/pictures/number_format.h"
#include "pepperpot.h"

struct pp_picture_format {
    const struct pp_number_format *numbers; /* numeric format; NULL: the picture is
                                             * displayed in a chart format */
    enum pp_chart_format shown;             /* chart format, if the picture is
                                             * displayed */
};

/* Finds a format by its name, such as "hdr". Returns false if there is none. */
bool pp_picture_format_named(struct pp_picture_format *format, const char *name);

/* Finds a format by the extension of a file name, in upper or lower case. Returns false
 * if there is none. */
bool pp_picture_format_of(struct pp_picture_format *format, const char *path);

/* Writes a list of the formats to `text`, such as "FILE.hdr, FILE.pfm, FILE.png,
 * FILE.pdf or FILE.svg" if `before` is "FILE.". numbers_only: only numeric formats. The
 * text is cut to `size` bytes. Returns `text`. */
const char *pp_picture_format_list(char *text, size_t size, const char *before,
                                   bool numbers_only);

#endif
