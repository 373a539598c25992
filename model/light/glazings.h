/* glazings.h - the named glazings (tables/glazings.csv). */
#ifndef PP_MODEL_LIGHT_GLAZINGS_H
#define PP_MODEL_LIGHT_GLAZINGS_H

#include "model/light/glass.h"

struct pp_glazing {
    const char *name;
    double panes, n, kl;
    double normal;         /* transmittance; NAN: calculated from panes */
    const char *diffusing; /* "yes": normal is the hemispherical transmittance */
    const char *source;    /* as explained at the head of the table */
    const char *description;
};

int pp_glazings_count(void);
const struct pp_glazing *pp_glazings_at(int index); /* in table order */

/* Glazing of that name; NULL if there is none. "none" (an unglazed opening) is not in
 * the table. */
const struct pp_glazing *pp_glazings_find(const char *name);

struct pp_glass pp_glazings_glass(const struct pp_glazing *glazing);

#endif
