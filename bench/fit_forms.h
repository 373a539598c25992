/* fit_forms.h - the forms of methods/fitted/ as models for the fit, and names of their
 * parts. */
#ifndef PP_BENCH_FIT_FORMS_H
#define PP_BENCH_FIT_FORMS_H

#include "bench/fit_model.h"

struct pp_fit_form {
    const char *name;                         /* name of the method */
    struct pp_fit_model model;                /* with initial values */
    enum pp_fit_source printed;               /* hand formula for comparison */
    const char *constants[PP_FIT_MOST_TERMS]; /* constant of each term, as named in
                                               * fitted_constants.h */
};

/* The first form is irc-atlas: the fits of the other forms use its position factors. */
extern const struct pp_fit_form pp_fit_forms_shipped[];
extern const int pp_fit_forms_count;

extern const char *const pp_fit_forms_sources[PP_FIT_SOURCES];
extern const char *const pp_fit_forms_shapes[PP_FIT_SHAPES];
extern const char *const pp_fit_forms_sides[PP_FIT_SIDES];
extern const char *const pp_fit_forms_shades[PP_FIT_SHADES];
extern const char *const pp_fit_forms_ranges[PP_FIT_RANGES];
extern const char *const pp_fit_forms_terms[PP_FIT_TERMS];

#endif
