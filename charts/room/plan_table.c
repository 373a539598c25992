/* plan_table.c - see plan_table.h. */
#include "charts/room/plan_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/room/plan_figures.h"
#include "charts/sheet/lettering.h"

/* Coordinates that differ by less than this (m) share a row or column. */
static const double same_place_m = 1e-3;

struct plan_table {
    cairo_t *cr;
    const struct pp_style *style;
    const struct pp_plan_chart *chart;
    int *points; /* indices of the receivers with a value on the plane */
    int count;
    double *x, *y; /* distinct coordinates (m), ascending */
    int x_count, y_count;
    double cell, row; /* width and height of a cell, mm */
};

static int compare_numbers(const void *a, const void *b)
{
    const double *p = a, *q = b;
    return (*p > *q) - (*p < *q);
}

/* Sorts coordinates and removes duplicates. Returns the number that remain. */
static int keep_different(double *list, int count)
{
    int kept = 0;
    qsort(list, (size_t)count, sizeof *list, compare_numbers);
    for (int i = 0; i < count; i++)
        if (kept == 0 || list[i] - list[kept - 1] > same_place_m)
            list[kept++] = list[i];
    return kept;
}

/* Collects the points with values and their coordinates, and measures a cell. Returns
 * false if memory is exhausted. The caller frees the lists in either case. */
static bool gather_values(struct plan_table *table)
{
    const struct pp_report *report = table->chart->report;
    size_t room = (size_t)report->receiver_count + 1;
    table->points = malloc(room * sizeof *table->points);
    table->x = malloc(room * sizeof *table->x);
    table->y = malloc(room * sizeof *table->y);
    if (!table->points || !table->x || !table->y)
        return false;
    for (int i = 0; i < report->receiver_count; i++) {
        if (!pp_plan_figures_has(table->chart, i))
            continue;
        table->x[table->count] = report->receivers[i].position.x;
        table->y[table->count] = report->receivers[i].position.y;
        table->points[table->count++] = i;
    }
    table->x_count = keep_different(table->x, table->count);
    table->y_count = keep_different(table->y, table->count);
    const struct pp_lettering set = {.size = PP_TEXT_SMALL};
    struct pp_box cell =
        pp_lettering_measure(table->cr, table->style, &set, 0, 0, "00.00");
    table->cell = cell.width + 1.2 * table->style->scale;
    table->row = 1.05 * cell.height;
    return true;
}

/* Writes text right-aligned in column `column` of row `row`, both counted from 0. */
static void write_cell(const struct plan_table *table, struct pp_box box, int column,
                       int row, double grey, const char *words)
{
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .grey = grey, .across = 1.0};
    pp_lettering_draw(table->cr, table->style, &set, box.x + (column + 1) * table->cell,
                      box.y + row * table->row, words);
}

static int place_in(const double *list, int count, double value)
{
    int i = 0;
    while (i + 1 < count && fabs(list[i] - value) > same_place_m)
        i++;
    return i;
}

static void write_grid(const struct plan_table *table, struct pp_box box)
{
    char words[32];
    write_cell(table, box, 0, 0, PP_GREY_TEXT, "y \\ x m");
    for (int i = 0; i < table->x_count; i++) {
        snprintf(words, sizeof words, "%.2f", table->x[i]);
        write_cell(table, box, i + 1, 0, PP_GREY_TEXT, words);
    }
    for (int i = 0; i < table->y_count; i++) {
        snprintf(words, sizeof words, "%.2f", table->y[i]);
        write_cell(table, box, 0, table->y_count - i, PP_GREY_TEXT, words);
    }
    for (int i = 0; i < table->count; i++) {
        const struct pp_vec3 *at =
            &table->chart->report->receivers[table->points[i]].position;
        pp_plan_figures_value(words, sizeof words, table->chart, table->points[i]);
        write_cell(table, box, 1 + place_in(table->x, table->x_count, at->x),
                   table->y_count - place_in(table->y, table->y_count, at->y), PP_INK,
                   words);
    }
}

static void write_list(const struct plan_table *table, struct pp_box box, int rows)
{
    for (int i = 0; i < table->count; i++) {
        const struct pp_vec3 *at =
            &table->chart->report->receivers[table->points[i]].position;
        int column = i / rows * 4, row = 1 + i % rows;
        char words[32];
        if (i % rows == 0) {
            write_cell(table, box, column, 0, PP_GREY_TEXT, "x m");
            write_cell(table, box, column + 1, 0, PP_GREY_TEXT, "y m");
            write_cell(table, box, column + 2, 0, PP_GREY_TEXT, "%");
        }
        snprintf(words, sizeof words, "%.2f", at->x);
        write_cell(table, box, column, row, PP_GREY_TEXT, words);
        snprintf(words, sizeof words, "%.2f", at->y);
        write_cell(table, box, column + 1, row, PP_GREY_TEXT, words);
        pp_plan_figures_value(words, sizeof words, table->chart, table->points[i]);
        write_cell(table, box, column + 2, row, PP_INK, words);
    }
}

/* Lays out the table as a grid or as a list. If `drawn` is false, only measures.
 * Returns the box of the table. */
static struct pp_box lay_table(const struct plan_table *table, struct pp_box box,
                               bool drawn)
{
    if (table->x_count * table->y_count <= 2 * table->count) {
        if (drawn)
            write_grid(table, box);
        return (struct pp_box){box.x, box.y, (table->x_count + 1) * table->cell,
                               (table->y_count + 1) * table->row};
    }
    int most = (int)fmax(box.height / table->row - 1.0, 1.0);
    int columns = (table->count + most - 1) / most;
    int rows = (table->count + columns - 1) / columns;
    if (drawn)
        write_list(table, box, rows);
    return (struct pp_box){box.x, box.y, (4 * columns - 1) * table->cell,
                           (rows + 1) * table->row};
}

struct pp_box pp_plan_table_draw(cairo_t *cr, const struct pp_style *style,
                                 const struct pp_plan_chart *chart, struct pp_box box,
                                 bool drawn)
{
    struct plan_table table = {.cr = cr, .style = style, .chart = chart};
    struct pp_box filled = {box.x, box.y, 0.0, 0.0};
    if (!gather_values(&table))
        pp_canvas_lacks_memory(cr);
    else if (table.count > 0)
        filled = lay_table(&table, box, drawn);
    free(table.points);
    free(table.x);
    free(table.y);
    return filled;
}
