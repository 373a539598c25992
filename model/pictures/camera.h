/* camera.h - viewpoint and projection of a picture.
 *
 * Views are those of Radiance [WS98], so that its programs can read them. Picture
 * coordinates run from 0 to 1, across and down; the centre is in the direction of view.
 *
 *     perspective    straight lines stay straight; sizes are angles
 *     parallel       all rays are parallel: plan, elevation, section; sizes in metres
 *     hemispherical  orthographic fisheye: the distance from the centre is the sine of
 *                    the angle, so that equal areas of the picture contribute equally
 *                    to the illuminance of a plane normal to the view
 *     angular        distance from the centre is proportional to the angle (fisheye)
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

/* Set by pp_camera_set and constant afterwards. */
struct pp_camera {
    enum pp_view_kind kind;
    struct pp_vec3 eye;
    struct pp_vec3 toward, right, up; /* unit, orthogonal */
    double across, down;              /* rad; metres for a parallel view */
};

/* Sets a view. `up` must not be parallel to `toward`; they need not be orthogonal or
 * unit vectors. Sizes, all above 0: perspective less than pi, hemispherical up to pi,
 * angular up to 2 pi. PP_BAD_INPUT for invalid views. */
enum pp_status pp_camera_set(struct pp_camera *camera, enum pp_view_kind kind,
                             struct pp_vec3 eye, struct pp_vec3 toward,
                             struct pp_vec3 up, double across, double down,
                             struct pp_error *err);

/* Ray through a position of the picture: origin and unit direction. False if the
 * position is outside a fisheye's circle. */
bool pp_camera_ray(const struct pp_camera *camera, double x, double y,
                   struct pp_vec3 *from, struct pp_vec3 *to);

/* Position of a point in the picture (x or y may be outside 0 to 1), and its distance
 * along its ray. False if it is behind the view or cannot be projected. In a parallel
 * view the distance is negative for a point behind the eye. */
bool pp_camera_project(const struct pp_camera *camera, struct pp_vec3 point, double *x,
                       double *y, double *distance_m);

/* Writes the view as Radiance options, "-vtv -vp 1 2 1.6 -vd ...", which read back to
 * the same view within 1e-9. */
void pp_camera_options(const struct pp_camera *camera, char *text, size_t room);

#endif
