/* skylight_indicator_chart.c - draws a half disc around the window with arcs of
 * altitude, rays of azimuth, marks and obstructions, and writes scales and the sum
 * below. */
#include "charts/drawing_board/skylight_indicator_chart.h"

#include <math.h>
#include <stdio.h>

#include "charts/drawing_board/board.h"
#include "charts/sheet/page.h"

struct indicator_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_skylight_indicator_sheet *sheet;
    struct pp_board_map
        map; /* map.mm: length on paper (mm) where distance equals height */
};

/* Altitudes of the arcs (degrees). */
static const int arcs[] = {6, 8, 10, 15, 20, 25, 30, 40, 50, 60, 70};
enum { ARCS = sizeof arcs / sizeof arcs[0] };

static double reach_mm(const struct indicator_drawing *drawing)
{
    return drawing->sheet->reach * drawing->map.mm;
}

static void trace_half_disc(const struct indicator_drawing *drawing, double radius)
{
    cairo_new_path(drawing->cr);
    cairo_arc(drawing->cr, drawing->map.x0, drawing->map.y0, radius, PP_PI,
              2.0 * PP_PI);
}

static void draw_net(const struct indicator_drawing *drawing)
{
    cairo_t *cr = drawing->cr;
    const struct pp_board_map *map = &drawing->map;
    double reach = reach_mm(drawing);
    for (int i = 0; i < ARCS; i++) {
        double radius = map->mm / tan(arcs[i] * PP_RAD);
        if (radius >= reach)
            continue;
        trace_half_disc(drawing, radius);
        pp_style_line(cr, drawing->style.hair, PP_GREY_LINE);
        cairo_stroke(cr);
    }
    for (int degree = -80; degree <= 80; degree += 10) {
        double s = sin(degree * PP_RAD), c = cos(degree * PP_RAD);
        double inner = degree % 30 ? map->mm : 0.0;
        cairo_move_to(cr, map->x0 + inner * s, map->y0 - inner * c);
        cairo_line_to(cr, map->x0 + reach * s, map->y0 - reach * c);
    }
    pp_style_line(cr, drawing->style.hair, PP_GREY_LINE);
    cairo_stroke(cr);
    trace_half_disc(drawing, reach);
    cairo_close_path(cr);
    pp_style_line(cr, drawing->style.medium, PP_INK);
    cairo_stroke(cr);
}

/* Writes the altitudes along the right half of the wall, where there are no marks, and
 * the azimuths along the rim. */
static void label_net(const struct indicator_drawing *drawing)
{
    const struct pp_style *style = &drawing->style;
    const struct pp_board_map *map = &drawing->map;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    double last = INFINITY, reach = reach_mm(drawing);
    char words[16];
    for (int i = 0; i < ARCS; i++) {
        double radius = map->mm / tan(arcs[i] * PP_RAD);
        if (radius >= reach || last - radius < 2.6 * style->text[PP_TEXT_SMALL])
            continue;
        last = radius;
        snprintf(words, sizeof words, "%d\u00b0", arcs[i]);
        pp_lettering_draw_on_white(drawing->cr, style, &set, map->x0 + radius,
                                   map->y0 - 0.9 * style->text[PP_TEXT_SMALL], words);
    }
    for (int degree = -90; degree <= 90; degree += 10) {
        double out = reach + 1.2 * style->text[PP_TEXT_SMALL];
        snprintf(words, sizeof words, "%d\u00b0", degree < 0 ? -degree : degree);
        pp_lettering_draw(drawing->cr, style, &set,
                          map->x0 + out * sin(degree * PP_RAD),
                          map->y0 - out * cos(degree * PP_RAD), words);
    }
}

static void draw_hidden(const struct indicator_drawing *drawing)
{
    struct pp_board_piece piece = {.hidden = true, .outline = drawing->sheet->hidden};
    const struct pp_board_window window = {.count = 1, .pieces = &piece};
    double reach = reach_mm(drawing);
    struct pp_box within = {drawing->map.x0 - reach, drawing->map.y0 - reach,
                            2.0 * reach, reach};
    cairo_save(drawing->cr);
    trace_half_disc(drawing, reach);
    cairo_close_path(drawing->cr);
    cairo_clip(drawing->cr);
    pp_board_tints(drawing->cr, &drawing->style, &drawing->map, &window, 1, within);
    pp_board_outline(drawing->cr, &drawing->style, &drawing->map, &piece.outline);
    cairo_restore(drawing->cr);
}

