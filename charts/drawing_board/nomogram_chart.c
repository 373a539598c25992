/* nomogram_chart.c - draws the stems of a nomogram with their marks and figures, and
 * over them a room's lines and readings.
 */
#include "charts/drawing_board/nomogram_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "charts/drawing_board/nomogram_curve.h"
#include "charts/drawing_board/nomogram_notes.h"
#include "charts/sheet/page.h"

double pp_nomogram_chart_height_mm(const struct pp_canvas *canvas)
{
    double width = pp_canvas_width_mm(canvas), height = pp_canvas_height_mm(canvas);
    return height > width ? 200.0 / 297.0 * height : 110.0 / 210.0 * height;
}

double pp_nomogram_chart_fine_mm(const struct pp_canvas *canvas)
{
    return 0.9 * pp_page_style(canvas).scale;
}

double pp_nomogram_chart_number_mm(const struct pp_canvas *canvas)
{
    struct pp_style style = pp_page_style(canvas);
    return 1.5 * style.text[PP_TEXT_SMALL];
}

static double x_of(const struct pp_nomogram_curve_frame *drawing, int stem)
{
    return pp_nomogram_curve_x(drawing, drawing->sheet->nomogram.stems[stem].x);
}

static double y_of(const struct pp_nomogram_curve_frame *drawing, double y)
{
    return pp_nomogram_curve_y(drawing, y);
}

/* Side of a stem on which its figures are: left (-1) of the first stem, right (1) of
 * all others. Readings are on the other side. */
static double stem_label_side(int stem)
{
    return stem == 0 ? -1.0 : 1.0;
}

/* --- scales --------------------------------------------------------------------------
 */

static void draw_stem_marks(const struct pp_nomogram_curve_frame *drawing, int stem)
{
    static const double length[] = {1.1, 1.8, 2.6};
    cairo_t *cr = drawing->cr;
    const struct pp_nomogram_scale *scale = &drawing->sheet->scales[stem];
    double x = x_of(drawing, stem), side = stem_label_side(stem) * drawing->style.scale;
    pp_style_line(cr, drawing->style.hair, PP_INK);
    for (int i = 0; i < scale->count; i++) {
        double y = y_of(drawing, scale->marks[i].y);
        cairo_move_to(cr, x, y);
        cairo_line_to(cr, x + side * length[scale->marks[i].rank], y);
    }
    cairo_stroke(cr);
}

static void write_numbers(const struct pp_nomogram_curve_frame *drawing, int stem)
{
    const struct pp_nomogram_scale *scale = &drawing->sheet->scales[stem];
    double side = stem_label_side(stem);
    double x = x_of(drawing, stem) + side * 3.3 * drawing->style.scale;
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .across = side < 0.0 ? 1.0 : 0.0, .down = 0.5};
    for (int i = 0; i < scale->count; i++) {
        if (scale->marks[i].rank != PP_MARK_LABELLED)
            continue;
        char words[32];
        snprintf(words, sizeof words, "%.4g", scale->marks[i].number);
        /* On a room's sheet the figures have a white background, which interrupts the
         * room's lines. */
        (drawing->sheet->blank ? pp_lettering_draw : pp_lettering_draw_on_white)(
            drawing->cr, &drawing->style, &set, x, y_of(drawing, scale->marks[i].y),
            words);
    }
}

/* Finds the ends of a stem: y of its highest and of its lowest mark. */
static void ends_of(const struct pp_nomogram_curve_frame *drawing, int stem,
                    double ends[2])
{
    const struct pp_nomogram_scale *scale = &drawing->sheet->scales[stem];
    ends[0] = ends[1] = y_of(drawing, scale->marks[0].y);
    for (int i = 0; i < scale->count; i++) {
        ends[0] = fmin(ends[0], y_of(drawing, scale->marks[i].y));
        ends[1] = fmax(ends[1], y_of(drawing, scale->marks[i].y));
    }
}

