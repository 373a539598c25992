/* half_space_clip.h - the part of a polygon within half-spaces through the eye, passed
 * to a callback vertex by vertex. */
#ifndef PP_METHODS_EXACT_HALF_SPACE_CLIP_H
#define PP_METHODS_EXACT_HALF_SPACE_CLIP_H

#include "model/geometry/vec.h"

/* The most half-spaces in one call. */
enum { PP_HALF_SPACES_MOST = 8 };

/* Callback that receives the next vertex of the clipped polygon. */
typedef void pp_half_space_sink(void *data, struct pp_vec3 vertex);

/* Calls the sink with each vertex, relative to the eye at the origin, of the part of a
 * ring within all the half-spaces h.u > 0, in the ring's order. A non-convex ring may
 * be cut into parts connected by bridges along the cut. The bridges are traversed in
 * both directions, and cancel in a sum over edges. Allocates nothing. */
void pp_half_space_clip(const struct pp_vec3 *vertices, int count,
                        const struct pp_vec3 *half_spaces, int half_space_count,
                        pp_half_space_sink *sink, void *data);

#endif
