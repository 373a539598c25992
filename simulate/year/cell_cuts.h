/* cell_cuts.h - divides a square of a surface where other inside surfaces stand on it,
 * so that no piece has parts on both sides of a partition.
 *
 * A square is divided along the line in which the plane of the other surface meets it.
 * The other surface must be near to the square's plane, and at least half as long as the
 * line in the piece that it divides. Otherwise light passes its ends.
 */
#ifndef PP_SIMULATE_YEAR_CELL_CUTS_H
#define PP_SIMULATE_YEAR_CELL_CUTS_H

#include "model/room/world.h"
#include "simulate/scene/light_scene_parts.h"

enum { PP_CELL_PIECES_MOST = 16, PP_CELL_CORNERS_MOST = 4 + PP_CELL_PIECES_MOST };

/* Point in the plane of a part, along its a and b, m. */
struct pp_cell_point {
    double a, b;
};

/* A convex piece of a square. */
struct pp_cell_piece {
    int count;
    struct pp_cell_point corners[PP_CELL_CORNERS_MOST]; /* counter-clockwise */
};

/* Points with normal . (a, b) = offset. */
struct pp_cell_line {
    struct pp_cell_point normal; /* unit */
    double offset_m;
};

/* Division of a piece. On the lower and upper side of the line is a piece, as
 * -1 - index, or a further cut, by its index. */
struct pp_cell_cut {
    struct pp_cell_line line;
    int sides[2];
};

/* Pieces of one square; with no cuts, the square is the only piece. */
struct pp_cell_cuts {
    int piece_count, cut_count;
    struct pp_cell_piece pieces[PP_CELL_PIECES_MOST];
    struct pp_cell_cut cuts[PP_CELL_PIECES_MOST];
};

/* The whole of a square with this lower corner. */
void pp_cell_cuts_init(struct pp_cell_cuts *cuts, struct pp_cell_point low,
                       const double step_m[2]);

/* A surface that may divide squares of a part. */
struct pp_cell_cutter {
    const struct pp_surface *surface;  /* not owned */
    const struct pp_light_part *plane; /* not owned */
    struct pp_vec3 centre;
    int side; /* of the part: 0 front, 1 back */
    double near_m;
    struct pp_cell_line line;
    struct pp_cell_point low, high; /* box around all points that are near */
};

/* False if no point of the surface is within `near_m` of the plane of the part, on the
 * given side, or if the two are nearly parallel. */
bool pp_cell_cuts_cutter_init(struct pp_cell_cutter *cutter,
                              const struct pp_light_scene *scene, int part, int side,
                              const struct pp_surface *surface, double near_m);

/* Divides the pieces of a square of the cutter's part. */
void pp_cell_cuts_by(struct pp_cell_cuts *cuts, const struct pp_cell_cutter *cutter);

/* Index of the piece that contains a point of the square. */
static inline int pp_cell_cuts_piece(const struct pp_cell_cut *cuts, int cut_count,
                                     struct pp_cell_point at)
{
    int next = cut_count > 0 ? 0 : -1;
    while (next >= 0) {
        const struct pp_cell_cut *cut = &cuts[next];
        const struct pp_cell_line *line = &cut->line;
        next =
            cut->sides[line->normal.a * at.a + line->normal.b * at.b > line->offset_m];
    }
    return -1 - next;
}

#endif
