/* show_picture.c - writes a picture in a numeric format, as a PNG, or on a sheet. */
#include "cli/render/show_picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "charts/picture_chart.h"
#include "charts/picture_png.h"
#include "charts/sheet/page.h"
#include "cli/output.h"
#include "config.h"
#include "model/base/read_file.h"
#include "model/pictures/picture_hdr.h"
#include "model/pictures/iso_lines.h"
#include "model/pictures/raster.h"
#include "model/results/sheets/picture_sheet.h"
#include "studies/pictures/view_grid.h"

/* Maximum size of a picture file: 1 GiB. */
#define BYTES_MOST ((size_t)1 << 30)

/* ---- reading a picture file ---- */

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

/* ---- writing a picture file ---- */

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
        /* A picture without a known angle of view is assumed to be 50 degrees wide. */
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

/* ---- text and false colours of a sheet ---- */

/* Contour lines: width of smoothing, and length of the shortest line, as fractions of
 * the longer side of the picture. */
static const double smooth_share = 1.0 / 250.0, shortest_share = 1.0 / 25.0;

/* Sets the scale bar and the north arrow of a parallel view. */
static void lay_lengths(struct pp_picture_sheet *sheet,
                        const struct pp_shown_picture *shown)
{
    const struct pp_camera *camera = &shown->camera;
    if (camera->kind != PP_VIEW_PARALLEL)
        return;
    double n = shown->world->north_rad;
    struct pp_vec3 north = {-sin(n), cos(n), 0.0};
    sheet->pixels_per_m = shown->picture.width / camera->across;
    sheet->upright = hypot(camera->toward.x, camera->toward.y) > 1e-6;
    sheet->north_rad =
        -atan2(pp_vec_dot(north, camera->right), pp_vec_dot(north, camera->up));
}

/* Adds a note on the factor for decorations, which applies to daylight factors and
 * illuminances, but not to luminances. */
static void note_decorations(struct pp_picture_sheet *sheet,
                             const struct pp_shown_picture *shown)
{
    size_t room = sizeof sheet->foot;
    if (shown->world->decorations == 1.0)
        return;
    if (shown->quantity == PP_LUMINANCE)
        pp_page_say(sheet->foot, room,
                    "The factor of %.3g for deterioration of decorations is not "
                    "applied.",
                    shown->world->decorations);
    else
        pp_page_say(
            sheet->foot, room,
            "Reflected light is multiplied by %.3g for deterioration of decorations.",
            shown->world->decorations);
}

/* Sets title, subtitle, notes and scale bar. */
static void write_picture_words(struct pp_picture_sheet *sheet,
                                const struct pp_shown_picture *shown,
                                const struct pp_render_choice *choice)
{
    struct pp_quantity_words words = pp_quantity_words(shown->quantity);
    size_t room = sizeof sheet->subtitle, notes = sizeof sheet->foot;
    pp_page_say(sheet->subtitle, room, "%s", words.heading);
    if (shown->quantity != PP_LUMINANCE)
        pp_page_say(sheet->subtitle, room, "on visible surfaces");
    if (!shown->world) {
        sheet->title = choice->from_picture;
        if (shown->view[0])
            pp_page_say(sheet->foot, notes, "View: %s.", shown->view);
        return;
    }
    char sky[128];
    lay_lengths(sheet, shown);
    sheet->title = shown->world->name;
    pp_page_sky(sky, sizeof sky, shown->world, shown->light);
    pp_page_say(sheet->subtitle, room, "under %s %s%s", sky[0] == 'I' ? "an" : "a", sky,
                shown->quantity == PP_DAYLIGHT_FACTOR ? "" : ",");
    if (shown->quantity != PP_DAYLIGHT_FACTOR)
        pp_page_say(sheet->subtitle, room, "%.0f lx outside", shown->external_lux);
    double sun = pp_outside_light_sun_on_plane(shown->light, pp_vec(0.0, 0.0, 1.0));
    if (sun > 0.0)
        pp_page_say(sheet->subtitle, room, "from the sky, %.0f lx from the sun",
                    sun * shown->external_lux);
    pp_page_say(sheet->foot, notes, "%s.", shown->words);
    if (shown->quantity != PP_LUMINANCE)
        pp_page_say(sheet->foot, notes, "Glass and sky have no %s and are left white.",
                    shown->quantity == PP_ILLUMINANCE ? "illuminance"
                                                      : "daylight factor");
    note_decorations(sheet, shown);
}

/* Sets `off_scale` if any pixel is below or above the scale. */
static void look_beyond(struct pp_picture_sheet *sheet,
                        const struct pp_picture *picture, double unit)
{
    for (int y = 0; y < picture->height; y++)
        for (int x = 0; x < picture->width; x++) {
            double value = unit * pp_rgb_luminance(pp_picture_rgb(picture, x, y));
            sheet->off_scale[0] |= value < sheet->scale.low * 0.999;
            sheet->off_scale[1] |= value > sheet->scale.high * 1.001;
        }
}

static void choose_levels(struct pp_picture_sheet *sheet,
                          const struct pp_render_choice *choice)
{
    if (choice->no_contours)
        return;
    if (choice->levels.count) {
        sheet->level_count = choice->levels.count;
        memcpy(sheet->levels, choice->levels.list, sizeof choice->levels.list);
        return;
    }
    /* Keeps the levels that are within the scale. */
    double all[PP_FALSE_COLOUR_LEVELS_MOST];
    int count = pp_false_colour_scale_levels(&sheet->scale, all);
    for (int i = 0; i < count; i++)
        if (all[i] > sheet->scale.low && all[i] < sheet->scale.high)
            sheet->levels[sheet->level_count++] = all[i];
}

/* Adds the false-colour raster, its colour scale and contour lines. */
static enum pp_status lay_false_colours(struct pp_picture_sheet *sheet,
                                        const struct pp_shown_picture *shown,
                                        const struct pp_render_choice *choice,
                                        struct pp_error *err)
{
    const struct pp_picture *picture = &shown->picture;
    struct pp_quantity_words words = pp_quantity_words(shown->quantity);
    sheet->scaled = true;
    sheet->unit = words.unit;
    enum pp_status status = pp_false_colour_scale_fit(
        &sheet->scale, picture, words.scale, !choice->linear, err);
    if (status != PP_OK)
        return status;
    if (choice->range.count)
        sheet->scale = (struct pp_false_colour_scale){
            choice->range.list[0], choice->range.list[1], !choice->linear};
    look_beyond(sheet, picture, words.scale);
    choose_levels(sheet, choice);
    double side = fmax(picture->width, picture->height);
    status = pp_false_colour_raster(&sheet->raster, picture, words.scale, &sheet->scale,
                                    err);
    if (status == PP_OK)
        status = pp_iso_lines(&sheet->lines, picture, shown->tags, words.scale,
                              sheet->levels, sheet->level_count, smooth_share * side,
                              shortest_share * side, err);
    return status;
}

/* ---- the sheet ---- */

static enum pp_status lay_raster(struct pp_picture_sheet *sheet,
                                 const struct pp_shown_picture *shown,
                                 const struct pp_render_choice *choice,
                                 struct pp_error *err)
{
    if (choice->false_colour)
        return lay_false_colours(sheet, shown, choice, err);
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
    write_picture_words(&sheet, shown, choice);
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
