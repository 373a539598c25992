/* hand_year_report.c - see hand_year_report.h. */
#include "reports/annual/hand_year_report.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "reports/df_steps.h"
#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "reports/parts/json_steps.h"
#include "reports/parts/print.h"
#include "reports/parts/table.h"

/* Figures that follow the autonomies, with their names in JSON and CSV. */
static const struct {
    const char *name;
    size_t offset;
    double unit;
} names[] = {
    {"udi-below", offsetof(struct pp_hand_figures, udi_below), 100.0},
    {"udi-low", offsetof(struct pp_hand_figures, udi_low), 100.0},
    {"udi-good", offsetof(struct pp_hand_figures, udi_good), 100.0},
    {"udi-above", offsetof(struct pp_hand_figures, udi_above), 100.0},
    {"mean-lux", offsetof(struct pp_hand_figures, mean_lx), 1.0},
};
enum { NAMES = sizeof names / sizeof *names };

static const struct pp_hand_figures *figures_at(const struct pp_hand_column *column,
                                                int point)
{
    return point >= 0 ? &column->points[point] : &column->mean;
}

static double figure_at(const struct pp_hand_column *column, int point, int name)
{
    const char *at = (const char *)figures_at(column, point) + names[name].offset;
    return names[name].unit * *(const double *)at;
}

/* ---- text ---- */

static void put_cell_number(struct pp_table_column *column, int row, double value,
                            int digits)
{
    if (isfinite(value))
        snprintf(column->cells[row], PP_CELL_BYTES, "%.*f", digits, value);
    else
        snprintf(column->cells[row], PP_CELL_BYTES, "-");
}

static bool put_places(struct pp_table *table, const struct pp_annual_sheet *sheet,
                       const struct pp_hand_year_sheet *hand)
{
    static const char *const headings[] = {"x", "y", "z", "DF %"};
    for (int axis = 0; axis < 4; axis++) {
        struct pp_table_column *column =
            pp_table_add(table, NULL, NULL, headings[axis]);
        if (!column)
            return false;
        for (int x = 0; x < sheet->receiver_count; x++) {
            struct pp_vec3 at = sheet->receivers[x].position;
            double value = axis == 0   ? at.x
                           : axis == 1 ? at.y
                           : axis == 2 ? at.z
                                       : 100.0 * hand->df[x];
            put_cell_number(column, x, value, axis == 3 ? 2 : 3);
        }
    }
    return true;
}

/* Adds a column of simulated values or, if `error` is set, of their standard errors. */
static bool put_simulated(struct pp_table *table, const struct pp_annual_sheet *sheet,
                          size_t offset, const char *heading, double unit, int digits,
                          bool error)
{
    struct pp_table_column *column =
        pp_table_add(table, "simulated", "sim.", error ? "se" : heading);
    for (int x = 0; column && x <= sheet->receiver_count; x++) {
        const struct pp_annual_figures *of =
            x < sheet->receiver_count ? &sheet->points[x] : &sheet->mean;
        const struct pp_annual_value *value =
            (const struct pp_annual_value *)((const char *)of + offset);
        put_cell_number(column, x, unit * (error ? value->std_error : value->value),
                        error ? digits + 1 : digits);
    }
    return column != NULL;
}

static size_t autonomy_offset(int i)
{
    return offsetof(struct pp_annual_figures, autonomy)
           + (size_t)i * sizeof(struct pp_annual_value);
}

static bool put_all_simulated(struct pp_table *table,
                              const struct pp_annual_sheet *sheet)
{
    bool good = true;
    for (int i = 0; i < 2 * sheet->illuminance_count && good; i++) {
        char heading[32];
        snprintf(heading, sizeof heading, "DA %g", sheet->illuminances_lx[i / 2]);
        good = put_simulated(table, sheet, autonomy_offset(i / 2), heading, 100.0, 1,
                             i % 2 == 1);
    }
    for (int i = 0; i < 4 && good; i++) {
        bool light = i < 2;
        good = put_simulated(table, sheet,
                             light ? offsetof(struct pp_annual_figures, mean_lx)
                                   : offsetof(struct pp_annual_figures, udi_good),
                             light ? "mean lx" : "300- 3000", light ? 1.0 : 100.0,
                             light ? 0 : 1, i % 2 == 1);
    }
    return good;
}

