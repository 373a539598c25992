/* fitted_opening.c - records the opening's dimensions, and its fraction below the
 * working plane. */
#include "methods/fitted/fitted_opening.h"

#include "methods/reflected/interior.h"

void pp_fitted_opening_put_reveal(struct pp_worksheet *sheet,
                                  const struct pp_opening *opening)
{
    pp_worksheet_put(sheet, PP_UNIT_METRE, opening->reveal_m, "d",
                     "depth of the reveal");
    pp_worksheet_put(sheet, PP_UNIT_METRE, opening->width_m, "w", "width");
    pp_worksheet_put(sheet, PP_UNIT_METRE, opening->height_m, "h", "height");
}

void pp_fitted_opening_put_breadth(struct pp_worksheet *sheet,
                                   const struct pp_opening *opening)
{
    pp_worksheet_put(sheet, PP_UNIT_METRE, opening->width_m, "w",
                     "width of the opening");
}

void pp_fitted_opening_put_low(struct pp_worksheet *sheet, const struct pp_world *world,
                               const struct pp_opening *opening)
{
    double low_m2 = pp_interior_area_below(&opening->inner, world->working_plane_m);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, low_m2 / opening->inner.area_m2, "n",
                     "fraction of the opening below the working plane");
}
