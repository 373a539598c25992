/* as_if_glass.h - panes as another program may have taken them. */
#ifndef PP_STUDIES_COMPARE_AS_IF_GLASS_H
#define PP_STUDIES_COMPARE_AS_IF_GLASS_H

#include "model/light/glass.h"
#include "studies/compare/as_if.h"

struct pp_glass pp_as_if_glass(struct pp_glass glass, const struct pp_as_if *as_if);

#endif
