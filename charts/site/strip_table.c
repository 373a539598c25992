/* strip_table.c - see strip_table.h. */
#include "charts/site/strip_table.h"

#include <math.h>
#include <stdio.h>

#include "charts/site/sky_bands.h"

/* Widths of the columns for one window, mm. */
struct table_widths {
    double window, room, figure, gap;
    int figures; /* number of columns of values */
};

static double text_mm(const struct pp_site_drawing *drawing, const char *words)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .bold = true};
    return pp_lettering_measure(drawing->cr, &drawing->style, &set, 0.0, 0.0, words)
        .width;
}

static struct table_widths widths_of(const struct pp_site_drawing *drawing)
{
    const struct pp_site_sheet *sheet = drawing->sheet;
    double unit = drawing->style.scale;
    struct table_widths widths = {.window = text_mm(drawing, "Window"),
                                  .room = text_mm(drawing, "Room"),
                                  .figure = text_mm(drawing, "proposed"),
                                  .gap = 2.0 * unit,
                                  .figures = sheet->has_before ? 2 : 1};
    for (int i = 0; i < sheet->window_count; i++) {
        widths.window = fmax(widths.window, text_mm(drawing, sheet->windows[i].label));
        if (sheet->windows[i].room)
            widths.room = fmax(widths.room, text_mm(drawing, sheet->windows[i].room));
    }
    widths.room = fmin(widths.room, 32.0 * unit);
    return widths;
}

static double column_mm(const struct table_widths *widths)
{
    return widths->window + widths->room + widths->figures * widths->figure
           + (3 + widths->figures) * widths->gap;
}

static double row_mm(const struct pp_style *style)
{
    return 1.35 * style->text[PP_TEXT_SMALL];
}

/* Number of windows that fit below the head of one column of that height; at least
 * 1. */
static int rows_in(const struct pp_site_drawing *drawing, double height)
{
    int rows = (int)(height / row_mm(&drawing->style)) - 1;
    return rows > 1 ? rows : 1;
}

struct pp_box pp_strip_table_size(const struct pp_site_drawing *drawing, double height)
{
    const struct table_widths widths = widths_of(drawing);
    int count = drawing->sheet->window_count, most = rows_in(drawing, height);
    int columns = (count + most - 1) / most;
    int rows = columns ? (count + columns - 1) / columns : 0;
    return (struct pp_box){.width = columns * column_mm(&widths),
                           .height = (rows + 1) * row_mm(&drawing->style)};
}

/* Writes one row: names of window and room on the left, values on the right. */
static void write_row(const struct pp_site_drawing *drawing,
                      const struct table_widths *widths, double x, double y, bool bold,
                      const char *window, const char *room,
                      const char *const figures[2])
{
    struct pp_lettering set = {.size = PP_TEXT_SMALL, .bold = bold};
    pp_lettering_draw(drawing->cr, &drawing->style, &set, x, y, window);
    x += widths->window + widths->gap;
    set.width = widths->room + 0.5;
    set.lines = 1;
    if (room && widths->room > 0.0)
        pp_lettering_draw(drawing->cr, &drawing->style, &set, x, y, room);
    x += widths->room + widths->gap;
    set.width = 0.0;
    set.across = 1.0;
    for (int i = 2 - widths->figures; i < 2; i++) {
        x += widths->figure;
        pp_lettering_draw(drawing->cr, &drawing->style, &set, x, y, figures[i]);
        x += widths->gap;
    }
}

void pp_strip_table_draw(const struct pp_site_drawing *drawing, struct pp_box box)
{
    const struct pp_site_sheet *sheet = drawing->sheet;
    const struct table_widths widths = widths_of(drawing);
    const char *const heads[2] = {"existing",
                                  sheet->has_before ? "proposed" : "VSC\u00a0%"};
    double row = row_mm(&drawing->style), wide = column_mm(&widths);
    int rows = rows_in(drawing, box.height + 0.01);
    for (int i = 0; i < sheet->window_count; i++) {
        const struct pp_site_window *window = &sheet->windows[i];
        char former[16] = "", now[16];
        double x = box.x + i / rows * wide, y = box.y + (1 + i % rows) * row;
        if (i % rows == 0) {
            write_row(drawing, &widths, x, box.y, false, "Window", "Room", heads);
            pp_style_line(drawing->cr, drawing->style.hair, PP_INK);
            cairo_move_to(drawing->cr, x, y - 0.1 * row);
            cairo_line_to(drawing->cr, x + wide - 2.0 * widths.gap, y - 0.1 * row);
            cairo_stroke(drawing->cr);
        }
        if (isfinite(window->before))
            snprintf(former, sizeof former, "%.1f", 100.0 * window->before);
        snprintf(now, sizeof now, "%.1f", 100.0 * window->component);
        write_row(drawing, &widths, x, y, pp_sky_bands_is_lost(window), window->label,
                  window->room, (const char *const[2]){former, now});
    }
}
