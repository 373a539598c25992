/* section_names.h - the names of the curves on a section chart. */
#ifndef PP_CHARTS_SECTION_SECTION_NAMES_H
#define PP_CHARTS_SECTION_SECTION_NAMES_H

#include "charts/section/section_plot.h"

/* Draws names next to the curves if there is space for all, else a legend in a free
 * corner of the field, or at `aside` if that lies beside the field. */
void pp_section_names_draw(struct pp_section_plot *plot, struct pp_box aside);

/* Sets plan and size of plot->legend, the legend below the section for more than
 * PP_KEYS_INSIDE names, in columns that fit into `width`. */
void pp_section_names_fit_legend(struct pp_section_plot *plot, double width);

/* Draws a legend of `count` names from number `first` on, on a white ground. */
void pp_section_names_draw_keys(struct pp_section_plot *plot, int first, int count,
                                double x, double y, double width);

#endif
