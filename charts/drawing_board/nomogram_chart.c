#include "charts/drawing_board/nomogram_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

/* Where the scales stand on paper. */
struct view {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_nomogram_sheet *sheet;
    double left, width, bottom, height; /* mm */
};

static double x_of(const struct view *view, int stem)
{
    return view->left + view->sheet->nomogram.stems[stem].x * view->width;
}

static double y_of(const struct view *view, double y)
{
    return view->bottom - y * view->height;
}

/* Numbers of the first stem stand left of it, all others right; readings on the other
 * side. */
static double side_of(int stem)
{
    return stem == 0 ? -1.0 : 1.0;
}

/* --- scales --------------------------------------------------------------------------
 */

static void draw_marks(const struct view *view, int stem)
{
    static const double length[] = {1.1, 1.8, 2.6};
    cairo_t *cr = view->cr;
    const struct pp_nomogram_scale *scale = &view->sheet->scales[stem];
    double x = x_of(view, stem), side = side_of(stem) * view->style.scale;
    pp_style_line(cr, view->style.hair, PP_INK);
    for (int i = 0; i < scale->count; i++) {
        double y = y_of(view, scale->marks[i].y);
        cairo_move_to(cr, x, y);
        cairo_line_to(cr, x + side * length[scale->marks[i].rank], y);
    }
    cairo_stroke(cr);
}

static void write_numbers(const struct view *view, int stem)
{
    const struct pp_nomogram_scale *scale = &view->sheet->scales[stem];
    double side = side_of(stem);
    double x = x_of(view, stem) + side * 3.3 * view->style.scale;
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .across = side < 0.0 ? 1.0 : 0.0, .down = 0.5};
    for (int i = 0; i < scale->count; i++) {
        if (scale->marks[i].rank != PP_MARK_LABELLED)
            continue;
        char words[32];
        snprintf(words, sizeof words, "%.4g", scale->marks[i].number);
        /* A room's lines end at the figures. */
        (view->sheet->blank ? pp_lettering_draw : pp_lettering_draw_on_white)(
            view->cr, &view->style, &set, x, y_of(view, scale->marks[i].y), words);
    }
}

/* The y of the ends of a stem: where its values end, or its marks. */
static void ends_of(const struct view *view, int stem, double ends[2])
{
    const struct pp_nomogram_scale *scale = &view->sheet->scales[stem];
    ends[0] = ends[1] = y_of(view, scale->marks[0].y);
    for (int i = 0; i < scale->count; i++) {
        ends[0] = fmin(ends[0], y_of(view, scale->marks[i].y));
        ends[1] = fmax(ends[1], y_of(view, scale->marks[i].y));
    }
}

/* Letter and tag of a stem above its upper end. */
static void write_head(const struct view *view, int stem, double top)
{
    const struct pp_style *style = &view->style;
    const struct pp_nomogram *nomogram = &view->sheet->nomogram;
    double x = x_of(view, stem), y = top - 1.2 * style->text[PP_TEXT_SMALL];
    const struct pp_lettering tag = {
        .size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT, .across = 0.5, .down = 1.0};
    const struct pp_lettering letter = {
        .size = PP_TEXT_HEAD, .bold = true, .across = 0.5, .down = 1.0};
    const char words[2] = {nomogram->stems[stem].letter, 0};
    struct pp_box box = pp_lettering_draw_on_white(
        view->cr, style, &tag, x, y, pp_nomogram_notes_stem_label(nomogram, stem));
    pp_lettering_draw_on_white(view->cr, style, &letter, x, box.y, words);
}

static double head_height(const struct pp_style *style)
{
    return 2.6 * style->text[PP_TEXT_SMALL] + 1.3 * style->text[PP_TEXT_HEAD];
}

static void draw_stem(const struct view *view, int stem)
{
    double ends[2], x = x_of(view, stem);
    ends_of(view, stem, ends);
    draw_marks(view, stem);
    pp_style_line(view->cr, view->style.thin, PP_INK);
    cairo_move_to(view->cr, x, ends[0]);
    cairo_line_to(view->cr, x, ends[1]);
    cairo_stroke(view->cr);
    write_numbers(view, stem);
    write_head(view, stem, ends[0]);
}

