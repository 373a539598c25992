/* section_series.h - selects columns of a report for a section chart. */
#ifndef PP_CHARTS_SECTION_SECTION_SERIES_H
#define PP_CHARTS_SECTION_SECTION_SERIES_H

#include "charts/section/section_plot.h"

/* Stores in plot->series the columns of daylight factors that have a value.
 * plot->series must have space for all columns. Simulated columns are points with error
 * bars; others are lines, with markers if there are more than four. A column that lacks
 * values gets a note in plot->foot. */
void pp_section_series_choose(struct pp_section_plot *plot);

#endif
