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
#include "methods/brs_table.h"

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

/* The table's row h/d = `row` at w/d, in per cent. */
static double read_row(const double *row, double w_over_d)
{
    const double *head = printed[0];
    int k = 1;
    while (k < COLUMNS - 1 && w_over_d > head[k])
        k++;
    double low = k > 1 ? head[k - 1] : 0.0, low_value = k > 1 ? row[k - 1] : 0.0;
    return low_value + between(w_over_d, low, head[k]) * (row[k] - low_value);
}

double pp_brs_table_read(double h_over_d, double w_over_d)
{
    if (!(h_over_d > 0.0 && w_over_d > 0.0))
        return 0.0;
    int i = ROWS - 1;
    while (i > 1 && h_over_d > printed[i][0])
        i--;
    bool first = i == ROWS - 1;
    double low = first ? 0.0 : printed[i + 1][0];
    double low_value = first ? 0.0 : read_row(printed[i + 1], w_over_d);
    double high_value = read_row(printed[i], w_over_d);
    double t = between(h_over_d, low, printed[i][0]);
    return (low_value + t * (high_value - low_value)) / 100.0;
}

/* Sky component from the normal to x/d: positive to the right, negative to the left. */
static double signed_read(double h_over_d, double x_over_d)
{
    return copysign(pp_brs_table_read(h_over_d, fabs(x_over_d)), x_over_d);
}

/* Sky component of a rectangle: its head less its sill. */
static double read_rectangle(const struct pp_elevation_part *part)
{
    double head =
        signed_read(part->high, part->right) - signed_read(part->high, part->left);
    double sill =
        signed_read(part->low, part->right) - signed_read(part->low, part->left);
    return head - sill;
}

/* ---- steps ---- */

/* Symbols, formulae and words for the steps of an edge. */
struct edge_names {
    const char *height, *left, *right, *sum;
    const char *added, *left_less, *right_less; /* formulae */
    const char *what;
};

static const struct edge_names upper = {
    "h",         "T_hl", "T_hr", "H", "T_hl# + T_hr#", "T_hl# - T_hr#", "T_hr# - T_hl#",
    "upper edge"};
static const struct edge_names lower = {
    "s",         "T_sl", "T_sr", "S", "T_sl# + T_sr#", "T_sl# - T_sr#", "T_sr# - T_sl#",
    "lower edge"};

/* Records the readings at one edge: both sides of the normal added, else the wider less
 * the narrower. */
static void add_edge_steps(struct pp_part_steps *terms, const struct edge_names *edge,
                           double h_over_d, const struct pp_elevation_part *part)
{
    struct pp_steps *steps = terms->steps;
    pp_steps_add_named(steps, PP_UNIT_NUMBER, h_over_d,
                       pp_part_steps_symbol(terms, edge->height).text,
                       "%s over distance, h/d", edge->what);
    pp_steps_add_named(steps, PP_UNIT_SHARE,
                       pp_brs_table_read(h_over_d, fabs(part->left)),
                       pp_part_steps_symbol(terms, edge->left).text,
                       "table at that h/d and w/d %.3f", fabs(part->left));
    pp_steps_add_named(steps, PP_UNIT_SHARE,
                       pp_brs_table_read(h_over_d, fabs(part->right)),
                       pp_part_steps_symbol(terms, edge->right).text,
                       "table at that h/d and w/d %.3f", fabs(part->right));
    double sum = signed_read(h_over_d, part->right) - signed_read(h_over_d, part->left);
    pp_part_steps_figure(terms, PP_UNIT_SHARE, sum, edge->sum,
                         part->left < 0.0 && part->right > 0.0 ? edge->added
                         : part->right > 0.0                   ? edge->right_less
                                                               : edge->left_less,
                         part->left < 0.0 && part->right > 0.0
                             ? "both sides of the normal added"
                             : "the wider less the narrower");
}

/* Records a rectangle: upper edge less lower edge, whose reading is 0 at the point's
 * height. */
static void add_rectangle_steps(struct pp_part_steps *terms,
                                const struct pp_elevation_part *part)
{
    bool hidden = !isnan(part->reflectance);
    double share = read_rectangle(part);
    pp_part_steps_next(terms);
    pp_steps_add(terms->steps, PP_UNIT_NUMBER, part->left,
                 "%s: left jamb over distance, w/d, right is positive",
                 hidden ? "obstruction" : "sky");
    pp_steps_add(terms->steps, PP_UNIT_NUMBER, part->right, "right jamb");
    add_edge_steps(terms, &upper, part->high, part);
    bool raised = part->low > 0.0;
    if (raised)
        add_edge_steps(terms, &lower, part->low, part);
    if (!hidden) {
        pp_part_steps_component(terms, false, share, raised ? "H# - S#" : "H#",
                                "sky component");
        return;
    }
    pp_part_steps_figure(terms, PP_UNIT_SHARE, share, "e", raised ? "H# - S#" : "H#",
                         "equivalent sky component of the obstruction");
    pp_part_steps_read(terms, PP_UNIT_NUMBER, part->reflectance, "f",
                       "luminance factor of the obstruction");
    pp_part_steps_component(terms, true, part->reflectance * share, "f# e#",
                            "externally reflected component");
}

/* ---- the method ---- */

static const char *refuses_room(const struct pp_world *world,
                                const struct pp_receiver *receiver)
{
    const char *why = pp_refusals_unless_overcast_and_up(world, receiver);
    return why ? why : pp_refusals_if_luminous(world);
}

static const char *refuses(const struct pp_world *world,
                           const struct pp_opening *opening,
                           const struct pp_receiver *receiver)
{
    (void)world, (void)receiver;
    if (opening->glass.diffusing)
        return "has diffusing glass; the table holds clear glass only";
    return pp_refusals_unless_vertical(opening);
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    (void)tools;
    struct pp_elevation elevation;
    enum pp_status status =
        pp_elevation_init(&elevation, world, opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    double sky = 0.0, external = 0.0;
    pp_steps_add(part->steps, PP_UNIT_METRE,
                 pp_vec_dot(pp_vec_sub(receiver->position, opening->inner.vertices[0]),
                            opening->inner.normal),
                 "distance d of the point from the opening's plane");
    struct pp_part_steps terms = pp_part_steps_begin(part->steps, elevation.count);
    for (int i = 0; i < elevation.count; i++) {
        const struct pp_elevation_part *seen = elevation.parts + i;
        double equivalent_sky = read_rectangle(seen);
        if (isnan(seen->reflectance))
            sky += equivalent_sky;
        else
            external += seen->reflectance * equivalent_sky;
        if (part->steps)
            add_rectangle_steps(&terms, seen);
    }
    pp_part_steps_end(&terms);
    part->sky = fmax(sky, 0.0);
    part->external = fmax(external, 0.0);
    pp_elevation_clear(&elevation);
    return PP_OK;
}

const struct pp_method pp_method_brs_table = {
    .name = "brs-table",
    .summary = "direct component by the BRS simplified daylight table",
    .source = "HLG58",
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_CLEAR_GLASS,
    .refuses_room = refuses_room,
    .refuses = refuses,
    .evaluate = evaluate,
};
