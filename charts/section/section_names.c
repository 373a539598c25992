/* section_names.c - writes the names of the curves beside them, or in a legend if there
 * is not enough space. */
#include "charts/section/section_names.h"

#include <math.h>

/* Draws the name of a series. The name of a curve has a sample of its line, since
 * curves may coincide. Names of points and of horizontal lines are text only. */
static struct pp_box draw_name(struct pp_section_plot *plot,
                               const struct pp_series *series, double x, double y,
                               bool drawn)
{
    const struct pp_lettering text = {.size = PP_TEXT_BODY};
    double wide = plot->field.width;
    if (series->kind == PP_CURVE)
        return (drawn ? pp_legend_draw : pp_legend_measure)(
            plot->cr, &plot->style, &series->key, 1, x, y, wide);
    return (drawn ? pp_lettering_draw : pp_lettering_measure)(
        plot->cr, &plot->style, &text, x, y, series->key.words);
}

void pp_section_names_draw_keys(struct pp_section_plot *plot, int first, int count,
                                double x, double y, double width)
{
    struct pp_key keys[PP_KEYS_MOST];
    for (int i = 0; i < count; i++)
        keys[i] = plot->series[first + i].key;
    struct pp_box box =
        pp_legend_measure(plot->cr, &plot->style, keys, count, x, y, width);
    pp_style_grey(plot->cr, 1.0);
    cairo_rectangle(plot->cr, box.x - 1.0, box.y, box.width + 2.0, box.height);
    cairo_fill(plot->cr);
    pp_legend_draw(plot->cr, &plot->style, keys, count, x, y, width);
}

void pp_section_names_fit_legend(struct pp_section_plot *plot, double width)
{
    struct pp_section_legend *legend = &plot->legend;
    legend->columns = 0;
    legend->height = 0.0;
    if (plot->series_count <= PP_KEYS_INSIDE)
        return;
    double gap = 5.0 * plot->style.scale, row = 0.0;
    legend->wide = 0.0;
    for (int i = 0; i < plot->series_count; i++) {
        struct pp_box box = pp_legend_measure(plot->cr, &plot->style,
                                              &plot->series[i].key, 1, 0, 0, width);
        legend->wide = fmax(legend->wide, box.width + gap);
        row = fmax(row, box.height + 0.7 * plot->style.scale);
    }
    legend->columns = (int)fmax(1.0, floor((width + gap) / legend->wide));
    legend->rows = (plot->series_count + legend->columns - 1) / legend->columns;
    legend->rows = legend->rows < PP_KEYS_MOST ? legend->rows : PP_KEYS_MOST;
    legend->height = legend->rows * row;
}

/* Draws the legend. If `aside` is beside the field, the legend is there; else it is in
 * the first free corner of the field, or at `aside` if no corner is free. */
static void draw_legend_inside(struct pp_section_plot *plot, struct pp_box aside)
{
    struct pp_box field = plot->field;
    struct pp_key keys[PP_KEYS_INSIDE];
    for (int i = 0; i < plot->series_count; i++)
        keys[i] = plot->series[i].key;
    struct pp_box size = pp_legend_measure(plot->cr, &plot->style, keys,
                                           plot->series_count, 0, 0, aside.width);
    double pad = 1.5 * plot->style.scale;
    double left = field.x + pad, right = field.x + field.width - size.width - pad;
    double top = field.y + pad, bottom = field.y + field.height - size.height - pad;
    const double corners[][2] = {
        {right, top}, {left, bottom}, {left, top}, {right, bottom}};
    for (int i = 0; i < 4 && aside.x < field.x + field.width; i++) {
        struct pp_box box = {corners[i][0], corners[i][1], size.width, size.height};
        if (pp_labels_is_free(plot->labels, box)) {
            aside.x = box.x;
            aside.y = box.y;
            break;
        }
    }
    pp_section_names_draw_keys(plot, 0, plot->series_count, aside.x, aside.y,
                               aside.width);
}

void pp_section_names_draw(struct pp_section_plot *plot, struct pp_box aside)
{
    struct pp_labels *labels = plot->labels;
    struct pp_box boxes[PP_KEYS_INSIDE];
    double anchors[PP_KEYS_INSIDE][2];
    int count = plot->series_count, before = labels->count;
    bool all = true;
    for (int i = 0; i < count && all; i++) {
        struct pp_box size = draw_name(plot, &plot->series[i], 0, 0, false);
        all = pp_labels_find(labels, &plot->style, size.width, size.height, i,
                             &boxes[i], anchors[i]);
        if (all)
            pp_labels_note_box(labels, boxes[i]);
    }
    for (int i = 0; i < count && all; i++) {
        pp_style_grey(plot->cr, 1.0);
        cairo_rectangle(plot->cr, boxes[i].x, boxes[i].y, boxes[i].width,
                        boxes[i].height);
        cairo_fill(plot->cr);
        pp_labels_lead(plot->cr, &plot->style, boxes[i], anchors[i]);
        draw_name(plot, &plot->series[i], boxes[i].x, boxes[i].y, true);
    }
    if (all)
        return;
    labels->count = before;
    draw_legend_inside(plot, aside);
}
