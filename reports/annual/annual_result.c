/* annual_result.c - list of the figures and their names. */
#include "reports/annual/annual_result.h"

#include <stddef.h>

#define FIGURE(name)                                                                   \
    ((int)(offsetof(struct pp_annual_figures, name) / sizeof(struct pp_annual_value)))

const struct pp_annual_figure_name pp_annual_result_names[] = {
    {"udi-below", "< 100", FIGURE(udi_below), 100.0, 1},
    {"udi-low", "100- 300", FIGURE(udi_low), 100.0, 1},
    {"udi-good", "300- 3000", FIGURE(udi_good), 100.0, 1},
    {"udi-above", "> 3000", FIGURE(udi_above), 100.0, 1},
    {"blinds-da300", "with blinds", FIGURE(blinds_autonomy), 100.0, 1},
    {"sun-hours", "sun h", FIGURE(sun_h), 1.0, 0},
    {"mean-lux", "mean lx", FIGURE(mean_lx), 1.0, 0},
    {"median-lux", "median lx", FIGURE(median_lx), 1.0, 0},
    {"year-klxh", "year klx h", FIGURE(year_lxh), 0.001, 0},
    {"sky-klxh", NULL, FIGURE(sky_lxh), 0.001, 0},
    {"sun-klxh", NULL, FIGURE(sun_lxh), 0.001, 0},
    {"sun-reflected-klxh", NULL, FIGURE(sun_reflected_lxh), 0.001, 0},
    {NULL, NULL, 0, 0.0, 0},
};

int pp_annual_result_autonomy(int i, bool continuous)
{
    return (continuous ? FIGURE(continuous) : FIGURE(autonomy)) + i;
}
