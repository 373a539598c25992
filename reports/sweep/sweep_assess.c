/* sweep_assess.c - table of findings in a sweep: one row per finding, one column per
 * run. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "reports/assess/finding_cells.h"
#include "reports/parts/figure_unit.h"
#include "reports/sweep/sweep_text.h"

enum { KEYS = 4 };

/* A finding that occurs in at least one run, identified by room, criterion and name. */
struct finding_row {
    const char *room, *criterion;
    const struct pp_finding *finding;
    int place; /* index of the room within its run */
};

static bool is_same_row(const struct finding_row *a, const struct finding_row *b)
{
    return a->place == b->place && strcmp(a->criterion, b->criterion) == 0
           && strcmp(a->finding->what, b->finding->what) == 0;
}

/* Calls `use` for each finding of the run. */
static void each_finding(const struct pp_assessments *run,
                         void (*use)(void *data, const struct finding_row *row),
                         void *data)
{
    for (int i = 0; i < run->count; i++)
        for (int k = 0; k < run->list[i].answers.count; k++) {
            const struct pp_answer *answer = &run->list[i].answers.list[k];
            for (int n = 0; n < answer->findings.count; n++) {
                const char *name = run->list[i].room->world->name;
                struct finding_row row = {name ? name : "", answer->criterion->name,
                                          &answer->findings.list[n], i};
                use(data, &row);
            }
        }
}

struct finding_rows {
    struct finding_row *list;
    int count;
    struct pp_table *table;
    int column;
    bool utf8;
};

static int find_row(const struct finding_rows *rows, const struct finding_row *row)
{
    for (int i = 0; i < rows->count; i++)
        if (is_same_row(&rows->list[i], row))
            return i;
    return -1;
}

static void count_finding(void *data, const struct finding_row *row)
{
    (void)row;
    ++*(int *)data;
}

static void gather_finding(void *data, const struct finding_row *row)
{
    struct finding_rows *rows = data;
    if (find_row(rows, row) < 0)
        rows->list[rows->count++] = *row;
}

/* Writes a figure, such as "1.07". A sign before it shows that the target is not met or
 * the verdict is undecided. */
static void write_finding(void *data, const struct finding_row *row)
{
    struct finding_rows *rows = data;
    const struct pp_finding *finding = row->finding;
    char *cell = rows->table->columns[rows->column].cells[find_row(rows, row)];
    const char *sign = finding->verdict == PP_NOT_MET     ? "* "
                       : finding->verdict == PP_UNDECIDED ? "? "
                                                          : "";
    if (isfinite(finding->figure))
        snprintf(cell, PP_CELL_BYTES, "%s%.2f", sign,
                 pp_figure_scale(finding->kind) * finding->figure);
    else
        snprintf(cell, PP_CELL_BYTES, "-");
}

/* Writes the target, or the unit if the figure has no target. */
static void write_target(char cell[PP_CELL_BYTES], const struct pp_finding *finding,
                         bool utf8)
{
    char wanted[PP_FINDING_CELL] = "";
    pp_finding_cells_wanted(wanted, finding, utf8);
    snprintf(cell, PP_CELL_BYTES, "%s",
             wanted[0] ? wanted : pp_figure_unit(finding->kind));
}

static bool add_assess_keys(struct pp_table *table, const struct finding_rows *rows,
                            bool utf8)
{
    static const char *const heads[KEYS] = {"room", "criterion", "of", "target"};
    for (int k = 0; k < KEYS; k++) {
        struct pp_table_column *column = pp_table_add(table, NULL, NULL, heads[k]);
        if (!column)
            return false;
        column->is_words = true;
        for (int i = 0; i < rows->count; i++) {
            const struct finding_row *row = &rows->list[i];
            char wanted[PP_CELL_BYTES];
            write_target(wanted, row->finding, utf8);
            const char *words[KEYS] = {row->room, row->criterion, row->finding->what,
                                       wanted};
            snprintf(column->cells[i], PP_CELL_BYTES, "%s", words[k]);
        }
    }
    table->key_count = KEYS;
    return true;
}

/* Swept values of each run, which are the titles of column groups. A group may extend
 * over several panels. */
struct run_heads {
    char (*texts)[PP_CELL_BYTES];
};

static void write_heads(struct run_heads *heads, const struct pp_sweep *sweep)
{
    for (int run = 0; run < pp_sweep_count(sweep); run++)
        for (int i = 0; i < sweep->axis_count; i++)
            pp_text_append(heads->texts[run], PP_CELL_BYTES, "%s%s", i > 0 ? ", " : "",
                           pp_sweep_value(sweep, run, i));
}

static bool add_run_columns(struct pp_table *table, const struct pp_sweep *sweep,
                            const struct pp_assessments *const *runs,
                            struct finding_rows *rows, const struct run_heads *heads)
{
    for (int run = 0; run < pp_sweep_count(sweep); run++) {
        if (!pp_table_add(table, heads->texts[run], heads->texts[run], ""))
            return false;
        rows->column = table->column_count - 1;
        each_finding(runs[run], write_finding, rows);
    }
    return true;
}

static void print_caption(const struct pp_sweep *sweep, FILE *out)
{
    fputs("Figures of each criterion for each value of ", out);
    for (int i = 0; i < sweep->axis_count; i++)
        fprintf(out, "%s%s", i > 0 ? ", " : "", sweep->axes[i].address);
    fputs("\n\n", out);
}

enum pp_status pp_sweep_assess_text(const struct pp_sweep *sweep,
                                    const struct pp_assessments *const *runs, int width,
                                    bool utf8, FILE *out, struct pp_error *err)
{
    struct pp_table table = {0};
    struct finding_rows rows = {.table = &table, .utf8 = utf8};
    int most = 0, run_count = pp_sweep_count(sweep);
    for (int run = 0; run < run_count; run++)
        each_finding(runs[run], count_finding, &most);
    struct run_heads heads = {calloc((size_t)run_count + 1, PP_CELL_BYTES)};
    rows.list = calloc((size_t)most + 1, sizeof *rows.list);
    bool good = rows.list && heads.texts;
    for (int run = 0; run < run_count && good; run++)
        each_finding(runs[run], gather_finding, &rows);
    if (good)
        write_heads(&heads, sweep);
    pp_table_init(&table, rows.count);
    good = good && add_assess_keys(&table, &rows, utf8)
           && add_run_columns(&table, sweep, runs, &rows, &heads);
    if (good) {
        print_caption(sweep, out);
        pp_table_fit(&table, width);
        pp_table_print(&table, width, out);
        fputs("\n  * not met   ? undecided   - not applicable\n", out);
    }
    pp_table_clear(&table);
    free(rows.list);
    free(heads.texts);
    return good ? PP_OK : pp_fail_memory(err);
}
