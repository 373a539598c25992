/* formula_list.h - the published formulae of all methods: texts, sources, and the
 * quantities that they and readers' variants may name. */
#ifndef PP_REPORTS_FORMULA_LIST_H
#define PP_REPORTS_FORMULA_LIST_H

#include <stdio.h>

#include "methods/variant.h"

/* A method begins with its name in the first column, a formula in the third, its
 * quantities in the seventh: docs/formulae.awk reads that. */
void pp_formula_list(FILE *out);

/* The variants of a run, each with its column's name, wrapped at `width`; nothing where
 * variants is NULL. */
void pp_formula_list_variants(const struct pp_variant_list *variants, int width,
                              FILE *out);

#endif
