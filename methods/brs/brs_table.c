/* brs_table.c - `brs-table`: sky component and externally reflected component by the
 * BRS simplified daylight table.                                            [HLG58]
 *
 * The table, T(h/d, w/d), gives the sky component of a vertical, clear-glazed window at
 * a point of the working plane under the CIE overcast sky. The window's sill is level
 * with the point and its head h above the point; one jamb is on the normal through the
 * point, the other w to the side; d is the distance. As published:
 *
 *   - a window on both sides of the normal: the two halves added
 *   - a window to one side: the wider less the narrower
 *   - a sill above the point: head less sill
 *   - an obstruction: as if its head were the sill; the difference is the equivalent
 *     sky component of the obstruction, and the externally reflected component is 0.2
 *     (the obstruction's reflectance) times that difference
 *
 * Interpolation is linear between neighbours in both directions, linear in the
 * reciprocal between the last printed column or row and infinity, and linear to zero
 * below the first. elevation.h says how openings and obstructions become rectangles; a
 * negative sum counts as 0.
 *
 * For vertical openings with clear glass, or none, and points that face up under the
 * CIE overcast sky. The figures contain clear single glass; no frame, no dirt. At 1 to
 * 7 m from the window, readings of 1 % and more are 1.4 % low on average against the
 * exact direct component with that glass, 3.4 % rms; a window far to one side, the
 * small difference of two cells, can be 20 % off, and nearer than the table's last row
 * twice that.
 */
#include "methods/brs/brs_table.h"

#include <stddef.h>

#include "methods/view/elevation.h"
#include "methods/method.h"
#include "methods/refusals.h"
#include "methods/part_steps.h"

/* The first row holds w/d; each other row h/d (from infinity down), then per cent. */
static const double printed[][21] = {
#include "tables/brs_simplified_table.inc"
};

enum {
    ROWS = sizeof printed / sizeof printed[0],
    COLUMNS = sizeof printed[0] / sizeof printed[0][0]
};

/* The position of x between two printed values: 0 at low, 1 at high. */
static double between(double x, double low, double high)
{
    return isinf(high) ? 1.0 - low / x : (x - low) / (high - low);
}

/* The last of the columns that w/d is read in, from 1, and how far it is from the one
 * before, which is zero before the first. */
static int column_of(double w_over_d, double *t)
{
    const double *head = printed[0];
    int k = 1;
    while (k < COLUMNS - 1 && w_over_d > head[k])
        k++;
    *t = between(w_over_d, k > 1 ? head[k - 1] : 0.0, head[k]);
    return k;
}

/* The upper one of the rows, from 1, and how far h/d is from the lower. */
static int row_of(double h_over_d, double *t)
{
    int i = ROWS - 1;
    while (i > 1 && h_over_d > printed[i][0])
        i--;
    *t = between(h_over_d, i == ROWS - 1 ? 0.0 : printed[i + 1][0], printed[i][0]);
    return i;
}

/* A row, in per cent; zero below the last. */
static double read_row(int row, int column, double t)
{
    if (row == ROWS)
        return 0.0;
    double low = column > 1 ? printed[row][column - 1] : 0.0;
    return low + t * (printed[row][column] - low);
}

double pp_brs_table_read(double h_over_d, double w_over_d)
{
    if (!(h_over_d > 0.0 && w_over_d > 0.0))
        return 0.0;
    double down, t;
    int column = column_of(w_over_d, &t), row = row_of(h_over_d, &down);
    double low_value = read_row(row + 1, column, t);
    double high_value = read_row(row, column, t);
    return (low_value + down * (high_value - low_value)) / 100.0;
}

void pp_brs_table_place(double h_over_d, double w_over_d, double *row, double *column)
{
    double down, t;
    *column = column_of(w_over_d, &t) - 2.0;
    *row = row_of(h_over_d, &down);
    *column += t;
    *row -= down;
}

double pp_brs_table_h_over_d(int row)
{
    return printed[row + 1][0];
}

