/* document_grid.h - a table of a document on paper: the widths of its columns, and its
 * rows one by one. Inside charts/document/ only. */
#ifndef PP_CHARTS_DOCUMENT_DOCUMENT_GRID_H
#define PP_CHARTS_DOCUMENT_DOCUMENT_GRID_H

#include "charts/sheet/lettering.h"
#include "model/results/document.h"

enum { PP_GRID_COLUMNS = 16 }; /* most columns of a table; others are left out */

struct pp_document_grid {
    cairo_t *cr;
    const struct pp_style *style;
    const struct pp_document_table *table;
    int column_count;
    double x, width, gap;           /* all in mm; gap: between columns */
    double widths[PP_GRID_COLUMNS]; /* widths of the columns, without gaps */
};

/* Sets the column widths of a table from x on, `width` wide (mm). Columns of numbers
 * and labels get the width they need; words are broken into lines in the rest. Columns
 * have the same widths on all sheets. */
struct pp_document_grid pp_document_grid_lay(cairo_t *cr, const struct pp_style *style,
                                             const struct pp_document_table *table,
                                             double x, double width);

/* Height (mm) of the head (0: none) or of a row, with the rule below it; draws it from
 * y down if `drawn`. */
double pp_document_grid_head(const struct pp_document_grid *grid, double y, bool drawn);
double pp_document_grid_row(const struct pp_document_grid *grid, int row, double y,
                            bool drawn);

/* Height that must be free on a sheet for a row to be placed there: a group's title and
 * its remarks stay with the first row of the group, and the last row of a table with the
 * one before it. */
double pp_document_grid_unit(const struct pp_document_grid *grid, int row);

#endif
