/* brs_table.c - `brs-table`: sky component and externally reflected component by the
 * BRS simplified daylight table.                                            [HLG58]
 *
 * The table, T(h/d, w/d), gives the sky component of a vertical, clear-glazed window at
 * a point of the working plane under the CIE overcast sky. The window's sill is level
 * with the point and its head h above the point; one jamb is on the normal through the
 * point, the other w to the side; d is the distance. As published:
 *
 *   - a window on both sides of the normal: the readings of both parts are added
 *   - a window to one side: reading of the far jamb less that of the near jamb
 *   - a sill above the point: reading of the head less that of the sill
 *   - an obstruction: the window is read as if its sill were the obstruction's head.
 *     The reduction of the reading is the equivalent sky component of the obstruction;
 *     the externally reflected component is 0.2 (the reflectance) times this reduction
 *
 * Interpolation is linear between neighbours in both directions, linear in the
 * reciprocal between the last printed column or row and infinity, and linear to zero
 * below the first. elevation.h describes the rectangles for openings and obstructions;
 * a negative sum counts as 0.
 *
 * The method is for vertical openings with clear glass, or none, and for points that
 * face up under the CIE overcast sky. The figures contain clear single glass; no frame,
 * no dirt. At 1 to 7 m from the window, readings of 1 % and more are 1.4 % low on
 * average against the exact direct component with that glass, 3.4 % rms. A window far
 * to one side is a small difference of two cells, which can be 20 % wrong. The error
 * can be twice that where h/d is above 5, the last row before infinity.
 */
#include "methods/brs/brs_table.h"

#include <stddef.h>

#include "methods/brs/brs_edges.h"
#include "methods/view/elevation.h"
#include "methods/method.h"
#include "methods/refusals.h"
#include "methods/part_steps.h"

/* The first row holds w/d; each other row h/d (from infinity down), then per cent. */
static const double printed[][21] = {
#include "tables/brs_simplified_table.inc"
};

static const struct pp_brs_cells table = {sizeof printed / sizeof printed[0],
                                          sizeof printed[0] / sizeof printed[0][0],
                                          printed[0]};

double pp_brs_table_read(double h_over_d, double w_over_d)
{
    return pp_brs_edges_read(&table, h_over_d, w_over_d);
}

void pp_brs_table_place(double h_over_d, double w_over_d, double *row, double *column)
{
    pp_brs_edges_place(&table, h_over_d, w_over_d, row, column);
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

/* ---- the method ---- */

static const char *brs_table_refuses_room(const struct pp_world *world,
                                          const struct pp_outside_light *light,
                                          const struct pp_receiver *receiver)
{
    const char *why = pp_refusals_unless_overcast_and_up(light, receiver);
    why = why ? why : pp_refusals_if_mesh(world);
    return why ? why : pp_refusals_if_luminous(world);
}

static const char *brs_table_refuses(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver)
{
    (void)world, (void)light, (void)receiver;
    if (opening->glass.diffusing)
        return "has diffusing glass, but the table is for clear glass only";
    return pp_refusals_unless_vertical(opening);
}

static const struct pp_formula *const formulae[] = {PP_BRS_EDGES_FORMULAE, NULL};

static enum pp_status evaluate_brs_table(const struct pp_world *world,
                                         const struct pp_outside_light *light,
                                         const struct pp_opening *opening,
                                         const struct pp_receiver *receiver,
                                         const void *tools, struct pp_part *part,
                                         struct pp_error *err)
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
        "distance d from the point to the plane of the opening");
    struct pp_part_steps terms = pp_part_steps_on(&part->sheet, elevation.count);
    for (int i = 0; i < elevation.count; i++) {
        const struct pp_elevation_part *seen = elevation.parts + i;
        const struct pp_brs_rectangle rectangle = {.left = seen->left,
                                                   .right = seen->right,
                                                   .low = fmax(seen->low, 0.0),
                                                   .high = seen->high,
                                                   .hidden = !isnan(seen->reflectance),
                                                   .factor = seen->reflectance};
        pp_brs_edges_work(&terms, part, &table, &rectangle, "h/d");
    }
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
    .refuses_room = brs_table_refuses_room,
    .refuses = brs_table_refuses,
    .evaluate = evaluate_brs_table,
};