double pp_brs_table_w_over_d(int column)
{
    return printed[0][column + 1];
}

double pp_brs_table_percent(int row, int column)
{
    return printed[row + 1][column + 1];
}

/* ---- the sum ---- */

/* An edge of a rectangle: what it is called, and its sums by the side of the jambs. */
struct edge {
    const char *height, *left, *right, *what;
    struct pp_formula added, left_less, right_less;
};

#define BRS(left, right, what_of, quantities_of, is_fixed)                             \
    {                                                                                  \
        .symbol = left, .sum = right, .unit = PP_UNIT_SHARE, .source = "HLG58",        \
        .what = what_of, .quantities = quantities_of, .fixed = is_fixed                \
    }

static const struct pp_formula_quantity of_upper[] = {
    {"h", PP_UNIT_NUMBER, "upper edge over distance"},
    {"T_hl", PP_UNIT_SHARE, "table there, to the left jamb"},
    {"T_hr", PP_UNIT_SHARE, "table there, to the right jamb"},
    {0},
};
static const struct pp_formula_quantity of_lower[] = {
    {"s", PP_UNIT_NUMBER, "lower edge over distance"},
    {"T_sl", PP_UNIT_SHARE, "table there, to the left jamb"},
    {"T_sr", PP_UNIT_SHARE, "table there, to the right jamb"},
    {0},
};

static const char both_sides[] = "jambs on both sides of the normal",
                  to_the_left[] = "both jambs to the left of the normal",
                  to_the_right[] = "both jambs to the right of the normal";

static const struct edge upper = {
    "h",
    "T_hl",
    "T_hr",
    "upper edge",
    BRS("H", "T_hl + T_hr", both_sides, of_upper, true),
    BRS("H", "T_hl - T_hr", to_the_left, of_upper, true),
    BRS("H", "T_hr - T_hl", to_the_right, of_upper, true)};
static const struct edge lower = {
    "s",
    "T_sl",
    "T_sr",
    "lower edge",
    BRS("S", "T_sl + T_sr", both_sides, of_lower, true),
    BRS("S", "T_sl - T_sr", to_the_left, of_lower, true),
    BRS("S", "T_sr - T_sl", to_the_right, of_lower, true)};

static const struct pp_formula_quantity of_rectangle[] = {
    {"H", PP_UNIT_SHARE, "sum at the upper edge"},
    {"S", PP_UNIT_SHARE, "sum at the lower edge; 0 at the point's height"},
    {0},
};
static const struct pp_formula_quantity of_hidden[] = {
    {"e", PP_UNIT_SHARE, "equivalent sky component of the obstruction"},
    {"f", PP_UNIT_NUMBER, "luminance factor of the obstruction"},
    {0},
};

static const char in_words[] = "sky component",
                  equivalent[] = "equivalent sky component of the obstruction",
                  external[] = "externally reflected component";

static const struct pp_formula sky_raised =
    BRS("sc", "H - S", "sky component", of_rectangle, false);
static const struct pp_formula sky_level = BRS(
    "sc", "H", "sky component, lower edge at the point's height", of_rectangle, false);
static const struct pp_formula equivalent_raised =
    BRS("e", "H - S", equivalent, of_rectangle, false);
static const struct pp_formula equivalent_level =
    BRS("e", "H", "the same, lower edge at the point's height", of_rectangle, false);
static const struct pp_formula reflected =
    BRS("erc", "f e", external, of_hidden, false);

static const struct pp_formula *const formulae[] = {
    &upper.added,       &upper.left_less,  &upper.right_less, &lower.added,
    &lower.left_less,   &lower.right_less, &sky_raised,       &sky_level,
    &equivalent_raised, &equivalent_level, &reflected,        NULL};

/* Works out an edge: the readings on both sides of the normal added, else the wider less
 * the narrower. */
