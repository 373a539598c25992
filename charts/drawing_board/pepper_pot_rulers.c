/* pepper_pot_rulers.c - the ruler of a pepper-pot diagram, and metres as they look in
 * planes at several distances. */
#include "charts/drawing_board/pepper_pot_rulers.h"

#include <math.h>
#include <stdio.h>

#include "charts/drawing_board/board.h"
#include "charts/sheet/lettering.h"
#include "charts/sheet/page.h"

enum { RULERS_MOST = 6 };

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
static void draw_metres(const struct pp_pepper_pot_drawing *drawing, double x, double y,
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

static void viewing_words(const struct pp_pepper_pot_drawing *drawing, char *words,
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

double pp_pepper_pot_rulers_draw(const struct pp_pepper_pot_drawing *drawing,
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
