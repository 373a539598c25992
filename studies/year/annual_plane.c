/* annual_plane.c - means over the plane, and fractions of the plane. Points of a grid
 * count by the area that they represent; other points count equally. */
#include "studies/year/annual_plane.h"

#include <math.h>
#include <stdlib.h>

#include "model/results/sheets/point_areas.h"
#include "studies/year/year_metrics.h"

/* The figures of the points: from all batches, or without one of them. */
struct figures_of_points {
    const struct pp_annual_sheet *sheet;
    const double *without; /* figures without one batch; NULL: use those from all */
    size_t step;           /* numbers from one point to the next */
    double area_m2;        /* of all points; NAN: they have none */
};

static double point_weight(const struct figures_of_points *all, int point)
{
    return pp_point_areas_weight(all->sheet->receivers, all->area_m2, point);
}

static double figure_of(const struct figures_of_points *all, int point, int index)
{
    if (all->without)
        return all->without[(size_t)point * all->step + (size_t)index];
    return pp_annual_sheet_figure(&all->sheet->points[point], index)->value;
}

#define FIGURE(name)                                                                   \
    ((int)(offsetof(struct pp_annual_figures, name) / sizeof(struct pp_annual_value)))

/* Fraction of the plane with a figure of at least `least` or, if `above`, greater than
 * `least`. */
static double share(const struct figures_of_points *all, int index, double least,
                    bool above)
{
    double over = 0.0, whole = 0.0;
    for (int x = 0; x < all->sheet->receiver_count; x++) {
        double value = figure_of(all, x, index), weight = point_weight(all, x);
        whole += weight;
        if (above ? value > least : value >= least)
            over += weight;
    }
    return whole > 0.0 ? over / whole : NAN;
}

/* LM-83: half of the hours or more, and more than 250 hours of sun; both with a
 * tolerance for the rounding of sums. */
static const double HALF = 0.5 - 1e-12, SUNLIT_H = 250.0 + 1e-9;

/* The values of pp_annual_plane. */
static void plane_of(double *values, const struct figures_of_points *all)
{
    struct pp_annual_plane plane;
    plane.autonomous.value = share(all, FIGURE(autonomy_300), HALF, false);
    plane.sda.value =
        all->sheet->has_blinds ? share(all, FIGURE(blinds_autonomy), HALF, false) : NAN;
    plane.ase.value = share(all, FIGURE(sun_h), SUNLIT_H, true);
    for (int i = 0; i < PP_ANNUAL_LEVELS; i++)
        plane.level[i].value =
            share(all, FIGURE(median_lx), pp_annual_sheet_levels_lx[i], false);
    for (int i = 0; i < PP_ANNUAL_PLANE; i++)
        values[i] = ((const struct pp_annual_value *)&plane)[i].value;
}

enum { BATCHES_MOST = 64 };

static double mean_of(const struct figures_of_points *all, int index)
{
    double sum = 0.0, whole = 0.0;
    for (int x = 0; x < all->sheet->receiver_count; x++) {
        sum += point_weight(all, x) * figure_of(all, x, index);
        whole += point_weight(all, x);
    }
    return sum / whole;
}

void pp_annual_plane_fill(struct pp_annual_sheet *sheet, const double *without,
                          int batches)
{
    struct figures_of_points all = {
        sheet, NULL, (size_t)batches * (size_t)PP_ANNUAL_FIGURES,
        pp_point_areas_sum(sheet->receivers, sheet->receiver_count)};
    double values[1 + BATCHES_MOST][PP_ANNUAL_PLANE], list[BATCHES_MOST];
    plane_of(values[0], &all);
    for (int b = 0; b < batches; b++) {
        all.without = without + b * PP_ANNUAL_FIGURES;
        plane_of(values[1 + b], &all);
    }
    for (int i = 0; i < PP_ANNUAL_PLANE; i++) {
        struct pp_annual_value *value = (struct pp_annual_value *)&sheet->plane + i;
        for (int b = 0; b < batches; b++)
            list[b] = values[1 + b][i];
        value->value = values[0][i];
        value->std_error = pp_year_metrics_error(list, batches);
    }
    for (int i = 0; i < PP_ANNUAL_FIGURES; i++) {
        struct pp_annual_value *value = pp_annual_sheet_figure(&sheet->mean, i);
        for (int b = 0; b < batches; b++) {
            all.without = without + b * PP_ANNUAL_FIGURES;
            list[b] = mean_of(&all, i);
        }
        all.without = NULL;
        value->value = mean_of(&all, i);
        value->std_error = pp_year_metrics_error(list, batches);
    }
    if (!pp_annual_sheet_has_sun(sheet))
        sheet->plane.ase = (struct pp_annual_value){NAN, NAN};
    sheet->near_half = 0;
    for (int x = 0; x < sheet->receiver_count; x++) {
        const struct pp_annual_value *a = &sheet->points[x].autonomy_300;
        sheet->near_half +=
            a->std_error > 0.0 && fabs(a->value - 0.5) < 2.0 * a->std_error;
    }
}
