/* brs_edges.h - simplified daylight tables read at the edges of rectangles [HLG58].
 *
 * A table T(up, aside) gives the sky component of a rectangle with one corner at the
 * origin of the table. `up` and `aside` are the distances from the origin to the
 * rectangle's far edge and to its far jamb, divided by the distance d of the
 * rectangle's plane. Interpolation is linear between neighbours in both directions,
 * linear in the reciprocal between the last printed column or row and infinity, and
 * linear to zero below the first one. As published:
 *
 *   - readings of jambs on both sides of the origin are added; for jambs on one side the
 *     narrower reading is subtracted from the wider one
 *   - the reading of the lower edge is subtracted from that of the upper edge; for edges
 *     on both sides of the origin (horizontal glass) both are added
 *   - an obstruction is read in the same way, and its externally reflected component is
 *     the reading times its luminance factor
 */
#ifndef PP_METHODS_BRS_BRS_EDGES_H
#define PP_METHODS_BRS_BRS_EDGES_H

#include "methods/method.h"
#include "methods/part_steps.h"

/* A table in the layout written by csv2c.awk. The first row holds the values of
 * `aside`. Each other row holds `up` (descending from infinity), then the readings in
 * per cent. */
struct pp_brs_cells {
    int rows, columns;
    const double *cells;
};

/* Sky component as a fraction; 0 unless both arguments are above 0. */
double pp_brs_edges_read(const struct pp_brs_cells *table, double up, double aside);

/* Position of a reading in the table; up and aside are above 0. Rows count from 0
 * (infinity), with one extra row if the table ends in zero. Columns count from 0;
 * column -1 is zero. Values between rows or columns are linear in these positions. */
void pp_brs_edges_place(const struct pp_brs_cells *table, double up, double aside,
                        double *row, double *column);

/* Positions of the edges, divided by d, as the table measures them; right is
 * positive. */
struct pp_brs_rectangle {
    double left, right, low, high;
    bool hidden;   /* true: an obstruction; false: sky */
    double factor; /* luminance factor of the obstruction */
    bool off_sky;  /* true: the rectangle of sky includes this obstruction, whose
                    * readings are subtracted */
};

/* Calculates the next part and adds it to *sum. `measure` is the name of `up` in the
 * table: "h/d". */
void pp_brs_edges_work(struct pp_part_steps *terms, struct pp_part *sum,
                       const struct pp_brs_cells *table,
                       const struct pp_brs_rectangle *rectangle, const char *measure);

/* Rows for a method's list of formulae. PP_BRS_EDGES_FORMULAE: for all tables.
 * PP_BRS_EDGES_ACROSS_FORMULAE: for tables with edges on both sides of the origin, and
 * for obstructions that are subtracted. */
extern const struct pp_formula pp_brs_edges_upper[3], pp_brs_edges_lower[3],
    pp_brs_edges_sky[2], pp_brs_edges_equivalent[2], pp_brs_edges_reflected,
    pp_brs_edges_across[4], pp_brs_edges_less;
#define PP_BRS_EDGES_FORMULAE                                                          \
    &pp_brs_edges_upper[0], &pp_brs_edges_upper[1], &pp_brs_edges_upper[2],            \
        &pp_brs_edges_lower[0], &pp_brs_edges_lower[1], &pp_brs_edges_lower[2],        \
        &pp_brs_edges_sky[0], &pp_brs_edges_sky[1], &pp_brs_edges_equivalent[0],       \
        &pp_brs_edges_equivalent[1], &pp_brs_edges_reflected
#define PP_BRS_EDGES_ACROSS_FORMULAE                                                   \
    &pp_brs_edges_across[0], &pp_brs_edges_across[1], &pp_brs_edges_across[2],         \
        &pp_brs_edges_across[3], &pp_brs_edges_less

#endif
