/* waldram_plot.c - draws squares, droop lines, scales of altitude and azimuth, and the
 * windows with their counted squares.
 */
#include "charts/drawing_board/waldram_plot.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/drawing_board/board.h"
#include "charts/sheet/page.h"
#include "model/geometry/bounds.h"

/* Number of columns of squares from azimuth 0 to 90 degrees. */
enum { HALF_COLUMNS = 18 };

/* Index of the curve style (style.c) for droop lines of edges perpendicular to the
 * window. */
enum { ACROSS_DASH = 1 };

/* A panel on paper; map.mm is the side of a square. */
struct waldram_plot {
    const struct pp_waldram_panel *panel;
    struct pp_board_map map;
    int first; /* index of the panel's first window */
};

static double at_x(const struct waldram_plot *plot, double x)
{
    return pp_board_x(&plot->map, x);
}

static double at_y(const struct waldram_plot *plot, double y)
{
    return pp_board_y(&plot->map, y);
}

/* --- the diagram ---------------------------------------------------------------------
 */

static struct pp_box frame_of(const struct waldram_plot *plot)
{
    const struct pp_waldram_panel *panel = plot->panel;
    return (struct pp_box){at_x(plot, panel->low), at_y(plot, panel->top),
                           (panel->high - panel->low) * plot->map.mm,
                           panel->top * plot->map.mm};
}

static void draw_squares(const struct pp_waldram_drawing *drawing,
                         const struct waldram_plot *plot)
{
    cairo_t *cr = drawing->cr;
    struct pp_box frame = frame_of(plot);
    pp_style_line(cr, drawing->style.hair, drawing->sheet->blank ? 0.45 : 0.2);
    for (int column = plot->panel->low; column <= plot->panel->high; column++) {
        cairo_move_to(cr, at_x(plot, column), frame.y);
        cairo_line_to(cr, at_x(plot, column), frame.y + frame.height);
    }
    for (int row = 0; row < plot->panel->top; row++) {
        cairo_move_to(cr, frame.x, at_y(plot, row));
        cairo_line_to(cr, frame.x + frame.width, at_y(plot, row));
    }
    cairo_stroke(cr);
}

static void draw_frame(const struct pp_waldram_drawing *drawing,
                       const struct waldram_plot *plot)
{
    struct pp_box frame = frame_of(plot);
    pp_style_line(drawing->cr, drawing->style.medium, PP_INK);
    cairo_rectangle(drawing->cr, frame.x, frame.y, frame.width, frame.height);
    cairo_stroke(drawing->cr);
    cairo_move_to(drawing->cr, plot->map.x0, frame.y);
    cairo_line_to(drawing->cr, plot->map.x0, frame.y + frame.height);
    pp_style_line(drawing->cr, drawing->style.thin, PP_INK);
    cairo_stroke(drawing->cr);
}

static void trace_curves(const struct pp_waldram_drawing *drawing,
                         const struct waldram_plot *plot,
                         const struct pp_curve_list *curves)
{
    for (int i = 0; i < curves->count; i++)
        for (int k = 0; k < curves->list[i].count; k++) {
            const double *xy = curves->list[i].xy[k];
            if (k == 0)
                cairo_move_to(drawing->cr, at_x(plot, xy[0]), at_y(plot, xy[1]));
            else
                cairo_line_to(drawing->cr, at_x(plot, xy[0]), at_y(plot, xy[1]));
        }
}

struct pp_curve_style pp_waldram_plot_droop_style(const struct pp_style *style,
                                                  bool across)
{
    struct pp_curve_style look = pp_style_curve(across ? ACROSS_DASH : 0);
    look.weight = style->thin / style->medium;
    return look;
}

static void draw_droop_lines(const struct pp_waldram_drawing *drawing,
                             const struct waldram_plot *plot)
{
    for (int across = 0; across < 2; across++) {
        struct pp_curve_style look =
            pp_waldram_plot_droop_style(&drawing->style, across);
        pp_style_pen(drawing->cr, &drawing->style, &look);
        pp_style_grey(drawing->cr, drawing->sheet->blank ? PP_INK : 0.35);
        trace_curves(drawing, plot,
                     across ? &plot->panel->across : &plot->panel->parallel);
        cairo_stroke(drawing->cr);
    }
    cairo_set_dash(drawing->cr, NULL, 0, 0.0);
}

