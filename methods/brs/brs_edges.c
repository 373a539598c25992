/* brs_edges.c - reads the tables and adds up the readings. */
#include "methods/brs/brs_edges.h"

#include <math.h>
#include <stddef.h>

/* ---- the table ---- */

/* The position of x between two printed values: 0 at low, 1 at high. */
static double interpolation_share(double x, double low, double high)
{
    return isinf(high) ? 1.0 - low / x : (x - low) / (high - low);
}

/* Finds the first column with w/d not below `aside` (counted from 1; the last column if
 * there is none). *t is the interpolation fraction: 1 at that column, and 0 at the
 * preceding column (at w/d = 0 for the first). */
static int brs_column(const struct pp_brs_cells *table, double aside, double *t)
{
    const double *head = table->cells;
    int k = 1;
    while (k < table->columns - 1 && aside > head[k])
        k++;
    *t = interpolation_share(aside, k > 1 ? head[k - 1] : 0.0, head[k]);
    return k;
}

static double up_of(const struct pp_brs_cells *table, int row)
{
    return table->cells[row * table->columns];
}

/* Finds the row with the lowest height that is not below `up` (counted from 1; row 1 if
 * there is none). *t is the interpolation fraction: 1 at that row, and 0 at the row of
 * the next lower height. */
static int row_of(const struct pp_brs_cells *table, double up, double *t)
{
    int i = table->rows - 1;
    while (i > 1 && up > up_of(table, i))
        i--;
    *t = interpolation_share(up, i == table->rows - 1 ? 0.0 : up_of(table, i + 1),
                             up_of(table, i));
    return i;
}

/* Value of a row between two columns, in per cent; 0 below the last row. */
static double read_brs_row(const struct pp_brs_cells *table, int row, int column,
                           double t)
{
    if (row == table->rows)
        return 0.0;
    const double *cells = table->cells + row * table->columns;
    double low = column > 1 ? cells[column - 1] : 0.0;
    return low + t * (cells[column] - low);
}

double pp_brs_edges_read(const struct pp_brs_cells *table, double up, double aside)
{
    if (!(up > 0.0 && aside > 0.0))
        return 0.0;
    double down, t;
    int column = brs_column(table, aside, &t), row = row_of(table, up, &down);
    double low_value = read_brs_row(table, row + 1, column, t);
    double high_value = read_brs_row(table, row, column, t);
    return (low_value + down * (high_value - low_value)) / 100.0;
}

void pp_brs_edges_place(const struct pp_brs_cells *table, double up, double aside,
                        double *row, double *column)
{
    double down, t;
    *column = brs_column(table, aside, &t) - 2.0;
    *row = row_of(table, up, &down);
    *column += t;
    *row -= down;
}

/* ---- the formulae ---- */

#define BRS(left, right, what_of, quantities_of, is_fixed)                             \
    {                                                                                  \
        .symbol = left, .sum = right, .unit = PP_UNIT_DAYLIGHT_FACTOR,                 \
        .source = "HLG58", .what = what_of, .quantities = quantities_of,               \
        .fixed = is_fixed                                                              \
    }

static const struct pp_formula_quantity of_upper[] = {
    {"h", PP_UNIT_NUMBER, "height of the upper edge divided by the distance"},
    {"T_hl", PP_UNIT_DAYLIGHT_FACTOR,
     "table value for the part from the normal to the left jamb"},
    {"T_hr", PP_UNIT_DAYLIGHT_FACTOR,
     "table value for the part from the normal to the right jamb"},
    {0},
};
static const struct pp_formula_quantity of_lower[] = {
    {"s", PP_UNIT_NUMBER, "height of the lower edge divided by the distance"},
    {"T_sl", PP_UNIT_DAYLIGHT_FACTOR,
     "table value for the part from the normal to the left jamb"},
    {"T_sr", PP_UNIT_DAYLIGHT_FACTOR,
     "table value for the part from the normal to the right jamb"},
    {0},
};

static const char both_sides[] = "one jamb on each side of the normal",
                  to_the_left[] = "both jambs to the left of the normal",
                  to_the_right[] = "both jambs to the right of the normal";

const struct pp_formula pp_brs_edges_upper[3] = {
    BRS("H", "T_hl + T_hr", both_sides, of_upper, true),
    BRS("H", "T_hl - T_hr", to_the_left, of_upper, true),
    BRS("H", "T_hr - T_hl", to_the_right, of_upper, true)};
const struct pp_formula pp_brs_edges_lower[3] = {
    BRS("S", "T_sl + T_sr", both_sides, of_lower, true),
    BRS("S", "T_sl - T_sr", to_the_left, of_lower, true),
    BRS("S", "T_sr - T_sl", to_the_right, of_lower, true)};

static const struct pp_formula_quantity of_rectangle[] = {
    {"H", PP_UNIT_DAYLIGHT_FACTOR, "table value at the upper edge"},
    {"S", PP_UNIT_DAYLIGHT_FACTOR,
     "table value at the lower edge (0 where the table starts)"},
    {0},
};
static const struct pp_formula_quantity of_hidden[] = {
    {"e", PP_UNIT_DAYLIGHT_FACTOR, "equivalent sky component of the obstruction"},
    {"f", PP_UNIT_NUMBER, "luminance factor of the obstruction"},
    {0},
};

