/* envelope_sheet.h - the largest envelope on a plot as a drawing of the site shows it. */
#ifndef PP_STUDIES_SITE_ENVELOPE_SHEET_H
#define PP_STUDIES_SITE_ENVELOPE_SHEET_H

#include "model/base/error.h"
#include "model/results/sheets/site_sheet.h"
#include "studies/sizing/plot_envelope.h"

/* Adds the cells of the envelope to a sheet of the building as left by
 * pp_plot_envelope_find. They replace the block of that name among the objects on the
 * sheet. */
enum pp_status pp_envelope_sheet_add(struct pp_site_sheet *sheet,
                                     const struct pp_plot_envelope *envelope,
                                     const char *block, struct pp_error *err);

#endif
