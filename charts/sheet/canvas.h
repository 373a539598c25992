/* canvas.h - a sheet of paper to draw on, at true scale, as PDF, SVG or PNG.
 *
 * One unit of the cairo context is one millimetre on paper; y runs down from the upper
 * left corner. Equal drawings give equal bytes: PDF dates are fixed, SVG ids are
 * numbered in order, text is laid out unhinted.
 *
 *   PDF  text remains text; title, subject and creator are set
 *   SVG  has <title> and <desc>, its size in mm, and ids with a prefix made from its
 *        title and drawing, so that several drawings can be in one page
 *   PNG  white ground, or none, with its resolution in the file; a large one is drawn
 *        in bands, so that a sheet of any size and resolution needs about 100 MiB
 *
 * The caller owns the file: a finished canvas is a block of bytes, or is passed to a
 * function of the caller's.
 */
#ifndef PP_CHARTS_SHEET_CANVAS_H
#define PP_CHARTS_SHEET_CANVAS_H

#include <stdbool.h>
#include <stddef.h>

#include <cairo.h>

#include "pepperpot.h"
#include "model/base/error.h"
#include "model/room/project.h"

struct pp_sheet {
    enum pp_chart_format format;
    enum pp_paper paper;
    bool landscape;
    double dpi;                 /* PNG only, 20 to 1200; 0: 200 */
    const char *title;          /* UTF-8, not owned; NULL: "" */
    const char *description;    /* description of the drawing for readers who cannot see
                                 * it; same ownership */
    bool transparent;           /* PNG only: no white ground; 128 MiB of pixels at
                                 * most */
    double width_mm, height_mm; /* used instead of the paper's; 0: the paper's */
    bool to_place;              /* without a file of its own: for pp_canvas_place */
};

struct pp_canvas;

enum pp_status pp_canvas_create(struct pp_canvas **canvas, const struct pp_sheet *sheet,
                                struct pp_error *err);
void pp_canvas_destroy(struct pp_canvas *canvas); /* NULL is allowed */

/* Units are millimetres; owned by the canvas. */
cairo_t *pp_canvas_cairo(struct pp_canvas *canvas);
double pp_canvas_width_mm(const struct pp_canvas *canvas);
double pp_canvas_height_mm(const struct pp_canvas *canvas);

/* Records that memory ran out for a part of a drawing on this context. pp_canvas_finish
 * then fails, as with cairo's own errors, so that no incomplete drawing is kept. Does
 * nothing for a context without a canvas. */
void pp_canvas_lacks_memory(cairo_t *cr);

/* Sets the small print at the foot of sheets from now on: the drawing's source; copied,
 * cut at 160 bytes. None at first. */
void pp_canvas_set_imprint(struct pp_canvas *canvas, const char *words);
const char *pp_canvas_imprint(const struct pp_canvas *canvas);

/* Sets the facts of the title block of later sheets; its texts are not owned. None at
 * first. */
void pp_canvas_set_project(struct pp_canvas *canvas, const struct pp_project *project);
const struct pp_project *pp_canvas_project(const struct pp_canvas *canvas);

/* True if the format allows further sheets. */
bool pp_canvas_has_sheets(const struct pp_canvas *canvas);

/* Begins a further sheet of the same size; PP_BAD_INPUT unless the file is a PDF. */
enum pp_status pp_canvas_next_sheet(struct pp_canvas *canvas, struct pp_error *err);

/* Adds an entry to the PDF's outline, with y_mm on this sheet as its target; does
 * nothing in other formats. level: 1 for the first entry, then at most one more than
 * that of the entry before. */
void pp_canvas_add_outline(struct pp_canvas *canvas, int level, const char *title,
                           double y_mm);

/* Places the drawing of another canvas on a canvas of PDF or SVG, at true scale and
 * line by line. Its upper left corner is at x_mm, y_mm, to the nearest point (1/72
 * inch). Parts beyond its edges are cut off. */
void pp_canvas_place(struct pp_canvas *canvas, const struct pp_canvas *drawing,
                     double x_mm, double y_mm);

/* Ends the drawing, and reports errors of all drawing so far. Afterwards *bytes is the
 * whole file, owned by the canvas and valid until it is destroyed. */
enum pp_status pp_canvas_finish(struct pp_canvas *canvas, const unsigned char **bytes,
                                size_t *length, struct pp_error *err);

/* Calls pp_canvas_finish, then passes the file to the caller's writer. A status of the
 * writer other than PP_OK is returned, with its message in err. */
enum pp_status pp_canvas_write(struct pp_canvas *canvas,
                               enum pp_status (*writer)(void *closure,
                                                        const unsigned char *bytes,
                                                        size_t length,
                                                        struct pp_error *err),
                               void *closure, struct pp_error *err);

/* Format by the ending of a file name (".pdf", ".svg", ".png", in either case). */
enum pp_status pp_canvas_format_of(enum pp_chart_format *format, const char *path,
                                   struct pp_error *err);

/* "a5" ... "a2", in either case. */
enum pp_status pp_canvas_paper_of(enum pp_paper *paper, const char *name,
                                  struct pp_error *err);

#endif
