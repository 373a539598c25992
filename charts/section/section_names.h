/* section_names.h - the names of the curves on a section chart. */
#ifndef PP_CHARTS_SECTION_SECTION_NAMES_H
#define PP_CHARTS_SECTION_SECTION_NAMES_H

#include "charts/section/section_plot.h"

/* Draws names beside the curves if there is space for all names. Otherwise draws a
 * legend at `aside` if that is beside the field, else in a free corner of the field. */
void pp_section_names_draw(struct pp_section_plot *plot, struct pp_box aside);

/* Sets columns and size of the legend below the section (plot->legend), so that the
 * columns fit into `width`. The legend is below the section if there are more than
 * PP_KEYS_INSIDE names. */
void pp_section_names_fit_legend(struct pp_section_plot *plot, double width);

/* Draws a legend of `count` names from index `first`, on a white background. */
void pp_section_names_draw_keys(struct pp_section_plot *plot, int first, int count,
                                double x, double y, double width);

#endif
