/* lumen_table_build.h - the tables of coefficients of utilization as grids, and their
 * construction from lines in any order. For the files of lumen/ only. */
#ifndef PP_METHODS_LUMEN_LUMEN_TABLE_BUILD_H
#define PP_METHODS_LUMEN_LUMEN_TABLE_BUILD_H

#include "methods/lumen/lumen_table.h"
#include "model/base/mistakes.h"

/* One line of a table for light from the side. */
struct pp_lumen_line {
    double light; /* Ev/Eh; NAN: the ground */
    double ceiling, walls, depth;
    int position;
    const double *cu; /* one for each width; not owned */
    int line;         /* line in the file, 0 if none */
};

/* One line of a table for light from above. */
struct pp_lumen_top_line {
    double rcr, ceiling, walls, cu;
    int line;
};

/* A table of light from the side. `light` is the index of a sky; the index after the
 * last sky is the ground. */
struct pp_lumen_side_table {
    struct pp_lumen_axis sky, axes[PP_LUMEN_SIDE_AXES];
    const double
        *cu;      /* [light][ceiling][walls][depth][position][width]; NAN: not given */
    int pitch;    /* number of entries in cu from one position to the next */
    double *made; /* values of cu if allocated from lines (to be freed), else NULL */
};

enum { PP_LUMEN_TOP_AXES = 3 }; /* rcr, ceiling, walls */

struct pp_lumen_top_table {
    struct pp_lumen_axis axes[PP_LUMEN_TOP_AXES];
    double *cu; /* [rcr][ceiling][walls] */
};

struct pp_lumen_table {
    struct pp_lumen_side_table side;
    struct pp_lumen_top_table top;
};

/* Builds a table from lines in any order. A reflectance that is NAN in all lines does
 * not become an axis. Two lines for one cell, and axes of more than PP_LUMEN_AXIS_MOST
 * values, are noted as mistakes. */
enum pp_status pp_lumen_table_build_side(struct pp_lumen_side_table *table,
                                         const struct pp_lumen_axis *widths,
                                         const struct pp_lumen_line *lines, int count,
                                         struct pp_mistakes *mistakes,
                                         struct pp_error *err);
enum pp_status pp_lumen_table_build_top(struct pp_lumen_top_table *table,
                                        const struct pp_lumen_top_line *lines,
                                        int count, struct pp_mistakes *mistakes,
                                        struct pp_error *err);

/* Index in cu of a cell of the side table, at[PP_LUMEN_WIDTH] included. */
size_t pp_lumen_table_build_cell(const struct pp_lumen_side_table *table, int light,
                                 const int at[PP_LUMEN_SIDE_AXES], int position);

#endif
