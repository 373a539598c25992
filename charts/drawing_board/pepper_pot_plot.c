/* pepper_pot_plot.c - draws Pleijel's dots, the windows in perspective, and the scales
 * of a panel. */
#include "charts/drawing_board/pepper_pot_plot.h"

#include <math.h>
#include <stdio.h>

#include "charts/drawing_board/board.h"
#include "charts/sheet/page.h"

/* Number of dots on a square whose side is the viewing distance, where the dots are
 * densest, if each dot is worth 0.1 %. */
static const double densest = 90.0;

/* A panel and its position on paper. */
struct pepper_pot_plot {
    const struct pp_pepper_pot_panel *panel;
    struct pp_box frame;
    struct pp_board_map map; /* map.mm is the viewing distance */
    int first;               /* index of the panel's first window */
};

/* --- windows -------------------------------------------------------------------------
 */

struct pp_bounds2 pp_pepper_pot_plot_extent(const struct pp_pepper_pot_panel *panel)
{
    struct pp_bounds2 extent = {{0.0, 0.0}, {0.0, 0.0}};
    for (int w = 0; w < panel->count; w++)
        pp_board_sheets_window_extent(&panel->windows[w], extent.low, extent.high);
    if (panel->any_slope)
        extent.low[1] = fmin(extent.low[1] - 0.2, -1.0); /* space for dots all around */
    else
        extent.low[1] = fmax(extent.low[1], -0.3);
    return extent;
}

static void draw_outlines(const struct pp_pepper_pot_drawing *drawing,
                          const struct pepper_pot_plot *plot)
{
    for (int w = 0; w < plot->panel->count; w++)
        for (int p = 0; p < plot->panel->windows[w].count; p++)
            pp_board_outline(drawing->cr, &drawing->style, &plot->map,
                             &plot->panel->windows[w].pieces[p].outline);
}

/* Writes each window's letter above the upper left corner of its visible part. */
static void draw_letters(const struct pp_pepper_pot_drawing *drawing,
                         const struct pepper_pot_plot *plot)
{
    for (int w = 0; w < plot->panel->count; w++) {
        struct pp_bounds2 extent = pp_bounds2_empty();
        pp_board_sheets_window_extent(&plot->panel->windows[w], extent.low,
                                      extent.high);
        if (!(extent.high[0] > extent.low[0]))
            continue;
        const struct pp_lettering set = {
            .size = PP_TEXT_HEAD, .bold = true, .down = 1.0};
        double x = pp_board_x(&plot->map, extent.low[0]);
        double y = pp_board_y(&plot->map, extent.high[1]);
        pp_lettering_draw_on_white(drawing->cr, &drawing->style, &set, x,
                                   y - 0.4 * drawing->style.scale,
                                   pp_board_letter(plot->first + w));
    }
}

/* --- the diagram ---------------------------------------------------------------------
 */

static void draw_dots(const struct pp_pepper_pot_drawing *drawing,
                      const struct pepper_pot_plot *plot)
{
    double spacing = drawing->viewing / sqrt(densest * 0.001 / drawing->sheet->worth);
    double radius = fmin(0.42 * drawing->style.scale,
                         fmax(0.17 * spacing, 0.11 * drawing->style.scale));
    for (int i = 0; i < plot->panel->dot_count; i++) {
        const struct pp_pepper_pot_dot *dot = &plot->panel->dots[i];
        double x = pp_board_x(&plot->map, dot->a);
        double y = pp_board_y(&plot->map, dot->b);
        bool within = x > plot->frame.x + radius && y > plot->frame.y + radius
                      && x < plot->frame.x + plot->frame.width - radius
                      && y < plot->frame.y + plot->frame.height;
        if (!within)
            continue;
        bool stands_back = !drawing->sheet->blank && !dot->counted;
        pp_style_grey(drawing->cr, stands_back ? PP_GREY_LINE : PP_INK);
        cairo_arc(drawing->cr, x, y, stands_back ? 0.8 * radius : radius, 0.0,
                  2.0 * PP_PI);
        cairo_fill(drawing->cr);
    }
}

/* Smallest interval of the scales at which labels do not overlap. */
static double scale_step(const struct pp_pepper_pot_drawing *drawing)
{
    static const double steps[] = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0};
    double room = 9.0 * drawing->style.scale;
    int i = 0;
    while (i < 5 && steps[i] * drawing->viewing < room)
        i++;
    return steps[i];
}

static void draw_scale(const struct pp_pepper_pot_drawing *drawing,
                       const struct pepper_pot_plot *plot, bool upright)
{
    const struct pp_style *style = &drawing->style;
    double step = scale_step(drawing), mm = plot->map.mm;
    double tick = 1.4 * style->scale, bottom = plot->frame.y + plot->frame.height;
    double from =
        upright ? (plot->map.y0 - bottom) / mm : (plot->frame.x - plot->map.x0) / mm;
    double to = upright ? (plot->map.y0 - plot->frame.y) / mm
                        : (plot->frame.x + plot->frame.width - plot->map.x0) / mm;
    struct pp_lettering set = {.size = PP_TEXT_SMALL,
                               .across = upright ? 1.0 : 0.5,
                               .down = upright ? 0.5 : 0.0};
    int first = (int)ceil(from / step - 1e-9), last = (int)floor(to / step + 1e-9);
    pp_style_line(drawing->cr, style->thin, PP_INK);
    for (int i = first; i <= last; i++) {
        double x = upright ? plot->frame.x : plot->map.x0 + i * step * mm;
        double y = upright ? plot->map.y0 - i * step * mm : bottom;
        char words[32];
        snprintf(words, sizeof words, "%g", fabs(i * step));
        cairo_move_to(drawing->cr, x, y);
        cairo_line_to(drawing->cr, upright ? x - tick : x, upright ? y : y + tick);
        cairo_stroke(drawing->cr);
        pp_lettering_draw(drawing->cr, style, &set, upright ? x - 1.4 * tick : x,
                          upright ? y : y + 1.2 * tick, words);
    }
}