/* --- a room's lines ------------------------------------------------------------------
 */

static void draw_edges(const struct view *view)
{
    const struct pp_nomogram_sheet *sheet = view->sheet;
    for (int i = 0; i < sheet->window_count; i++)
        for (int k = 0; k < sheet->nomogram.edge_count; k++) {
            const struct pp_nomogram_edge *edge = &sheet->nomogram.edges[k];
            const struct pp_nomogram_window *window = &sheet->windows[i];
            if (!window->read.used[k])
                continue;
            struct pp_curve_style curve = pp_style_curve(i);
            pp_style_pen(view->cr, &view->style, &curve);
            cairo_move_to(view->cr, x_of(view, edge->from),
                          y_of(view, window->y[edge->from]));
            cairo_line_to(view->cr, x_of(view, edge->to),
                          y_of(view, window->y[edge->to]));
            cairo_stroke(view->cr);
        }
    cairo_set_dash(view->cr, NULL, 0, 0.0);
}

/* A reading's words, and where they would best stand. */
struct note {
    double wanted, y;
    char words[48];
};

static int by_height(const void *a, const void *b)
{
    double difference = ((const struct note *)a)->y - ((const struct note *)b)->y;
    return (difference > 0.0) - (difference < 0.0);
}

/* Moves notes, in order down the sheet, apart to at least `gap`. */
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

/* Is the stem set or read for a window? */
static bool stem_used(const struct view *view, const struct pp_nomogram_window *window,
                      int stem)
{
    const struct pp_nomogram *nomogram = &view->sheet->nomogram;
    for (int k = 0; k < nomogram->edge_count; k++) {
        const struct pp_nomogram_edge *edge = &nomogram->edges[k];
        if (window->read.used[k]
            && (edge->from == stem || edge->to == stem || edge->read == stem))
            return true;
    }
    return false;
}

/* Which way a reading keeps off the line that leaves the stem on its side: up, -1, or
 * down. */