static double mark_size(const struct indicator_drawing *drawing)
{
    return fmin(0.8 * drawing->style.scale, 0.075 * drawing->map.mm);
}

/* Draws the cross of a mark: grey if the mark is not counted. */
static void draw_cross(const struct indicator_drawing *drawing, double x, double y,
                       bool counted)
{
    double arm = mark_size(drawing);
    cairo_move_to(drawing->cr, x - arm, y - arm);
    cairo_line_to(drawing->cr, x + arm, y + arm);
    cairo_move_to(drawing->cr, x - arm, y + arm);
    cairo_line_to(drawing->cr, x + arm, y - arm);
    pp_style_line(drawing->cr, drawing->style.medium, counted ? PP_INK : PP_GREY_LINE);
    cairo_stroke(drawing->cr);
}

static void draw_indicator_marks(const struct indicator_drawing *drawing)
{
    const struct pp_skylight_indicator_sheet *sheet = drawing->sheet;
    for (int i = 0; i < PP_SKYLIGHT_RINGS * PP_SKYLIGHT_RAYS; i++) {
        const struct pp_skylight_mark *mark = &sheet->marks[i];
        draw_cross(drawing, pp_board_x(&drawing->map, mark->x),
                   pp_board_y(&drawing->map, mark->y), sheet->blank || mark->counted);
    }
}

static double ratios_height(const struct pp_style *style)
{
    return 1.44 * style->scale + 2.8 * style->text[PP_TEXT_SMALL];
}

/* Draws a scale along the wall: distance divided by height. */
static void draw_ratios(const struct indicator_drawing *drawing)
{
    const struct pp_style *style = &drawing->style;
    const struct pp_board_map *map = &drawing->map;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5};
    double tick = 1.2 * style->scale;
    int most = (int)floor(drawing->sheet->reach);
    for (int i = -most; i <= most; i++) {
        cairo_move_to(drawing->cr, map->x0 + i * map->mm, map->y0);
        cairo_line_to(drawing->cr, map->x0 + i * map->mm, map->y0 + tick);
    }
    pp_style_line(drawing->cr, style->thin, PP_INK);
    cairo_stroke(drawing->cr);
    int step = map->mm > 2.2 * style->text[PP_TEXT_SMALL] ? 1 : 2;
    for (int i = -(most / step) * step; i <= most; i += step) {
        char words[16];
        snprintf(words, sizeof words, "%d", i < 0 ? -i : i);
        pp_lettering_draw(drawing->cr, style, &set, map->x0 + i * map->mm,
                          map->y0 + 1.2 * tick, words);
    }
    pp_lettering_draw(drawing->cr, style, &set, map->x0,
                      map->y0 + 1.2 * tick + 1.4 * style->text[PP_TEXT_SMALL],
                      "distance divided by height above the centre of the window");
}

static void say_indicator_foot(char *foot, size_t room,
                               const struct pp_skylight_indicator_sheet *sheet)
{
    pp_page_say(foot, room,
                "There are %d crosses, each worth %.3f\u00a0%%; the total under an "
                "open sky is %.1f\u00a0%%.",
                PP_SKYLIGHT_RINGS * PP_SKYLIGHT_RAYS, 100.0 * sheet->worth,
                100.0 * sheet->whole);
    pp_page_say(
        foot, room, "%s",
        sheet->blank
            ? "Place the indicator on a site plan with the middle of the straight side "
              "on the window. The top edge of an obstruction hides the crosses beyond "
              "it, between the sight lines to its ends."
            : "Obstructions are drawn at their distance divided by "
              "their height above the centre of the window.");
}

/* Lists, for several usual plan scales, the obstruction height for which the indicator
 * has the scale of the plan. */
