/* section_series.h - choice of a report's columns for a section chart. */
#ifndef PP_CHARTS_SECTION_SECTION_SERIES_H
#define PP_CHARTS_SECTION_SECTION_SERIES_H

#include "charts/section/section_plot.h"

/* Stores the columns of daylight factors that have a value in plot->series, which has
 * space for all. Sampled columns are points with error bars, the others lines; if there
 * are more than four lines they have markers too. A column that lacks values gets a
 * note in plot->foot. */
void pp_section_series_choose(struct pp_section_plot *plot);

#endif
