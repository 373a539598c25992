/* picture_chart.c - places a picture on a sheet. Grid, contour lines and marks are
 * drawn on the picture, a scale of its false colours beside it, and a scale bar in
 * metres below it. */
#include "charts/picture_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/sheet/labels.h"
#include "charts/sheet/page.h"
#include "charts/picture_png.h"
#include "charts/room/room_plan.h"

/* Sizes in mm, to be multiplied by style.scale: space beside the picture for the colour
 * scale, width of the bar of that scale, and space below the picture for the scale of
 * lengths. */
static const double scale_mm = 22.0, bar_mm = 7.0, below_mm = 11.0;

struct picture_drawing {
    cairo_t *cr;
    const struct pp_style *style;
    const struct pp_picture_sheet *sheet;
    struct pp_box box;       /* box of the picture */
    double mm;               /* mm per pixel */
    struct pp_labels labels; /* occupied places, so that figures do not overlap */
};

static void level_words(char *text, size_t room, double level)
{
    /* %.4g would print 10000 and more in exponential form. */
    snprintf(text, room, level >= 1e4 && level < 1e7 ? "%.0f" : "%.4g", level);
}

/* ---- the picture ---- */

static void place_picture(struct picture_drawing *drawing, struct pp_box free)
{
    const struct pp_raster *raster = &drawing->sheet->raster;
    double beside = drawing->sheet->scaled ? scale_mm * drawing->style->scale : 0.0;
    double below =
        drawing->sheet->pixels_per_m > 0.0 ? below_mm * drawing->style->scale : 0.0;
    drawing->mm = fmin((free.width - beside) / raster->width,
                       (free.height - below) / raster->height);
    drawing->box.width = drawing->mm * raster->width;
    drawing->box.height = drawing->mm * raster->height;
    drawing->box.x = free.x + (free.width - beside - drawing->box.width) / 2.0;
    drawing->box.y = free.y;
}

static enum pp_status draw_raster(const struct picture_drawing *drawing,
                                  struct pp_error *err)
{
    cairo_t *cr = drawing->cr;
    struct pp_box box = drawing->box;
    cairo_surface_t *image = pp_picture_png_surface(&drawing->sheet->raster);
    if (!image)
        return pp_fail(
            err, PP_SYSTEM,
            "cannot draw the picture: it is too large, or memory is exhausted");
    cairo_save(cr);
    cairo_translate(cr, box.x, box.y);
    cairo_scale(cr, drawing->mm, drawing->mm);
    cairo_set_source_surface(cr, image, 0.0, 0.0);
    cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_GOOD);
    cairo_pattern_set_extend(cairo_get_source(cr), CAIRO_EXTEND_PAD);
    cairo_rectangle(cr, 0.0, 0.0, drawing->sheet->raster.width,
                    drawing->sheet->raster.height);
    cairo_fill(cr);
    cairo_restore(cr);
    cairo_surface_destroy(image);
    pp_style_line(cr, drawing->style->hair, PP_INK);
    cairo_rectangle(cr, box.x, box.y, box.width, box.height);
    cairo_stroke(cr);
    return PP_OK;
}

/* ---- lines and figures on the picture ---- */

static void path(const struct picture_drawing *drawing, const struct pp_curve *curve)
{
    cairo_new_path(drawing->cr);
    for (int i = 0; i < curve->count; i++)
        cairo_line_to(drawing->cr, drawing->box.x + drawing->mm * curve->xy[i][0],
                      drawing->box.y + drawing->mm * curve->xy[i][1]);
    if (curve->closed)
        cairo_close_path(drawing->cr);
}

/* Strokes the path dark with a light border, so that it is visible on any colour. */
static void stroke_seen(const struct picture_drawing *drawing, double weight_mm)
{
    cairo_t *cr = drawing->cr;
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    cairo_set_source_rgba(cr, 1.0, 1.0, 1.0, 0.6);
    cairo_set_line_width(cr, 3.0 * weight_mm);
    cairo_stroke_preserve(cr);
    pp_style_line(cr, weight_mm, PP_INK);
    cairo_stroke(cr);
}

