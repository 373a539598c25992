/* board_windows.h - the windows on a diagram of the drawing board, and what was counted
 * of them.
 */
#ifndef PP_MODEL_BOARD_WINDOWS_H
#define PP_MODEL_BOARD_WINDOWS_H

#include <stdbool.h>

#include "model/geometry/region.h"

/* A square as it was counted. */
struct pp_counted_square {
    int column, row; /* its lower left corner */
    int tenths;      /* 0 to 10 */
};

/* A piece of a window: sky, or something that hides it. */
struct pp_board_piece {
    struct pp_region outline; /* in the diagram's own coordinates */
    bool hidden;
    double factor;  /* luminance factor of what hides it; 1 for the sky */
    double counted; /* squares or dots within */
    int square_count;
    struct pp_counted_square *squares; /* each of them; NULL of dots */
};

struct pp_board_window {
    int line;             /* of the room file */
    double distance_m;    /* from the point to its plane */
    double allowance;     /* for its glass, frame and dirt */
    double sky, external; /* what it gives, fractions of Eh, allowance included */
    int count;            /* 0: the point sees nothing of it */
    struct pp_board_piece *pieces;
};

/* Works out what the window gives of what was counted; worth: of a square or dot, a
 * fraction of Eh. */
void pp_board_window_sum(struct pp_board_window *window, double worth);

/* Adds what the windows give to *sky and *external. */
void pp_board_windows_add(const struct pp_board_window *windows, int count, double *sky,
                          double *external);

/* Does anything hide a piece of them? */
bool pp_board_windows_hidden(const struct pp_board_window *windows, int count);

/* The rectangle around all pieces, joined to the one given. */
void pp_board_window_extent(const struct pp_board_window *window, double low[2],
                            double high[2]);

void pp_board_windows_destroy(struct pp_board_window *windows, int count);

#endif
