/* fit_forms.h - the forms of methods/fitted/ as models to be fitted, and the names of what
 * they are made of. */
#ifndef PP_BENCH_FIT_FORMS_H
#define PP_BENCH_FIT_FORMS_H

#include "bench/fit_model.h"

struct pp_fit_form {
    const char *name;                         /* of the method */
    struct pp_fit_model model;                /* with values to begin from */
    enum pp_fit_source printed;               /* that it is compared with */
    const char *constants[PP_FIT_MOST_TERMS]; /* of fitted_constants.h, by term */
};

/* irc-atlas first: the others have its position. */
extern const struct pp_fit_form pp_fit_forms_shipped[];
extern const int pp_fit_forms_count;

extern const char *const pp_fit_forms_sources[PP_FIT_SOURCES];
extern const char *const pp_fit_forms_shapes[PP_FIT_SHAPES];
extern const char *const pp_fit_forms_sides[PP_FIT_SIDES];
extern const char *const pp_fit_forms_shades[PP_FIT_SHADES];
extern const char *const pp_fit_forms_ranges[PP_FIT_RANGES];
extern const char *const pp_fit_forms_terms[PP_FIT_TERMS];

#endif
