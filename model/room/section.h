/* section.h - the room's section by a level plane. */
#ifndef PP_MODEL_ROOM_SECTION_H
#define PP_MODEL_ROOM_SECTION_H

#include "model/room/world.h"

/* The section by the plane at z (m), as world->plane is that by the working plane;
 * empty where the room does not reach. The region is the caller's. */
enum pp_status pp_section_at(struct pp_region *region, const struct pp_world *world,
                             double z, struct pp_error *err);

/* The same where the envelope's corners are numbered already: `corners` has a number
 * for each vertex, face after face, the same for all faces that meet in a corner. */
enum pp_status pp_section_cut(struct pp_region *region, const struct pp_world *world,
                              const int *corners, double z, struct pp_error *err);

/* True if it stands through the working plane. */
bool pp_section_meets(const struct pp_world *world, const struct pp_fitting *fitting);

/* The working plane less the furniture, columns and partitions that it cuts; all of it where
 * they leave nothing. The region is the caller's. */
enum pp_status pp_section_open(struct pp_region *region, const struct pp_world *world,
                               struct pp_error *err);

#endif
