/* title_block.h - a row of framed cells with the facts of a project at the foot of a
 * sheet: project, client, author, date, revision. */
#ifndef PP_CHARTS_SHEET_TITLE_BLOCK_H
#define PP_CHARTS_SHEET_TITLE_BLOCK_H

#include <stdbool.h>

#include "charts/sheet/style.h"
#include "model/room/project.h"

/* Draws the block with its lower left corner at x, bottom; facts that are not given have
 * no cell. Returns its height in mm, 0 if no fact is given; `drawn` false: only
 * measures it. */
double pp_title_block_draw(cairo_t *cr, const struct pp_style *style,
                           const struct pp_project *project, double x, double bottom,
                           double width, bool drawn);

#endif