/* Writes the stem's letter and tag above its upper end. */
static void write_stem_head(const struct pp_nomogram_curve_frame *drawing, int stem,
                            double top)
{
    const struct pp_style *style = &drawing->style;
    const struct pp_nomogram *nomogram = &drawing->sheet->nomogram;
    double x = x_of(drawing, stem), y = top - 1.2 * style->text[PP_TEXT_SMALL];
    const struct pp_lettering tag = {
        .size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT, .across = 0.5, .down = 1.0};
    const struct pp_lettering letter = {
        .size = PP_TEXT_HEAD, .bold = true, .across = 0.5, .down = 1.0};
    const char words[2] = {nomogram->stems[stem].letter, 0};
    struct pp_box box = pp_lettering_draw_on_white(
        drawing->cr, style, &tag, x, y, pp_nomogram_notes_stem_label(nomogram, stem));
    pp_lettering_draw_on_white(drawing->cr, style, &letter, x, box.y, words);
}

static double head_height(const struct pp_style *style)
{
    return 2.6 * style->text[PP_TEXT_SMALL] + 1.3 * style->text[PP_TEXT_HEAD];
}

static void draw_stem(const struct pp_nomogram_curve_frame *drawing, int stem)
{
    double ends[2], x = x_of(drawing, stem);
    ends_of(drawing, stem, ends);
    draw_stem_marks(drawing, stem);
    pp_style_line(drawing->cr, drawing->style.thin, PP_INK);
    cairo_move_to(drawing->cr, x, ends[0]);
    cairo_line_to(drawing->cr, x, ends[1]);
    cairo_stroke(drawing->cr);
    write_numbers(drawing, stem);
    write_stem_head(drawing, stem, ends[0]);
}

/* --- a room's lines ------------------------------------------------------------------
 */

static void draw_edges(const struct pp_nomogram_curve_frame *drawing)
{
    const struct pp_nomogram_sheet *sheet = drawing->sheet;
    for (int i = 0; i < sheet->window_count; i++)
        for (int k = 0; k < sheet->nomogram.edge_count; k++) {
            const struct pp_nomogram_edge *edge = &sheet->nomogram.edges[k];
            const struct pp_nomogram_window *window = &sheet->windows[i];
            if (!window->read.used[k])
                continue;
            struct pp_curve_style curve = pp_style_curve(i);
            pp_style_pen(drawing->cr, &drawing->style, &curve);
            cairo_move_to(drawing->cr, x_of(drawing, edge->from),
                          y_of(drawing, window->y[edge->from]));
            cairo_line_to(drawing->cr, x_of(drawing, edge->to),
                          y_of(drawing, window->y[edge->to]));
            cairo_stroke(drawing->cr);
        }
    cairo_set_dash(drawing->cr, NULL, 0, 0.0);
}

/* Text of a reading. wanted: y of the reading on its stem, where the leader begins; y:
 * y of the text. */
struct note {
    double wanted, y;
    char words[48];
};

static int by_height(const void *a, const void *b)
{
    double difference = ((const struct note *)a)->y - ((const struct note *)b)->y;
    return (difference > 0.0) - (difference < 0.0);
}

/* Sorts notes by y, and moves close neighbours up and down by equal amounts until they
 * are at least `gap` apart. */
static void spread(struct note *notes, int count, double gap)
{
    qsort(notes, (size_t)count, sizeof *notes, by_height);
    for (int pass = 0; pass < 60; pass++)
        for (int i = 1; i < count; i++) {
            double lacks = gap - (notes[i].y - notes[i - 1].y);
            if (lacks <= 0.0)
                continue;
            notes[i - 1].y -= lacks / 2.0;
            notes[i].y += lacks / 2.0;
        }
}

enum { NOTED_MOST = 12 };

/* True if one of a window's lines uses the stem, as input or as result. */
static bool stem_used(const struct pp_nomogram_curve_frame *drawing,
                      const struct pp_nomogram_window *window, int stem)
{
    const struct pp_nomogram *nomogram = &drawing->sheet->nomogram;
    for (int k = 0; k < nomogram->edge_count; k++) {
        const struct pp_nomogram_edge *edge = &nomogram->edges[k];
        if (window->read.used[k]
            && (edge->from == stem || edge->to == stem || edge->read == stem))
            return true;
    }
    return false;
}

