/* title_block.c - see title_block.h. */
#include "charts/sheet/title_block.h"

#include <math.h>

#include "charts/sheet/lettering.h"

/* Least width of a cell (mm, on A4). */
static const double cell_least_mm = 26.0;

double pp_title_block_draw(cairo_t *cr, const struct pp_style *style,
                           const struct pp_project *project, double x, double bottom,
                           double width, bool drawn)
{
    int count = 0, cell = 0;
    for (int i = 0; i < PP_PROJECT_FACTS; i++)
        count += pp_project_at(project, i) != NULL;
    if (count == 0)
        return 0.0;
    int most = (int)fmax(width / (cell_least_mm * style->scale), 1.0);
    int rows = (count + most - 1) / most, columns = (count + rows - 1) / rows;
    double gap = 0.8 * style->scale, wide = width / columns;
    double high =
        1.3 * (style->text[PP_TEXT_SMALL] + style->text[PP_TEXT_BODY]) + 2.0 * gap;
    for (int i = 0; i < PP_PROJECT_FACTS && drawn; i++) {
        const char *value = pp_project_at(project, i);
        if (!value)
            continue;
        double left = x + cell % columns * wide,
               top = bottom - (rows - cell / columns) * high;
        /* The last cell of the last row fills the rest of the row. */
        double right = cell == count - 1 ? x + width : left + wide;
        const struct pp_lettering label = {.size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT};
        const struct pp_lettering fact = {
            .size = PP_TEXT_BODY, .width = right - left - 2.0 * gap, .lines = 1};
        pp_style_line(cr, style->thin, PP_INK);
        cairo_new_path(cr);
        cairo_rectangle(cr, left, top, right - left, high);
        cairo_stroke(cr);
        pp_lettering_draw(cr, style, &label, left + gap, top + gap,
                          pp_project_facts[i].label);
        pp_lettering_draw(cr, style, &fact, left + gap,
                          top + gap + 1.3 * style->text[PP_TEXT_SMALL], value);
        cell++;
    }
    return rows * high;
}
