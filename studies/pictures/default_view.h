/* default_view.h - views of a room if the user chooses none.
 *
 * A perspective looks towards the largest window, from a point from which the window is
 * visible and most of the picture shows a far view, with the window not far from its
 * middle. The point is 0.4 m clear of walls and of objects in the room, if the room is
 * large enough. In an L-shaped room it is not behind the corner. It is at eye height,
 * and the view is level unless the window is far above the eye: verticals stay
 * vertical. A fisheye is the view of a light meter on the working plane in the middle
 * of the room. Plan and section are parallel views of the whole room, cut as in
 * drawings.
 */
#ifndef PP_STUDIES_PICTURES_DEFAULT_VIEW_H
#define PP_STUDIES_PICTURES_DEFAULT_VIEW_H

#include "model/pictures/camera.h"
#include "model/room/world.h"
#include "simulate/scene/light_scene.h"

#define PP_EYE_HEIGHT_M 1.6
#define PP_PERSPECTIVE_DEG 75.0 /* across the picture */
#define PP_PLAN_CUT_M 1.2

/* Kind of view of a room. */
enum pp_room_view {
    PP_ROOM_VIEW_PERSPECTIVE,
    PP_ROOM_VIEW_FISHEYE,
    PP_ROOM_VIEW_PLAN,    /* from above; +y is up */
    PP_ROOM_VIEW_SECTION, /* through the middle of the largest window, which is on
                           * the left */
};

struct pp_view_place {
    struct pp_vec3 eye, toward, up; /* directions not unit */
    double across_m, down_m;        /* size of plan and section; else 0 */
};

/* `scene` must be made from `world`. */
void pp_default_view(struct pp_view_place *place, const struct pp_light_scene *scene,
                     const struct pp_world *world, enum pp_room_view view);

#endif
