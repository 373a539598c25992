/* direct_plane.h - the direct component, by one method, anywhere on a room's working
 * plane, for a receiver that faces up.
 *
 * The direct component is not defined in the plane of a vertical opening. The least
 * distance from an opening is 20 mm or 1/500 of the plane's diagonal, whichever is
 * less; nearer points have the value at that distance. Points nearer to a wall than 1
 * mm have the value at 1 mm.
 */
#ifndef PP_METHODS_DIRECT_PLANE_H
#define PP_METHODS_DIRECT_PLANE_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/room/world.h"

struct pp_method; /* methods/method.h */
struct pp_direct_plane;

/* Prepares a plane for a method that gives values at points and does not count squares
 * or dots. World and light must outlive *plane. On success the caller destroys *plane.
 * PP_BAD_INPUT, with the reason, if the method does not cover the room. */
enum pp_status pp_direct_plane_create(struct pp_direct_plane **plane,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_method *method,
                                      struct pp_error *err);
void pp_direct_plane_destroy(struct pp_direct_plane *plane); /* NULL is allowed */

/* Sky component and externally reflected component (fractions), corrected for glass,
 * frame and dirt. */
enum pp_status pp_direct_plane_at(const struct pp_direct_plane *plane, double x,
                                  double y, double *sky, double *external,
                                  struct pp_error *err);

/* The point (x, y, z), moved along the inward normals of nearby edges until it is at
 * least inset_m from the walls. The view of the outside is not defined on the edge
 * itself, where the point may be in the plane of a window. */
struct pp_vec3 pp_direct_plane_off_walls(const struct pp_region *region, double z,
                                         double inset_m, double x, double y);

#endif
