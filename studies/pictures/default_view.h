/* default_view.h - standard views of a room, used if the user does not specify a view.
 *
 * Perspective: a view towards the largest window from eye height, at least 0.4 m from
 * walls and objects if the room is large enough. The window is visible near the middle
 * of the picture, and most of the picture shows distant surfaces. In an L-shaped room
 * the viewpoint is not behind the corner. The view is horizontal, so that vertical
 * edges are vertical in the picture, unless the window is far above the eye.
 *
 * Fisheye: a view upwards from the working plane in the middle of the room. Plan and
 * section: parallel views of the whole room, cut as in drawings.
 */
#ifndef PP_STUDIES_PICTURES_DEFAULT_VIEW_H
#define PP_STUDIES_PICTURES_DEFAULT_VIEW_H

#include "model/pictures/camera.h"
#include "model/room/world.h"
#include "simulate/scene/light_scene.h"

#define PP_EYE_HEIGHT_M 1.6
#define PP_PERSPECTIVE_DEG 75.0 /* horizontal angle of view */
#define PP_PLAN_CUT_M 1.2

/* Kind of view of a room. */
enum pp_room_view {
    PP_ROOM_VIEW_PERSPECTIVE,
    PP_ROOM_VIEW_FISHEYE,
    PP_ROOM_VIEW_PLAN,    /* seen from above, with +y upwards */
    PP_ROOM_VIEW_SECTION, /* through the middle of the largest window, with the window
                           * on the left */
};

struct pp_view_place {
    struct pp_vec3 eye, toward, up; /* directions need not be unit vectors */
    double across_m, down_m;        /* size of plan and section (m); otherwise 0 */
};

/* Sets a standard view. `scene` must be made from `world`. */
void pp_default_view(struct pp_view_place *place, const struct pp_light_scene *scene,
                     const struct pp_world *world, enum pp_room_view view);

#endif
