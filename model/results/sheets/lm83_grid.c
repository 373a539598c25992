/* lm83_grid.c - see lm83_grid.h. */
#include "model/results/sheets/lm83_grid.h"

#include <math.h>
#include <stdbool.h>

#include "model/base/text.h"
#include "model/results/sheets/point_areas.h"

static const double HEIGHT_M = 0.76, SPACING_M = 0.6;

/* A plane at 0.75 m, as in other standards, counts as one at 0.76 m. */
static const double SAME_HEIGHT_M = 0.02;

/* Fraction of the plane that the points represent, from which nothing is left out
 * except in corners of furniture. */
static const double NEARLY_ALL = 0.98;

/* Greatest distance between neighbours of a grid. Points are listed by rows: along x, or
 * to the next row. */
static double spacing_of(const struct pp_annual_sheet *sheet)
{
    double step[2] = {INFINITY, INFINITY};
    for (int i = 1; i < sheet->receiver_count; i++) {
        struct pp_vec3 by =
            pp_vec_sub(sheet->receivers[i].position, sheet->receivers[i - 1].position);
        if (by.x > 1e-6 && fabs(by.y) < 1e-6)
            step[0] = fmin(step[0], by.x);
        if (by.y > 1e-6)
            step[1] = fmin(step[1], by.y);
    }
    return fmax(isfinite(step[0]) ? step[0] : 0.0, isfinite(step[1]) ? step[1] : 0.0);
}

void pp_lm83_grid_words(char words[PP_LM83_GRID_WORDS],
                        const struct pp_annual_sheet *sheet)
{
    words[0] = '\0';
    if (!sheet->is_grid || !sheet->world || !sheet->receivers)
        return;
    double height_m = sheet->receivers[0].position.z, spacing_m = spacing_of(sheet);
    double area_m2 = pp_point_areas_sum(sheet->receivers, sheet->receiver_count);
    double plane_m2 = pp_region_area(&sheet->world->plane);
    bool high = fabs(height_m - HEIGHT_M) > SAME_HEIGHT_M;
    bool wide = spacing_m > SPACING_M + 0.005;
    bool less = area_m2 < NEARLY_ALL * plane_m2;
    if (!high && !wide && !less)
        return;
    pp_text_append(words, PP_LM83_GRID_WORDS, "the grid is not that of LM-83");
    if (high)
        pp_text_append(words, PP_LM83_GRID_WORDS,
                       ": %.2f m above the floor instead of %.2f m", height_m,
                       HEIGHT_M);
    if (wide)
        pp_text_append(words, PP_LM83_GRID_WORDS, "%s points %.2f m apart, not %.1f m",
                       high ? "," : ":", spacing_m, SPACING_M);
    if (less)
        pp_text_append(words, PP_LM83_GRID_WORDS,
                       "%s only %.3g of the %.3g m2 of the plane",
                       high || wide ? "," : ":", area_m2, plane_m2);
    pp_text_append(words, PP_LM83_GRID_WORDS,
                   "; use <working-plane height=\"0.76\"/> and <grid spacing=\"0.5\" "
                   "margin=\"0\"/>");
}
