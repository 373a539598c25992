/* pepper_pot_chart.c - the sheet of a pepper-pot diagram: viewing distance, panels side
 * by side, the sum and rulers below the panels, and the text. */
#include "charts/drawing_board/pepper_pot_chart.h"

#include <math.h>
#include <stdio.h>

#include "charts/drawing_board/board.h"
#include "charts/drawing_board/pepper_pot_plot.h"
#include "charts/sheet/lettering.h"
#include "charts/sheet/page.h"

/* ---- ruler, scale bar, and metres at the distances of the windows ---- */

enum { RULERS_MOST = 6 };

/* Distances for which the length of a metre is drawn: those of the windows, or common
 * ones on a blank form. */
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

/* Draws the apparent length of a metre in planes at several distances. */
static void draw_metres(const struct pp_pepper_pot_drawing *drawing, double x, double y,
                        double width)
{
    const struct pp_style *style = &drawing->style;
    double distances[RULERS_MOST];
    int count = ruler_distances(drawing->sheet, distances);
    double label = 20.0 * style->scale, end = 15.0 * style->scale;
    const struct pp_lettering head = {.size = PP_TEXT_SMALL, .bold = true};
    pp_lettering_draw(drawing->cr, style, &head, x, y,
                      "Metres in the plane of the window");
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
        double part = metre <= room ? 1.0 : 0.1; /* too near for a whole metre:
                                                  * tenths */
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

static void viewing_words(const struct pp_pepper_pot_drawing *drawing, char *words,
                          size_t room)
{
    static const int scales[] = {20, 50, 100, 200};
    *words = 0;
    pp_page_say(
        words, room,
        "Viewing distance %.4g\u00a0mm: a length of 1\u00a0m at a distance of "
        "d\u00a0metres is drawn %.4g\u00a0mm\u00a0\u00f7\u00a0d long. An elevation "
        "laid under the sheet fits if it is drawn at the scale for its distance:",
        drawing->viewing, drawing->viewing);
    for (int i = 0; i < 4; i++) {
        char metres[32];
        pp_style_metres(metres, sizeof metres, drawing->viewing * scales[i] / 1000.0);
        pp_page_say(words, room, "1:%d for %s%s", scales[i], metres, i < 3 ? "," : ".");
    }
}

/* Draws all rulers into `room`. If `drawn` is false, only measures. Returns the
 * height. */
static double draw_rulers(const struct pp_pepper_pot_drawing *drawing,
                          struct pp_box room, bool drawn)
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

/* ---- the sheet ---- */

/* Draws the keys of the tints, and the sum. If `drawn` is false, only measures. Returns
 * the height. */
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
                "Each dot is worth a daylight factor of %.3g\u00a0%%. The outermost "
                "dots are outside the frame.",
                100.0 * sheet->worth);
    if (!sheet->blank)
        pp_page_say(foot, room,
                    "Count all dots inside a window, wherever it is on the sheet.");
    pp_page_say(foot, room,
                "The drawing is in true perspective %s. No row of dots runs along an "
                "edge. After Pleijel, 1954.",
                sheet->any ? "in the plane of each window" : "of vertical windows");
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

/* Default viewing distance (mm). Dots of lower value are closer together and need a
 * larger drawing. */
static double default_viewing(const struct pp_pepper_pot_sheet *sheet)
{
    return sheet->worth < 0.0005 ? 60.0 : 30.0;
}

/* Chooses the largest of the usual viewing distances (mm), at most the default, at
 * which all windows fit into frames of that size. */
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
    double rulers = draw_rulers(&drawing, body, false);
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
    draw_rulers(&drawing, (struct pp_box){body.x, bottom - rulers, body.width, rulers},
                true);
    return PP_OK;
}
