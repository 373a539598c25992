/* bytes.h - a growing block of bytes, and the changes to SVG files of cairo that
 * canvas.h describes. */
#ifndef PP_CHARTS_SHEET_BYTES_H
#define PP_CHARTS_SHEET_BYTES_H

#include <stdbool.h>
#include <stddef.h>

/* Counts are size_t, since the PNG of a poster may be too large for the int of
 * model/base/array.h. */
struct pp_bytes {
    unsigned char *list;
    size_t count, room;
};

/* Appends bytes. False: out of memory, and nothing was added. */
bool pp_bytes_add(struct pp_bytes *bytes, const void *more, size_t count);
void pp_bytes_clear(struct pp_bytes *bytes);

/* Copies an SVG file made by cairo into *svg, which must be empty. The root gets the
 * size in mm, <title> and <desc>. Ids are renumbered in order of appearance, with a
 * prefix made from the title and the drawing. Returns false if memory is exhausted or
 * there is no <svg> element. */
bool pp_bytes_name_svg(struct pp_bytes *svg, const struct pp_bytes *cairo,
                       double width_mm, double height_mm, const char *title,
                       const char *description);

#endif
