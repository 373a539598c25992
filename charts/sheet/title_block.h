/* title_block.h - rows of framed cells at the foot of a sheet, with facts of the
 * project: project, client, author, date, revision. */
#ifndef PP_CHARTS_SHEET_TITLE_BLOCK_H
#define PP_CHARTS_SHEET_TITLE_BLOCK_H

#include <stdbool.h>

#include "charts/sheet/style.h"
#include "model/room/project.h"

/* Draws the block with its lower left corner at x, bottom. A fact that is not given has
 * no cell. If `drawn` is false, only measures. Returns the height in mm, 0 if no fact
 * is given. */
double pp_title_block_draw(cairo_t *cr, const struct pp_style *style,
                           const struct pp_project *project, double x, double bottom,
                           double width, bool drawn);

#endif
