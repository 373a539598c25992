/* year_cells.h - the inside surfaces of a room, divided into cells of about one size.
 *
 * Every diffuse side of an inside surface is divided into squares along the axes of its
 * plane. A square is a cell, unless a partition or another inside surface stands on
 * it; each piece beside that surface is then a cell (cell_cuts.h). The cell of a hit
 * follows from its position; points of a cell are drawn within the surface's outline,
 * outside its openings and outside the objects that cover the surface.
 */
#ifndef PP_SIMULATE_YEAR_YEAR_CELLS_H
#define PP_SIMULATE_YEAR_YEAR_CELLS_H

#include "simulate/path_tracer/path_trace.h"
#include "simulate/year/cell_cuts.h"

/* The cells in a square of a part. */
struct pp_year_square {
    int first; /* first cell, relative to the first cell of the side */
    int cut_count;
    struct pp_cell_cut *cuts; /* NULL: one cell */
};

/* The cells of both sides of a part: front first, then back; -1: the side has none. */
struct pp_year_part_cells {
    int first[2];
    int per_side;   /* number of cells of a side */
    int count[2];   /* number of squares along the part's a and b */
    double low[2];  /* lower bounds along a and b, m */
    double step[2]; /* size of a square, m */
    struct pp_year_square *squares;
};

/* Place of a cell: its square, and the rectangle around it in the part's plane. */
struct pp_year_cell {
    int part, square;
    struct pp_cell_point low, size; /* m */
};

struct pp_year_cells {
    const struct pp_light_scene *scene; /* not owned */
    int count;
    double size_m;                    /* intended size of a cell */
    struct pp_year_part_cells *parts; /* by part of the scene */
    struct pp_year_cell *cells;
    int capacity;
    int *covers; /* surfaces: doors and dados */
    int cover_count;
};

/* Makes about `wanted` cells. On success the caller must clear *cells. */
enum pp_status pp_year_cells_init(struct pp_year_cells *cells,
                                  const struct pp_light_scene *scene, int wanted,
                                  struct pp_error *err);
void pp_year_cells_clear(struct pp_year_cells *cells);

/* Index of the cell that was hit; -1: there is none. */
int pp_year_cells_of(const struct pp_year_cells *cells, const struct pp_light_hit *hit);

/* The point at relative coordinates u and v (0 to 1) of the rectangle around a cell,
 * with its normal. False if the point is outside the cell or the surface's outline, in
 * an opening or fitting, or behind a door or dado. */
bool pp_year_cells_point(const struct pp_year_cells *cells, int cell, double u,
                         double v, struct pp_lit_point *point);

#endif
