/* plan_roof.h - the envelope of a rectangular room under a pitched roof. Inside
 * model/room/read/ only.
 */
#ifndef PP_MODEL_ROOM_READ_PLAN_ROOF_H
#define PP_MODEL_ROOM_READ_PLAN_ROOF_H

#include "model/room/read/block_shape.h"
#include "model/room/read/reader.h"
#include "model/room/room_parts.h"

enum { PP_PLAN_ROOF_TEETH_MOST = 50 };

/* Form of a plan's roof: lengths in metres, the eaves' height, pitch in rad. */
struct pp_plan_roof {
    double width_m, depth_m, height_m, pitch_rad;
    enum pp_roof roof; /* not flat */
    enum pp_ridge ridge;
    int teeth; /* of a saw-tooth roof, 1 to PP_PLAN_ROOF_TEETH_MOST */
    int line;
};

/* Adds the faces to the plan, which is then an envelope: the floor; walls south, east,
 * north and west; slopes named by their direction, roof-south, ... A saw-tooth roof has
 * roof-1, ... from the eaves on, with the vertical walls light-1, ... between them.
 * Roofs have the shapes of block roofs (block_shape.h); the slope of saw teeth faces
 * away from the ridge of a mono-pitch one. The reader reports lack of memory. */
void pp_plan_roof_add(struct pp_reader *r, struct pp_plan_part *plan,
                      const struct pp_plan_roof *roof);

#endif
