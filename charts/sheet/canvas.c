/* canvas.c - makes the cairo surface of a sheet of paper, and makes the finished file
 * from cairo's output. */
#include "charts/sheet/canvas.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <pango/pangocairo.h>

#include "charts/sheet/bytes.h"
#include "charts/sheet/lettering.h"
#include "charts/sheet/png_file.h"

#define MM_PER_INCH 25.4
#define POINTS_PER_MM (72.0 / MM_PER_INCH)

/* Date in every PDF, so that equal drawings give equal files. */
#define FIXED_DATE "2000-01-01T00:00:00Z"

/* A PNG whose pixels need more than WHOLE_BYTES_MOST is drawn in bands of about
 * BAND_BYTES each. */
enum { WHOLE_BYTES_MOST = 128 << 20, BAND_BYTES = 32 << 20 };

enum { OUTLINE_LEVELS = 3 };

struct pp_canvas {
    struct pp_sheet sheet; /* copy; its title and description are not used */
    char *title, *description;
    char imprint[160];
    struct pp_project project;
    double width_mm, height_mm, dpi;
    int width_px, height_px; /* size of a PNG in pixels */
    bool in_bands;           /* true: a PNG is drawn in bands, since its pixels would
                              * need too much memory at once */
    cairo_surface_t *surface;
    cairo_t *cr;
    int page; /* number of the current page, from 1 */
    int outlines[OUTLINE_LEVELS
                 + 1];    /* last outline entry of each level; [0]: the root */
    struct pp_bytes raw;  /* output of cairo */
    struct pp_bytes file; /* the finished file */
    bool finished;
    bool lacks_memory; /* true if parts of the drawing are missing for lack of memory */
};

/* Key of the user data that is attached to the cairo context: a pointer to lacks_memory
 * of its canvas. */
static const cairo_user_data_key_t memory_key;

static enum pp_status fail_cairo(struct pp_error *err, cairo_status_t status)
{
    if (status == CAIRO_STATUS_NO_MEMORY)
        return pp_fail_memory(err);
    return pp_fail(err, PP_SYSTEM, "cannot draw the chart: %s",
                   cairo_status_to_string(status));
}

static cairo_status_t append_canvas_bytes(void *closure, const unsigned char *bytes,
                                          unsigned int length)
{
    return pp_bytes_add(closure, bytes, length) ? CAIRO_STATUS_SUCCESS
                                                : CAIRO_STATUS_NO_MEMORY;
}

static void paper_size(const struct pp_sheet *sheet, double *width_mm,
                       double *height_mm)
{
    *width_mm = sheet->width_mm;
    *height_mm = sheet->height_mm;
    if (sheet->width_mm > 0.0)
        return;
    static const double upright[][2] = {[PP_PAPER_A4] = {210, 297},
                                        [PP_PAPER_A5] = {148, 210},
                                        [PP_PAPER_A3] = {297, 420},
                                        [PP_PAPER_A2] = {420, 594}};
    *width_mm = upright[sheet->paper][sheet->landscape ? 1 : 0];
    *height_mm = upright[sheet->paper][sheet->landscape ? 0 : 1];
}

/* True if fonts are installed. Without fonts, Pango draws boxes or ends the process. */
static bool has_fonts(void)
{
    PangoFontFamily **families;
    int count;
    char name[64];
    pango_font_map_list_families(pango_cairo_font_map_get_default(), &families, &count);
    g_free(families);
    return count > 0 && pp_lettering_font("A", name, sizeof name) == 0;
}

static void describe_pdf(struct pp_canvas *canvas)
{
    cairo_surface_t *pdf = canvas->surface;
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_TITLE, canvas->title);
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_SUBJECT,
                                   canvas->description);
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATOR, "pepperpot");
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATE_DATE, FIXED_DATE);
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_MOD_DATE, FIXED_DATE);
}

