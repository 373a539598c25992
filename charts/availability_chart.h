/* availability_chart.h - cumulative frequency of diffuse illuminance in working hours,
 * one curve per period, outside and in a room.
 *
 * The horizontal axis is the diffuse horizontal illuminance outside, the vertical axis
 * the share of working hours in which the illuminance is at least that high. With a
 * room, a second horizontal scale shows the illuminance inside, from the daylight
 * factor at the point or, if there are several points, from the average. A vertical
 * line for each target illuminance stands at the illuminance outside that the target
 * requires, with a dot on each curve. The numbers are printed below.
 */
#ifndef PP_CHARTS_AVAILABILITY_CHART_H
#define PP_CHARTS_AVAILABILITY_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/availability_sheet.h"

enum pp_status pp_availability_chart_draw(struct pp_canvas *canvas,
                                          const struct pp_availability_sheet *sheet,
                                          struct pp_error *err);

#endif