/* Writes the figure of a line at the free place nearest to the middle of the line. */
static void draw_figure(struct picture_drawing *drawing, const struct pp_curve *curve)
{
    char words[32];
    level_words(words, sizeof words, curve->level);
    struct pp_lettering text = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    double apart = 4.0 * drawing->style->text[PP_TEXT_SMALL];
    if (drawing->mm * pp_curve_length(curve) < 2.0 * apart)
        return;
    for (int k = 0; k < curve->count; k++) {
        int i = curve->count / 2 + (k % 2 ? (k + 1) / 2 : -(k / 2));
        if (i < 0 || i >= curve->count)
            continue;
        double x = drawing->box.x + drawing->mm * curve->xy[i][0];
        double y = drawing->box.y + drawing->mm * curve->xy[i][1];
        struct pp_box box =
            pp_lettering_measure(drawing->cr, drawing->style, &text, x, y, words);
        double gap = 0.8 * drawing->style->scale;
        struct pp_box wide = {box.x - gap, box.y - gap, box.width + 2.0 * gap,
                              box.height + 2.0 * gap};
        if (!pp_labels_is_free(&drawing->labels, wide))
            continue;
        pp_lettering_draw_on_white(drawing->cr, drawing->style, &text, x, y, words);
        pp_labels_note_box(&drawing->labels, wide);
        return;
    }
}

static void draw_lines(struct picture_drawing *drawing)
{
    const struct pp_curve_list *lines = &drawing->sheet->lines;
    cairo_t *cr = drawing->cr;
    cairo_save(cr);
    cairo_rectangle(cr, drawing->box.x, drawing->box.y, drawing->box.width,
                    drawing->box.height);
    cairo_clip(cr);
    for (int i = 0; i < lines->count; i++) {
        path(drawing, &lines->list[i]);
        stroke_seen(drawing, drawing->style->thin);
    }
    cairo_restore(cr);
}

static void draw_grid(struct picture_drawing *drawing)
{
    const struct pp_curve_list *grid = &drawing->sheet->grid;
    for (int i = 0; i < grid->count; i++) {
        path(drawing, &grid->list[i]);
        stroke_seen(drawing, drawing->style->hair);
    }
}

/* Draws the text of the grid, then the figures of lines, which avoid that text. */
static void draw_words(struct picture_drawing *drawing)
{
    const struct pp_picture_sheet *sheet = drawing->sheet;
    for (int i = 0; i < sheet->word_count; i++) {
        struct pp_lettering text = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
        struct pp_box box = pp_lettering_draw_on_white(
            drawing->cr, drawing->style, &text,
            drawing->box.x + drawing->mm * sheet->words[i].x,
            drawing->box.y + drawing->mm * sheet->words[i].y, sheet->words[i].words);
        pp_labels_note_box(&drawing->labels, box);
    }
    for (int i = 0; i < sheet->lines.count; i++)
        draw_figure(drawing, &sheet->lines.list[i]);
}

static void draw_picture_marks(const struct picture_drawing *drawing)
{
    const struct pp_picture_sheet *sheet = drawing->sheet;
    cairo_t *cr = drawing->cr;
    double radius = 0.35 * drawing->style->scale;
    for (int i = 0; i < sheet->mark_count; i++) {
        cairo_new_path(cr);
        cairo_arc(cr, drawing->box.x + drawing->mm * sheet->marks[i][0],
                  drawing->box.y + drawing->mm * sheet->marks[i][1], radius, 0.0,
                  2.0 * PP_PI);
        cairo_set_source_rgb(cr, 1.0, 1.0, 1.0);
        cairo_fill_preserve(cr);
        pp_style_line(cr, drawing->style->hair, PP_INK);
        cairo_stroke(cr);
    }
}

/* ---- the scale ---- */

static void draw_bar(const struct picture_drawing *drawing, struct pp_box bar)
{
    enum { STEPS = 256 };
    cairo_t *cr = drawing->cr;
    struct pp_raster raster;
    if (pp_raster_init(&raster, 1, STEPS, NULL) != PP_OK) {
        pp_canvas_lacks_memory(cr);
        return;
    }
    for (int i = 0; i < STEPS; i++)
        pp_false_colour((STEPS - 1 - i + 0.5) / STEPS, pp_raster_at(&raster, 0, i));
    cairo_surface_t *image = pp_picture_png_surface(&raster);
    pp_raster_clear(&raster);
    if (!image) {
        pp_canvas_lacks_memory(cr);
        return;
    }
    cairo_save(cr);
    cairo_translate(cr, bar.x, bar.y);
    cairo_scale(cr, bar.width, bar.height / STEPS);
    cairo_set_source_surface(cr, image, 0.0, 0.0);
    cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_NEAREST);
    cairo_rectangle(cr, 0.0, 0.0, 1.0, STEPS);
    cairo_fill(cr);
    cairo_restore(cr);
    cairo_surface_destroy(image);
    pp_style_line(cr, drawing->style->hair, PP_INK);
    cairo_rectangle(cr, bar.x, bar.y, bar.width, bar.height);
    cairo_stroke(cr);
}

