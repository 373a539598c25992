/* fitted_constants.h - constants of the formulae that were fitted to simulated rooms,
 * as printed in their texts, and the data of the fit [ATLAS].
 *
 * bench/fit_formulae writes the constants, with their uncertainty: the constants are
 * fitted to the rooms with even numbers; rooms with odd numbers are held out.
 * docs/theory.md lists the forms that were tried and their errors.
 */
#ifndef PP_METHODS_FITTED_FITTED_CONSTANTS_H
#define PP_METHODS_FITTED_FITTED_CONSTANTS_H

/* Constants of the position (fitted_position.h): k (depth), c (start) and s (side). */
#define PP_FITTED_DEPTH "1.65"
#define PP_FITTED_START "1.47"
#define PP_FITTED_SIDE "0.65"

/* Constant of the light outside (fitted_light.h): exponent b for the shading of
 * obstructions and of the ground. */
#define PP_FITTED_SHADE "0.78"

/* Constants of `irc-atlas`: for the parts of the room, and for the reveal. */
#define PP_FITTED_PARTS "0.35"
#define PP_FITTED_REVEAL "0.46"

/* Constants of `bre-atlas`: for the upper part, for the parts of the room, and for
 * shallow rooms. */
#define PP_FITTED_BRE_UPPER "0.72"
#define PP_FITTED_BRE_PARTS "0.33"
#define PP_FITTED_BRE_SHALLOW "0.27"

/* Constant of `split-flux-atlas`: for glass below the working plane. */
#define PP_FITTED_FLUX_LOW "0.86"

/* Constants of `average-df-atlas`: factor, and for reveal, floor and light from the
 * ground. */
#define PP_FITTED_DF "0.73"
#define PP_FITTED_DF_REVEAL "0.70"
#define PP_FITTED_DF_FLOOR "0.43"
#define PP_FITTED_DF_UPWARD "0.38"

#endif