static void plan_words(const struct indicator_drawing *drawing, char *words,
                       size_t room)
{
    static const int plans[] = {100, 200, 500, 1000, 1250};
    *words = 0;
    pp_page_say(words, room,
                "A distance-to-height ratio of 1 is drawn as %g\u00a0mm. The indicator "
                "is to scale for obstruction edges",
                drawing->map.mm);
    for (int i = 0; i < 5; i++)
        pp_page_say(words, room, "%.4g\u00a0m%s on a 1:%d plan%s",
                    drawing->map.mm * plans[i] / 1000.0,
                    i == 0 ? " above the centre of the window" : "", plans[i],
                    i < 4 ? "," : ".");
}

static void indicator_titles(const struct pp_skylight_indicator_sheet *sheet,
                             char *title, char *subtitle, size_t room)
{
    char sky[96];
    pp_page_sky_words(sky, sizeof sky, &sheet->sky, 0.0);
    snprintf(title, room, "%s", sheet->name ? sheet->name : "Skylight indicator");
    if (sheet->blank)
        snprintf(subtitle, room,
                 "Vertical sky component of a window from the site plan, %s", sky);
    else
        snprintf(subtitle, room,
                 "Skylight indicator for the window %s, centre of its outer face "
                 "x\u00a0%.2f, y\u00a0%.2f, z\u00a0%.2f\u00a0m, %s",
                 sheet->label, sheet->middle.x, sheet->middle.y, sheet->middle.z, sky);
}

/* Draws the sum and the scales. If `drawn` is false, only measures. Returns the
 * height. */
static double draw_words(const struct indicator_drawing *drawing, struct pp_box room,
                         bool drawn)
{
    const struct pp_skylight_indicator_sheet *sheet = drawing->sheet;
    char sum[160] = "", scales[320];
    if (!sheet->blank)
        snprintf(sum, sizeof sum,
                 "%d crosses on the sky \u00d7 %.3f\u00a0%% = vertical sky component "
                 "%.1f\u00a0%%",
                 sheet->counted, 100.0 * sheet->worth, 100.0 * sheet->sky_component);
    plan_words(drawing, scales, sizeof scales);
    struct pp_lettering set = {.size = PP_TEXT_BODY, .width = room.width};
    double height = 0.0;
    for (int i = 0; i < 2; i++) {
        const char *words = i ? scales : sum;
        set.bold = i == 0;
        if (!*words)
            continue;
        height +=
            (drawn ? pp_lettering_draw : pp_lettering_measure)(
                drawing->cr, &drawing->style, &set, room.x, room.y + height, words)
                .height
            + drawing->style.scale;
    }
    return height;
}

/* Largest round length (mm) of one unit at which a half disc with a radius of `reach`
 * units fits. */
static double choose_unit(double reach, double width, double height)
{
    double most = fmin(0.5 * width, height) / reach;
    double step = most >= 10.0 ? 5.0 : 1.0;
    return step * floor(most / step);
}

enum pp_status pp_skylight_indicator_chart_draw(
    struct pp_canvas *canvas, const struct pp_skylight_indicator_sheet *sheet,
    struct pp_error *err)
{
    (void)err;
    struct indicator_drawing drawing = {.cr = pp_canvas_cairo(canvas),
                                        .style = pp_page_style(canvas),
                                        .sheet = sheet,
                                        .map = {.mm = 99.0}};
    const struct pp_style *style = &drawing.style;
    char title[512], subtitle[512], foot[1024] = "";
    indicator_titles(sheet, title, subtitle, sizeof title);
    say_indicator_foot(foot, sizeof foot, sheet);
    const struct pp_page page = {title, subtitle, foot};
    struct pp_box body = pp_page_draw(canvas, style, &page);

    double border = 2.4 * style->text[PP_TEXT_SMALL];
    double words = draw_words(&drawing, body, false);
    double below = ratios_height(style) + 2.0 * style->scale + words;
    drawing.map.mm = choose_unit(sheet->reach, body.width - 2.0 * border,
                                 body.height - border - below);
    double height = border + reach_mm(&drawing) + below;
    double top = body.y + 0.5 * (body.height - height);
    drawing.map.x0 = body.x + 0.5 * body.width;
    drawing.map.y0 = top + border + reach_mm(&drawing);
    draw_hidden(&drawing);
    draw_net(&drawing);
    label_net(&drawing);
    draw_indicator_marks(&drawing);
    draw_ratios(&drawing);
    body.y = top + height - words;
    draw_words(&drawing, body, true);
    return PP_OK;
}