static double off_line(const struct view *view, const struct pp_nomogram_window *window,
                       int stem)
{
    const struct pp_nomogram *nomogram = &view->sheet->nomogram;
    double side = -side_of(stem);
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

/* The nearest stem on the readings' side of one, or -1. */
static int neighbour(const struct view *view, int stem)
{
    double side = -side_of(stem), gap = INFINITY;
    int nearest = -1;
    for (int i = 0; i < view->sheet->nomogram.stem_count; i++) {
        double away = side * (x_of(view, i) - x_of(view, stem));
        if (away > 0.0 && away < gap) {
            gap = away;
            nearest = i;
        }
    }
    return nearest;
}

/* How far the figures of a stem reach from it. */
static double figures_mm(const struct pp_style *style)
{
    return 3.3 * style->scale + 2.4 * style->text[PP_TEXT_SMALL];
}

/* Is there less room beside a stem, on the readings' side, than "3: 0.0155" takes? */
static bool narrow(const struct view *view, int stem)
{
    int next = neighbour(view, stem);
    return next >= 0
           && fabs(x_of(view, next) - x_of(view, stem))
                  < figures_mm(&view->style) + 3.0 * view->style.scale
                        + 5.5 * view->style.text[PP_TEXT_BODY];
}

/* Would a reading at this height cover figures of the next stem? */
static bool covers_figures(const struct view *view, int stem, double width, double y)
{
    const struct pp_style *style = &view->style;
    int next = neighbour(view, stem);
    if (next < 0 || side_of(stem) < 0.0
        || x_of(view, next) + figures_mm(style)
               < x_of(view, stem) - 3.0 * style->scale - width)
        return false;
    double apart = 0.65 * (style->text[PP_TEXT_BODY] + style->text[PP_TEXT_SMALL]);
    const struct pp_nomogram_scale *scale = &view->sheet->scales[next];
    for (int i = 0; i < scale->count; i++)
        if (scale->marks[i].rank == PP_MARK_LABELLED
            && fabs(y_of(view, scale->marks[i].y) - y) < apart)
            return true;
    return false;
}

/* The height near `y`, further up or down the way it is off the line, at which a lone
 * reading covers nothing. */
static double clear_height(const struct view *view, int stem, double wanted, double y,
                           double width)
{
    double way = y > wanted ? 1.0 : -1.0, step = 0.3 * view->style.text[PP_TEXT_BODY];
    for (int i = 0; i < 24; i++)
        if (!covers_figures(view, stem, width, y + way * i * step))
            return y + way * i * step;
    return y;
}

static void write_readings(const struct view *view, int stem)
{
    const struct pp_nomogram_sheet *sheet = view->sheet;
    const struct pp_style *style = &view->style;
    struct note notes[NOTED_MOST];
    int count = 0;
    double x = x_of(view, stem);
    for (int i = 0; i < sheet->window_count; i++) {
        const struct pp_nomogram_window *window = &sheet->windows[i];
        if (!stem_used(view, window, stem))
            continue;
        double y = y_of(view, window->y[stem]);
        pp_style_marker(view->cr, style, PP_CIRCLE, x, y);
        char words[48];
        pp_nomogram_notes_value(words, sizeof words, sheet, i, stem,
                                narrow(view, stem));
        bool known = count == NOTED_MOST;
        for (int k = 0; k < count && !known; k++)
            known = strcmp(notes[k].words, words) == 0;
        if (known)
            continue;
        double off = 1.1 * style->text[PP_TEXT_BODY] * off_line(view, window, stem);
        notes[count] = (struct note){.wanted = y, .y = y + off};
        memcpy(notes[count++].words, words, sizeof words);
    }
    spread(notes, count, 1.5 * style->text[PP_TEXT_BODY]);
    double side = -side_of(stem);
    const struct pp_lettering set = {.size = PP_TEXT_BODY,
                                     .bold = true,
                                     .across = side < 0.0 ? 1.0 : 0.0,
                                     .down = 0.5};
    for (int i = 0; i < count; i++) {
        double at = x + side * 3.0 * style->scale;
        if (count == 1) {
            double width =
                pp_lettering_measure(view->cr, style, &set, 0, 0, notes[i].words).width;
            notes[i].y = clear_height(view, stem, notes[i].wanted, notes[i].y, width);
        }
        pp_style_line(view->cr, style->hair, PP_INK);
        cairo_move_to(view->cr, x + side * 0.8 * style->scale, notes[i].wanted);
        cairo_line_to(view->cr, at - side * 0.4 * style->scale, notes[i].y);
        cairo_stroke(view->cr);
        pp_lettering_draw_on_white(view->cr, style, &set, at, notes[i].y,
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
    struct view view = {.cr = pp_canvas_cairo(canvas),
                        .style = pp_page_style(canvas),
                        .sheet = sheet,
                        .height = pp_nomogram_chart_height_mm(canvas)};
    const struct pp_style *style = &view.style;
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
    double taken = pp_lettering_draw(view.cr, style, &set, box.x, box.y, how).height
                   + 2.0 * style->scale;
    double numbers = 3.3 * style->scale + 3.2 * style->text[PP_TEXT_SMALL];
    view.left = box.x + numbers;
    view.width = box.width - 2.0 * numbers;
    taken += head_height(style);
    double rest = box.height - taken - 0.6 * style->text[PP_TEXT_SMALL];
    view.height = fmin(view.height, rest);
    view.bottom = box.y + taken + (rest + view.height) / 2.0;

    draw_edges(&view);
    for (int i = 0; i < sheet->nomogram.stem_count; i++)
        draw_stem(&view, i);
    for (int i = 0; i < sheet->nomogram.stem_count; i++)
        write_readings(&view, i);
    return PP_OK;
}
