/* section.h - horizontal sections of the room. */
#ifndef PP_MODEL_ROOM_SECTION_H
#define PP_MODEL_ROOM_SECTION_H

#include "model/room/world.h"

/* Section of the room at the height z (m); world->plane is the section at the working
 * plane. The section is empty above and below the room. The caller clears the
 * region. */
enum pp_status pp_section_at(struct pp_region *region, const struct pp_world *world,
                             double z, struct pp_error *err);

/* Section for an envelope with numbered corners: `corners` has a number for each vertex
 * of each face in order; vertices that coincide have equal numbers. The caller clears
 * the region. */
enum pp_status pp_section_cut(struct pp_region *region, const struct pp_world *world,
                              const int *corners, double z, struct pp_error *err);

/* True if the fitting crosses the working plane. */
bool pp_section_meets(const struct pp_world *world, const struct pp_fitting *fitting);

/* Working plane less the fittings that cross it; the whole plane if nothing is left.
 * The caller clears the region. */
enum pp_status pp_section_open(struct pp_region *region, const struct pp_world *world,
                               struct pp_error *err);

#endif
