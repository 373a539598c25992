/* show_picture.c - writes a picture as numbers, as PNG, or drawn on a sheet. */
#include "cli/render/show_picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "charts/picture_chart.h"
#include "charts/picture_png.h"
#include "cli/output.h"
#include "cli/render/picture_words.h"
#include "config.h"
#include "model/base/read_file.h"
#include "formats/pictures/picture_hdr.h"
#include "model/pictures/raster.h"
#include "studies/pictures/view_grid.h"

/* Largest picture file: 1 GiB. */
#define BYTES_MOST ((size_t)1 << 30)

/* ---- from a file ---- */

static enum pp_status take_notes(struct pp_shown_picture *shown,
                                 const struct pp_hdr_notes *notes,
                                 const struct pp_render_choice *choice,
                                 struct pp_error *err)
{
    snprintf(shown->view, sizeof shown->view, "%s", notes->view);
    shown->quantity = choice->quantity.is;
    if (!notes->quantity[0])
        return PP_OK;
    for (int i = 0; i < PP_QUANTITY_COUNT; i++)
        if (strcmp(notes->quantity, pp_quantity_words((enum pp_quantity)i).name) == 0)
            shown->quantity = (enum pp_quantity)i;
    if (choice->quantity.said && choice->quantity.is != shown->quantity)
        return pp_fail(err, PP_BAD_INPUT, "%s is a picture of %s, not of %s",
                       choice->from_picture, notes->quantity,
                       pp_quantity_words(choice->quantity.is).name);
    return PP_OK;
}

enum pp_status pp_show_picture_read(struct pp_shown_picture *shown,
                                    const struct pp_render_choice *choice,
                                    struct pp_error *err)
{
    *shown = (struct pp_shown_picture){0};
    char *bytes;
    size_t length;
    enum pp_status status =
        pp_read_file(&bytes, &length, choice->from_picture, BYTES_MOST, err);
    if (status != PP_OK)
        return status;
    struct pp_hdr_notes notes;
    struct pp_error own = {0};
    status = pp_picture_hdr_read(&shown->picture, &notes, (const unsigned char *)bytes,
                                 length, &own);
    free(bytes);
    if (status != PP_OK)
        return pp_fail(err, status, "%s: %s", pp_read_file_title(choice->from_picture),
                       own.message);
    size_t count = 3 * (size_t)shown->picture.width * (size_t)shown->picture.height;
    for (size_t i = 0; i < count; i++)
        shown->picture.rgb[i] = (float)(shown->picture.rgb[i] / notes.exposure);
    status = take_notes(shown, &notes, choice, err);
    if (status != PP_OK)
        pp_picture_clear(&shown->picture);
    return status;
}

/* ---- into one ---- */

enum pp_status pp_show_picture_numbers(const struct pp_shown_picture *shown,
                                       const struct pp_number_format *format, FILE *out,
                                       struct pp_error *err)
{
    struct pp_hdr_notes notes = {.exposure = 1.0,
                                 .software = PACKAGE_NAME " " PACKAGE_VERSION};
    snprintf(notes.view, sizeof notes.view, "%s", shown->view);
    if (shown->quantity != PP_LUMINANCE)
        snprintf(notes.quantity, sizeof notes.quantity, "%s",
                 pp_quantity_words(shown->quantity).name);
    return format->write(out, &shown->picture, &notes, err);
}

static enum pp_status tone_raster(struct pp_raster *raster,
                                  const struct pp_shown_picture *shown,
                                  const struct pp_render_choice *choice,
                                  struct pp_error *err)
{
    double across_deg = shown->camera.across / PP_RAD;
    bool angle = shown->world && shown->camera.kind != PP_VIEW_PARALLEL;
    struct pp_tone_options options = {
        .way = choice->exposure.said ? choice->exposure.way : PP_TONE_AUTOMATIC,
        .white = choice->exposure.white,
        .unit = pp_quantity_words(shown->quantity).scale,
        /* A picture without angles is looked at as if it were 50 degrees wide. */
        .degree_pixels = fmax(shown->picture.width / (angle ? across_deg : 50.0), 1.0)};
    struct pp_tone tone;
    enum pp_status status = pp_tone_prepare(&tone, &shown->picture, &options, err);
    if (status == PP_OK)
        status = pp_raster_of_tone(raster, &shown->picture, &tone, err);
    return status;
}

