/* section_plot.h - what the files of section_chart.h share.
 */
#ifndef PP_CHARTS_ROOM_SECTION_PLOT_H
#define PP_CHARTS_ROOM_SECTION_PLOT_H

#include "charts/sheet/axis.h"
#include "charts/sheet/labels.h"
#include "charts/sheet/legend.h"
#include "charts/room/section_cut.h"
#include "model/results/report.h"

/* One column of the report on the chart. */
struct pp_series {
    const struct pp_column *column;
    enum { PP_CURVE, PP_SAMPLED, PP_LEVEL } kind;
    struct pp_curve_style look;
    struct pp_key key;
};

/* More names than that go to a legend below the section; at most so many a column. */
enum { PP_KEYS_INSIDE = 6, PP_KEYS_MOST = 64 };

struct pp_section_legend {
    int columns, rows; /* 0: there is none */
    double wide, height;
};

struct pp_section_plot {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_report *report;
    struct pp_section_cut cut;
    struct pp_axis across, up;
    struct pp_box field; /* of the curves */
    int *order;          /* receivers by their distance */
    double *distance;    /* of each receiver */
    struct pp_series *series;
    int series_count, curve_count;
    struct pp_labels *labels;
    struct pp_section_legend legend;
    char foot[4096];
};

/* The columns of daylight factors that have a value, into plot->series, which has room
 * for all. Sampled ones are points with error bars, the others lines; where these are
 * more than four, they get markers too. What has no value is said in plot->foot. */
void pp_section_series_choose(struct pp_section_plot *plot);

/* Names next to the curves where there is room for all, else in a legend in a free
 * corner of the field, or at `aside` where that lies beside it. */
void pp_section_names_draw(struct pp_section_plot *plot, struct pp_box aside);

/* The columns of plot->legend that more than PP_KEYS_INSIDE names need below the
 * section, and their size. */
void pp_section_names_fit_legend(struct pp_section_plot *plot, double width);

/* A legend of some of the names, on white. */
void pp_section_names_draw_keys(struct pp_section_plot *plot, int first, int count,
                                double x, double y, double width);

#endif
