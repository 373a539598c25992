/* pepper_pot_chart.c - draws Pleijel's dots and a room's windows in perspective.
 *
 * The eye stands at the viewing distance v (mm) before the paper, at the height of the
 * horizon. A length of l metres in an upright plane d metres away is drawn with
 *
 *     v l / d                                                        (mm)
 */
#include "charts/drawing_board/pepper_pot_chart.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/drawing_board/board.h"
#include "charts/sheet/page.h"
#include "model/geometry/bounds.h"

enum { RULERS_MOST = 6 };

/* Dots on a square of one viewing distance, where dots are densest, for a worth of 0.1 %
 * a dot. */
static const double densest = 90.0;

struct pepper_pot_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_pepper_pot_sheet *sheet;
    double viewing; /* distance from the eye to the paper, mm */
};

/* One panel on paper. */
struct pepper_pot_plot {
    const struct pp_pepper_pot_panel *panel;
    struct pp_box frame;
    struct pp_board_map map; /* its mm is the viewing distance */
    int first;               /* number of its first window */
};

/* --- windows -------------------------------------------------------------------------
 */

/* The extent of a panel's windows and the point straight ahead; of what lies below the
 * horizon only the uppermost part. */
static struct pp_bounds2 panel_extent(const struct pp_pepper_pot_panel *panel)
{
    struct pp_bounds2 extent = {{0.0, 0.0}, {0.0, 0.0}};
    for (int w = 0; w < panel->count; w++)
        pp_board_sheets_window_extent(&panel->windows[w], extent.low, extent.high);
    extent.low[1] = fmax(extent.low[1], -0.3);
    return extent;
}

static void draw_tints(const struct pepper_pot_drawing *drawing,
                       const struct pepper_pot_plot *plot)
{
    for (int w = 0; w < plot->panel->count; w++)
        for (int p = 0; p < plot->panel->windows[w].count; p++) {
            const struct pp_board_piece *piece = &plot->panel->windows[w].pieces[p];
            pp_board_fill(drawing->cr, &drawing->style, &plot->map, &piece->outline,
                          piece->hidden, plot->frame);
        }
}

static void draw_outlines(const struct pepper_pot_drawing *drawing,
                          const struct pepper_pot_plot *plot)
{
    for (int w = 0; w < plot->panel->count; w++)
        for (int p = 0; p < plot->panel->windows[w].count; p++)
            pp_board_outline(drawing->cr, &drawing->style, &plot->map,
                             &plot->panel->windows[w].pieces[p].outline);
}

/* Each window's letter, beside the upper left corner of the part that is seen. */
static void draw_letters(const struct pepper_pot_drawing *drawing,
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
        double x = plot->map.x0 + plot->map.mm * extent.low[0];
        double y = plot->map.y0 - plot->map.mm * extent.high[1];
        pp_lettering_draw_on_white(drawing->cr, &drawing->style, &set, x,
                                   y - 0.4 * drawing->style.scale,
                                   pp_board_letter(plot->first + w));
    }
}

/* --- the diagram ---------------------------------------------------------------------
 */

