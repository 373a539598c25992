/* df_text.c - fills the table of daylight factors and prints the text above and below
 * it. */
#include "reports/df_text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reports/atlas/advice_report.h"
#include "reports/df_plane.h"
#include "reports/df_steps.h"
#include "reports/formula_list.h"
#include "reports/parts/print.h"
#include "reports/parts/print_band.h"
#include "reports/parts/print_notes.h"
#include "reports/parts/print_reliability.h"
#include "reports/parts/print_places.h"
#include "reports/parts/table.h"
#include "reports/parts/format.h"
#include "model/base/text.h"
#include "model/results/reading.h"
#include "studies/engines/engine.h"

struct titles {
    const char *full, *brief;
};

static const struct titles titles[PP_COMPONENT_COUNT] = {
    [PP_SC] = {"sky component", "SC"},
    [PP_ERC] = {"externally reflected", "ERC"},
    [PP_IRC] = {"internally reflected", "IRC"},
    [PP_DF] = {"daylight factor", "DF"},
};

static const char off_brief[] = "off, %";
static const char apart_title[] = "diff./s.e.";
static const char band_title[] = "95 % band";

/* ---- printed numbers ---- */

/* Writes a value in per cent with two decimals; a dash if there is none. */
static void put_value(char cell[PP_CELL_BYTES], const struct pp_reading *reading)
{
    if (isfinite(reading->value))
        snprintf(cell, PP_CELL_BYTES, "%.2f", 100.0 * reading->value + 0.0);
    else
        snprintf(cell, PP_CELL_BYTES, "-");
}

/* Writes a value with its standard error, which is rounded up to the printed digits. */
static void put_sampled(char cell[PP_CELL_BYTES], const struct pp_reading *reading,
                        bool utf8)
{
    put_value(cell, reading);
    if (!isfinite(reading->value) || !isfinite(reading->std_error))
        return;
    pp_text_append(cell, PP_CELL_BYTES, " %s%.2f", utf8 ? "\xc2\xb1" : "+-",
                   pp_reading_printed_error(reading));
}

/* Writes the deviation of a value from the simulated value, in per cent of the
 * simulated value; a dash if the simulated value is too uncertain. */
static void put_distance(char cell[PP_CELL_BYTES], const struct pp_reading *reading,
                         const struct pp_reading *traced)
{
    double off = 100.0 * (reading->value - traced->value) / traced->value;
    bool known = isfinite(off) && traced->value > 4.0 * traced->std_error;
    if (!known)
        snprintf(cell, PP_CELL_BYTES, "-");
    else if (fabs(off) < 0.05)
        snprintf(cell, PP_CELL_BYTES, "0.0");
    else
        snprintf(cell, PP_CELL_BYTES, fabs(off) < 99.95 ? "%+.1f" : "%+.0f", off);
}

/* Writes the difference between two simulated values, in units of its standard
 * error. */
static void put_apart(char cell[PP_CELL_BYTES], const struct pp_reading *reading,
                      const struct pp_reading *truth)
{
    double apart = pp_reading_apart(reading, truth);
    if (isfinite(apart))
        snprintf(cell, PP_CELL_BYTES, "%+.1f", apart);
    else
        snprintf(cell, PP_CELL_BYTES, "-");
}

/* Writes an illuminance in lux: whole from 100 lx, with one decimal from 10 lx, else
 * with two, and "0" below 0.05 lx; a dash if there is no value. */
static void put_lux(char cell[PP_CELL_BYTES], double lux)
{
    if (!isfinite(lux)) {
        snprintf(cell, PP_CELL_BYTES, "-");
        return;
    }
    int decimals = lux < 0.05 || lux >= 99.95 ? 0 : lux < 9.995 ? 2 : 1;
    snprintf(cell, PP_CELL_BYTES, "%.*f", decimals, lux + 0.0);
}

/* ---- the table ---- */