/* Writes the altitude on each droop line of edges parallel to the window, where there
 * is space. */
static void label_droop_lines(const struct pp_waldram_drawing *drawing,
                              const struct waldram_plot *plot)
{
    const struct pp_curve_list *lines = &plot->panel->parallel;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    double last = plot->map.y0;
    for (int i = 0; i < lines->count; i++) {
        int degree = (int)lrint(lines->list[i].level / PP_RAD);
        double y = at_y(plot, plot->panel->altitude[degree]);
        char words[16];
        snprintf(words, sizeof words, "%d\u00b0", degree);
        struct pp_box box = pp_lettering_measure(drawing->cr, &drawing->style, &set,
                                                 plot->map.x0, y, words);
        if (last - y < 0.9 * box.height
            || y - at_y(plot, plot->panel->top) < 0.6 * box.height)
            continue;
        last = y;
        pp_lettering_draw_on_white(drawing->cr, &drawing->style, &set, plot->map.x0, y,
                                   words);
    }
}

/* --- scales --------------------------------------------------------------------------
 */

/* Altitudes in order of priority for labels. */
static const int altitudes[] = {0, 90, 50, 30, 70, 40, 60, 20, 80, 10};

static double label_height(const struct pp_waldram_drawing *drawing)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL};
    return pp_lettering_measure(drawing->cr, &drawing->style, &set, 0, 0, "90\u00b0")
        .height;
}

static double label_width(const struct pp_waldram_drawing *drawing)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL};
    return pp_lettering_measure(drawing->cr, &drawing->style, &set, 0, 0, "90\u00b0")
        .width;
}

static void draw_altitudes(const struct pp_waldram_drawing *drawing,
                           const struct waldram_plot *plot)
{
    enum { COUNT = sizeof altitudes / sizeof altitudes[0] };
    const struct pp_style *style = &drawing->style;
    struct pp_box frame = frame_of(plot);
    double tick = 0.9 * style->scale, height = 0.85 * label_height(drawing);
    double right = frame.x + frame.width, taken[COUNT];
    int count = 0;
    pp_style_line(drawing->cr, style->thin, PP_INK);
    for (int degree = 0; degree <= 90; degree += 5) {
        double y = at_y(plot, plot->panel->altitude[degree]);
        double length = degree % 10 ? tick : 1.8 * tick;
        cairo_move_to(drawing->cr, frame.x, y);
        cairo_line_to(drawing->cr, frame.x - length, y);
        cairo_move_to(drawing->cr, right, y);
        cairo_line_to(drawing->cr, right + length, y);
    }
    cairo_stroke(drawing->cr);
    for (int i = 0; i < COUNT; i++) {
        double y = at_y(plot, plot->panel->altitude[altitudes[i]]);
        bool clear = true;
        for (int k = 0; k < count; k++)
            clear = clear && fabs(taken[k] - y) >= height;
        if (!clear)
            continue;
        taken[count++] = y;
        char words[16];
        snprintf(words, sizeof words, "%d\u00b0", altitudes[i]);
        struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 1.0, .down = 0.5};
        pp_lettering_draw(drawing->cr, style, &set, frame.x - 2.4 * tick, y, words);
        set.across = 0.0;
        pp_lettering_draw(drawing->cr, style, &set, right + 2.4 * tick, y, words);
    }
    struct pp_lettering title = {
        .size = PP_TEXT_SMALL, .across = 0.5, .down = 1.0, .turn_rad = -PP_PI / 2.0};
    pp_lettering_draw(drawing->cr, style, &title,
                      frame.x - 2.8 * tick - label_width(drawing),
                      frame.y + 0.5 * frame.height, "altitude");
}

static double azimuth_place(const struct waldram_plot *plot, int degree)
{
    return at_x(plot, copysign(plot->panel->azimuth[abs(degree)], degree));
}

