/* section_names.h - the names of the curves on a section chart. */
#ifndef PP_CHARTS_ROOM_SECTION_NAMES_H
#define PP_CHARTS_ROOM_SECTION_NAMES_H

#include "charts/room/section_plot.h"

/* Names next to the curves where there is room for all, else in a legend in a free
 * corner of the field, or at `aside` where that lies beside the field. */
void pp_section_names_draw(struct pp_section_plot *plot, struct pp_box aside);

/* Sets plot->legend: the legend below the section that more than PP_KEYS_INSIDE names
 * need, in columns that fit into `width`. */
void pp_section_names_fit_legend(struct pp_section_plot *plot, double width);

/* A legend of `count` names from number `first` on, on white. */
void pp_section_names_draw_keys(struct pp_section_plot *plot, int first, int count,
                                double x, double y, double width);

#endif
