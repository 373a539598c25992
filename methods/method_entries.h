/* method_entries.h - each hand method's own entry, for the list and for tests. */
#ifndef PP_METHODS_METHOD_ENTRIES_H
#define PP_METHODS_METHOD_ENTRIES_H

#include "methods/exact/exact.h"
#include "methods/method.h"

extern const struct pp_method pp_method_brs_table;
extern const struct pp_method pp_method_waldram;
extern const struct pp_method pp_method_pepper_pot;
extern const struct pp_method pp_method_protractor;
extern const struct pp_method pp_method_bre;
extern const struct pp_method pp_method_bre_min;
extern const struct pp_method pp_method_bre_table;
extern const struct pp_method pp_method_split_flux;
extern const struct pp_method pp_method_sphere;
extern const struct pp_method pp_method_nomogram;
extern const struct pp_method pp_method_average_df;
extern const struct pp_method pp_method_average_df_lynes;
extern const struct pp_method pp_method_lumen;
extern const struct pp_method pp_method_lumen_one;

#endif
