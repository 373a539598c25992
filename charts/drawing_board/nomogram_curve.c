/* nomogram_curve.c - draws the curve with perpendicular marks and figures above it, and
 * the straight-edges across it. */
#include "charts/drawing_board/nomogram_curve.h"

#include <math.h>
#include <stdio.h>

#include "charts/sheet/lettering.h"

double pp_nomogram_curve_x(const struct pp_nomogram_curve_frame *frame, double x)
{
    return frame->left + x * frame->width;
}

double pp_nomogram_curve_y(const struct pp_nomogram_curve_frame *frame, double y)
{
    return frame->bottom - y * frame->height;
}

/* Unit normal to the curve at a mark, pointing up the sheet. */
static void find_normal(double normal[2], const struct pp_nomogram_curve_frame *frame,
                        int index)
{
    const struct pp_nomogram_scale *curve = &frame->sheet->curve;
    const struct pp_nomogram_mark *from = &curve->marks[index > 0 ? index - 1 : 0];
    const struct pp_nomogram_mark *to =
        &curve->marks[index + 1 < curve->count ? index + 1 : index];
    double x = (to->x - from->x) * frame->width;
    double y = -(to->y - from->y) * frame->height;
    double length = hypot(x, y), up = x > 0.0 ? -1.0 : 1.0;
    normal[0] = -up * y / length;
    normal[1] = up * x / length;
}

static void draw_mark(const struct pp_nomogram_curve_frame *frame, int index)
{
    static const double length[] = {1.1, 1.8, 2.6};
    const struct pp_nomogram_mark *mark = &frame->sheet->curve.marks[index];
    double normal[2], x = pp_nomogram_curve_x(frame, mark->x),
                      y = pp_nomogram_curve_y(frame, mark->y);
    find_normal(normal, frame, index);
    double reach = length[mark->rank] * frame->style.scale;
    cairo_move_to(frame->cr, x, y);
    cairo_line_to(frame->cr, x + reach * normal[0], y + reach * normal[1]);
    cairo_stroke(frame->cr);
    if (mark->rank != PP_MARK_LABELLED)
        return;
    char words[16];
    double away = 3.4 * frame->style.scale + 0.5 * frame->style.text[PP_TEXT_SMALL];
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    snprintf(words, sizeof words, mark->number < 0.0 ? "\u2212%.0f" : "%.0f",
             fabs(mark->number));
    pp_lettering_draw(frame->cr, &frame->style, &set, x + away * normal[0],
                      y + away * normal[1], words);
}

/* Writes the curve's letter beside the end with the large figures. */
static void write_curve_head(const struct pp_nomogram_curve_frame *frame)
{
    const struct pp_nomogram_scale *curve = &frame->sheet->curve;
    const struct pp_nomogram_mark *last = &curve->marks[curve->count - 1];
    const struct pp_lettering set = {
        .size = PP_TEXT_HEAD, .bold = true, .across = 0.0, .down = 0.5};
    pp_lettering_draw_on_white(frame->cr, &frame->style, &set,
                               pp_nomogram_curve_x(frame, last->x)
                                   + 2.0 * frame->style.scale,
                               pp_nomogram_curve_y(frame, last->y), "q");
}

void pp_nomogram_curve_draw(const struct pp_nomogram_curve_frame *frame)
{
    const struct pp_nomogram_scale *curve = &frame->sheet->curve;
    cairo_t *cr = frame->cr;
    if (curve->count == 0)
        return;
    pp_style_line(cr, frame->style.thin, PP_INK);
    for (int i = 0; i < curve->count; i++)
        cairo_line_to(cr, pp_nomogram_curve_x(frame, curve->marks[i].x),
                      pp_nomogram_curve_y(frame, curve->marks[i].y));
    cairo_stroke(cr);
    pp_style_line(cr, frame->style.hair, PP_INK);
    for (int i = 0; i < curve->count; i++)
        draw_mark(frame, i);
    write_curve_head(frame);
}

static void draw_edge(const struct pp_nomogram_curve_frame *frame, int window,
                      int which)
{
    const struct pp_nomogram_sheet *sheet = frame->sheet;
    const struct pp_nomogram_place *place = &sheet->windows[window].read.places[which];
    const int factors = sheet->nomogram.edges[PP_NOMOGRAM_EDGES - 1].to;
    const int places = sheet->nomogram.stem_count - 1;
    double x_share = pp_nomogram_curve_x(frame, sheet->nomogram.stems[places].x);
    double x_factor = pp_nomogram_curve_x(frame, sheet->nomogram.stems[factors].x);
    double y_share = pp_nomogram_curve_y(frame, place->share_y);
    double y_factor = pp_nomogram_curve_y(frame, place->factor_y);
    double x = pp_nomogram_curve_x(frame, place->x),
           y = pp_nomogram_curve_y(frame, place->y);
    struct pp_curve_style curve = pp_style_curve(window);
    pp_style_pen(frame->cr, &frame->style, &curve);
    cairo_move_to(frame->cr, x_share, y_share);
    cairo_line_to(frame->cr, x, y);
    cairo_line_to(frame->cr, x_factor, y_factor);
    cairo_stroke(frame->cr);
    cairo_set_dash(frame->cr, NULL, 0, 0.0);
    pp_style_marker(frame->cr, &frame->style, PP_CIRCLE, x, y);
    pp_style_marker(frame->cr, &frame->style, PP_CIRCLE, x_share, y_share);
    pp_style_marker(frame->cr, &frame->style, PP_CIRCLE, x_factor, y_factor);

    char words[16] = "";
    const struct pp_lettering set = {
        .size = PP_TEXT_BODY, .bold = true, .across = 1.0, .down = which ? 0.0 : 1.0};
    if (sheet->window_count > 1)
        snprintf(words, sizeof words, "%d%c", window + 1, which ? 's' : 'd');
    else
        snprintf(words, sizeof words, "%c", which ? 's' : 'd');
    pp_lettering_draw_on_white(frame->cr, &frame->style, &set,
                               x_share - 2.0 * frame->style.scale, y_share, words);
}

void pp_nomogram_curve_edges(const struct pp_nomogram_curve_frame *frame)
{
    for (int i = 0; i < frame->sheet->window_count && frame->sheet->curve.count > 0;
         i++)
        for (int which = 0; which < 2; which++)
            draw_edge(frame, i, which);
}