static void draw_eye(const struct pp_pepper_pot_drawing *drawing,
                     const struct pepper_pot_plot *plot)
{
    const struct pp_box *frame = &plot->frame;
    pp_style_line(drawing->cr, drawing->style.thin, PP_GREY_LINE);
    cairo_move_to(drawing->cr, plot->map.x0, frame->y);
    cairo_line_to(drawing->cr, plot->map.x0, frame->y + frame->height);
    cairo_stroke(drawing->cr);
    pp_style_line(drawing->cr, drawing->style.thin, PP_INK);
    cairo_move_to(drawing->cr, frame->x, plot->map.y0);
    cairo_line_to(drawing->cr, frame->x + frame->width, plot->map.y0);
    cairo_stroke(drawing->cr);
}

static void panel_words(char *words, size_t room,
                        const struct pp_pepper_pot_panel *panel)
{
    pp_board_panel_words(words, room, &panel->face, panel->glazed);
    pp_page_say(words, room, "%d dots in all, %.1f\u00a0%%", panel->dot_count,
                100.0 * panel->whole);
}

/* Space for scales and text around a panel's frame: left, top, right, bottom (mm). */
struct pepper_pot_margins {
    double left, top, right, bottom;
};

static struct pepper_pot_margins panel_border(
    const struct pp_pepper_pot_drawing *drawing)
{
    const struct pp_style *style = &drawing->style;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL};
    struct pp_box label =
        pp_lettering_measure(drawing->cr, style, &set, 0.0, 0.0, "0.5");
    double tick = 1.4 * style->scale;
    return (struct pepper_pot_margins){
        2.0 * tick + label.width + label.height, 1.6 * style->text[PP_TEXT_BODY],
        0.5 * label.width, 1.2 * tick + 2.0 * label.height};
}

struct pp_box pp_pepper_pot_plot_frame(const struct pp_pepper_pot_drawing *drawing,
                                       struct pp_box room)
{
    struct pepper_pot_margins border = panel_border(drawing);
    return (struct pp_box){room.x + border.left, room.y + border.top,
                           room.width - border.left - border.right,
                           room.height - border.top - border.bottom};
}

void pp_pepper_pot_plot_draw(const struct pp_pepper_pot_drawing *drawing,
                             const struct pp_pepper_pot_panel *panel, int first,
                             struct pp_box room)
{
    const struct pp_style *style = &drawing->style;
    struct pepper_pot_margins border = panel_border(drawing);
    struct pp_bounds2 extent = pp_pepper_pot_plot_extent(panel);
    double mm = drawing->viewing;
    double low = extent.low[0], high = extent.high[0];
    struct pepper_pot_plot at = {.panel = panel,
                                 .frame = pp_pepper_pot_plot_frame(drawing, room),
                                 .first = first};
    const struct pepper_pot_plot *plot = &at;
    const struct pp_box *frame = &plot->frame;
    at.map =
        (struct pp_board_map){frame->x + 0.5 * frame->width - 0.5 * (low + high) * mm,
                              frame->y + frame->height + extent.low[1] * mm, mm};

    char words[128];
    panel_words(words, sizeof words, panel);
    struct pp_lettering set = {.size = PP_TEXT_BODY, .bold = true, .across = 0.5};
    pp_lettering_draw(drawing->cr, style, &set, frame->x + 0.5 * frame->width,
                      frame->y - border.top, words);
    cairo_save(drawing->cr);
    cairo_rectangle(drawing->cr, frame->x, frame->y, frame->width, frame->height);
    cairo_clip(drawing->cr);
    pp_board_tints(drawing->cr, style, &plot->map, panel->windows, panel->count,
                   *frame);
    draw_eye(drawing, plot);
    draw_outlines(drawing, plot);
    draw_dots(drawing, plot);
    draw_letters(drawing, plot);
    cairo_restore(drawing->cr);
    pp_style_line(drawing->cr, style->medium, PP_INK);
    cairo_rectangle(drawing->cr, frame->x, frame->y, frame->width, frame->height);
    cairo_stroke(drawing->cr);
    draw_scale(drawing, plot, false);
    draw_scale(drawing, plot, true);
    set = (struct pp_lettering){.size = PP_TEXT_SMALL, .across = 0.5, .down = 1.0};
    pp_lettering_draw(drawing->cr, style, &set, frame->x + 0.5 * frame->width,
                      frame->y + frame->height + border.bottom,
                      "lateral distance \u00f7 distance to the plane of the window");
    set.turn_rad = -PP_PI / 2.0;
    set.down = 0.0;
    pp_lettering_draw(drawing->cr, style, &set, frame->x - border.left,
                      frame->y + 0.5 * frame->height,
                      panel->any_slope ? "distance up the slope \u00f7 distance"
                                       : "height above the point \u00f7 distance");
}