static void draw_dots(const struct pepper_pot_drawing *drawing,
                      const struct pepper_pot_plot *plot)
{
    double spacing = drawing->viewing / sqrt(densest * 0.001 / drawing->sheet->worth);
    double radius = fmin(0.42 * drawing->style.scale,
                         fmax(0.17 * spacing, 0.11 * drawing->style.scale));
    for (int i = 0; i < plot->panel->dot_count; i++) {
        const struct pp_pepper_pot_dot *dot = &plot->panel->dots[i];
        double x = plot->map.x0 + plot->map.mm * dot->a;
        double y = plot->map.y0 - plot->map.mm * dot->b;
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

/* The least step of the scales at which labels have room. */
static double scale_step(const struct pepper_pot_drawing *drawing)
{
    static const double steps[] = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0};
    double room = 9.0 * drawing->style.scale;
    int i = 0;
    while (i < 5 && steps[i] * drawing->viewing < room)
        i++;
    return steps[i];
}

static void draw_scale(const struct pepper_pot_drawing *drawing,
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

static void draw_eye(const struct pepper_pot_drawing *drawing,
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
                        const struct pp_pepper_pot_sheet *sheet,
                        const struct pp_pepper_pot_panel *panel)
{
    *words = 0;
    if (!sheet->blank && panel->wall)
        pp_page_say(words, room, "Wall %s:", panel->wall);
    pp_page_say(words, room, "%s, %d dots in all, %.1f\u00a0%%",
                panel->glazed ? "with clear single glass" : "without glass",
                panel->dot_count, 100.0 * panel->whole);
}

/* Room for scales and words around a panel's frame: left, top, right, bottom (mm). */
struct pepper_pot_margins {
    double left, top, right, bottom;
};

static struct pepper_pot_margins panel_border(const struct pepper_pot_drawing *drawing)
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

static struct pp_box frame_within(const struct pepper_pot_drawing *drawing,
                                  struct pp_box room)
{
    struct pepper_pot_margins border = panel_border(drawing);
    return (struct pp_box){room.x + border.left, room.y + border.top,
                           room.width - border.left - border.right,
                           room.height - border.top - border.bottom};
}

static void draw_panel(const struct pepper_pot_drawing *drawing,
                       struct pepper_pot_plot *plot)
{
    const struct pp_style *style = &drawing->style;
    const struct pp_box *frame = &plot->frame;
    struct pepper_pot_margins border = panel_border(drawing);
    struct pp_bounds2 extent = panel_extent(plot->panel);
    double mm = drawing->viewing;
    double low = extent.low[0], high = extent.high[0];
    plot->map =
        (struct pp_board_map){frame->x + 0.5 * frame->width - 0.5 * (low + high) * mm,
                              frame->y + frame->height + extent.low[1] * mm, mm};

    char words[128];
    panel_words(words, sizeof words, drawing->sheet, plot->panel);
    struct pp_lettering set = {.size = PP_TEXT_BODY, .bold = true, .across = 0.5};
    pp_lettering_draw(drawing->cr, style, &set, frame->x + 0.5 * frame->width,
                      frame->y - border.top, words);
    cairo_save(drawing->cr);
    cairo_rectangle(drawing->cr, frame->x, frame->y, frame->width, frame->height);
    cairo_clip(drawing->cr);
    draw_tints(drawing, plot);
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
                      "to the side \u00f7 distance of the window's plane");
    set.turn_rad = -PP_PI / 2.0;
    set.down = 0.0;
    pp_lettering_draw(drawing->cr, style, &set, frame->x - border.left,
                      frame->y + 0.5 * frame->height,
                      "above the point \u00f7 distance");
}

/* --- rulers --------------------------------------------------------------------------
 */

/* Distances for which a metre is drawn: the windows' own, or some usual ones. */
static int ruler_distances(const struct pp_pepper_pot_sheet *sheet, double *distances)
{
    static const double usual[RULERS_MOST] = {1.0, 1.5, 2.0, 3.0, 4.0, 6.0};
    int count = 0;
    for (int i = 0; i < sheet->count; i++)
        for (int w = 0; w < sheet->panels[i].count; w++) {
            double d = sheet->panels[i].windows[w].distance_m;
            bool known = !(d > 0.0) || count == RULERS_MOST;
            for (int k = 0; k < count; k++)
                known = known || fabs(distances[k] - d) < 0.005;
            if (!known)
                distances[count++] = d;
        }
    if (count == 0)
        for (; count < RULERS_MOST; count++)
            distances[count] = usual[count];
    return count;
}

static double ruler_pitch(const struct pp_style *style)
{
    return 1.35 * style->text[PP_TEXT_SMALL];
}

/* Draws metres as they look in planes at several distances. */
static void draw_metres(const struct pepper_pot_drawing *drawing, double x, double y,
                        double width)
{
    const struct pp_style *style = &drawing->style;
    double distances[RULERS_MOST];
    int count = ruler_distances(drawing->sheet, distances);
    double label = 20.0 * style->scale, end = 15.0 * style->scale;
    const struct pp_lettering head = {.size = PP_TEXT_SMALL, .bold = true};
    pp_lettering_draw(drawing->cr, style, &head, x, y, "Metres in the window's plane");
    for (int i = 0; i < count; i++) {
        double metre = drawing->viewing / distances[i];
        double base = y + (i + 1.85) * ruler_pitch(style);
        double room = width - label - end;
        int metres = (int)floor(room / metre);
        metres = metres < 1 ? 1 : metres > 10 ? 10 : metres;
        char words[64], shown[32];
        pp_style_metres(shown, sizeof shown, distances[i]);
        snprintf(words, sizeof words, "%s away", shown);
        struct pp_lettering set = {.size = PP_TEXT_SMALL, .down = 0.8};
        pp_lettering_draw(drawing->cr, style, &set, x, base, words);
        double part = metre <= room ? 1.0 : 0.1; /* too near for a whole metre */
        if (part < 1.0)
            metres = (int)fmin(floor(room / (0.1 * metre)), 10.0);
        pp_style_line(drawing->cr, style->thin, PP_INK);
        cairo_move_to(drawing->cr, x + label, base);
        cairo_line_to(drawing->cr, x + label + metres * part * metre, base);
        for (int m = 0; m <= metres; m++) {
            cairo_move_to(drawing->cr, x + label + m * part * metre, base);
            cairo_line_to(drawing->cr, x + label + m * part * metre,
                          base - 1.6 * style->scale);
        }
        cairo_stroke(drawing->cr);
        pp_style_metres(shown, sizeof shown, metres * part);
        pp_lettering_draw(drawing->cr, style, &set,
                          x + label + metres * part * metre + style->scale, base,
                          shown);
    }
}

static void viewing_words(const struct pepper_pot_drawing *drawing, char *words,
                          size_t room)
{
    static const int scales[] = {20, 50, 100, 200};
    *words = 0;
    pp_page_say(
        words, room,
        "Viewing distance %.4g\u00a0mm: a metre d\u00a0metres away is "
        "%.4g\u00a0mm\u00a0\u00f7\u00a0d. An elevation can be laid under it from "
        "where it is seen at its own scale:",
        drawing->viewing, drawing->viewing);
    for (int i = 0; i < 4; i++) {
        char metres[32];
        pp_style_metres(metres, sizeof metres, drawing->viewing * scales[i] / 1000.0);
        pp_page_say(words, room, "1:%d from %s%s", scales[i], metres,
                    i < 3 ? "," : ".");
    }
}

/* The ruler, the rule of scale and the metres; drawn only if `drawn`. Returns their
 * height. */
static double draw_rulers(const struct pepper_pot_drawing *drawing, struct pp_box room,
                          bool drawn)
{
    const struct pp_style *style = &drawing->style;
    double distances[RULERS_MOST], gap = 4.0 * style->scale;
    double metres =
        (ruler_distances(drawing->sheet, distances) + 1.3) * ruler_pitch(style);
    double ruler = pp_board_ruler_height(style), inset = 2.0 * style->scale;
    double ruler_width = 100.0 + 30.0 * style->scale;
    bool beside = room.width > ruler_width + gap + 52.0 * style->scale;
    char words[512];
    viewing_words(drawing, words, sizeof words);
    struct pp_lettering set = {.size = PP_TEXT_BODY,
                               .width = beside ? ruler_width : room.width};
    struct pp_box said =
        pp_lettering_measure(drawing->cr, style, &set, room.x, room.y, words);
    double left = said.height + style->scale + ruler;
    if (drawn) {
        pp_lettering_draw(drawing->cr, style, &set, room.x, room.y, words);
        pp_board_ruler(drawing->cr, style, room.x + inset,
                       room.y + said.height + style->scale);
        if (beside)
            draw_metres(drawing, room.x + ruler_width + gap, room.y,
                        room.width - ruler_width - gap);
        else
            draw_metres(drawing, room.x, room.y + left + 0.5 * gap, room.width);
    }
    return beside ? fmax(left, metres) : left + 0.5 * gap + metres;
}

/* --- the sheet -----------------------------------------------------------------------
 */

/* The tints' keys and the sum; drawn only if `drawn`. Returns their height. */
static double draw_sums(const struct pepper_pot_drawing *drawing, struct pp_box room,
                        bool drawn)
{
    const struct pp_pepper_pot_sheet *sheet = drawing->sheet;
    if (sheet->blank)
        return 0.0;
    struct pp_board_sums sums = {.unit = "dots", .worth = sheet->worth};
    for (int i = 0; i < sheet->count; i++)
        pp_board_sums_add(&sums, sheet->panels[i].windows, sheet->panels[i].count);
    double height = pp_board_tint_keys(drawing->cr, &drawing->style, room.x, room.y,
                                       sums.any_hidden, drawn)
                        .height
                    + drawing->style.scale;
    height += pp_board_sums_draw(drawing->cr, &drawing->style, &sums, room.x,
                                 room.y + height, room.width, drawn);
    return height + 2.0 * drawing->style.scale;
}

static void say_foot(char *foot, size_t room, const struct pp_pepper_pot_sheet *sheet)
{
    pp_page_say(foot, room,
                "Each dot is worth %.3g\u00a0%% daylight factor; the outermost are "
                "beyond the frame.",
                100.0 * sheet->worth);
    if (!sheet->blank)
        pp_page_say(foot, room, "Dots in a window count wherever it reaches.");
    pp_page_say(foot, room,
                "True perspective of vertical windows; no row of dots runs along an "
                "edge. After Pleijel, 1954.");
}

static void titles(const struct pepper_pot_drawing *drawing, char *title,
                   char *subtitle, size_t room)
{
    const struct pp_pepper_pot_sheet *sheet = drawing->sheet;
    char sky[96];
    pp_page_sky_words(sky, sizeof sky, &sheet->sky, 0.0);
    const char *plane = sheet->upright ? "vertical plane" : "horizontal plane";
    if (sheet->blank) {
        snprintf(title, room, "Pepper-pot diagram");
        snprintf(subtitle, room, "Sky component on a %s%s, %s", plane,
                 sheet->upright ? " that faces the window" : "", sky);
        return;
    }
    snprintf(title, room, "%s", sheet->name ? sheet->name : "Pepper-pot diagram");
    snprintf(subtitle, room,
             "Pepper-pot diagram from x\u00a0%.2f, y\u00a0%.2f, z\u00a0%.2f\u00a0m, "
             "%s, %s",
             sheet->point.x, sheet->point.y, sheet->point.z, plane, sky);
}

/* Dots worth less stand closer together, and need a larger drawing. */
static double default_viewing(const struct pp_pepper_pot_sheet *sheet)
{
    return sheet->worth < 0.0005 ? 60.0 : 30.0;
}

/* The largest usual viewing distance, up to the default, at which all windows are
 * within frames of that size. */
static double choose_viewing(const struct pp_pepper_pot_sheet *sheet, double width,
                             double height)
{
    static const double usual[] = {60.0, 50.0, 40.0, 30.0, 25.0, 20.0, 15.0, 12.0,
                                   10.0, 8.0,  6.0,  5.0,  4.0,  3.0,  2.0,  1.0};
    enum { COUNT = sizeof usual / sizeof usual[0] };
    double most = default_viewing(sheet);
    for (int i = 0; i < sheet->count; i++) {
        struct pp_bounds2 extent = panel_extent(&sheet->panels[i]);
        double wide = extent.high[0] - extent.low[0];
        double high = extent.high[1] - extent.low[1];
        most = fmin(most, fmin(0.96 * width / wide, 0.93 * height / high));
    }
    int i = 0;
    while (i < COUNT - 1 && usual[i] > most)
        i++;
    return usual[i];
}

enum pp_status pp_pepper_pot_chart_draw(struct pp_canvas *canvas,
                                        const struct pp_pepper_pot_sheet *sheet,
                                        double viewing_mm, struct pp_error *err)
{
    (void)err;
    struct pepper_pot_drawing drawing = {
        .cr = pp_canvas_cairo(canvas),
        .style = pp_page_style(canvas),
        .sheet = sheet,
        .viewing = viewing_mm > 0.0 ? viewing_mm : default_viewing(sheet)};
    char title[512], subtitle[512], foot[2048] = "";
    titles(&drawing, title, subtitle, sizeof title);
    say_foot(foot, sizeof foot, sheet);
    const struct pp_page page = {title, subtitle, foot};
    struct pp_box body = pp_page_draw(canvas, &drawing.style, &page);

    double gap = 3.0 * drawing.style.scale;
    double rulers = draw_rulers(&drawing, body, false);
    double sums = draw_sums(&drawing, body, false);
    int columns = (int)ceil(sqrt(sheet->count));
    int rows = (sheet->count + columns - 1) / columns;
    double width = body.width / columns;
    double height = (body.height - rulers - sums) / rows;
    struct pp_box frame =
        frame_within(&drawing, (struct pp_box){0.0, 0.0, width, height - gap});
    if (viewing_mm <= 0.0)
        drawing.viewing = choose_viewing(sheet, frame.width, frame.height);
    int first = 0;
    for (int i = 0; i < sheet->count; i++) {
        struct pp_box room = {body.x + i % columns * width,
                              body.y + i / columns * height, width, height - gap};
        struct pepper_pot_plot plot = {.panel = &sheet->panels[i],
                                       .frame = frame_within(&drawing, room),
                                       .first = first};
        draw_panel(&drawing, &plot);
        first += sheet->panels[i].count;
    }
    double bottom = body.y + body.height;
    draw_sums(&drawing,
              (struct pp_box){body.x, bottom - rulers - sums, body.width, sums}, true);
    draw_rulers(&drawing, (struct pp_box){body.x, bottom - rulers, body.width, rulers},
                true);
    return PP_OK;
}
