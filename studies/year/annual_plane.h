/* annual_plane.h - the figures of all points together. Standard errors come from the
 * points' figures with each randomisation left out in turn. */
#ifndef PP_STUDIES_YEAR_ANNUAL_PLANE_H
#define PP_STUDIES_YEAR_ANNUAL_PLANE_H

#include "model/results/sheets/annual_sheet.h"

/* Fills mean, plane and near_half of a sheet whose points are known. without:
 * [receiver][batch][figure]. */
void pp_annual_plane_fill(struct pp_annual_sheet *sheet, const double *without,
                          int batches);

#endif