static const char in_words[] = "sky component",
                  equivalent[] = "equivalent sky component of the obstruction",
                  external[] = "externally reflected component";

const struct pp_formula pp_brs_edges_sky[2] = {
    BRS("sc", "H - S", in_words, of_rectangle, false),
    BRS("sc", "H", "sky component, for a lower edge where the table starts",
        of_rectangle, false)};
const struct pp_formula pp_brs_edges_equivalent[2] = {
    BRS("e", "H - S", equivalent, of_rectangle, false),
    BRS("e", "H",
        "equivalent sky component of the obstruction, for a lower edge where the table "
        "starts",
        of_rectangle, false)};
const struct pp_formula pp_brs_edges_reflected =
    BRS("erc", "f e", external, of_hidden, false);
const struct pp_formula pp_brs_edges_across[4] = {
    BRS("sc", "H + S", "sky component of a point under the glass", of_rectangle, true),
    BRS("e", "H + S",
        "equivalent sky component of an obstruction, for a point under the glass",
        of_rectangle, true),
    BRS("sc", "S - H", "sky component, with both edges below the normal", of_rectangle,
        true),
    BRS("e", "S - H",
        "equivalent sky component of an obstruction, with both edges below the normal",
        of_rectangle, true)};
const struct pp_formula pp_brs_edges_less = BRS(
    "sc", "-e", "reduction of the sky component by an obstruction", of_hidden, true);

/* ---- the sum ---- */

/* An edge of a rectangle: its symbols and name, and the formulae of its sum. The
 * formula depends on the sides of the normal on which the jambs lie. */
static const struct edge {
    const char *height, *left, *right, *what;
    const struct pp_formula *sums; /* formulae of the sum for jambs on both sides, both
                                    * to the left, both to the right */
} upper = {"h", "T_hl", "T_hr", "upper edge", pp_brs_edges_upper},
  lower = {"s", "T_sl", "T_sr", "lower edge", pp_brs_edges_lower};

/* Records the readings of an edge and their sum. Readings on both sides of the normal
 * are added; on one side, the narrower is subtracted from the wider. */
static void work_edge(struct pp_worksheet *sheet, const struct edge *edge,
                      const struct pp_brs_cells *table, double up,
                      const struct pp_brs_rectangle *at, const char *measure)
{
    double left = fabs(at->left), right = fabs(at->right);
    bool both = at->left < 0.0 && at->right > 0.0;
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, up, edge->height,
                     "%s: height divided by the distance, %s", edge->what, measure);
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, pp_brs_edges_read(table, up, left),
                     edge->left, "table value at this %s and w/d %.3f", measure, left);
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR,
                     pp_brs_edges_read(table, up, right), edge->right,
                     "table value at this %s and w/d %.3f", measure, right);
    pp_worksheet_work(sheet,
                      &edge->sums[both              ? 0
                                  : at->right > 0.0 ? 2
                                                    : 1],
                      both ? "sum of the values for both sides of the normal"
                           : "value of the wider part minus that of the narrower part");
}

/* Formula that combines the sums of both edges. The formula depends on whether the
 * lower edge is above, at or below the origin of the table. */
static const struct pp_formula *sum_of(const struct pp_brs_rectangle *at)
{
    if (at->low < 0.0)
        return &pp_brs_edges_across[(at->high > 0.0 ? 0 : 2) + at->hidden];
    const struct pp_formula *sums =
        at->hidden ? pp_brs_edges_equivalent : pp_brs_edges_sky;
    return &sums[at->low > 0.0 ? 0 : 1];
}

void pp_brs_edges_work(struct pp_part_steps *terms, struct pp_part *sum,
                       const struct pp_brs_cells *table,
                       const struct pp_brs_rectangle *at, const char *measure)
{
    struct pp_worksheet *sheet = terms->sheet;
    pp_part_steps_next(terms);
    pp_worksheet_note(
        sheet, PP_UNIT_NUMBER, at->left,
        "%s: distance of the left jamb from the normal, divided by d: w/d (right "
        "positive)",
        at->hidden ? "obstruction" : "sky");
    pp_worksheet_note(sheet, PP_UNIT_NUMBER, at->right,
                      "distance of the right jamb from the normal, divided by d: w/d");
    work_edge(sheet, &upper, table, fabs(at->high), at, measure);
    if (at->low != 0.0)
        work_edge(sheet, &lower, table, fabs(at->low), at, measure);
    else
        pp_worksheet_know(sheet, PP_UNIT_DAYLIGHT_FACTOR, 0.0, "S");
    if (!at->hidden) {
        sum->sky += pp_part_steps_work(terms, false, sum_of(at), in_words);
        return;
    }
    pp_worksheet_work(sheet, sum_of(at), "%s", equivalent);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, at->factor, "f",
                     "luminance factor of the obstruction");
    sum->external += pp_part_steps_work(terms, true, &pp_brs_edges_reflected, external);
    if (at->off_sky)
        sum->sky += pp_part_steps_work(terms, false, &pp_brs_edges_less,
                                       "reduction of the sky component");
}
