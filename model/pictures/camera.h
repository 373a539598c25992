/* camera.h - viewpoint and projection of a picture.
 *
 * Views are Radiance's [WS98], so that its programs read ours: a picture runs from 0 to
 * 1 across and from 0 to 1 down; its middle lies in the direction of view.
 *
 *     perspective    right angles stay right about the middle; sizes are angles
 *     parallel       all rays one way: a plan, an elevation, a section; sizes in metres
 *     hemispherical  as it falls on a plane square to the view: equal areas of the
 *                    picture weigh equally in its illuminance (the sine of the angle
 *                    from the middle)
 *     angular        distance from the middle goes as the angle (fisheye)
 */
#ifndef PP_MODEL_PICTURES_CAMERA_H
#define PP_MODEL_PICTURES_CAMERA_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"
#include "model/geometry/vec.h"

enum pp_view_kind {
    PP_VIEW_PERSPECTIVE,
    PP_VIEW_PARALLEL,
    PP_VIEW_HEMISPHERICAL,
    PP_VIEW_ANGULAR,
};

/* Filled by pp_camera_set, and only read from then on. */
struct pp_camera {
    enum pp_view_kind kind;
    struct pp_vec3 eye;
    struct pp_vec3 toward, right, up; /* unit, square to each other */
    double across, down;              /* rad, or metres of a parallel view */
};

/* `up` need not be square to `toward`, only not along it; neither need be unit. Sizes:
 * perspective less than pi, hemispherical up to pi, angular up to 2 pi, all above 0.
 * PP_BAD_INPUT for invalid views. */
enum pp_status pp_camera_set(struct pp_camera *camera, enum pp_view_kind kind,
                             struct pp_vec3 eye, struct pp_vec3 toward,
                             struct pp_vec3 up, double across, double down,
                             struct pp_error *err);

/* The ray through a place in the picture: from where, and to (unit). False where there
 * is none: outside a fisheye's circle. */
bool pp_camera_ray(const struct pp_camera *camera, double x, double y,
                   struct pp_vec3 *from, struct pp_vec3 *to);

/* Position of a point in the picture (x or y may lie outside 0 to 1), and its distance
 * along its ray. False if it is behind the view or cannot be projected. */
bool pp_camera_project(const struct pp_camera *camera, struct pp_vec3 point, double *x,
                       double *y, double *distance_m);

/* The view as Radiance's options, "-vtv -vp 1 2 1.6 -vd ...", that read back to the
 * same view within 1e-9. */
void pp_camera_options(const struct pp_camera *camera, char *text, size_t room);

#endif
