/* default_view.h - from where to look at a room when nobody says so.
 *
 * A perspective is taken towards the largest window, from where one sees it and sees
 * far across all of the picture, not much aside of the window, and 0.4 m clear of walls
 * and of what stands in the room where that is large enough: in an L-shaped room not
 * from behind the corner. It is taken at eye height, and level where the window is not
 * far above the eye: uprights stay upright. A fisheye is
 * the view of a light meter that lies on the working plane in the middle of the room.
 * Plan and section are parallel views of all of the room, cut as drawings are.
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
    PP_ROOM_VIEW_SECTION, /* through the middle of the largest window, it on the left */
};

struct pp_view_place {
    struct pp_vec3 eye, toward, up; /* directions not unit */
    double across_m, down_m;        /* of plan and section; else 0 */
};

/* `scene` must be made from `world`. */
void pp_default_view(struct pp_view_place *place, const struct pp_light_scene *scene,
                     const struct pp_world *world, enum pp_room_view view);

#endif