static void open_picture(struct pp_canvas *canvas)
{
    double dots_per_mm = canvas->dpi / MM_PER_INCH;
    canvas->width_px = (int)lrint(canvas->width_mm * dots_per_mm);
    canvas->height_px = (int)lrint(canvas->height_mm * dots_per_mm);
    canvas->in_bands = canvas->width_px > WHOLE_BYTES_MOST / 4 / canvas->height_px;
    cairo_rectangle_t all = {0.0, 0.0, canvas->width_px, canvas->height_px};
    canvas->surface =
        canvas->in_bands
            ? cairo_recording_surface_create(CAIRO_CONTENT_COLOR, &all)
            : cairo_image_surface_create(canvas->sheet.transparent ? CAIRO_FORMAT_ARGB32
                                                                   : CAIRO_FORMAT_RGB24,
                                         canvas->width_px, canvas->height_px);
}

/* Adds the picture as a PNG file to canvas->raw. */
static cairo_status_t write_picture(struct pp_canvas *canvas)
{
    double dots_per_mm = canvas->dpi / MM_PER_INCH;
    if (!canvas->in_bands)
        return pp_png_file_of_image(&canvas->raw, canvas->surface, dots_per_mm);
    int rows = BAND_BYTES / 4 / canvas->width_px;
    return pp_png_file_in_bands(&canvas->raw, canvas->surface, canvas->width_px,
                                canvas->height_px, rows > 1 ? rows : 1, dots_per_mm);
}

/* Creates the surface of a file. */
static void open_file(struct pp_canvas *canvas, double width_pt, double height_pt)
{
    switch (canvas->sheet.format) {
    case PP_CHART_PDF:
        canvas->surface = cairo_pdf_surface_create_for_stream(
            append_canvas_bytes, &canvas->raw, width_pt, height_pt);
        describe_pdf(canvas);
        break;
    case PP_CHART_SVG:
        canvas->surface = cairo_svg_surface_create_for_stream(
            append_canvas_bytes, &canvas->raw, width_pt, height_pt);
        break;
    case PP_CHART_PNG:
        open_picture(canvas);
        break;
    }
}

static void open_surface(struct pp_canvas *canvas)
{
    double width_pt = canvas->width_mm * POINTS_PER_MM;
    double height_pt = canvas->height_mm * POINTS_PER_MM;
    double dots_per_mm = canvas->dpi / MM_PER_INCH;
    const cairo_rectangle_t all = {0.0, 0.0, width_pt, height_pt};
    bool to_place = canvas->sheet.to_place;
    if (to_place)
        canvas->surface =
            cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, &all);
    else
        open_file(canvas, width_pt, height_pt);
    canvas->cr = cairo_create(canvas->surface);
    if (canvas->sheet.format == PP_CHART_PNG && !to_place) {
        cairo_set_source_rgb(canvas->cr, 1, 1, 1);
        if (!canvas->sheet.transparent)
            cairo_paint(canvas->cr);
        cairo_scale(canvas->cr, dots_per_mm, dots_per_mm);
    } else {
        cairo_scale(canvas->cr, POINTS_PER_MM, POINTS_PER_MM);
    }
    cairo_set_source_rgb(canvas->cr, 0, 0, 0);
}

