/* direct_steps.h - how what a patch of a view gives is set out on paper. */
#ifndef PP_METHODS_EXACT_DIRECT_STEPS_H
#define PP_METHODS_EXACT_DIRECT_STEPS_H

#include "methods/exact/solid_angle.h"
#include "methods/part_steps.h"

/* What was worked out of one patch; shares of Eh. */
struct pp_patch_figures {
    bool hidden;
    struct pp_moments moments; /* of what lies above the horizon */
    bool closed_form;          /* do they suffice for the sky? */
    bool glazed;
    double above;  /* the sky's light, seen or hidden, through the glass */
    double below;  /* hidden: at the luminance of the horizon; else the
                    * ground's, for a reflectance of 1 */
    double own;    /* what a patch that is hidden gives off by itself */
    double factor; /* luminance factor of what hides, or of the ground */
};

/* Sets down the next of the terms; nothing of what is a sliver. */
void pp_direct_steps_add(struct pp_part_steps *terms,
                         const struct pp_patch_figures *figures,
                         const struct pp_sky *sky);

#endif
