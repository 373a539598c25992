/* fitted_opening.c - the opening's extents, and its area below the working plane. */
#include "methods/fitted/fitted_opening.h"

#include "methods/reflected/interior.h"

void pp_fitted_opening_put_reveal(struct pp_worksheet *sheet,
                                  const struct pp_opening *opening)
{
    pp_worksheet_put(sheet, PP_UNIT_METRE, opening->reveal_m, "d",
                     "opening on line %d: depth of its reveal", opening->line);
    pp_worksheet_put(sheet, PP_UNIT_METRE, opening->width_m, "w", "its breadth");
    pp_worksheet_put(sheet, PP_UNIT_METRE, opening->height_m, "h", "its height");
}

void pp_fitted_opening_put_breadth(struct pp_worksheet *sheet,
                                   const struct pp_opening *opening)
{
    pp_worksheet_put(sheet, PP_UNIT_METRE, opening->width_m, "w",
                     "opening on line %d: its breadth", opening->line);
}

void pp_fitted_opening_put_low(struct pp_worksheet *sheet, const struct pp_world *world,
                               const struct pp_opening *opening)
{
    double low_m2 = pp_interior_area_below(&opening->inner, world->working_plane_m);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, low_m2 / opening->inner.area_m2, "n",
                     "opening on line %d: share below the working plane",
                     opening->line);
}
