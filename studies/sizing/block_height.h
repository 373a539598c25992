/* block_height.h - greatest height of a block at which the windows or rooms around it
 * keep the required amount of sky (retained_sky.h).
 *
 * The sky visible from these windows and rooms decreases with the height of the block.
 * Their `before` value is that of the existing site or, if the file has no states, of
 * the site with the block only 2 mm high.
 *
 * The result is the height at which the first window or room has just its required
 * value (root_bracket.h). The height is found to 1e-6 of a vertical sky component, or
 * to 1e-4 of a lit area, whose boundary is known to a millimetre. If the value jumps at
 * the required value, the height is at most 10 um below the jump.
 */
#ifndef PP_STUDIES_SIZING_BLOCK_HEIGHT_H
#define PP_STUDIES_SIZING_BLOCK_HEIGHT_H

#include "studies/sizing/retained_sky.h"

struct pp_block_height_task {
    struct pp_building *building; /* building whose state and block height are changed
                                   * by the search */
    const char *block;            /* name of a block of the building */
    struct pp_retained_sky_rule rule;
    double most_m; /* greatest height considered */
};

enum pp_block_height_verdict {
    PP_BLOCK_HEIGHT_FOUND,
    PP_BLOCK_HEIGHT_ANY, /* all requirements are met even at height most_m */
    PP_BLOCK_HEIGHT_NONE /* a requirement is not met at any height of the block */
};

struct pp_block_height {
    enum pp_block_height_verdict verdict;
    double now_m;    /* height in the file, m */
    double height_m; /* greatest height, m; most_m if every height is possible, NAN if
                      * none is */
    struct pp_retained_sky retained;
    int deciding; /* index of the window or room with the least surplus; -1: none was
                   * assessed */
};

/* Finds the height. PP_BAD_INPUT if no window or room is assessed, or if a room is
 * invalid at some height, because the block reaches into it. The caller clears *found,
 * also after a failure. */
enum pp_status pp_block_height_find(struct pp_block_height *found,
                                    const struct pp_block_height_task *task,
                                    struct pp_error *err);
void pp_block_height_clear(struct pp_block_height *found);

#endif
