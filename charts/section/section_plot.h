/* section_plot.h - drawing state of the section chart, shared by section_chart.c
 * (layout and curves), section_series.c and section_names.c. */
#ifndef PP_CHARTS_SECTION_SECTION_PLOT_H
#define PP_CHARTS_SECTION_SECTION_PLOT_H

#include "charts/sheet/axis.h"
#include "charts/sheet/labels.h"
#include "charts/sheet/legend.h"
#include "charts/section/section_cut.h"
#include "model/results/report.h"

/* One column of the report, as drawn in the chart. */
struct pp_series {
    const struct pp_column *column;
    enum { PP_CURVE, PP_SAMPLED, PP_LEVEL } kind;
    struct pp_curve_style look;
    struct pp_key key;
};

/* If there are more than PP_KEYS_INSIDE names, they are in a legend below the section,
 * with at most PP_KEYS_MOST in a column. */
enum { PP_KEYS_INSIDE = 6, PP_KEYS_MOST = 64 };

struct pp_section_legend {
    int columns, rows;   /* 0: no legend below the section */
    double wide, height; /* width and height of a column, mm */
};

struct pp_section_plot {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_report *report;
    struct pp_section_cut cut;
    struct pp_axis across, up;
    struct pp_box field; /* area of the curves */
    int *order;          /* indices of the receivers in order of distance */
    double *distance;    /* distance of each receiver along the section, m */
    struct pp_series *series;
    int series_count, curve_count;
    struct pp_labels *labels;
    struct pp_section_legend legend;
    char foot[4096];
};

#endif
