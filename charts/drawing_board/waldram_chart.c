/* waldram_chart.c - the sheet of a Waldram diagram: text above, panels side by side,
 * keys, and the sum below the panels. */
#include "charts/drawing_board/waldram_chart.h"

#include <math.h>
#include <stdio.h>

#include "charts/drawing_board/board.h"
#include "charts/drawing_board/waldram_plot.h"
#include "charts/sheet/legend.h"
#include "charts/sheet/page.h"

static void say_waldram_foot(char *foot, size_t room,
                             const struct pp_waldram_sheet *sheet)
{
    pp_page_say(foot, room, "Each square is worth a %s of %.3g\u00a0%%.",
                sheet->upright ? "vertical sky component" : "daylight factor",
                100.0 * sheet->worth);
    bool glazed = false;
    for (int i = 0; i < sheet->count; i++)
        glazed = glazed || sheet->panels[i].glazed;
    if (glazed)
        pp_page_say(
            foot, room,
            "The diagram includes the transmission of one clear pane in a vertical "
            "window: a factor for the altitude times a factor for the azimuth.");
    if (sheet->inclined)
        pp_page_say(foot, room,
                    "Each droop line begins at the altitude of its edge: in the "
                    "middle for edges parallel to the window, and %.4g\u00b0 to the "
                    "%s for inclined edges, at their nearest point.",
                    fabs(sheet->incline_rad) / PP_RAD,
                    sheet->incline_rad < 0.0 ? "left" : "right");
    else
        pp_page_say(
            foot, room,
            "Each droop line begins at the altitude of its edge: in the middle for "
            "edges parallel to the window, and at 90\u00b0 for perpendicular edges.");
    if (!sheet->blank)
        pp_page_say(foot, room,
                    "Estimate part squares to a tenth, and carry the rounding "
                    "remainder over to the next square.");
    if (sheet->upright)
        pp_page_say(foot, room,
                    "Horizontal scale: sine of the azimuth. Vertical scale: integral "
                    "of the sky luminance times cos\u00b2 of the altitude. 270 squares "
                    "are 27\u00a0%%.");
    pp_page_say(foot, room, "After Waldram and Waldram, 1923.");
}

/* Draws keys and sum below the panels. If `drawn` is false, only measures. Returns the
 * height. */
static double draw_below(const struct pp_waldram_drawing *drawing, double x, double y,
                         double width, bool drawn)
{
    const struct pp_waldram_sheet *sheet = drawing->sheet;
    const struct pp_style *style = &drawing->style;
    struct pp_key keys[] = {
        {.kind = PP_KEY_LINE,
         .curve = pp_waldram_plot_droop_style(style, false),
         .grey = PP_INK,
         .words = "horizontal edges parallel to the window"},
        {.kind = PP_KEY_LINE,
         .curve = pp_waldram_plot_droop_style(style, true),
         .grey = PP_INK,
         .words = "horizontal edges perpendicular to the window"},
    };
    if (sheet->inclined)
        snprintf(keys[1].words, sizeof keys[1].words,
                 "horizontal edges inclined by %.4g\u00b0 in plan",
                 fabs(sheet->incline_rad) / PP_RAD);
    double column = 0.5 * width, gap = 2.0 * style->scale;
    struct pp_box left = (drawn ? pp_legend_draw : pp_legend_measure)(
        drawing->cr, style, keys, 2, x, y, column - gap);
    cairo_set_dash(drawing->cr, NULL, 0, 0.0);
    if (sheet->blank)
        return left.height;
    struct pp_board_sums sums = {
        .unit = "squares", .upright = sheet->upright, .worth = sheet->worth};
    for (int i = 0; i < sheet->count; i++)
        pp_board_sums_add(&sums, sheet->panels[i].windows, sheet->panels[i].count);
    pp_board_tint_keys(drawing->cr, style, x + column, y, sums.any_hidden, drawn);
    double above = left.height + gap;
    return above
           + pp_board_sums_draw(drawing->cr, style, &sums, x, y + above, width, drawn);
}

