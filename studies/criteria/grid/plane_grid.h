/* plane_grid.h - the grid of points over the working plane used by criteria of daylight
 * factors: equal cells inside a margin along the walls, with a point at the centre of
 * each. */
#ifndef PP_STUDIES_CRITERIA_GRID_PLANE_GRID_H
#define PP_STUDIES_CRITERIA_GRID_PLANE_GRID_H

#include "model/base/error.h"
#include "model/room/room.h"
#include "model/room/world.h"

/* The margin along the walls that [EN17037] leaves out (m). */
#define PP_PLANE_GRID_MARGIN_M 0.5

/* Greatest number of cells of a grid; a grid with more cells has no points. */
enum { PP_PLANE_GRID_MOST = 20000 };

/* Source of a grid's spacing. */
enum pp_grid_origin {
    PP_GRID_DEFAULT, /* 0.3 m, or more in a plane larger than 90 m2 */
    PP_GRID_OF_FILE, /* the finest <grid> of the room file */
    PP_GRID_CHOSEN,  /* chosen by the user */
    PP_GRID_LARGEST, /* the largest that [EN17037] permits, which depends on the room */
};

/* Spacing and margin to use in place of the file's or the default ones. */
struct pp_grid_choice {
    double spacing_m; /* 0: not given */
    double margin_m;  /* margin along the walls; used with spacing_m only */
    bool largest;     /* true: the largest cells that the standard permits, instead of
                       * spacing_m */
};

struct pp_plane_grid {
    struct pp_receiver *receivers;
    int (*cells)[2]; /* column and row of each receiver */
    int count;
    int columns, rows;
    double cell_m[2]; /* width and depth of a cell */
    double spacing_m; /* limit for the sides of a cell */
    double margin_m;
    enum pp_grid_origin origin;
    int halvings;     /* halvings of the origin's spacing */
    bool is_too_fine; /* true: there are no points, because there would be too many */
};

/* Points of the working plane, facing up. The plane's bounding rectangle, less the
 * margin, is divided into equal cells no larger than the spacing. Points are the
 * centres of cells that lie within the plane, at least the margin from its edge, where
 * a receiver can stand (pp_position_receiver_fault). The count is 0 in a room too small
 * for the margin, and if there would be more than PP_PLANE_GRID_MOST cells
 * (is_too_fine). The spacing comes from `choice` (NULL: none), from the file, or is the
 * default one, and is halved `halvings` times. room: may be NULL (no file's grid). The
 * caller clears the grid, even after a failure. */
enum pp_status pp_plane_grid_make(struct pp_plane_grid *grid,
                                  const struct pp_world *world,
                                  const struct pp_room *room,
                                  const struct pp_grid_choice *choice, int halvings,
                                  struct pp_error *err);

/* Makes such a grid with this spacing and margin (m), or with a wider spacing if it
 * would have more than most_cells. */
enum pp_status pp_plane_grid_at_most(struct pp_plane_grid *grid,
                                     const struct pp_world *world, double spacing_m,
                                     double margin_m, int most_cells,
                                     struct pp_error *err);
void pp_plane_grid_clear(struct pp_plane_grid *grid);

/* Makes the points of the grid with the largest cells that [EN17037] permits; the
 * caller frees *receivers. */
enum pp_status pp_plane_grid_largest(struct pp_receiver **receivers, int *count,
                                     const struct pp_world *world,
                                     struct pp_error *err);

/* Puts the grid into words: "a grid of 0.28 x 0.30 m (168 points, 0.5 m from the
 * walls)". */
enum { PP_PLANE_GRID_WORDS = 128 };
void pp_plane_grid_words(char words[PP_PLANE_GRID_WORDS],
                         const struct pp_plane_grid *grid);

/* Largest distance of neighbouring points (m), after [EN17037] annex B:
 *
 *     p = 0.5 * 5^(log10 d),   at most 10 m
 *
 * d is the longer side of the plane, or the shorter one where the longer is twice as
 * long or more (m, both greater than 0). */
double pp_plane_grid_largest_spacing(double width_m, double depth_m);

#endif
