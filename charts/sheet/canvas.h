/* canvas.h - a sheet of paper for drawings to scale, as PDF, SVG or PNG.
 *
 * One unit of the cairo context is one millimetre on paper; y runs down from the upper
 * left corner. Equal drawings give equal bytes: PDF dates are fixed, SVG ids are
 * numbered in order, text is laid out unhinted.
 *
 *   PDF  text remains text; title, subject and creator are set
 *   SVG  has <title> and <desc>, its size in mm, and ids with a prefix made from its
 *        title and drawing, so that several drawings can be in one page
 *   PNG  has a white background, or none, and states its resolution; a large PNG is
 *        drawn in bands, so that its pixels never need more than 128 MiB of memory
 *
 * The caller writes the file: a finished canvas gives a block of bytes, or is passed to
 * a function of the caller.
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
    double dpi;                 /* PNG only: resolution in dots per inch, 20 to 1200; 0:
                                 * 200 */
    const char *title;          /* UTF-8, not owned; NULL: "" */
    const char *description;    /* description of the drawing for readers who cannot see
                                 * it; UTF-8, not owned; NULL: "" */
    bool transparent;           /* PNG only: no white background; the pixels may need at
                                 * most 128 MiB */
    double width_mm, height_mm; /* size used instead of the paper's; 0: size of the
                                 * paper */
    bool to_place;              /* no file is made: the canvas is a drawing for
                                 * pp_canvas_place */
};

struct pp_canvas;

enum pp_status pp_canvas_create(struct pp_canvas **canvas, const struct pp_sheet *sheet,
                                struct pp_error *err);
void pp_canvas_destroy(struct pp_canvas *canvas); /* NULL is allowed */

/* Drawing context in millimetres, owned by the canvas. */
cairo_t *pp_canvas_cairo(struct pp_canvas *canvas);
double pp_canvas_width_mm(const struct pp_canvas *canvas);
double pp_canvas_height_mm(const struct pp_canvas *canvas);

/* Records that memory was exhausted while this context was used. pp_canvas_finish then
 * fails, as after errors of cairo, so that no incomplete drawing is kept. Does nothing
 * for a context without a canvas. */
void pp_canvas_lacks_memory(cairo_t *cr);

/* Sets the small print at the foot of this and later sheets, which states the source of
 * the drawing. The text is copied, and cut to 159 bytes. Initially there is none. */
void pp_canvas_set_imprint(struct pp_canvas *canvas, const char *words);
const char *pp_canvas_imprint(const struct pp_canvas *canvas);

/* Sets the facts for the title block of later sheets. The texts are not owned.
 * Initially there are none. */
void pp_canvas_set_project(struct pp_canvas *canvas, const struct pp_project *project);
const struct pp_project *pp_canvas_project(const struct pp_canvas *canvas);

/* True if the format allows more than one sheet. */
bool pp_canvas_has_sheets(const struct pp_canvas *canvas);

/* Begins another sheet of the same size; PP_BAD_INPUT unless the format is PDF. */
enum pp_status pp_canvas_next_sheet(struct pp_canvas *canvas, struct pp_error *err);

/* Adds an entry to the outline of the PDF, with y_mm on this sheet as its target. Does
 * nothing in other formats. level: 1 for the first entry, then at most one more than
 * the level of the previous entry; entries of level 4 or more are ignored. */
void pp_canvas_add_outline(struct pp_canvas *canvas, int level, const char *title,
                           double y_mm);

/* Places the drawing of another canvas on a PDF or SVG canvas, at its original scale
 * and as vectors. Its upper left corner is at x_mm, y_mm, rounded to points (1/72
 * inch). Parts outside this canvas are cut off. */
void pp_canvas_place(struct pp_canvas *canvas, const struct pp_canvas *drawing,
                     double x_mm, double y_mm);

/* Finishes the drawing, and reports any error since the canvas was created. *bytes is
 * then the complete file, owned by the canvas and valid until the canvas is
 * destroyed. */
enum pp_status pp_canvas_finish(struct pp_canvas *canvas, const unsigned char **bytes,
                                size_t *length, struct pp_error *err);

/* Calls pp_canvas_finish, then passes the file to `writer`. If the writer returns a
 * status other than PP_OK, that status is returned, with the writer's message in
 * err. */
enum pp_status pp_canvas_write(struct pp_canvas *canvas,
                               enum pp_status (*writer)(void *closure,
                                                        const unsigned char *bytes,
                                                        size_t length,
                                                        struct pp_error *err),
                               void *closure, struct pp_error *err);

/* Finds the format from the extension of a file name (".pdf", ".svg", ".png", in upper
 * or lower case). */
enum pp_status pp_canvas_format_of(enum pp_chart_format *format, const char *path,
                                   struct pp_error *err);

/* Finds the paper size from its name, "a5" ... "a2", in upper or lower case. */
enum pp_status pp_canvas_paper_of(enum pp_paper *paper, const char *name,
                                  struct pp_error *err);

#endif
