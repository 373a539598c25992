/* frame.h - right-handed orthogonal axes, and directions in them.
 *
 * x cross y is z. The owner defines their orientation: a face's frame has z along its
 * normal, a sampling frame has z along the axis of its lobe.
 */
#ifndef PP_MODEL_GEOMETRY_FRAME_H
#define PP_MODEL_GEOMETRY_FRAME_H

#include "model/geometry/vec.h"

struct pp_frame {
    struct pp_vec3 x, y, z; /* unit */
};

/* Converts a direction from the frame to the world. */
static inline struct pp_vec3 pp_frame_out(const struct pp_frame *frame,
                                          struct pp_vec3 own)
{
    return pp_vec(frame->x.x * own.x + frame->y.x * own.y + frame->z.x * own.z,
                  frame->x.y * own.x + frame->y.y * own.y + frame->z.y * own.z,
                  frame->x.z * own.x + frame->y.z * own.y + frame->z.z * own.z);
}

/* Converts a direction from the world to the frame. */
static inline struct pp_vec3 pp_frame_in(const struct pp_frame *frame,
                                         struct pp_vec3 direction)
{
    return pp_vec(pp_vec_dot(frame->x, direction), pp_vec_dot(frame->y, direction),
                  pp_vec_dot(frame->z, direction));
}

#endif
