/* glazings.h - the named glazings (tables/glazings.csv). */
#ifndef PP_MODEL_LIGHT_GLAZINGS_H
#define PP_MODEL_LIGHT_GLAZINGS_H

#include "model/light/glass.h"

struct pp_glazing {
    const char *name;
    double panes, n, kl;
    double normal;         /* NAN: as the panes give it */
    const char *diffusing; /* "yes": normal is its hemispherical transmittance */
    const char *source;    /* as the head of the table explains it */
    const char *description;
};

int pp_glazings_count(void);
const struct pp_glazing *pp_glazings_at(int index); /* in the table's order */

/* The glazing of that name, or NULL. "none" (an unglazed opening) is not in the
 * table. */
const struct pp_glazing *pp_glazings_find(const char *name);

struct pp_glass pp_glazings_glass(const struct pp_glazing *glazing);

#endif
