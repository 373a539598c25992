/* availability_chart.h - cumulative frequency of diffuse illuminance in working hours,
 * one curve per period, outside and in a room.
 *
 * The horizontal axis is the diffuse horizontal illuminance outside, the vertical axis
 * the share of working hours that reach it. With a room, a second scale shows the
 * illuminance inside at its daylight factor: at a point if the chart is for one point,
 * else on average. Each target illuminance is a line at the illuminance outside that it
 * needs, with a dot on each curve. The figures are written below.
 */
#ifndef PP_CHARTS_AVAILABILITY_CHART_H
#define PP_CHARTS_AVAILABILITY_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/availability_sheet.h"

enum pp_status pp_availability_chart_draw(struct pp_canvas *canvas,
                                          const struct pp_availability_sheet *sheet,
                                          struct pp_error *err);

#endif