static void upright_titles(const struct pp_waldram_sheet *sheet, const char *sky,
                           char *title, char *subtitle, size_t room)
{
    snprintf(title, room, "%s",
             sheet->name ? sheet->name : "Waldram diagram of a vertical receiver");
    if (sheet->blank)
        snprintf(subtitle, room, "Vertical sky component, %s", sky);
    else
        snprintf(subtitle, room,
                 "Vertical sky component of the window %s, %s of its outer "
                 "face x\u00a0%.2f, y\u00a0%.2f, z\u00a0%.2f\u00a0m, %s",
                 sheet->panels->windows->label, sheet->off_middle ? "point" : "centre",
                 sheet->point.x, sheet->point.y, sheet->point.z, sky);
}

static void waldram_titles(const struct pp_waldram_sheet *sheet, char *title,
                           char *subtitle, size_t room)
{
    char sky[96];
    pp_page_sky_words(sky, sizeof sky, &sheet->sky, 0.0);
    if (sheet->upright) {
        upright_titles(sheet, sky, title, subtitle, room);
        return;
    }
    if (sheet->blank) {
        snprintf(title, room, "Waldram diagram");
        snprintf(subtitle, room, "Sky component of vertical windows, %s", sky);
        return;
    }
    snprintf(title, room, "%s", sheet->name ? sheet->name : "Waldram diagram");
    snprintf(subtitle, room,
             "Waldram diagram from x\u00a0%.2f, y\u00a0%.2f, z\u00a0%.2f\u00a0m, %s",
             sheet->point.x, sheet->point.y, sheet->point.z, sky);
}

/* Number of panel columns at which the squares of the diagrams are largest. */
static int choose_columns(const struct pp_waldram_drawing *drawing, struct pp_box body,
                          double gap)
{
    const struct pp_waldram_sheet *sheet = drawing->sheet;
    int best = 1;
    double best_mm = -INFINITY;
    for (int columns = 1; columns <= sheet->count; columns++) {
        int rows = (sheet->count + columns - 1) / columns;
        double mm = INFINITY;
        for (int i = 0; i < sheet->count; i++)
            mm = fmin(mm, pp_waldram_plot_square(drawing, &sheet->panels[i],
                                                 body.width / columns,
                                                 body.height / rows - gap));
        if (mm > best_mm) {
            best_mm = mm;
            best = columns;
        }
    }
    return best;
}

enum pp_status pp_waldram_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_waldram_sheet *sheet,
                                     struct pp_error *err)
{
    (void)err;
    const struct pp_waldram_drawing drawing = {
        .cr = pp_canvas_cairo(canvas), .style = pp_page_style(canvas), .sheet = sheet};
    char title[512], subtitle[512], foot[2048] = "";
    waldram_titles(sheet, title, subtitle, sizeof title);
    say_waldram_foot(foot, sizeof foot, sheet);
    const struct pp_page page = {title, subtitle, foot};
    struct pp_box body = pp_page_draw(canvas, &drawing.style, &page);

    double gap = 3.0 * drawing.style.scale;
    double below = draw_below(&drawing, body.x, body.y, body.width, false);
    body.height -= below;
    int columns = choose_columns(&drawing, body, gap);
    int rows = (sheet->count + columns - 1) / columns, first = 0;
    double width = body.width / columns, height = body.height / rows;
    for (int i = 0; i < sheet->count; i++) {
        pp_waldram_plot_draw(&drawing, &sheet->panels[i], first,
                             (struct pp_box){body.x + i % columns * width,
                                             body.y + i / columns * height, width,
                                             height - gap});
        first += sheet->panels[i].count;
    }
    draw_below(&drawing, body.x, body.y + body.height, body.width, true);
    return PP_OK;
}