static bool add_values(struct pp_table *table, const struct pp_report *report,
                       const struct pp_column *column, bool utf8)
{
    const struct titles *title = &titles[column->component];
    struct pp_table_column *shown =
        pp_table_add(table, title->full, title->brief, column->name);
    if (!shown)
        return false;
    bool with_error = pp_engine_of_column(column->name) && column->component == PP_DF;
    for (int row = 0; row <= report->receiver_count; row++) {
        const struct pp_reading *reading = pp_print_notes_reading(report, column, row);
        if (reading && with_error)
            put_sampled(shown->cells[row], reading, utf8);
        else if (reading)
            put_value(shown->cells[row], reading);
    }
    return true;
}

static bool add_distances(struct pp_table *table, const struct pp_report *report,
                          const struct pp_column *column, const struct pp_column *truth)
{
    struct pp_table_column *shown = pp_table_add(
        table, pp_engine_of_column(truth->name)->from, off_brief, column->name);
    if (!shown)
        return false;
    for (int row = 0; row <= report->receiver_count; row++) {
        const struct pp_reading *reading = pp_print_notes_reading(report, column, row);
        if (reading)
            put_distance(shown->cells[row], reading,
                         pp_print_notes_reading(report, truth, row));
    }
    return true;
}

/* Adds the differences between an engine's column and the reference. */
static bool add_apart(struct pp_table *table, const struct pp_report *report,
                      const struct pp_column *column, const struct pp_column *truth)
{
    struct pp_table_column *shown =
        pp_table_add(table, apart_title, apart_title, column->name);
    if (!shown)
        return false;
    for (int row = 0; row <= report->receiver_count; row++) {
        const struct pp_reading *reading = pp_print_notes_reading(report, column, row);
        if (reading)
            put_apart(shown->cells[row], reading,
                      pp_print_notes_reading(report, truth, row));
    }
    return true;
}

static bool has_band(const struct pp_report *report, const struct pp_column *column)
{
    for (int row = 0; row <= report->receiver_count; row++)
        if (pp_band_is_known(pp_print_band_at(column, row, report->receiver_count)))
            return true;
    return false;
}

static bool add_bands(struct pp_table *table, const struct pp_report *report,
                      const struct pp_column *column)
{
    struct pp_table_column *shown =
        pp_table_add(table, band_title, band_title, column->name);
    if (!shown)
        return false;
    for (int row = 0; row <= report->receiver_count; row++)
        pp_print_band(shown->cells[row], PP_CELL_BYTES,
                      pp_print_band_at(column, row, report->receiver_count));
    return true;
}

/* Adds illuminances: daylight factors times the external illuminance. */
static bool add_illuminances(struct pp_table *table, const struct pp_report *report,
                             const struct pp_column *column, const char *title,
                             double external_lux)
{
    struct pp_table_column *shown = pp_table_add(table, title, "lux", column->name);
    if (!shown)
        return false;
    for (int row = 0; row <= report->receiver_count; row++) {
        const struct pp_reading *reading = pp_print_notes_reading(report, column, row);
        if (reading)
            put_lux(shown->cells[row], external_lux * reading->value);
    }
    return true;
}

/* True if all cells of a column would be dashes, and another method replaces it. */
static bool is_stood_in_for(const struct pp_report *report,
                            const struct pp_column *column)
{
    for (int row = 0; row <= report->receiver_count; row++) {
        const struct pp_reading *reading = pp_print_notes_reading(report, column, row);
        if (reading && isfinite(reading->value))
            return false;
    }
    return report->stand_in != NULL;
}

/* Fills the table of daylight factors. external_lux: illuminance outside (lux); 0: no
 * columns of illuminance; lux_title: title of those columns; all_bands: bands for every
 * method; false: only for the first method that has bands. */
