/* plan_roof.h - the envelope of a rectangular room under a pitched roof. Inside
 * model/room/read/ only.
 */
#ifndef PP_MODEL_ROOM_READ_PLAN_ROOF_H
#define PP_MODEL_ROOM_READ_PLAN_ROOF_H

#include "model/room/read/block_shape.h"
#include "model/room/read/reader.h"
#include "model/room/room_parts.h"

enum { PP_PLAN_ROOF_TEETH_MOST = 50 };

/* A pitched roof over a plan: lengths in metres, height of the eaves, pitch in rad. */
struct pp_plan_roof {
    double width_m, depth_m, height_m, pitch_rad;
    enum pp_roof roof; /* not flat */
    enum pp_ridge ridge;
    int teeth; /* saw-tooth roof only, 1 to PP_PLAN_ROOF_TEETH_MOST */
    int line;
};

/* Adds the faces of an envelope to the plan: the floor; the walls south, east, north
 * and west; slopes named by direction, roof-south, ... A saw-tooth roof has the slopes
 * roof-1, ... with the vertical walls light-1, ... between them. Shapes are those of
 * block_shape.h; saw teeth slope like a mono-pitch roof. The reader records if memory
 * runs out. */
void pp_plan_roof_add(struct pp_reader *r, struct pp_plan_part *plan,
                      const struct pp_plan_roof *roof);

#endif
