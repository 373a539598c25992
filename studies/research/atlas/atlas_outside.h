/* atlas_outside.h - obstructions outside a room of the sweep. Inside
 * studies/research/atlas/ only. */
#ifndef PP_STUDIES_RESEARCH_ATLAS_ATLAS_OUTSIDE_H
#define PP_STUDIES_RESEARCH_ATLAS_ATLAS_OUTSIDE_H

#include <stdbool.h>

#include "studies/research/atlas/atlas_layout.h"

/* The ground and its level, and the sky; sets room->ground. */
void pp_atlas_outside_site(struct pp_atlas_layout *room);

/* windows: does the room have any in walls? Behind its shape and openings. */
void pp_atlas_outside_put(struct pp_atlas_layout *room, bool windows);

#endif