static enum pp_status write_png(FILE *out, const struct pp_shown_picture *shown,
                                const struct pp_render_choice *choice,
                                struct pp_error *err)
{
    struct pp_raster raster = {0};
    unsigned char *bytes = NULL;
    size_t length = 0;
    enum pp_status status = tone_raster(&raster, shown, choice, err);
    if (status == PP_OK)
        status = pp_picture_png(&bytes, &length, &raster, err);
    if (status == PP_OK && fwrite(bytes, 1, length, out) != length)
        status = pp_fail_memory(err);
    free(bytes);
    pp_raster_clear(&raster);
    return status;
}

static enum pp_status lay_raster(struct pp_picture_sheet *sheet,
                                 const struct pp_shown_picture *shown,
                                 const struct pp_render_choice *choice,
                                 struct pp_error *err)
{
    if (choice->false_colour)
        return pp_picture_words_false_colour(sheet, shown, choice, err);
    return tone_raster(&sheet->raster, shown, choice, err);
}

static enum pp_status lay_marks(struct pp_picture_sheet *sheet,
                                const struct pp_shown_picture *shown,
                                struct pp_error *err)
{
    if (shown->mark_count == 0)
        return PP_OK;
    size_t size = (size_t)shown->mark_count * sizeof *sheet->marks;
    sheet->marks = malloc(size);
    if (!sheet->marks)
        return pp_fail_memory(err);
    memcpy(sheet->marks, shown->marks, size);
    sheet->mark_count = shown->mark_count;
    return PP_OK;
}

static enum pp_status draw_picture_sheet(FILE *out,
                                         const struct pp_picture_sheet *sheet,
                                         const struct pp_sheet *paper,
                                         struct pp_error *err)
{
    struct pp_canvas *canvas;
    enum pp_status status = pp_canvas_create(&canvas, paper, err);
    if (status != PP_OK)
        return status;
    status = pp_picture_chart_draw(canvas, sheet, err);
    if (status == PP_OK)
        status = pp_canvas_write(canvas, pp_output_put, out, err);
    pp_canvas_destroy(canvas);
    return status;
}

static enum pp_status write_sheet(FILE *out, const struct pp_shown_picture *shown,
                                  const struct pp_render_choice *choice,
                                  enum pp_chart_format format, struct pp_error *err)
{
    struct pp_picture_sheet sheet = {0};
    pp_picture_words(&sheet, shown, choice);
    enum pp_status status = lay_raster(&sheet, shown, choice, err);
    if (status == PP_OK && choice->grid)
        status = pp_view_grid(&sheet, &shown->camera, shown->world, err);
    if (status == PP_OK)
        status = lay_marks(&sheet, shown, err);
    struct pp_sheet paper = {.format = format,
                             .paper = choice->paper.is,
                             .landscape = choice->orientation == PP_LANDSCAPE
                                          || (choice->orientation == PP_AS_FITS
                                              && pp_picture_chart_landscape(&sheet)),
                             .dpi = choice->dpi,
                             .title = sheet.title,
                             .description = sheet.subtitle};
    if (status == PP_OK)
        status = draw_picture_sheet(out, &sheet, &paper, err);
    pp_picture_sheet_clear(&sheet);
    return status;
}

enum pp_status pp_show_picture(const struct pp_shown_picture *shown,
                               const struct pp_render_choice *choice, const char *path,
                               FILE *out, struct pp_error *err)
{
    struct pp_picture_format format;
    enum pp_status status = pp_render_choice_format(&format, choice, path, err);
    if (status != PP_OK)
        return status;
    if (pp_render_choice_on_sheet(choice, &format))
        return write_sheet(out, shown, choice, format.shown, err);
    if (format.numbers)
        return pp_show_picture_numbers(shown, format.numbers, out, err);
    return write_png(out, shown, choice, err);
}
