/* triangles.h - surfaces, panes and the working plane cut into triangles, for the ray
 * kernels and for sampling by area.
 */
#ifndef PP_SIMULATE_SCENE_TRIANGLES_H
#define PP_SIMULATE_SCENE_TRIANGLES_H

#include "model/base/error.h"
#include "model/geometry/clipper.h"
#include "model/room/world.h"

struct pp_triangles {
    struct pp_vec3 (*corners)[3];
    int *facet_of; /* index of each triangle's facet */
    int count;
};

void pp_triangles_clear(struct pp_triangles *list); /* the list is then empty */

/* Appends the triangles of a surface (for a face of the room, without its openings) as
 * facet `surface`, in coordinates from `centre`. Corners are bit-identical to the
 * polygon's corners, so that there are no gaps between neighbours. */
enum pp_status pp_triangles_of_surface(struct pp_triangles *list,
                                       struct pp_clipper *clipper,
                                       const struct pp_world *world, int surface,
                                       struct pp_vec3 centre, struct pp_error *err);

/* Triangulates any polygon. A polygon that touches or crosses itself is cut at the
 * crossings (clipper.h). The enclosed area may be empty. */
enum pp_status pp_triangles_of_polygon(struct pp_triangles *list,
                                       struct pp_clipper *clipper,
                                       const struct pp_polygon *polygon, int facet,
                                       struct pp_vec3 centre, struct pp_error *err);

/* Triangulates the working plane; the caller frees *triangles. */
enum pp_status pp_triangles_of_plane(struct pp_vec3 (**triangles)[3], int *count,
                                     struct pp_clipper *clipper,
                                     const struct pp_world *world,
                                     struct pp_vec3 centre, struct pp_error *err);

/* Converts the corners to single precision, for the ray kernels; the caller frees the
 * result. NULL if memory runs out. */
float (*pp_triangles_single(const struct pp_vec3 (*corners)[3], int count))[3][3];

#endif
