/* fitted_opening.h - an opening's reveal, and how much of it lies below the working
 * plane, for the formulae that were fitted to simulated rooms. */
#ifndef PP_METHODS_FITTED_FITTED_OPENING_H
#define PP_METHODS_FITTED_FITTED_OPENING_H

#include "model/results/worksheet.h"
#include "model/room/world.h"

/* Rows of a formula's list of quantities. */
#define PP_FITTED_OPENING_REVEAL                                                       \
    {"d", PP_UNIT_METRE, "depth of the reveal"},                                       \
        {"w", PP_UNIT_METRE, "width of the opening"},                                  \
    {                                                                                  \
        "h", PP_UNIT_METRE, "height"                                                   \
    }
#define PP_FITTED_OPENING_LOW                                                          \
    {                                                                                  \
        "n", PP_UNIT_NUMBER, "fraction of the opening below the working plane"         \
    }

/* Each function records quantities on the worksheet: d, w and h; w alone; n. */
void pp_fitted_opening_put_reveal(struct pp_worksheet *sheet,
                                  const struct pp_opening *opening);
void pp_fitted_opening_put_breadth(struct pp_worksheet *sheet,
                                   const struct pp_opening *opening);
void pp_fitted_opening_put_low(struct pp_worksheet *sheet, const struct pp_world *world,
                               const struct pp_opening *opening);

#endif
