/* block_height.h - greatest height of a block at which the windows or rooms around it
 * retain their required share of the sky (retained_sky.h).
 *
 * The visible sky of these windows and rooms decreases as the block rises. `before` is
 * the existing site or, if the file has no states, the site with the block only 2 mm
 * high.
 *
 * The height at which the value of the first window or room equals its required value
 * (root_bracket.h) is found to 1e-6 of a vertical sky component, or to 1e-4 of a lit
 * area, whose boundary is known to a millimetre. If the value jumps at the required
 * value, the height is at most 10 um below the jump.
 */
#ifndef PP_STUDIES_SIZING_BLOCK_HEIGHT_H
#define PP_STUDIES_SIZING_BLOCK_HEIGHT_H

#include "studies/sizing/retained_sky.h"

struct pp_block_height_task {
    struct pp_building *building; /* building whose state and block height are
                                   * changed */
    const char *block;            /* name of a block of the building */
    struct pp_retained_sky_rule rule;
    double most_m; /* greatest height considered */
};

enum pp_block_height_verdict {
    PP_BLOCK_HEIGHT_FOUND,
    PP_BLOCK_HEIGHT_ANY, /* all requirements are met even at most_m */
    PP_BLOCK_HEIGHT_NONE /* some requirement is missed at any height of the block */
};

struct pp_block_height {
    enum pp_block_height_verdict verdict;
    double now_m;    /* as in the file */
    double height_m; /* the result: most_m if every height is possible, NAN if none
                      * is */
    struct pp_retained_sky retained;
    int deciding; /* index of the window or room with the least surplus; -1: none is
                   * assessed */
};

/* PP_BAD_INPUT if no window or room counts, or a room is invalid at some height (the
 * block grows into it). To be cleared in any case. */
enum pp_status pp_block_height_find(struct pp_block_height *found,
                                    const struct pp_block_height_task *task,
                                    struct pp_error *err);
void pp_block_height_clear(struct pp_block_height *found);

#endif
