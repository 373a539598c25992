/* variant_glass.h - the glass of a room or scene as other programs may model it. */
#ifndef PP_STUDIES_RESEARCH_COMPARE_VARIANT_GLASS_H
#define PP_STUDIES_RESEARCH_COMPARE_VARIANT_GLASS_H

#include "model/light/glass.h"
#include "studies/research/compare/room_variant.h"

struct pp_glass pp_variant_glass(struct pp_glass glass,
                                 const struct pp_room_variant *variant);

#endif