/* Adds a column of likely ranges for one target, if the method has any. */
static bool put_range(struct pp_table *table, const struct pp_annual_sheet *sheet,
                      const struct pp_hand_column *method, int target)
{
    bool any = false;
    for (int x = 0; x < sheet->receiver_count; x++)
        any |= isfinite(method->ranges[x].low[target]);
    if (!any)
        return true;
    struct pp_table_column *column =
        pp_table_add(table, method->name, method->name, "likely");
    for (int x = 0; column && x < sheet->receiver_count; x++)
        if (isfinite(method->ranges[x].low[target]))
            snprintf(column->cells[x], PP_CELL_BYTES, "%.0f-%.0f",
                     100.0 * method->ranges[x].low[target],
                     100.0 * method->ranges[x].high[target]);
    return column != NULL;
}

static bool put_method(struct pp_table *table, const struct pp_annual_sheet *sheet,
                       const struct pp_hand_column *method)
{
    enum { UDI_GOOD = 2, MEAN = 4 };
    for (int i = 0; i < sheet->illuminance_count + 2; i++) {
        char heading[32];
        int extra = i - sheet->illuminance_count;
        if (extra < 0)
            snprintf(heading, sizeof heading, "DA %g", sheet->illuminances_lx[i]);
        else
            snprintf(heading, sizeof heading, extra == 0 ? "mean lx" : "300- 3000");
        struct pp_table_column *column =
            pp_table_add(table, method->name, method->name, heading);
        if (!column)
            return false;
        for (int x = 0; x <= sheet->receiver_count; x++) {
            int point = x < sheet->receiver_count ? x : -1;
            double value = extra < 0
                               ? 100.0 * figures_at(method, point)->autonomy[i]
                               : figure_at(method, point, extra == 0 ? MEAN : UDI_GOOD);
            put_cell_number(column, x, value, extra == 0 ? 0 : 1);
        }
        if (extra < 0 && !put_range(table, sheet, method, i))
            return false;
    }
    return true;
}

static void print_methods(const struct pp_hand_year_sheet *hand, int width, FILE *out)
{
    enum { NAME = 16 };
    for (int i = 0; i < hand->column_count; i++) {
        const struct pp_hand_column *column = &hand->columns[i];
        char text[1024];
        snprintf(text, sizeof text, "%s [%s]. %s: %s", column->summary, column->source,
                 column->why ? "Not applicable" : "Assumptions",
                 column->why ? column->why : column->assumptions);
        fprintf(out, "  %-*s", NAME, column->name);
        pp_print_wrapped(text, NAME + 2, NAME + 2, width, out);
    }
}

static void print_explanations(const struct pp_hand_year_sheet *hand,
                               const struct pp_annual_sheet *sheet, int width,
                               bool utf8, FILE *out)
{
    for (int i = 0; i < hand->column_count; i++) {
        const struct pp_hand_column *column = &hand->columns[i];
        if (column->hour.count > 0) {
            fprintf(out, "\n  illuminance by %s, %s\n", column->name, hand->when);
            pp_df_steps_list(&column->hour, sheet->world, width, utf8, out);
        }
        if (column->year.count > 0) {
            fprintf(out, "\n  the year by %s\n", column->name);
            pp_df_steps_list(&column->year, sheet->world, width, utf8, out);
        }
    }
}

bool pp_hand_year_report_text(const struct pp_hand_year_sheet *hand,
                              const struct pp_annual_sheet *sheet, int width, bool utf8,
                              FILE *out)
{
    struct pp_table table;
    if (hand->column_count == 0 || !hand->finished)
        return true;
    fputs("\n  Hand methods for the year: ", out);
    pp_print_wrapped(hand->words, 29, 2, width, out);
    fputs("  ", out);
    pp_print_wrapped(hand->ranges, 2, 2, width, out);
    print_methods(hand, width, out);
    fputc('\n', out);
    pp_table_init(&table, sheet->receiver_count + 1);
    bool good = put_places(&table, sheet, hand) && put_all_simulated(&table, sheet);
    for (int i = 0; i < hand->column_count && good; i++)
        good = hand->columns[i].why || put_method(&table, sheet, &hand->columns[i]);
    table.key_count = 4;
    table.last_label = "mean";
    if (good)
        pp_table_print(&table, width, out);
    pp_table_clear(&table);
    print_explanations(hand, sheet, width, utf8, out);
    return good;
}

/* ---- JSON ---- */

static bool add_year_method(struct json_object *list,
                            const struct pp_hand_year_sheet *hand,
                            const struct pp_annual_sheet *sheet,
                            const struct pp_hand_column *column)
{
    struct json_object *object = json_object_new_object();
    bool good = pp_json_append(list, object)
                && pp_json_text(object, "name", column->name)
                && pp_json_text(object, "summary", column->summary)
                && pp_json_text(object, "source", column->source)
                && pp_json_text(object, "assumptions", column->assumptions);
    if (good && column->why)
        good = pp_json_text(object, "why", column->why);
    if (good && column->hour.count > 0)
        good = pp_json_text(object, "when", hand->when)
               && pp_json_steps_add(object, "hour", sheet->world, &column->hour);
    if (good && column->year.count > 0)
        good = pp_json_steps_add(object, "year", sheet->world, &column->year);
    return good;
}

