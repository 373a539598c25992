/* direct_steps.h - the steps of one patch of a view, for direct.c. */
#ifndef PP_METHODS_EXACT_DIRECT_STEPS_H
#define PP_METHODS_EXACT_DIRECT_STEPS_H

#include "methods/exact/solid_angle.h"
#include "methods/part_steps.h"

/* The results for one patch, over Eh. */
struct pp_patch_figures {
    bool hidden;
    struct pp_moments moments; /* of the part above the horizon */
    bool closed_form; /* the sky's luminance has a closed form by the moments */
    bool glazed;
    double above;  /* by visible or hidden sky, through the glass */
    double below;  /* by ground with a reflectance of 1; for an obstruction, by its part
                    * below the horizon at the luminance of the horizon */
    double own;    /* by the exitance of the obstruction */
    double factor; /* luminance factor of the obstruction, reflectance of the ground */
};

/* Records the steps of the next part; none for a patch of no size. */
void pp_direct_steps_add(struct pp_part_steps *terms,
                         const struct pp_patch_figures *figures,
                         const struct pp_sky *sky);

#endif