static bool fill_table(struct pp_table *table, const struct pp_report *report,
                       double external_lux, const char *lux_title, bool all_bands,
                       bool utf8)
{
    for (int i = 0; i < report->column_count; i++)
        if ((report->columns[i].component != PP_ERC
             || !pp_print_notes_is_zero(report, PP_ERC))
            && !is_stood_in_for(report, &report->columns[i])
            && !add_values(table, report, &report->columns[i], utf8))
            return false;
    bool banded = false;
    for (int i = 0; i < report->column_count && (all_bands || !banded); i++) {
        const struct pp_column *column = &report->columns[i];
        if (column->component != PP_DF || !has_band(report, column))
            continue;
        if (!add_bands(table, report, column))
            return false;
        banded = true;
    }
    for (int i = 0; external_lux > 0.0 && i < report->column_count; i++)
        if (report->columns[i].component == PP_DF
            && !is_stood_in_for(report, &report->columns[i])
            && !add_illuminances(table, report, &report->columns[i], lux_title,
                                 external_lux))
            return false;
    const struct pp_column *truth = pp_engine_truth(report);
    for (int i = 0; truth && i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (column->component != PP_DF || column == truth || column->of_all_surfaces
            || is_stood_in_for(report, column))
            continue;
        if (!add_distances(table, report, column, truth))
            return false;
        if (pp_engine_of_column(column->name)
            && !add_apart(table, report, column, truth))
            return false;
    }
    return true;
}

/* True if the column has values without a standard error, which are interpolated. */
static bool is_interpolated(const struct pp_report *report,
                            const struct pp_column *column)
{
    for (int i = 0; i < report->receiver_count; i++)
        if (isfinite(column->points[i].value) && !isfinite(column->points[i].std_error))
            return true;
    return false;
}

/* Appends a description of the engine, such as "traced: by simulation, ± one standard
 * error, seed 1". */
static void say_engine(char *text, size_t size, const struct pp_report *report,
                       const struct pp_column *column,
                       const struct pp_study_options *options, bool utf8)
{
    const struct pp_engine *engine = pp_engine_of_column(column->name);
    const bool interpolated = is_interpolated(report, column);
    pp_text_append(text, size, "%s%s: %s, %s%s %s", text[0] ? "; " : "", column->name,
                   engine->said,
                   interpolated ? "interpolated at the points, with unknown error; "
                                : "",
                   utf8 ? "\xc2\xb1" : "+-", engine->deviation);
    if (engine->is_sampled)
        pp_text_append(text, size, ", seed %llu", (unsigned long long)options->seed);
}

/* Prints the engines and the notes on their values. Prints nothing if no engine was
 * used. */
static void print_simulation(const struct pp_result *result,
                             const struct pp_study_options *options, bool utf8,
                             int width, FILE *out)
{
    const struct pp_report *report = &result->report;
    const struct pp_column *truth = pp_engine_truth(report);
    char text[1024] = "";
    int engines = 0;
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (column->component != PP_DF || !pp_engine_of_column(column->name))
            continue;
        engines++;
        say_engine(text, sizeof text, report, column, options, utf8);
        if (column == truth)
            pp_text_append(text, sizeof text,
                           "; off: difference between the method and %s", column->name);
    }
    if (engines == 0)
        return;
    if (truth && engines > 1)
        pp_text_append(text, sizeof text,
                       "; diff./s.e.: difference between the engine and %s, divided by "
                       "the standard error of this difference",
                       truth->name);
    if (!report->finished)
        pp_text_append(text, sizeof text, "; NOT FINISHED, interrupted");
    else if (result->by_clock)
        pp_text_append(text, sizeof text,
                       "; stopped at the --time limit, so another run may differ");
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
}

/* ---- a room ---- */

/* Prints the sentence above a table that contains only averages, and adds its key
 * column. Returns false if memory is exhausted. */
static bool add_no_places(struct pp_table *table, const struct pp_report *report,
                          FILE *out)
{
    fprintf(out, "  Daylight factors in per cent, lengths in m; points at z = %.2f\n",
            report->receivers[0].position.z);
    table->key_count = 1;
    return pp_table_add(table, NULL, NULL, "       ") != NULL;
}

