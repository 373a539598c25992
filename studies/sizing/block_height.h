/* block_height.h - how high a block may be so that the windows about it keep their due of
 * the sky.
 *
 * The vertical sky component of a window (methods/exact/exterior.h) falls as a block
 * rises. Each window keeps a share of what it has before: of the site as existing, or
 * where the file has no states, of the site with the block as low as 2 mm.
 *
 *     VSC(height) >= keep VSC(before)     for every window           [BR209]: keep = 0.8
 *
 * The height at which the first window has no more than its due is found by the Illinois
 * variant of false position, to 1e-6 of the share.
 */
#ifndef PP_STUDIES_SIZING_BLOCK_HEIGHT_H
#define PP_STUDIES_SIZING_BLOCK_HEIGHT_H

#include "model/base/error.h"
#include "model/room/building.h"

struct pp_block_height_task {
    struct pp_building *building; /* its state and the block's height are changed */
    const char *block;            /* its name; the building has one so called */
    const char *window;           /* the only one that counts, by name; NULL: all */
    double keep;                  /* share that each window keeps, above 0, below 1 */
    double most_m;                /* the greatest height of interest */
};

/* A window that counts. */
struct pp_block_height_window {
    char room[64], window[64]; /* names, cut; the window's may be empty */
    int line;
    double before, now, after; /* vertical sky components, fractions: before, with the
                                * block as the file has it, and at the height found */
};

enum pp_block_height_verdict {
    PP_BLOCK_HEIGHT_FOUND,
    PP_BLOCK_HEIGHT_ANY, /* even at most_m every window keeps its due */
    PP_BLOCK_HEIGHT_NONE /* a window lacks its due whatever the block's height */
};

struct pp_block_height {
    enum pp_block_height_verdict verdict;
    double now_m;    /* as the file has it */
    double height_m; /* found; most_m where any will do, NAN where none will */
    struct pp_block_height_window *windows;
    int window_count;
    int deciding; /* the window with the least of its due; -1: there is none */
};

/* PP_BAD_INPUT where no upright window counts, or a room makes no sense at some height
 * (the block grows into it). To be cleared in any case. */
enum pp_status pp_block_height_find(struct pp_block_height *found,
                                    const struct pp_block_height_task *task,
                                    struct pp_error *err);
void pp_block_height_clear(struct pp_block_height *found);

#endif
