/* picture_format.h - what kind of file a picture becomes: one that keeps its numbers
 * (formats/pictures/number_format.h), or one that shows it, as a chart's. */
#ifndef PP_CLI_RENDER_PICTURE_FORMAT_H
#define PP_CLI_RENDER_PICTURE_FORMAT_H

#include <stdbool.h>
#include <stddef.h>

#include "formats/pictures/number_format.h"
#include "pepperpot.h"

struct pp_picture_format {
    const struct pp_number_format *numbers; /* keeps them so; NULL: it is shown, */
    enum pp_chart_format shown;             /* as this */
};

/* The format that is typed so ("hdr"); false: there is none. */
bool pp_picture_format_named(struct pp_picture_format *format, const char *name);

/* The format that a file's name asks for by its ending, in either case; false: none. */
bool pp_picture_format_of(struct pp_picture_format *format, const char *path);

/* Writes "FILE.hdr, FILE.pfm, FILE.png, FILE.pdf or FILE.svg", where `before` is
 * "FILE.", or of those only that keep numbers, to text, cut to its size. Returns text. */
const char *pp_picture_format_list(char *text, size_t size, const char *before,
                                   bool numbers_only);

#endif