/* Prints the table. The daylight factors of a grid are arranged like the plan, and the
 * table then has only averages. If illuminances are requested, all values are in the
 * table. */
static enum pp_status print_table(const struct pp_report *report,
                                  const struct pp_study_options *options,
                                  bool all_bands, int width, bool utf8, FILE *out,
                                  struct pp_error *err)
{
    char lux_title[48];
    struct pp_lattice lattice;
    struct pp_report shown = *report;
    snprintf(lux_title, sizeof lux_title, "lux, for %g outside", options->external_lux);
    enum pp_status status =
        pp_lattice_find(&lattice, report->receivers, report->receiver_count, err);
    if (status != PP_OK)
        return status;
    bool as_plan = lattice.columns > 0 && options->external_lux == 0.0;
    if (as_plan)
        shown.receiver_count = 0;
    struct pp_table table;
    pp_table_init(&table, shown.receiver_count + 1);
    table.last_label = "average";
    bool good = (as_plan ? add_no_places(&table, report, out)
                         : pp_print_places(&table, &shown, width, out))
                && fill_table(&table, &shown, options->external_lux, lux_title,
                              all_bands, utf8);
    if (good) {
        fputc('\n', out);
        pp_table_print(&table, width, out);
        if (as_plan)
            pp_df_plane_tables(report, &lattice, width, out);
    }
    pp_table_clear(&table);
    pp_lattice_clear(&lattice);
    return good ? PP_OK : pp_fail_memory(err);
}

/* Prints the average daylight factors inside the margin. */
static void print_margin(const struct pp_report *report, bool utf8, int width,
                         FILE *out)
{
    char text[1024] = "";
    bool asked = false;
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        const struct pp_reading *mean = &column->margin_average;
        if (!column->has_margin_average || column->component != PP_DF)
            continue;
        asked = true;
        if (!isfinite(mean->value))
            continue;
        pp_text_append(text, sizeof text, "%s%s %.2f", text[0] ? ", " : "",
                       column->name, 100.0 * mean->value);
        if (isfinite(mean->std_error))
            pp_text_append(text, sizeof text, " %s%.2f", utf8 ? "\xc2\xb1" : "+-",
                           100.0 * mean->std_error);
    }
    if (!asked)
        return;
    fputs("\n  Average over the part of the plane 0.5 m or more from the walls, per "
          "cent:\n  ",
          out);
    pp_print_wrapped(text[0] ? text : "none", 2, 2, width, out);
}

static enum pp_status print_df_room(const struct pp_result *result,
                                    const struct pp_study_options *options,
                                    bool all_bands, int width, bool utf8, FILE *out,
                                    struct pp_error *err)
{
    const struct pp_report *report = &result->report;
    pp_print_title(report->world, result->file, out);
    fputc('\n', out);
    pp_print_assumed(report->world, &report->light, width, out);
    fputc('\n', out);

    enum pp_status status =
        print_table(report, options, all_bands, width, utf8, out, err);
    if (status != PP_OK)
        return status;
    pp_print_band_note(report, width, out);
    pp_df_plane_summary(report, width, utf8, out);
    print_margin(report, utf8, width, out);

    print_simulation(result, options, utf8, width, out);
    pp_formula_list_variants(options->method_options.variants, width, out);
    pp_df_steps(report, width, utf8, out);
    if (!pp_print_notes(report, width, out))
        return pp_fail_memory(err);
    struct pp_reliability reliability = pp_reliability_of(report);
    pp_print_reliability(&reliability, width, out);
    if (result->has_advice)
        pp_advice_report(&result->advice, report, width, out);
    return PP_OK;
}

enum pp_status pp_df_text(const struct pp_results *results, int width, bool utf8,
                          FILE *out, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < results->count && status == PP_OK; i++) {
        if (i > 0)
            fputs("\n\n", out);
        status = print_df_room(&results->list[i], results->options, results->bands,
                               width, utf8, out, err);
    }
    return status;
}
