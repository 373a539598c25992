/* brs_rooflight.c - `brs-table-rooflight`: sky component and externally reflected
 * component of rooflights by simplified daylight tables.
 *
 * The tables have the form of the table for vertical windows (brs_table.c). The source
 * [HLG58] also contains tables for rooflights, but they were not available. The tables
 * here were calculated by quadrature under the same conditions: CIE overcast sky, clear
 * single glass, a point that faces up (bench/make_rooflight_tables.c). There is one
 * table for horizontal glass and one each for glass at 30 and 60 degrees. The
 * arguments, with d the perpendicular distance from the point to the plane of the
 * glass:
 *
 *     horizontal  T(l/d, w/d)  l and w from the point above the receiver, symmetrical
 *     sloping     T(s/d, w/d)  s up the slope, from the line where the plane of the glass
 *                              is at the point's height, like h of the vertical table
 *
 * Vertical windows are read from the table in brs_table.c, so that rooms with both
 * windows and rooflights have a value. All tables are read in the same way
 * (brs_edges.h). view/slope_rectangles.h describes the rectangles for openings and
 * obstructions. The figures contain clear single glass; no frame, no dirt.
 */
#include "methods/brs/brs_rooflight.h"

#include <math.h>
#include <stddef.h>

#include "methods/brs/brs_edges.h"
#include "methods/view/slope_rectangles.h"
#include "methods/method.h"
#include "methods/refusals.h"

static const double level[][21] = {
#include "tables/brs_rooflight_0.inc"
};
static const double at_30[][21] = {
#include "tables/brs_rooflight_30.inc"
};
static const double at_60[][21] = {
#include "tables/brs_rooflight_60.inc"
};

static const struct slope_table {
    double slope_deg;
    struct pp_brs_cells table;
    const char *measure;
} tables[] = {
    {0.0, {sizeof level / sizeof level[0], 21, level[0]}, "l/d"},
    {30.0, {sizeof at_30 / sizeof at_30[0], 21, at_30[0]}, "s/d"},
    {60.0, {sizeof at_60 / sizeof at_60[0], 21, at_60[0]}, "s/d"},
};

static const struct slope_table *table_at(double slope_rad)
{
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++)
        if (fabs(slope_rad - tables[i].slope_deg * PP_RAD)
            < PP_SLOPE_RECTANGLES_TOLERANCE_RAD)
            return &tables[i];
    return NULL;
}

double pp_brs_rooflight_read(int slope_deg, double up_over_d, double w_over_d)
{
    const struct slope_table *table = table_at(slope_deg * PP_RAD);
    return table ? pp_brs_edges_read(&table->table, up_over_d, w_over_d) : NAN;
}

static const char *brs_rooflight_refuses_room(const struct pp_world *world,
                                              const struct pp_outside_light *light,
                                              const struct pp_receiver *receiver)
{
    const char *why = pp_refusals_unless_overcast_and_up(light, receiver);
    why = why ? why : pp_refusals_if_mesh(world);
    return why ? why : pp_refusals_if_luminous(world);
}

static const char *brs_rooflight_refuses(const struct pp_world *world,
                                         const struct pp_outside_light *light,
                                         const struct pp_opening *opening,
                                         const struct pp_receiver *receiver)
{
    if (!pp_refusals_unless_vertical(opening))
        return pp_method_brs_table.refuses(world, light, opening, receiver);
    if (opening->glass.diffusing)
        return "has diffusing glass, but the tables are for clear glass only";
    if (!table_at(pp_slope_rectangles_slope(opening)))
        return "has a slope that the tables do not cover; they cover 0, 30 and 60 "
               "degrees";
    return NULL;
}

static enum pp_status read_rooflight(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     struct pp_part *part, struct pp_error *err)
{
    struct pp_slope_rectangles seen;
    const struct slope_table *table = table_at(pp_slope_rectangles_slope(opening));
    enum pp_status status =
        pp_slope_rectangles_init(&seen, world, light, opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    pp_worksheet_note(
        &part->sheet, PP_UNIT_METRE,
        pp_vec_dot(pp_vec_sub(receiver->position, opening->inner.vertices[0]),
                   opening->inner.normal),
        "distance d from the point to the plane of the glass");
    double begins =
        table->slope_deg > 0.0 ? -1.0 / tan(table->slope_deg * PP_RAD) : 0.0;
    struct pp_part_steps terms = pp_part_steps_on(&part->sheet, seen.count);
    for (int i = 0; i < seen.count; i++) {
        const struct pp_slope_rectangle *at = &seen.list[i];
        double low = at->low - begins;
        const struct pp_brs_rectangle rectangle = {
            .left = at->left,
            .right = at->right,
            .low = table->slope_deg > 0.0 ? fmax(low, 0.0) : low,
            .high = at->high - begins,
            .hidden = at->hidden,
            .factor = at->factor,
            .off_sky = at->hidden};
        pp_brs_edges_work(&terms, part, &table->table, &rectangle, table->measure);
    }
    pp_part_steps_end(&terms);
    part->sky = fmax(part->sky, 0.0);
    part->external = fmax(part->external, 0.0);
    pp_slope_rectangles_clear(&seen);
    return PP_OK;
}

/* If all openings are vertical, the results are those of the table for windows. */
static const struct pp_method *same_as(const struct pp_world *world)
{
    for (int i = 0; i < world->opening_count; i++)
        if (pp_refusals_unless_vertical(&world->openings[i]))
            return NULL;
    return &pp_method_brs_table;
}

static enum pp_status evaluate_brs_rooflight(const struct pp_world *world,
                                             const struct pp_outside_light *light,
                                             const struct pp_opening *opening,
                                             const struct pp_receiver *receiver,
                                             const void *tools, struct pp_part *part,
                                             struct pp_error *err)
{
    if (!pp_refusals_unless_vertical(opening))
        return pp_method_brs_table.evaluate(world, light, opening, receiver, tools,
                                            part, err);
    return read_rooflight(world, light, opening, receiver, part, err);
}

static const struct pp_formula *const formulae[] = {PP_BRS_EDGES_FORMULAE,
                                                    PP_BRS_EDGES_ACROSS_FORMULAE, NULL};

const struct pp_method pp_method_brs_rooflight = {
    .name = "brs-table-rooflight",
    .summary = "direct component by the BRS simplified daylight table and similar "
               "tables for rooflights",
    .source = "HLG58",
    .formulae = formulae,
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_CLEAR_GLASS,
    .refuses_room = brs_rooflight_refuses_room,
    .refuses = brs_rooflight_refuses,
    .same_as = same_as,
    .evaluate = evaluate_brs_rooflight,
};