/* Direction in which to move a reading away from the line that leaves the stem: up (-1)
 * or down (1). */
static double off_line(const struct pp_nomogram_curve_frame *drawing,
                       const struct pp_nomogram_window *window, int stem)
{
    const struct pp_nomogram *nomogram = &drawing->sheet->nomogram;
    double side = -stem_label_side(stem);
    for (int k = 0; k < nomogram->edge_count; k++) {
        const struct pp_nomogram_edge *edge = &nomogram->edges[k];
        if (!window->read.used[k]
            || (edge->from != stem && edge->to != stem && edge->read != stem))
            continue;
        int end = side < 0.0 ? edge->from : edge->to;
        if (end != stem)
            return window->y[end] > window->y[stem] ? 1.0 : -1.0;
    }
    return -1.0;
}

/* Index of the stem nearest to `stem` on the side where its readings are; -1: none. */
static int neighbour(const struct pp_nomogram_curve_frame *drawing, int stem)
{
    double side = -stem_label_side(stem), gap = INFINITY;
    int nearest = -1;
    for (int i = 0; i < drawing->sheet->nomogram.stem_count; i++) {
        double away = side * (x_of(drawing, i) - x_of(drawing, stem));
        if (away > 0.0 && away < gap) {
            gap = away;
            nearest = i;
        }
    }
    return nearest;
}

/* Width of a stem's figures and of the space between stem and figures, mm. */
static double figures_mm(const struct pp_style *style)
{
    return 3.3 * style->scale + 2.4 * style->text[PP_TEXT_SMALL];
}

/* True if the space on the side where a stem's readings are is too narrow for a label
 * as long as "3: 0.0155". */
static bool narrow(const struct pp_nomogram_curve_frame *drawing, int stem)
{
    int next = neighbour(drawing, stem);
    return next >= 0
           && fabs(x_of(drawing, next) - x_of(drawing, stem))
                  < figures_mm(&drawing->style) + 3.0 * drawing->style.scale
                        + 5.5 * drawing->style.text[PP_TEXT_BODY];
}

/* True if a reading at this y would cover figures of the neighbouring stem. */
static bool covers_figures(const struct pp_nomogram_curve_frame *drawing, int stem,
                           double width, double y)
{
    const struct pp_style *style = &drawing->style;
    int next = neighbour(drawing, stem);
    if (next < 0 || stem_label_side(stem) < 0.0
        || x_of(drawing, next) + figures_mm(style)
               < x_of(drawing, stem) - 3.0 * style->scale - width)
        return false;
    double apart = 0.65 * (style->text[PP_TEXT_BODY] + style->text[PP_TEXT_SMALL]);
    const struct pp_nomogram_scale *scale = &drawing->sheet->scales[next];
    for (int i = 0; i < scale->count; i++)
        if (scale->marks[i].rank == PP_MARK_LABELLED
            && fabs(y_of(drawing, scale->marks[i].y) - y) < apart)
            return true;
    return false;
}

/* The y nearest to `y`, in the direction away from `wanted`, at which a single reading
 * does not cover any figures; `y` if there is none nearby. */
static double clear_height(const struct pp_nomogram_curve_frame *drawing, int stem,
                           double wanted, double y, double width)
{
    double way = y > wanted ? 1.0 : -1.0,
           step = 0.3 * drawing->style.text[PP_TEXT_BODY];
    for (int i = 0; i < 24; i++)
        if (!covers_figures(drawing, stem, width, y + way * i * step))
            return y + way * i * step;
    return y;
}

