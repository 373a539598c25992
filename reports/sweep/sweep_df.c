/* sweep_df.c - table of daylight factors in a sweep: one row per room and point of a
 * run, one column per method. */
#include <stdlib.h>
#include <string.h>

#include "reports/sweep/sweep_text.h"

/* Row of the table: a room of a run, and the index of its point (receiver_count: the
 * average). */
struct df_row {
    const struct pp_result *result;
    int point;
};

struct df_rows {
    struct df_row *list;
    int *of_run;
    int count;
    bool several, points;
};

static int points_of(const struct pp_results *results, const struct pp_result *result)
{
    return results->options->points.count > 0 ? result->report.receiver_count : 0;
}

static bool gather_df_rows(struct df_rows *rows, const struct pp_sweep *sweep,
                           const struct pp_results *const *runs)
{
    int most = 0, run_count = pp_sweep_count(sweep);
    for (int run = 0; run < run_count; run++)
        for (int i = 0; i < runs[run]->count; i++)
            most += points_of(runs[run], &runs[run]->list[i]) + 1;
    rows->list = calloc((size_t)most + 1, sizeof *rows->list);
    rows->of_run = calloc((size_t)most + 1, sizeof *rows->of_run);
    if (!rows->list || !rows->of_run)
        return false;
    for (int run = 0; run < run_count; run++)
        for (int i = 0; i < runs[run]->count; i++) {
            const struct pp_result *result = &runs[run]->list[i];
            int points = points_of(runs[run], result);
            rows->several |= runs[run]->count > 1;
            rows->points |= points > 0;
            for (int p = 0; p <= points; p++) {
                rows->of_run[rows->count] = run;
                rows->list[rows->count++] = (struct df_row){
                    result, p < points ? p : result->report.receiver_count};
            }
        }
    return true;
}

static bool add_room_column(struct pp_table *table, const struct df_rows *rows)
{
    struct pp_table_column *column = pp_table_add(table, NULL, NULL, "room");
    if (!column)
        return false;
    table->key_count++;
    column->is_words = true;
    for (int i = 0; i < rows->count; i++) {
        const char *name = rows->list[i].result->report.world->name;
        snprintf(column->cells[i], PP_CELL_BYTES, "%s", name ? name : "");
    }
    return true;
}

static bool add_place_column(struct pp_table *table, const struct df_rows *rows)
{
    struct pp_table_column *column = pp_table_add(table, NULL, NULL, "point");
    if (!column)
        return false;
    table->key_count++;
    column->is_words = true;
    for (int i = 0; i < rows->count; i++) {
        const struct pp_report *report = &rows->list[i].result->report;
        int p = rows->list[i].point;
        if (p == report->receiver_count)
            snprintf(column->cells[i], PP_CELL_BYTES, "average");
        else
            snprintf(column->cells[i], PP_CELL_BYTES, "%.6g, %.6g",
                     report->receivers[p].position.x, report->receivers[p].position.y);
    }
    return true;
}

/* Finds the method's column among the columns from index `first`, or adds it. NULL: out
 * of memory. */
static struct pp_table_column *method_column(struct pp_table *table, int first,
                                             const char *name)
{
    static const char group[] = "daylight factor, %";
    for (int i = first; i < table->column_count; i++)
        if (strcmp(table->columns[i].heading, name) == 0)
            return &table->columns[i];
    return pp_table_add(table, group, "DF, %", name);
}

static bool fill_df_row(struct pp_table *table, int keys, int row,
                        const struct df_row *of_row, bool utf8)
{
    const struct pp_report *report = &of_row->result->report;
    for (int c = 0; c < report->column_count; c++) {
        const struct pp_column *column = &report->columns[c];
        if (column->component != PP_DF)
            continue;
        struct pp_table_column *cells = method_column(table, keys, column->name);
        if (!cells)
            return false;
        if (of_row->point == report->receiver_count)
            pp_sweep_text_reading(cells->cells[row], &column->average, utf8);
        else if (column->points)
            pp_sweep_text_reading(cells->cells[row], &column->points[of_row->point],
                                  utf8);
    }
    return true;
}

enum pp_status pp_sweep_df_text(const struct pp_sweep *sweep,
                                const struct pp_results *const *runs, int width,
                                bool utf8, FILE *out, struct pp_error *err)
{
    struct df_rows rows = {0};
    struct pp_table table = {0};
    bool good = gather_df_rows(&rows, sweep, runs);
    if (good) {
        pp_table_init(&table, rows.count);
        good = pp_sweep_text_keys(&table, sweep, rows.of_run)
               && (!rows.several || add_room_column(&table, &rows))
               && (!rows.points || add_place_column(&table, &rows));
    }
    int keys = table.column_count;
    for (int i = 0; i < rows.count && good; i++)
        good = fill_df_row(&table, keys, i, &rows.list[i], utf8);
    if (good) {
        fputs(rows.points ? "Daylight factors at points, and their average over the "
                            "working plane.\n\n"
                          : "Average daylight factor over the working plane.\n\n",
              out);
        pp_table_print(&table, width, out);
    }
    pp_table_clear(&table);
    free(rows.list);
    free(rows.of_run);
    return good ? PP_OK : pp_fail_memory(err);
}
