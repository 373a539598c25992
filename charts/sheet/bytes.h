/* bytes.h - a growing block of bytes, and the changes to cairo's SVG files that
 * canvas.h promises. */
#ifndef PP_CHARTS_SHEET_BYTES_H
#define PP_CHARTS_SHEET_BYTES_H

#include <stdbool.h>
#include <stddef.h>

/* Counts are size_t, since a poster's PNG may exceed the int of model/base/array.h. */
struct pp_bytes {
    unsigned char *list;
    size_t count, room;
};

/* False: out of memory, and nothing was added. */
bool pp_bytes_add(struct pp_bytes *bytes, const void *more, size_t count);
void pp_bytes_clear(struct pp_bytes *bytes);

/* Copies an SVG file of cairo's into svg (empty at first), with its size in mm at the
 * root, <title> and <desc> first, and ids renumbered in order of appearance with a
 * prefix made from the drawing. False: out of memory. */
bool pp_bytes_name_svg(struct pp_bytes *svg, const struct pp_bytes *cairo,
                       double width_mm, double height_mm, const char *title,
                       const char *description);

#endif
