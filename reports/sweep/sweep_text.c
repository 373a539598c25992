/* sweep_text.c - see sweep_text.h. Here: the columns that all tables of sweeps have. */
#include "reports/sweep/sweep_text.h"

#include <math.h>

#include "model/base/text.h"

bool pp_sweep_text_keys(struct pp_table *table, const struct pp_sweep *sweep,
                        const int *of_run)
{
    for (int i = 0; i < sweep->axis_count; i++) {
        struct pp_table_column *column =
            pp_table_add(table, NULL, NULL, sweep->axes[i].address);
        if (!column)
            return false;
        table->key_count++;
        double number;
        for (int row = 0; row < table->row_count; row++) {
            const char *value = pp_sweep_value(sweep, of_run[row], i);
            snprintf(column->cells[row], PP_CELL_BYTES, "%s", value);
            column->is_words |= !pp_text_parse_number(value, &number);
        }
    }
    return true;
}

void pp_sweep_text_reading(char cell[PP_CELL_BYTES], const struct pp_reading *reading,
                           bool utf8)
{
    if (!isfinite(reading->value))
        snprintf(cell, PP_CELL_BYTES, "-");
    else if (isfinite(reading->std_error))
        snprintf(cell, PP_CELL_BYTES, "%.2f %s%.2f", 100.0 * reading->value,
                 utf8 ? "\302\261" : "+-", 100.0 * reading->std_error);
    else
        snprintf(cell, PP_CELL_BYTES, "%.2f", 100.0 * reading->value);
}
