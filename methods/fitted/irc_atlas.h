/* irc_atlas.h - the first step of `irc-atlas`, which is also used by nomogram IV. */
#ifndef PP_METHODS_FITTED_IRC_ATLAS_H
#define PP_METHODS_FITTED_IRC_ATLAS_H

#include "model/results/formula.h"

/* L: effective light on an opening for the mean internally reflected component. */
extern const struct pp_formula pp_irc_atlas_light;

#endif
