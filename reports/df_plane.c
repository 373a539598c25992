/* df_plane.c - prints values arranged like the plan, and the summary of a plane. */
#include "reports/df_plane.h"

#include <math.h>
#include <string.h>

#include "model/base/text.h"
#include "model/results/reading.h"
#include "reports/parts/print.h"
#include "reports/parts/print_band.h"

enum { CELL = 7, BAND_CELL = 12, EDGE = 8, SHARE = 6, WORDS = 96 };

/* Prints a cell padded to `columns` on the terminal, where a multibyte character
 * occupies one column. */
static void put_padded(const char *cell, int columns, FILE *out)
{
    int bytes = (int)strlen(cell), shown = 0;
    for (int i = 0; i < bytes; i++)
        shown += ((unsigned char)cell[i] & 0xc0) != 0x80;
    fprintf(out, "%*s%s", columns > shown ? columns - shown : 0, "", cell);
}

/* ---- values arranged like the plan ---- */

static bool has_points(const struct pp_report *report, const struct pp_column *column)
{
    if (column->component != PP_DF || !column->points)
        return false;
    for (int i = 0; i < report->receiver_count; i++)
        if (isfinite(column->points[i].value))
            return true;
    return false;
}

/* Values to be printed at the points: the daylight factors of a column, or their
 * bands. */
struct layer {
    const struct pp_column *column;
    const struct pp_lattice *lattice;
    bool bands;
    int cell; /* width of a cell for one point, in columns of the terminal */
};

static void put_point(const struct layer *layer, int at, char cell[WORDS])
{
    double value = layer->column->points[at].value;
    if (layer->bands)
        pp_print_band(cell, WORDS, layer->column->bands[at]);
    else if (isfinite(value))
        snprintf(cell, WORDS, "%.2f", 100.0 * value + 0.0);
    else
        snprintf(cell, WORDS, "-");
}

static void put_plane_row(const struct layer *layer, int row, int first, int last,
                          FILE *out)
{
    const struct pp_lattice *lattice = layer->lattice;
    fprintf(out, "%*.2f |", EDGE, lattice->y[row]);
    for (int i = first; i < last; i++) {
        int at = lattice->receivers[row * lattice->columns + i];
        char cell[WORDS] = "";
        if (at >= 0)
            put_point(layer, at, cell);
        put_padded(cell, layer->cell, out);
    }
    fputc('\n', out);
}

static void put_panel(const struct layer *layer, int first, int last, FILE *out)
{
    const struct pp_lattice *lattice = layer->lattice;
    fprintf(out, "\n%*s\n", EDGE, "y");
    for (int row = lattice->rows - 1; row >= 0; row--)
        put_plane_row(layer, row, first, last, out);
    fprintf(out, "%*s +", EDGE, "");
    for (int i = 0; i < layer->cell * (last - first); i++)
        fputc('-', out);
    fprintf(out, "\n%*s  ", EDGE, "x");
    for (int i = first; i < last; i++)
        fprintf(out, "%*.2f", layer->cell, lattice->x[i]);
    fputc('\n', out);
}

static void put_layer(const struct layer *layer, int width, FILE *out)
{
    int most = (width - EDGE - 2) / layer->cell, columns = layer->lattice->columns;
    most = most < 1 ? 1 : most;
    for (int first = 0; first < columns; first += most)
        put_panel(layer, first, first + most < columns ? first + most : columns, out);
}

void pp_df_plane_tables(const struct pp_report *report,
                        const struct pp_lattice *lattice, int width, FILE *out)
{
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (!has_points(report, column))
            continue;
        struct layer layer = {column, lattice, false, CELL};
        fprintf(out, "\n  Daylight factors by %s, per cent\n", column->name);
        put_layer(&layer, width, out);
        if (!column->bands)
            continue;
        layer.bands = true;
        layer.cell = BAND_CELL;
        fprintf(out, "\n  95 %% band of the daylight factors by %s, per cent\n",
                column->name);
        put_layer(&layer, width, out);
    }
}

/* ---- summary of the plane ---- */

/* Writes a value in per cent: "1.25", or "1.25 ±0.02" with its standard error. */
static void put_reading(char cell[WORDS], const struct pp_reading *reading, bool utf8)
{
    snprintf(cell, WORDS, "%.2f", 100.0 * reading->value + 0.0);
    if (isfinite(reading->std_error))
        pp_text_append(cell, WORDS, " %s%.2f", utf8 ? "\xc2\xb1" : "+-",
                       pp_reading_printed_error(reading));
}

static void put_line(const struct pp_column *column, int name, int wide, bool utf8,
                     FILE *out)
{
    const struct pp_plane_reading *plane = &column->plane;
    const struct pp_reading *readings[] = {&plane->minimum, &plane->median,
                                           &plane->average};
    fprintf(out, "  %-*s", name, column->name);
    for (int k = 0; k < 3; k++) {
        char cell[WORDS];
        put_reading(cell, readings[k], utf8);
        put_padded(cell, wide, out);
    }
    if (isfinite(plane->uniformity))
        fprintf(out, "%9.4f", plane->uniformity);
    else /* NAN: the whole plane is dark */
        put_padded("-", 9, out);
    for (int k = 0; k < PP_PLANE_LEVELS; k++)
        fprintf(out, "%5.0f%%", 100.0 * plane->over[k]);
    fputc('\n', out);
}

void pp_df_plane_summary(const struct pp_report *report, int width, bool utf8,
                         FILE *out)
{
    static const char *const heads[] = {"minimum", "median", "mean"};
    int name = 0, wide = 9;
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        int length = (int)strlen(column->name);
        if (!column->has_plane)
            continue;
        name = length > name ? length : name;
        if (isfinite(column->plane.average.std_error))
            wide = 12;
    }
    if (name == 0)
        return;
    char text[256];
    snprintf(
        text, sizeof text,
        report->grid_of_standard
            ? "Working plane at the %d points of the EN 17037 grid, 0.5 m or more from "
              "the walls. Figures are in per cent; uniformity is minimum divided by "
              "mean. The last columns show the share of points that reach a level"
            : "Working plane at the %d points of the grid. Figures are in per cent; "
              "uniformity is minimum divided by mean. The last columns show the share "
              "of points that reach a level",
        report->grid_points);
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
    fprintf(out, "\n  %-*s", name, "");
    for (int k = 0; k < 3; k++)
        put_padded(heads[k], wide, out);
    fputs(" min/mean", out);
    for (int k = 0; k < PP_PLANE_LEVELS; k++) {
        char head[WORDS];
        snprintf(head, sizeof head, "%s%g%%",
                 utf8 ? "\xe2\x89\xa5" : ">=", 100.0 * pp_plane_levels[k]);
        put_padded(head, SHARE, out);
    }
    fputc('\n', out);
    for (int i = 0; i < report->column_count; i++)
        if (report->columns[i].has_plane)
            put_line(&report->columns[i], name, wide, utf8, out);
}
