/* document_grid.h - layout of a table of a document on paper: column widths, and the
 * rows one by one. For use inside charts/document/ only. */
#ifndef PP_CHARTS_DOCUMENT_DOCUMENT_GRID_H
#define PP_CHARTS_DOCUMENT_DOCUMENT_GRID_H

#include "charts/sheet/lettering.h"
#include "model/results/document.h"

enum { PP_GRID_COLUMNS = 16 }; /* maximum number of columns in a table */

struct pp_document_grid {
    cairo_t *cr;
    const struct pp_style *style;
    const struct pp_document_table *table;
    int column_count;
    double x, width, gap;           /* all in mm; gap: between columns */
    double widths[PP_GRID_COLUMNS]; /* widths of the columns, without gaps */
};

/* Sets the column widths of a table `width` wide (mm) whose left edge is at x. Columns
 * of numbers and labels get the width they need; text is broken into lines in the other
 * columns. Columns have the same widths on all sheets. */
struct pp_document_grid pp_document_grid_lay(cairo_t *cr, const struct pp_style *style,
                                             const struct pp_document_table *table,
                                             double x, double width);

/* Height (mm) of the table's head (0: none) or of a row, including the rule below it.
 * If `drawn`, also draws it, with its upper edge at y. */
double pp_document_grid_head(const struct pp_document_grid *grid, double y, bool drawn);
double pp_document_grid_row(const struct pp_document_grid *grid, int row, double y,
                            bool drawn);

/* Height (mm) that must be free on a sheet for a row to be placed there. A group's
 * title and remarks stay with the first row of the group. The last row of a table stays
 * with the row before it. */
double pp_document_grid_unit(const struct pp_document_grid *grid, int row);

#endif
