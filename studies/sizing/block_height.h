/* block_height.h - how high a block may be so that the windows or the rooms about it keep
 * their due of the sky (retained_sky.h).
 *
 * Their sky falls as the block rises. `before` is the site as existing, or where the
 * file has no states, the site with the block as low as 2 mm.
 *
 * The height at which the first has no more than its due (root_bracket.h) is found to 1e-6 of
 * the share of a vertical sky component, to 1e-4 of that of a lit area, whose line is
 * known to a millimetre; and where it falls by a step, to 10 um below that.
 */
#ifndef PP_STUDIES_SIZING_BLOCK_HEIGHT_H
#define PP_STUDIES_SIZING_BLOCK_HEIGHT_H

#include "studies/sizing/retained_sky.h"

struct pp_block_height_task {
    struct pp_building *building; /* its state and the block's height are changed */
    const char *block;            /* its name; the building has one so called */
    struct pp_retained_sky_rule rule;
    double most_m; /* the greatest height of interest */
};

enum pp_block_height_verdict {
    PP_BLOCK_HEIGHT_FOUND,
    PP_BLOCK_HEIGHT_ANY, /* even at most_m everyone keeps his due */
    PP_BLOCK_HEIGHT_NONE /* somebody lacks his due whatever the block's height */
};

struct pp_block_height {
    enum pp_block_height_verdict verdict;
    double now_m;    /* as in the file */
    double height_m; /* found; most_m where any will do, NAN where none will */
    struct pp_retained_sky retained;
    int deciding; /* who has the least over his due; -1: nobody is due anything */
};

/* PP_BAD_INPUT where nobody counts, or a room makes no sense at some height
 * (the block grows into it). To be cleared in any case. */
enum pp_status pp_block_height_find(struct pp_block_height *found,
                                    const struct pp_block_height_task *task,
                                    struct pp_error *err);
void pp_block_height_clear(struct pp_block_height *found);

#endif