static void draw_azimuths(const struct pp_waldram_drawing *drawing,
                          const struct waldram_plot *plot)
{
    const struct pp_style *style = &drawing->style;
    struct pp_box frame = frame_of(plot);
    double bottom = frame.y + frame.height, tick = 0.9 * style->scale;
    int end = plot->panel->high > HALF_COLUMNS ? 180 : 90;
    double pitch = frame.width / (2 * end / 10);
    int step = pitch > 1.5 * label_width(drawing) ? 10 : 30;
    pp_style_line(drawing->cr, style->thin, PP_INK);
    for (int degree = -end; degree <= end; degree += 5) {
        double x = azimuth_place(plot, degree);
        cairo_move_to(drawing->cr, x, bottom);
        cairo_line_to(drawing->cr, x, bottom + (degree % 10 ? tick : 1.8 * tick));
    }
    cairo_stroke(drawing->cr);
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5};
    double last = -INFINITY, width = 1.25 * label_width(drawing);
    for (int degree = -end; degree <= end; degree += step) {
        double x = azimuth_place(plot, degree);
        /* For a glazed window the scale is compressed towards its ends. Labels that
         * would overlap the previous label or those of the ends are omitted. */
        bool crowds = abs(degree) != end
                      && (fabs(x - azimuth_place(plot, end)) < width || x - last < width
                          || fabs(x - azimuth_place(plot, -end)) < width);
        if (crowds)
            continue;
        last = x;
        char words[16];
        snprintf(words, sizeof words, "%d\u00b0", abs(degree));
        pp_lettering_draw(drawing->cr, style, &set, x, bottom + 2.2 * tick, words);
    }
    pp_lettering_draw(drawing->cr, style, &set, plot->map.x0,
                      bottom + 2.2 * tick + label_height(drawing),
                      "azimuth to the left and right of the window normal");
}

/* --- windows -------------------------------------------------------------------------
 */

/* Writes the tenths of partly covered squares: for sky in the upper part of the square,
 * for obstructions in the lower. */
static void draw_tenths(const struct pp_waldram_drawing *drawing,
                        const struct waldram_plot *plot,
                        const struct pp_board_piece *piece)
{
    struct pp_style style = drawing->style;
    style.text[PP_TEXT_SMALL] = fmin(style.text[PP_TEXT_SMALL], 0.36 * plot->map.mm);
    if (style.text[PP_TEXT_SMALL] < 1.3)
        return;
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .italic = piece->hidden, .across = 0.5, .down = 0.5};
    double down = piece->hidden ? 0.25 : 0.72;
    for (int i = 0; i < piece->square_count; i++) {
        const struct pp_counted_square *square = &piece->squares[i];
        if (square->tenths == 0 || square->tenths == 10)
            continue;
        char words[16];
        snprintf(words, sizeof words, "%d", square->tenths);
        double x = at_x(plot, square->column + 0.5), y = at_y(plot, square->row + down);
        pp_lettering_draw_on_white(drawing->cr, &style, &set, x, y, words);
    }
}

/* Writes the window's letter in the middle of its visible part, or above it. */
static void draw_letter(const struct pp_waldram_drawing *drawing,
                        const struct waldram_plot *plot,
                        const struct pp_board_window *window, int index)
{
    struct pp_bounds2 extent = pp_bounds2_empty();
    pp_board_sheets_window_extent(window, extent.low, extent.high);
    const double *low = extent.low, *high = extent.high;
    if (!(high[0] > low[0]))
        return;
    struct pp_lettering set = {
        .size = PP_TEXT_HEAD, .bold = true, .across = 0.5, .down = 0.5};
    double y = at_y(plot, 0.5 * (low[1] + high[1]));
    if ((high[1] - low[1]) * plot->map.mm < 1.8 * drawing->style.text[PP_TEXT_HEAD]) {
        set.down = 1.0; /* the visible part is too low for a letter */
        y = at_y(plot, high[1]) - 0.4 * drawing->style.scale;
    }
    pp_lettering_draw_on_white(drawing->cr, &drawing->style, &set,
                               at_x(plot, 0.5 * (low[0] + high[0])), y,
                               pp_board_letter(index));
}

/* Draws all windows, tinted or outlined. */
static void draw_pieces(const struct pp_waldram_drawing *drawing,
                        const struct waldram_plot *plot, bool tints)
{
    const struct pp_waldram_panel *panel = plot->panel;
    if (tints) {
        pp_board_tints(drawing->cr, &drawing->style, &plot->map, panel->windows,
                       panel->count, frame_of(plot));
        return;
    }
    for (int w = 0; w < panel->count; w++)
        for (int p = 0; p < panel->windows[w].count; p++) {
            const struct pp_board_piece *piece = &panel->windows[w].pieces[p];
            pp_board_outline(drawing->cr, &drawing->style, &plot->map, &piece->outline);
            draw_tenths(drawing, plot, piece);
        }
}

