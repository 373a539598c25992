/* section_series.h - which columns of a report are drawn on a section chart. */
#ifndef PP_CHARTS_ROOM_SECTION_SERIES_H
#define PP_CHARTS_ROOM_SECTION_SERIES_H

#include "charts/room/section_plot.h"

/* The columns of daylight factors that have a value, into plot->series, which has room
 * for all. Sampled columns are points with error bars, the others lines; more than four
 * lines get markers too. A column without all its values is accounted for in
 * plot->foot. */
void pp_section_series_choose(struct pp_section_plot *plot);

#endif
