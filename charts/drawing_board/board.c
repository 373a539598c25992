/* board.c - tints, hatching, sums and ruler shared by the diagrams of the drawing
 * board. */
#include "charts/drawing_board/board.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/sheet/hatch.h"
#include "charts/sheet/page.h"
#include "model/base/text.h"

/* Maximum number of windows whose sums are listed. */
enum { SUMS_MOST = 8 };

/* Grey level (0 black, 1 white) of shapes that hide the sky. */
static const double hidden_grey = 0.72;

/* Adds the outline of a region to the path. */
static void trace_region(cairo_t *cr, const struct pp_board_map *map,
                         const struct pp_region *region)
{
    for (int r = 0; r < region->count; r++) {
        const struct pp_ring *ring = &region->rings[r];
        for (int i = 0; i < ring->count; i++) {
            double x = pp_board_x(map, ring->xy[i][0]);
            double y = pp_board_y(map, ring->xy[i][1]);
            if (i == 0)
                cairo_move_to(cr, x, y);
            else
                cairo_line_to(cr, x, y);
        }
        if (ring->count)
            cairo_close_path(cr);
    }
}

static void fill_path(cairo_t *cr, const struct pp_style *style, bool hidden,
                      struct pp_box within)
{
    cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
    pp_style_grey(cr, hidden ? hidden_grey : PP_GREY_FILL);
    if (!hidden) {
        cairo_fill(cr);
        return;
    }
    cairo_fill_preserve(cr);
    pp_hatch_path(cr, within, 1.6 / sqrt(2.0) * style->scale, style->hair, 0.4);
}

void pp_board_tints(cairo_t *cr, const struct pp_style *style,
                    const struct pp_board_map *map,
                    const struct pp_board_window *windows, int count,
                    struct pp_box within)
{
    for (int w = 0; w < count; w++)
        for (int p = 0; p < windows[w].count; p++) {
            const struct pp_board_piece *piece = &windows[w].pieces[p];
            trace_region(cr, map, &piece->outline);
            fill_path(cr, style, piece->hidden, within);
        }
}

void pp_board_outline(cairo_t *cr, const struct pp_style *style,
                      const struct pp_board_map *map, const struct pp_region *region)
{
    trace_region(cr, map, region);
    pp_style_line(cr, style->medium, PP_INK);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(cr);
}

struct pp_box pp_board_tint_keys(cairo_t *cr, const struct pp_style *style, double x,
                                 double y, bool hidden_too, bool drawn)
{
    static const char *const words[] = {"sky", "obstruction"};
    const struct pp_lettering set = {.size = PP_TEXT_BODY};
    double width = 7.0 * style->scale, gap = 1.5 * style->scale, at = x, height = 0.0;
    for (int i = 0; i < 1 + hidden_too; i++) {
        double left = at + width + gap;
        struct pp_box box = pp_lettering_measure(cr, style, &set, left, y, words[i]);
        struct pp_box sample = {at, y + 0.15 * box.height, width, 0.7 * box.height};
        if (drawn) {
            pp_lettering_draw(cr, style, &set, left, y, words[i]);
            cairo_rectangle(cr, sample.x, sample.y, sample.width, sample.height);
            fill_path(cr, style, i == 1, sample);
            cairo_rectangle(cr, sample.x, sample.y, sample.width, sample.height);
            pp_style_line(cr, style->thin, PP_INK);
            cairo_stroke(cr);
        }
        height = box.height;
        at = left + box.width + 4.0 * gap;
    }
    return (struct pp_box){x, y, at - x, height};
}

const char *pp_board_letter(int index)
{
    static const char *const letters[] = {"A", "B", "C", "D", "E", "F", "G", "H", "I",
                                          "J", "K", "L", "M", "N", "O", "P", "Q", "R",
                                          "S", "T", "U", "V", "W", "X", "Y", "Z"};
    return letters[index % 26];
}

void pp_board_panel_words(char *words, size_t room, const struct pp_board_face *face,
                          bool glazed)
{
    *words = 0;
    if (face->name || face->overhead)
        pp_page_say(words, room, "%s%s%s:", face->overhead ? "Ceiling" : "Wall",
                    face->name ? " " : "", face->name ? face->name : "");
    pp_page_say(words, room, "%s,",
                glazed ? "with clear single glass" : "without glass");
}

/* Writes a count with at most one decimal: "12", "12.3". */
static void write_count(char *text, size_t room, double count)
{
    snprintf(text, room, count == rint(count) ? "%.0f" : "%.1f", count);
}

/* Sum of the counts of all pieces of the same kind as piece `first`: alike in `hidden`
 * and `factor`. 0 if an earlier piece is of that kind. */
static double like(const struct pp_board_window *window, int first)
{
    const struct pp_board_piece *pieces = window->pieces;
    double sum = 0.0;
    for (int i = 0; i < window->count; i++) {
        if (pieces[i].hidden != pieces[first].hidden
            || pieces[i].factor != pieces[first].factor)
            continue;
        if (i < first)
            return 0.0;
        sum += pieces[i].counted;
    }
    return sum;
}

