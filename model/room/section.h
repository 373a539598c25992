/* section.h - horizontal sections of the room. */
#ifndef PP_MODEL_ROOM_SECTION_H
#define PP_MODEL_ROOM_SECTION_H

#include "model/room/world.h"

/* Section by the plane at z (m), like world->plane for the working plane; empty outside
 * the room's heights. The caller clears the region. */
enum pp_status pp_section_at(struct pp_region *region, const struct pp_world *world,
                             double z, struct pp_error *err);

/* Section for an envelope with numbered corners: `corners` has a number for each vertex
 * of each face in order, equal for faces that meet in a corner. The caller clears the
 * region. */
enum pp_status pp_section_cut(struct pp_region *region, const struct pp_world *world,
                              const int *corners, double z, struct pp_error *err);

/* True if the fitting crosses the working plane. */
bool pp_section_meets(const struct pp_world *world, const struct pp_fitting *fitting);

/* Working plane less the fittings that cross it; the whole plane if nothing is left.
 * The caller clears the region. */
enum pp_status pp_section_open(struct pp_region *region, const struct pp_world *world,
                               struct pp_error *err);

#endif