static void write_readings(const struct pp_nomogram_curve_frame *drawing, int stem)
{
    const struct pp_nomogram_sheet *sheet = drawing->sheet;
    const struct pp_style *style = &drawing->style;
    struct note notes[NOTED_MOST];
    int count = 0;
    double x = x_of(drawing, stem);
    for (int i = 0; i < sheet->window_count; i++) {
        const struct pp_nomogram_window *window = &sheet->windows[i];
        if (!stem_used(drawing, window, stem))
            continue;
        double y = y_of(drawing, window->y[stem]);
        pp_style_marker(drawing->cr, style, PP_CIRCLE, x, y);
        char words[48];
        pp_nomogram_notes_value(words, sizeof words, sheet, i, stem,
                                narrow(drawing, stem));
        bool known = count == NOTED_MOST;
        for (int k = 0; k < count && !known; k++)
            known = strcmp(notes[k].words, words) == 0;
        if (known)
            continue;
        double off = 1.1 * style->text[PP_TEXT_BODY] * off_line(drawing, window, stem);
        notes[count] = (struct note){.wanted = y, .y = y + off};
        memcpy(notes[count++].words, words, sizeof words);
    }
    spread(notes, count, 1.5 * style->text[PP_TEXT_BODY]);
    double side = -stem_label_side(stem);
    const struct pp_lettering set = {.size = PP_TEXT_BODY,
                                     .bold = true,
                                     .across = side < 0.0 ? 1.0 : 0.0,
                                     .down = 0.5};
    for (int i = 0; i < count; i++) {
        double at = x + side * 3.0 * style->scale;
        if (count == 1) {
            double width =
                pp_lettering_measure(drawing->cr, style, &set, 0, 0, notes[i].words)
                    .width;
            notes[i].y =
                clear_height(drawing, stem, notes[i].wanted, notes[i].y, width);
        }
        pp_style_line(drawing->cr, style->hair, PP_INK);
        cairo_move_to(drawing->cr, x + side * 0.8 * style->scale, notes[i].wanted);
        cairo_line_to(drawing->cr, at - side * 0.4 * style->scale, notes[i].y);
        cairo_stroke(drawing->cr);
        pp_lettering_draw_on_white(drawing->cr, style, &set, at, notes[i].y,
                                   notes[i].words);
    }
}

/* --- the sheet -----------------------------------------------------------------------
 */

enum pp_status pp_nomogram_chart_draw(struct pp_canvas *canvas,
                                      const struct pp_nomogram_sheet *sheet,
                                      struct pp_error *err)
{
    (void)err;
    struct pp_nomogram_curve_frame drawing = {.cr = pp_canvas_cairo(canvas),
                                              .style = pp_page_style(canvas),
                                              .sheet = sheet,
                                              .height =
                                                  pp_nomogram_chart_height_mm(canvas)};
    const struct pp_style *style = &drawing.style;
    char foot[4000] = "", subtitle[256] = "", title[32];
    pp_nomogram_notes_title(title, sizeof title, sheet);
    pp_nomogram_notes_subtitle(subtitle, sizeof subtitle, sheet);
    pp_nomogram_notes_foot(foot, sizeof foot, sheet);
    const struct pp_page page = {.title =
                                     sheet->blank || !sheet->name ? title : sheet->name,
                                 .subtitle = subtitle,
                                 .foot = foot};
    struct pp_box box = pp_page_draw(canvas, style, &page);

    char how[256] = "";
    pp_nomogram_notes_instructions(how, sizeof how, &sheet->nomogram);
    const struct pp_lettering set = {
        .size = PP_TEXT_BODY, .width = box.width, .lines = 3};
    double taken = pp_lettering_draw(drawing.cr, style, &set, box.x, box.y, how).height
                   + 2.0 * style->scale;
    double numbers = 3.3 * style->scale + 3.2 * style->text[PP_TEXT_SMALL];
    drawing.left = box.x + numbers;
    drawing.width = box.width - 2.0 * numbers;
    taken += head_height(style);
    double rest = box.height - taken - 0.6 * style->text[PP_TEXT_SMALL];
    drawing.height = fmin(drawing.height, rest);
    drawing.bottom = box.y + taken + (rest + drawing.height) / 2.0;

    draw_edges(&drawing);
    pp_nomogram_curve_draw(&drawing);
    pp_nomogram_curve_edges(&drawing);
    for (int i = 0; i < sheet->nomogram.stem_count; i++)
        draw_stem(&drawing, i);
    for (int i = 0; i < sheet->nomogram.stem_count; i++)
        write_readings(&drawing, i);
    return PP_OK;
}
