/* fitted_constants.h - the constants of the formulae that were fitted to traced rooms, as
 * they stand in their texts, and what they were fitted to [ATLAS].
 *
 * They are written by bench/fit_formulae, which says their uncertainty too: rooms of even
 * number were fitted, rooms of odd number are held out. docs/theory.md has the forms that
 * were tried, and the errors of all of them.
 */
#ifndef PP_METHODS_FITTED_FITTED_CONSTANTS_H
#define PP_METHODS_FITTED_FITTED_CONSTANTS_H

/* Of the position (fitted_position.h): depth and side. */
#define PP_FITTED_DEPTH "1.36"
#define PP_FITTED_SIDE "0.36"

/* Of `irc-atlas`: upper reflectance, sky, parts, reveal. */
#define PP_FITTED_UPPER "0.53"
#define PP_FITTED_SKY "0.31"
#define PP_FITTED_PARTS "0.47"
#define PP_FITTED_REVEAL "0.44"

/* Of `bre-atlas`: factor, sky, parts. */
#define PP_FITTED_BRE "0.87"
#define PP_FITTED_BRE_SKY "0.27"
#define PP_FITTED_BRE_PARTS "0.50"

/* Of `split-flux-atlas`: factor, sky, low glass. */
#define PP_FITTED_FLUX "0.88"
#define PP_FITTED_FLUX_SKY "0.29"
#define PP_FITTED_FLUX_LOW "0.39"

/* Of `average-df-atlas`: factor, sky, reveal, floor, ground. */
#define PP_FITTED_DF "0.77"
#define PP_FITTED_DF_SKY "0.31"
#define PP_FITTED_DF_REVEAL "0.82"
#define PP_FITTED_DF_FLOOR "0.42"
#define PP_FITTED_DF_GROUND "0.47"

#endif
