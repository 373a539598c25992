/* block_shape.h - shapes of blocks that are not boxes: footprints of any outline, and
 * roofs, as polygons. Inside model/room/ only.
 *
 * Lengths are in metres, in the block's own axes: u along its width, v along its depth,
 * z up from its base. All polygons are plane and counter-clockwise seen from outside.
 */
#ifndef PP_MODEL_ROOM_READ_BLOCK_SHAPE_H
#define PP_MODEL_ROOM_READ_BLOCK_SHAPE_H

#include "model/base/error.h"
#include "model/geometry/vec.h"

enum pp_roof {
    PP_ROOF_FLAT,
    PP_ROOF_MONO,     /* rises from one side to the opposite side */
    PP_ROOF_GABLE,    /* two slopes that meet in a ridge, with vertical ends */
    PP_ROOF_HIP,      /* four slopes of equal pitch */
    PP_ROOF_SAW_TOOTH /* a row of mono-pitch roofs; rooms only */
};
enum pp_ridge {
    PP_RIDGE_LONGER, /* along the longer sides; along the width of a square */
    PP_RIDGE_WIDTH,
    PP_RIDGE_DEPTH
};

enum { PP_BLOCK_SHAPE_CORNERS = 4, PP_BLOCK_SHAPE_ROOF_MOST = 4 };

/* A polygon of three or four corners. */
struct pp_block_shape_face {
    struct pp_vec3 corners[PP_BLOCK_SHAPE_CORNERS];
    int count;
};

/* Makes the roof of a box of that width and depth with walls of height_m: slopes and
 * gables at the pitch (rad, above 0, below pi/2). A mono-pitch roof is highest at v =
 * depth (ridge along the width) or u = width (ridge along the depth). The ridge of a
 * hip roof runs along the longer sides. Returns the number of faces; 0 for a flat
 * roof. */
int pp_block_shape_roof(struct pp_block_shape_face faces[PP_BLOCK_SHAPE_ROOF_MOST],
                        double width_m, double depth_m, double height_m,
                        enum pp_roof roof, double pitch_rad, enum pp_ridge ridge);

#endif