static void draw_windows(const struct pp_waldram_drawing *drawing,
                         const struct waldram_plot *plot, bool tints)
{
    const struct pp_waldram_panel *panel = plot->panel;
    struct pp_box frame = frame_of(plot);
    cairo_save(drawing->cr);
    cairo_rectangle(drawing->cr, frame.x, frame.y, frame.width, frame.height);
    cairo_clip(drawing->cr);
    draw_pieces(drawing, plot, tints);
    /* On a diagram of all azimuths, a window that crosses one end continues at the
     * other end. */
    for (int side = -1; side <= 1 && panel->high > HALF_COLUMNS; side += 2) {
        struct waldram_plot turned = *plot;
        turned.map.x0 += side * (panel->high - panel->low) * plot->map.mm;
        cairo_save(drawing->cr);
        cairo_rectangle(drawing->cr, frame.x, frame.y, frame.width, frame.height);
        cairo_clip(drawing->cr);
        draw_pieces(drawing, &turned, tints);
        cairo_restore(drawing->cr);
    }
    /* The single window of a vertical receiver covers the whole diagram and needs no
     * letter. */
    for (int w = 0; w < panel->count && !tints && !drawing->sheet->upright; w++)
        draw_letter(drawing, plot, &panel->windows[w], plot->first + w);
    cairo_restore(drawing->cr);
}

/* --- the panel in its part of the sheet ----------------------------------------------
 */

/* Text above a panel: its wall, glass, number of squares and their value. */
static void panel_words(char *words, size_t room, const struct pp_waldram_sheet *sheet,
                        const struct pp_waldram_panel *panel)
{
    if (sheet->upright)
        *words = 0;
    else
        pp_board_panel_words(words, room, &panel->face, panel->glazed);
    pp_page_say(words, room, "%.0f squares, %.1f\u00a0%%", panel->whole / sheet->worth,
                100.0 * panel->whole);
}

/* Space for scales and text around a panel's frame, mm. */
struct waldram_margins {
    double side, head, foot;
};

static struct waldram_margins panel_border(const struct pp_waldram_drawing *drawing)
{
    const struct pp_style *style = &drawing->style;
    double small = label_height(drawing), tick = 0.9 * style->scale;
    return (struct waldram_margins){3.2 * tick + label_width(drawing) + small,
                                    1.6 * style->text[PP_TEXT_BODY],
                                    2.2 * tick + 2.0 * small};
}

double pp_waldram_plot_square(const struct pp_waldram_drawing *drawing,
                              const struct pp_waldram_panel *panel, double width,
                              double height)
{
    struct waldram_margins border = panel_border(drawing);
    return fmin((width - 2.0 * border.side) / (panel->high - panel->low),
                (height - border.head - border.foot) / panel->top);
}

void pp_waldram_plot_draw(const struct pp_waldram_drawing *drawing,
                          const struct pp_waldram_panel *panel, int first,
                          struct pp_box room)
{
    const struct pp_style *style = &drawing->style;
    struct waldram_margins border = panel_border(drawing);
    double mm = pp_waldram_plot_square(drawing, panel, room.width, room.height);
    double height = border.head + panel->top * mm + border.foot;
    double top = room.y + 0.5 * (room.height - height);
    const struct waldram_plot at = {
        panel,
        {room.x + 0.5 * room.width, top + border.head + panel->top * mm, mm},
        first};
    const struct waldram_plot *plot = &at;
    char words[128];
    panel_words(words, sizeof words, drawing->sheet, panel);
    const struct pp_lettering set = {.size = PP_TEXT_BODY, .bold = true, .across = 0.5};
    pp_lettering_draw(drawing->cr, style, &set, plot->map.x0, top, words);
    draw_windows(drawing, plot, true);
    draw_squares(drawing, plot);
    draw_droop_lines(drawing, plot);
    draw_windows(drawing, plot, false);
    draw_frame(drawing, plot);
    if (drawing->sheet->blank)
        label_droop_lines(drawing, plot);
    draw_altitudes(drawing, plot);
    draw_azimuths(drawing, plot);
}