static void work_edge(struct pp_worksheet *sheet, const struct edge *edge,
                      double h_over_d, const struct pp_elevation_part *part)
{
    double left = fabs(part->left), right = fabs(part->right);
    bool both = part->left < 0.0 && part->right > 0.0;
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, h_over_d, edge->height,
                     "%s over distance, h/d", edge->what);
    pp_worksheet_put(sheet, PP_UNIT_SHARE, pp_brs_table_read(h_over_d, left),
                     edge->left, "table at that h/d and w/d %.3f", left);
    pp_worksheet_put(sheet, PP_UNIT_SHARE, pp_brs_table_read(h_over_d, right),
                     edge->right, "table at that h/d and w/d %.3f", right);
    pp_worksheet_work(sheet,
                      both                ? &edge->added
                      : part->right > 0.0 ? &edge->right_less
                                          : &edge->left_less,
                      both ? "both sides of the normal added"
                           : "the wider less the narrower");
}

/* Adds a rectangle of sky or of an obstruction: upper edge less lower edge, whose reading
 * is 0 at the point's height. */
static void work_rectangle(struct pp_part_steps *terms, struct pp_part *sum,
                           const struct pp_elevation_part *part)
{
    struct pp_worksheet *sheet = terms->sheet;
    bool hidden = !isnan(part->reflectance), raised = part->low > 0.0;
    pp_part_steps_next(terms);
    pp_worksheet_note(sheet, PP_UNIT_NUMBER, part->left,
                      "%s: left jamb over distance, w/d, right is positive",
                      hidden ? "obstruction" : "sky");
    pp_worksheet_note(sheet, PP_UNIT_NUMBER, part->right, "right jamb");
    work_edge(sheet, &upper, part->high, part);
    if (raised)
        work_edge(sheet, &lower, part->low, part);
    else
        pp_worksheet_know(sheet, PP_UNIT_SHARE, 0.0, "S");
    if (!hidden) {
        sum->sky += pp_part_steps_work(terms, false, raised ? &sky_raised : &sky_level,
                                       in_words);
        return;
    }
    pp_worksheet_work(sheet, raised ? &equivalent_raised : &equivalent_level, "%s",
                      equivalent);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, part->reflectance, "f",
                     "luminance factor of the obstruction");
    sum->external += pp_part_steps_work(terms, true, &reflected, external);
}

/* ---- the method ---- */

static const char *refuses_room(const struct pp_world *world,
                                const struct pp_outside_light *light,
                                const struct pp_receiver *receiver)
{
    const char *why = pp_refusals_unless_overcast_and_up(light, receiver);
    return why ? why : pp_refusals_if_luminous(world);
}

static const char *refuses(const struct pp_world *world,
                           const struct pp_outside_light *light,
                           const struct pp_opening *opening,
                           const struct pp_receiver *receiver)
{
    (void)world, (void)light, (void)receiver;
    if (opening->glass.diffusing)
        return "has diffusing glass; the table holds clear glass only";
    return pp_refusals_unless_vertical(opening);
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_outside_light *light,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    (void)light, (void)tools;
    struct pp_elevation elevation;
    enum pp_status status =
        pp_elevation_init(&elevation, world, opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    pp_worksheet_note(
        &part->sheet, PP_UNIT_METRE,
        pp_vec_dot(pp_vec_sub(receiver->position, opening->inner.vertices[0]),
                   opening->inner.normal),
        "distance d of the point from the opening's plane");
    struct pp_part_steps terms = pp_part_steps_on(&part->sheet, elevation.count);
    for (int i = 0; i < elevation.count; i++)
        work_rectangle(&terms, part, elevation.parts + i);
    pp_part_steps_end(&terms);
    part->sky = fmax(part->sky, 0.0);
    part->external = fmax(part->external, 0.0);
    pp_elevation_clear(&elevation);
    return PP_OK;
}

const struct pp_method pp_method_brs_table = {
    .name = "brs-table",
    .summary = "direct component by the BRS simplified daylight table",
    .source = "HLG58",
    .formulae = formulae,
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_CLEAR_GLASS,
    .refuses_room = refuses_room,
    .refuses = refuses,
    .evaluate = evaluate,
};
