/* formula_list.h - prints the published formulae of all methods: text, source, and the
 * quantities that may be named in formulae and in variants. */
#ifndef PP_REPORTS_FORMULA_LIST_H
#define PP_REPORTS_FORMULA_LIST_H

#include <stdio.h>

#include "methods/variant.h"

/* Prints the list. Method names begin in column 1, formulae in column 3, and quantities
 * in column 7. docs/formulae.awk depends on these columns. */
void pp_formula_list(FILE *out);

/* Prints the variants used in a run, each with the name of its column, wrapped at
 * `width`. Prints nothing if variants is NULL. */
void pp_formula_list_variants(const struct pp_variant_list *variants, int width,
                              FILE *out);

#endif
