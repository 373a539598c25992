/* lumen_parts.h - what the reader of the lumen method's tables and their user share. */
#ifndef PP_METHODS_LUMEN_LUMEN_PARTS_H
#define PP_METHODS_LUMEN_LUMEN_PARTS_H

#include "methods/lumen/lumen_table.h"

/* One line of a table for light from the side. */
struct pp_lumen_line {
    double light; /* Ev/Eh; NAN: the ground */
    double ceiling, walls, depth;
    int position;
    const double *cu; /* one for each width; not owned */
    int line;         /* in the file, 0 where none */
};

/* One line of a table for light from above. */
struct pp_lumen_top_line {
    double rcr, ceiling, walls, cu;
    int line;
};

/* Light from the side. Skies lie one behind another, the ground last. */
struct pp_lumen_side_table {
    struct pp_lumen_axis sky, axes[PP_LUMEN_SIDE_AXES];
    double *cu; /* [light][ceiling][walls][depth][position][width]; NAN: not given */
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

/* A table out of lines in any order. Reflectances that are NAN in all of them are not
 * asked for. Lines that say the same twice, and axes of more than PP_LUMEN_AXIS_MOST
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

#endif