static void draw_scale(const struct picture_drawing *drawing)
{
    const struct pp_picture_sheet *sheet = drawing->sheet;
    const struct pp_style *style = drawing->style;
    cairo_t *cr = drawing->cr;
    double x = drawing->box.x + drawing->box.width + 4.0 * style->scale;
    struct pp_lettering unit = {.size = PP_TEXT_BODY, .bold = true};
    struct pp_box head =
        pp_lettering_draw(cr, style, &unit, x, drawing->box.y, sheet->unit);
    double top = drawing->box.y + head.height + 2.5 * style->scale;
    double height =
        fmin(drawing->box.y + drawing->box.height - top, 120.0 * style->scale);
    struct pp_box bar = {x, top, bar_mm * style->scale,
                         fmax(height, 25.0 * style->scale)};
    draw_bar(drawing, bar);

    double levels[PP_FALSE_COLOUR_LEVELS_MOST], last = INFINITY;
    int count = pp_false_colour_scale_levels(&sheet->scale, levels);
    struct pp_lettering text = {.size = PP_TEXT_BODY, .down = 0.5};
    for (int i = 0; i < count; i++) {
        double y = bar.y + bar.height
                   - bar.height * pp_false_colour_scale_at(&sheet->scale, levels[i]);
        pp_style_line(cr, style->thin, PP_INK);
        cairo_move_to(cr, bar.x + 0.6 * bar.width, y);
        cairo_line_to(cr, bar.x + bar.width + 1.0 * style->scale, y);
        cairo_stroke(cr);
        if (last - y < 1.1 * style->text[PP_TEXT_BODY])
            continue;
        char words[48], figure[32];
        level_words(figure, sizeof figure, levels[i]);
        bool less = i == 0 && sheet->off_scale[0];
        bool more = i == count - 1 && sheet->off_scale[1];
        snprintf(words, sizeof words, "%s%s", less ? "≤ " : more ? "≥ " : "", figure);
        pp_lettering_draw(cr, style, &text, bar.x + bar.width + 1.8 * style->scale, y,
                          words);
        last = y;
    }
}

/* Draws a scale bar in metres below the picture and, for a view from above, a north
 * arrow. */
static void draw_lengths(const struct picture_drawing *drawing)
{
    const struct pp_picture_sheet *sheet = drawing->sheet;
    double mm = drawing->style->scale;
    struct pp_box bar = pp_room_plan_scale_bar(
        drawing->cr, drawing->style, sheet->pixels_per_m * drawing->mm,
        drawing->box.x + mm, drawing->box.y + drawing->box.height + 2.5 * mm);
    if (!sheet->upright)
        pp_room_plan_north_arrow(drawing->cr, drawing->style, sheet->north_rad,
                                 bar.x + bar.width + 9.0 * mm, bar.y + 4.5 * mm,
                                 3.5 * mm);
}

/* ---- the sheet ---- */

enum pp_status pp_picture_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_picture_sheet *sheet,
                                     struct pp_error *err)
{
    struct pp_style style = pp_page_style(canvas);
    struct pp_page page = {sheet->title, sheet->subtitle, sheet->foot};
    struct picture_drawing *drawing = calloc(1, sizeof *drawing);
    if (!drawing)
        return pp_fail_memory(err);
    drawing->cr = pp_canvas_cairo(canvas);
    drawing->style = &style;
    drawing->sheet = sheet;
    place_picture(drawing, pp_page_draw(canvas, &style, &page));
    drawing->labels.field = drawing->box;
    enum pp_status status = draw_raster(drawing, err);
    if (status == PP_OK) {
        draw_grid(drawing);
        draw_lines(drawing);
        draw_words(drawing);
        draw_picture_marks(drawing);
        if (sheet->scaled)
            draw_scale(drawing);
        if (sheet->pixels_per_m > 0.0)
            draw_lengths(drawing);
    }
    free(drawing);
    return status;
}

bool pp_picture_chart_landscape(const struct pp_picture_sheet *sheet)
{
    return sheet->raster.width > 0.85 * sheet->raster.height;
}
