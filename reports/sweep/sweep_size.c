/* sweep_size.c - table of sizes in a sweep: one row per run and room. */
#include <math.h>
#include <stdlib.h>

#include "reports/size_csv.h"
#include "reports/sweep/sweep_text.h"

static const char *answer_words(const struct pp_size_room_result *result)
{
    switch (result->answer.verdict) {
    case PP_SIZE_REACHED:
        return isfinite(result->traced.value) && !result->holds ? "does not hold"
                                                                : "reached";
    case PP_SIZE_SMALLEST_EXCEEDS:
        return "exceeded even by the smallest size";
    default:
        return result->why && !result->answer.room ? "no answer" : "out of reach";
    }
}

static bool fill_size_columns(struct pp_table *table,
                              const struct pp_size_room_result *const *rows,
                              const struct pp_size_request *request, bool several,
                              bool utf8)
{
    const char *unit = request->change == PP_CHANGE_NUMBER ? "" : ", m";
    char head[48];
    snprintf(head, sizeof head, "%s%s", pp_size_room_change_words[request->change],
             unit);
    const char *const heads[] = {"room", head, "reached, %", "simulated, %", "target"};
    for (int k = several ? 0 : 1; k < 5; k++) {
        static const char group[] = "answer";
        struct pp_table_column *column =
            pp_table_add(table, k == 0 ? NULL : group, group, heads[k]);
        if (!column)
            return false;
        table->key_count += k == 0;
        column->is_words = k == 0 || k == 4;
        for (int i = 0; i < table->row_count; i++) {
            char *cell = column->cells[i];
            double size = pp_size_csv_size(rows[i], request->change);
            const char *name = rows[i]->room->world->name;
            if (k == 0)
                snprintf(cell, PP_CELL_BYTES, "%s", name ? name : "");
            else if (k == 1 && isfinite(size))
                snprintf(cell, PP_CELL_BYTES, "%.4g", size);
            else if (k == 2)
                pp_sweep_text_reading(cell, &rows[i]->answer.reading, utf8);
            else if (k == 3)
                pp_sweep_text_reading(cell, &rows[i]->traced, utf8);
            else if (k == 4)
                snprintf(cell, PP_CELL_BYTES, "%s", answer_words(rows[i]));
        }
    }
    return true;
}

enum pp_status pp_sweep_size_text(const struct pp_sweep *sweep,
                                  const struct pp_size_results *const *runs, int width,
                                  bool utf8, FILE *out, struct pp_error *err)
{
    int most = 0, count = 0;
    bool several = false;
    for (int run = 0; run < pp_sweep_count(sweep); run++)
        most += runs[run]->count;
    const struct pp_size_room_result **rows = calloc((size_t)most + 1, sizeof *rows);
    int *of_run = calloc((size_t)most + 1, sizeof *of_run);
    for (int run = 0; run < pp_sweep_count(sweep) && rows && of_run; run++)
        for (int i = 0; i < runs[run]->count; i++) {
            several |= runs[run]->count > 1;
            of_run[count] = run;
            rows[count++] = &runs[run]->list[i];
        }
    struct pp_table table;
    pp_table_init(&table, count);
    bool good = rows && of_run && pp_sweep_text_keys(&table, sweep, of_run)
                && fill_size_columns(&table, rows, runs[0]->request, several, utf8);
    if (good)
        pp_table_print(&table, width, out);
    pp_table_clear(&table);
    free(rows);
    free(of_run);
    return good ? PP_OK : pp_fail_memory(err);
}