bool pp_hand_year_report_json(struct json_object *object,
                              const struct pp_hand_year_sheet *hand,
                              const struct pp_annual_sheet *sheet)
{
    if (hand->column_count == 0 || !hand->finished)
        return true;
    struct json_object *list = json_object_new_array();
    bool good = pp_json_text(object, "methods-factors", hand->words)
                && pp_json_text(object, "methods-ranges", hand->ranges)
                && pp_json_add(object, "methods", list);
    for (int i = 0; i < hand->column_count && good; i++)
        good = add_year_method(list, hand, sheet, &hand->columns[i]);
    return good;
}

bool pp_hand_year_report_json_point(struct json_object *object,
                                    const struct pp_hand_year_sheet *hand,
                                    const struct pp_annual_sheet *sheet, int point)
{
    if (hand->column_count == 0 || !hand->finished)
        return true;
    struct json_object *methods = json_object_new_object();
    bool good = (point < 0 || pp_json_number(object, "df", 100.0 * hand->df[point]))
                && pp_json_add(object, "methods", methods);
    for (int i = 0; i < hand->column_count && good; i++) {
        const struct pp_hand_column *column = &hand->columns[i];
        struct json_object *line = json_object_new_object();
        good = pp_json_add(methods, column->name, line);
        if (!good)
            break;
        pp_json_on_one_line(line);
        for (int k = 0; k < sheet->illuminance_count && good; k++) {
            char key[32];
            snprintf(key, sizeof key, "da%g", sheet->illuminances_lx[k]);
            good = pp_json_number(line, key,
                                  100.0 * figures_at(column, point)->autonomy[k]);
            if (good && point >= 0 && isfinite(column->ranges[point].low[k])) {
                double ends[2] = {100.0 * column->ranges[point].low[k],
                                  100.0 * column->ranges[point].high[k]};
                snprintf(key, sizeof key, "da%g-range", sheet->illuminances_lx[k]);
                good = pp_json_numbers(line, key, ends, 2);
            }
        }
        for (int k = 0; k < NAMES && good; k++)
            good = pp_json_number(line, names[k].name, figure_at(column, point, k));
    }
    return good;
}

/* ---- CSV ---- */

int pp_hand_year_report_csv_columns(const struct pp_hand_year_sheet *hand,
                                    const struct pp_annual_sheet *sheet)
{
    if (hand->column_count == 0)
        return 0;
    /* Each autonomy has three columns: the value and both ends of its likely range. */
    return 1 + hand->column_count * (3 * sheet->illuminance_count + NAMES);
}

void pp_hand_year_report_csv_heading(const struct pp_hand_year_sheet *hand,
                                     const struct pp_annual_sheet *sheet, FILE *out)
{
    if (hand->column_count > 0)
        fputs(",df", out);
    for (int i = 0; i < hand->column_count; i++) {
        const char *name = hand->columns[i].name;
        for (int k = 0; k < sheet->illuminance_count; k++)
            fprintf(out, ",%s.da%g,%s.da%g_low,%s.da%g_high", name,
                    sheet->illuminances_lx[k], name, sheet->illuminances_lx[k], name,
                    sheet->illuminances_lx[k]);
        for (int k = 0; k < NAMES; k++)
            fprintf(out, ",%s.%s", name, names[k].name);
    }
}

void pp_hand_year_report_csv(const struct pp_hand_year_sheet *hand,
                             const struct pp_annual_sheet *sheet, int point, FILE *out)
{
    if (hand->column_count > 0)
        pp_format_csv_number(point >= 0 ? 100.0 * hand->df[point] : NAN, out);
    for (int i = 0; i < hand->column_count; i++) {
        const struct pp_hand_column *column = &hand->columns[i];
        for (int k = 0; k < sheet->illuminance_count; k++) {
            bool known = point >= 0;
            pp_format_csv_number(100.0 * figures_at(column, point)->autonomy[k], out);
            pp_format_csv_number(known ? 100.0 * column->ranges[point].low[k] : NAN,
                                 out);
            pp_format_csv_number(known ? 100.0 * column->ranges[point].high[k] : NAN,
                                 out);
        }
        for (int k = 0; k < NAMES; k++)
            pp_format_csv_number(figure_at(column, point, k), out);
    }
}
