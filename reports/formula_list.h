/* formula_list.h - the published formulae of all methods: texts, sources, and the
 * quantities that they and users' variants may name. */
#ifndef PP_REPORTS_FORMULA_LIST_H
#define PP_REPORTS_FORMULA_LIST_H

#include <stdio.h>

#include "methods/variant.h"

/* Prints the list. A method begins with its name in column 1, a formula in column 3,
 * its quantities in column 7: docs/formulae.awk depends on it. */
void pp_formula_list(FILE *out);

/* Prints the variants of a run, each with its column's name, wrapped at `width`;
 * nothing if variants is NULL. */
void pp_formula_list_variants(const struct pp_variant_list *variants, int width,
                              FILE *out);

#endif