enum pp_status pp_canvas_create(struct pp_canvas **canvas_out,
                                const struct pp_sheet *sheet, struct pp_error *err)
{
    *canvas_out = 0;
    double dpi = sheet->dpi == 0.0 ? 200.0 : sheet->dpi;
    if (!(dpi >= 20.0 && dpi <= 1200.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the resolution is %g dots per inch; expected 20 to 1200", dpi);
    if (!has_fonts())
        return pp_fail(err, PP_SYSTEM,
                       "no font is installed; charts need one, such as DejaVu Sans "
                       "(Debian: fonts-dejavu-core)");

    struct pp_canvas *canvas = calloc(1, sizeof *canvas);
    if (!canvas)
        return pp_fail_memory(err);
    canvas->sheet = *sheet;
    canvas->dpi = dpi;
    canvas->page = 1;
    canvas->title = g_utf8_make_valid(sheet->title ? sheet->title : "", -1);
    canvas->description =
        g_utf8_make_valid(sheet->description ? sheet->description : "", -1);
    paper_size(sheet, &canvas->width_mm, &canvas->height_mm);
    open_surface(canvas);
    if (canvas->in_bands && sheet->transparent) {
        pp_canvas_destroy(canvas);
        return pp_fail(err, PP_BAD_INPUT,
                       "a transparent PNG of this size needs more than 128 MiB; "
                       "expected a smaller --dpi or --paper, or an SVG");
    }

    cairo_status_t status = cairo_status(canvas->cr);
    if (status == CAIRO_STATUS_SUCCESS)
        status =
            cairo_set_user_data(canvas->cr, &memory_key, &canvas->lacks_memory, NULL);
    if (status != CAIRO_STATUS_SUCCESS) {
        pp_canvas_destroy(canvas);
        return fail_cairo(err, status);
    }
    *canvas_out = canvas;
    return PP_OK;
}

void pp_canvas_destroy(struct pp_canvas *canvas)
{
    if (!canvas)
        return;
    cairo_destroy(canvas->cr);
    cairo_surface_destroy(canvas->surface);
    pp_bytes_clear(&canvas->raw);
    pp_bytes_clear(&canvas->file);
    g_free(canvas->title);
    g_free(canvas->description);
    free(canvas);
}

cairo_t *pp_canvas_cairo(struct pp_canvas *canvas)
{
    return canvas->cr;
}

void pp_canvas_lacks_memory(cairo_t *cr)
{
    bool *lacks_memory = cairo_get_user_data(cr, &memory_key);
    if (lacks_memory)
        *lacks_memory = true;
}

double pp_canvas_width_mm(const struct pp_canvas *canvas)
{
    return canvas->width_mm;
}

double pp_canvas_height_mm(const struct pp_canvas *canvas)
{
    return canvas->height_mm;
}

bool pp_canvas_has_sheets(const struct pp_canvas *canvas)
{
    return canvas->sheet.format == PP_CHART_PDF && !canvas->sheet.to_place;
}

void pp_canvas_set_imprint(struct pp_canvas *canvas, const char *words)
{
    snprintf(canvas->imprint, sizeof canvas->imprint, "%s", words);
}

const char *pp_canvas_imprint(const struct pp_canvas *canvas)
{
    return canvas->imprint;
}

void pp_canvas_set_project(struct pp_canvas *canvas, const struct pp_project *project)
{
    canvas->project = *project;
}

const struct pp_project *pp_canvas_project(const struct pp_canvas *canvas)
{
    return &canvas->project;
}

enum pp_status pp_canvas_next_sheet(struct pp_canvas *canvas, struct pp_error *err)
{
    if (!pp_canvas_has_sheets(canvas))
        return pp_fail(err, PP_BAD_INPUT,
                       "an SVG or PNG file holds one sheet, but there are several; "
                       "expected a PDF");
    cairo_show_page(canvas->cr);
    canvas->page++;
    return PP_OK;
}

void pp_canvas_add_outline(struct pp_canvas *canvas, int level, const char *title,
                           double y_mm)
{
    char place[64];
    if (!pp_canvas_has_sheets(canvas) || level > OUTLINE_LEVELS)
        return;
    char *valid = g_utf8_make_valid(title, -1);
    snprintf(place, sizeof place, "page=%d pos=[0 %.0f]", canvas->page,
             y_mm * POINTS_PER_MM);
    canvas->outlines[level] =
        cairo_pdf_surface_add_outline(canvas->surface, canvas->outlines[level - 1],
                                      valid, place, CAIRO_PDF_OUTLINE_FLAG_OPEN);
    g_free(valid);
}

/* cairo (1.16) rasterises some drawings unless the matrix between the two canvases is a
 * shift by whole units. The position is therefore rounded to points. */
void pp_canvas_place(struct pp_canvas *canvas, const struct pp_canvas *drawing,
                     double x_mm, double y_mm)
{
    cairo_t *cr = canvas->cr;
    canvas->lacks_memory |= drawing->lacks_memory;
    cairo_save(cr);
    cairo_identity_matrix(cr);
    cairo_translate(cr, rint(x_mm * POINTS_PER_MM), rint(y_mm * POINTS_PER_MM));
    cairo_set_source_surface(cr, drawing->surface, 0.0, 0.0);
    cairo_paint(cr);
    cairo_restore(cr);
}

static enum pp_status take_file(struct pp_canvas *canvas, struct pp_error *err)
{
    if (canvas->sheet.format == PP_CHART_SVG)
        return pp_bytes_name_svg(&canvas->file, &canvas->raw, canvas->width_mm,
                                 canvas->height_mm, canvas->title, canvas->description)
                   ? PP_OK
                   : pp_fail_memory(err);
    canvas->file = canvas->raw;
    canvas->raw = (struct pp_bytes){0};
    return PP_OK;
}

enum pp_status pp_canvas_finish(struct pp_canvas *canvas, const unsigned char **bytes,
                                size_t *length, struct pp_error *err)
{
    if (canvas->lacks_memory)
        return pp_fail_memory(err);
    if (canvas->sheet.to_place)
        return pp_fail(err, PP_BAD_INPUT,
                       "a drawing placed on a sheet cannot be a file of its own");
    if (!canvas->finished) {
        cairo_status_t status = cairo_status(canvas->cr);
        if (status == CAIRO_STATUS_SUCCESS && canvas->sheet.format == PP_CHART_PNG)
            status = write_picture(canvas);
        cairo_surface_finish(canvas->surface);
        if (status == CAIRO_STATUS_SUCCESS)
            status = cairo_surface_status(canvas->surface);
        if (status != CAIRO_STATUS_SUCCESS)
            return fail_cairo(err, status);
        enum pp_status taken = take_file(canvas, err);
        if (taken != PP_OK)
            return taken;
        canvas->finished = true;
    }
    *bytes = canvas->file.list;
    *length = canvas->file.count;
    return PP_OK;
}

enum pp_status pp_canvas_write(struct pp_canvas *canvas,
                               enum pp_status (*writer)(void *closure,
                                                        const unsigned char *bytes,
                                                        size_t length,
                                                        struct pp_error *err),
                               void *closure, struct pp_error *err)
{
    const unsigned char *bytes;
    size_t length;
    enum pp_status status = pp_canvas_finish(canvas, &bytes, &length, err);
    if (status != PP_OK)
        return status;
    return writer(closure, bytes, length, err);
}

enum pp_status pp_canvas_format_of(enum pp_chart_format *format, const char *path,
                                   struct pp_error *err)
{
    static const char *const endings[] = {
        [PP_CHART_PDF] = ".pdf", [PP_CHART_SVG] = ".svg", [PP_CHART_PNG] = ".png"};
    size_t length = strlen(path);
    for (int i = 0; i < 3; i++)
        if (length >= 4 && strcasecmp(path + length - 4, endings[i]) == 0) {
            *format = (enum pp_chart_format)i;
            return PP_OK;
        }
    return pp_fail(
        err, PP_BAD_INPUT,
        "unknown kind of file: \"%s\"; expected a name that ends in .pdf, .svg or .png",
        path);
}

enum pp_status pp_canvas_paper_of(enum pp_paper *paper, const char *name,
                                  struct pp_error *err)
{
    static const struct {
        const char *name;
        enum pp_paper paper;
    } papers[] = {{"a5", PP_PAPER_A5},
                  {"a4", PP_PAPER_A4},
                  {"a3", PP_PAPER_A3},
                  {"a2", PP_PAPER_A2}};
    for (int i = 0; i < 4; i++)
        if (strcasecmp(name, papers[i].name) == 0) {
            *paper = papers[i].paper;
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT, "unknown paper \"%s\"; expected a5, a4, a3 or a2",
                   name);
}
