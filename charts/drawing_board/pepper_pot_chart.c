/* pepper_pot_chart.c - the sheet of a pepper-pot diagram: its viewing distance, its panels
 * side by side, the sum and rulers below them, its words.
 */
#include "charts/drawing_board/pepper_pot_chart.h"

#include <math.h>
#include <stdio.h>

#include "charts/drawing_board/board.h"
#include "charts/drawing_board/pepper_pot_plot.h"
#include "charts/drawing_board/pepper_pot_rulers.h"
#include "charts/sheet/page.h"

/* The tints' keys and the sum; drawn only if `drawn`. Returns their height. */
static double draw_sums(const struct pp_pepper_pot_drawing *drawing, struct pp_box room,
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

static void say_pepper_pot_foot(char *foot, size_t room,
                                const struct pp_pepper_pot_sheet *sheet)
{
    pp_page_say(foot, room,
                "Each dot is worth %.3g\u00a0%% daylight factor; the outermost are "
                "beyond the frame.",
                100.0 * sheet->worth);
    if (!sheet->blank)
        pp_page_say(foot, room, "Dots in a window count wherever it reaches.");
    pp_page_say(foot, room,
                "True perspective %s; no row of dots runs along an edge. After "
                "Pleijel, 1954.",
                sheet->any ? "on each window's own plane" : "of vertical windows");
}

static void pepper_pot_titles(const struct pp_pepper_pot_drawing *drawing, char *title,
                              char *subtitle, size_t room)
{
    const struct pp_pepper_pot_sheet *sheet = drawing->sheet;
    char sky[96];
    pp_page_sky_words(sky, sizeof sky, &sheet->sky, 0.0);
    const char *plane = sheet->upright  ? "vertical plane"
                        : sheet->aslant ? "sloping plane"
                                        : "horizontal plane";
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
        struct pp_bounds2 extent = pp_pepper_pot_plot_extent(&sheet->panels[i]);
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
    struct pp_pepper_pot_drawing drawing = {
        .cr = pp_canvas_cairo(canvas),
        .style = pp_page_style(canvas),
        .sheet = sheet,
        .viewing = viewing_mm > 0.0 ? viewing_mm : default_viewing(sheet)};
    char title[512], subtitle[512], foot[2048] = "";
    pepper_pot_titles(&drawing, title, subtitle, sizeof title);
    say_pepper_pot_foot(foot, sizeof foot, sheet);
    const struct pp_page page = {title, subtitle, foot};
    struct pp_box body = pp_page_draw(canvas, &drawing.style, &page);

    double gap = 3.0 * drawing.style.scale;
    double rulers = pp_pepper_pot_rulers_draw(&drawing, body, false);
    double sums = draw_sums(&drawing, body, false);
    int columns = (int)ceil(sqrt(sheet->count));
    int rows = (sheet->count + columns - 1) / columns;
    double width = body.width / columns;
    double height = (body.height - rulers - sums) / rows;
    struct pp_box frame = pp_pepper_pot_plot_frame(
        &drawing, (struct pp_box){0.0, 0.0, width, height - gap});
    if (viewing_mm <= 0.0)
        drawing.viewing = choose_viewing(sheet, frame.width, frame.height);
    int first = 0;
    for (int i = 0; i < sheet->count; i++) {
        struct pp_box room = {body.x + i % columns * width,
                              body.y + i / columns * height, width, height - gap};
        pp_pepper_pot_plot_draw(&drawing, &sheet->panels[i], first, room);
        first += sheet->panels[i].count;
    }
    double bottom = body.y + body.height;
    draw_sums(&drawing,
              (struct pp_box){body.x, bottom - rulers - sums, body.width, sums}, true);
    pp_pepper_pot_rulers_draw(
        &drawing, (struct pp_box){body.x, bottom - rulers, body.width, rulers}, true);
    return PP_OK;
}