static void say_window(struct pp_board_sums *sums, const struct pp_board_window *window)
{
    char *text = sums->text;
    const size_t room = sizeof sums->text;
    bool any = false;
    pp_page_say(text, room, "%s, window %s:", pp_board_letter(sums->windows),
                window->label);
    for (int i = 0; i < window->count; i++) {
        double sum = like(window, i);
        if (sum == 0.0)
            continue;
        const struct pp_board_piece *piece = &window->pieces[i];
        char number[32], factor[32] = "";
        write_count(number, sizeof number, sum);
        if (piece->hidden)
            snprintf(factor, sizeof factor, " \u00d7 %.3g", piece->factor);
        pp_page_say(text, room, "%s%s %s on %s%s \u00d7 %.4g\u00a0%% = %.2f\u00a0%%,",
                    any ? "and " : "", number, sums->unit,
                    piece->hidden ? "an obstruction" : "the sky", factor,
                    100.0 * sums->worth, 100.0 * sum * piece->factor * sums->worth);
        any = true;
    }
    if (!any)
        pp_page_say(text, room, "no %s.", sums->unit);
    else if (window->allowance != 1.0)
        pp_page_say(text, room,
                    "all \u00d7 %.3g for the glass, frame and dirt of the window.",
                    window->allowance);
    else
        text[strlen(text) - 1] = '.';
}

void pp_board_sums_add(struct pp_board_sums *sums,
                       const struct pp_board_window *windows, int count)
{
    for (int i = 0; i < count; i++, sums->windows++) {
        if (sums->windows >= SUMS_MOST)
            continue;
        if (sums->windows > 0)
            pp_text_append(sums->text, sizeof sums->text, "\n");
        say_window(sums, &windows[i]);
    }
    pp_board_sheets_windows_add(windows, count, &sums->sky, &sums->external);
    sums->any_hidden =
        sums->any_hidden || pp_board_sheets_windows_hidden(windows, count);
}

double pp_board_sums_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_board_sums *sums, double x, double y,
                          double width, bool drawn)
{
    char text[sizeof sums->text + 64], total[256] = "";
    snprintf(text, sizeof text, "%s", sums->text);
    if (sums->windows > SUMS_MOST)
        pp_page_say(text, sizeof text,
                    "Read the remaining windows (%d) in the same way.",
                    sums->windows - SUMS_MOST);
    if (sums->upright)
        pp_page_say(total, sizeof total, "Vertical sky component %.1f\u00a0%%.",
                    100.0 * sums->sky);
    else
        pp_page_say(total, sizeof total,
                    "Sky component %.2f\u00a0%%, externally reflected component "
                    "%.2f\u00a0%%, together %.2f\u00a0%%.",
                    100.0 * sums->sky, 100.0 * sums->external,
                    100.0 * (sums->sky + sums->external));
    struct pp_lettering set = {.size = PP_TEXT_BODY, .width = width};
    double height = 0.0;
    for (int i = 0; i < 2; i++) {
        const char *words = i ? total : text;
        set.bold = i == 1;
        if (drawn)
            pp_lettering_draw(cr, style, &set, x, y + height, words);
        height += pp_lettering_measure(cr, style, &set, x, y + height, words).height;
    }
    return height;
}

double pp_board_ruler_height(const struct pp_style *style)
{
    return 3.2 * style->scale + 1.3 * style->text[PP_TEXT_SMALL];
}

struct pp_box pp_board_ruler(cairo_t *cr, const struct pp_style *style, double x,
                             double y)
{
    double bottom = y + pp_board_ruler_height(style);
    pp_style_line(cr, style->thin, PP_INK);
    cairo_move_to(cr, x, bottom);
    cairo_line_to(cr, x + 100.0, bottom);
    for (int mm = 0; mm <= 100; mm++) {
        double length = mm % 10 == 0 ? 2.8 : mm % 5 == 0 ? 2.0 : 1.2;
        cairo_move_to(cr, x + mm, bottom);
        cairo_line_to(cr, x + mm, bottom - length * style->scale);
    }
    cairo_stroke(cr);
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5};
    for (int mm = 0; mm <= 100; mm += 20) {
        char words[16];
        snprintf(words, sizeof words, mm == 100 ? "%d\u00a0mm" : "%d", mm);
        pp_lettering_draw(cr, style, &set, x + mm, y, words);
    }
    const struct pp_lettering note = {.size = PP_TEXT_SMALL, .down = 1.0};
    struct pp_box said =
        pp_lettering_draw(cr, style, &note, x + 100.0 + 3.0 * style->scale, bottom,
                          "print at 100\u00a0%");
    return (struct pp_box){x, y, said.x + said.width - x, bottom - y};
}
