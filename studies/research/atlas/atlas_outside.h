/* atlas_outside.h - obstructions outside a room of the sweep. Inside
 * studies/research/atlas/ only. */
#ifndef PP_STUDIES_RESEARCH_ATLAS_ATLAS_OUTSIDE_H
#define PP_STUDIES_RESEARCH_ATLAS_ATLAS_OUTSIDE_H

#include <stdbool.h>

#include "studies/research/atlas/atlas_layout.h"

/* Writes the ground and its level, and the sky; sets room->ground. */
void pp_atlas_outside_site(struct pp_atlas_layout *room);

/* Writes the obstructions. windows: true if the room has windows in walls. Call this
 * after the room's shape and openings are written. */
void pp_atlas_outside_put(struct pp_atlas_layout *room, bool windows);

#endif
