/* camera.c - see camera.h. */
#include "model/pictures/camera.h"

#include <math.h>
#include <stdio.h>

/* Least angle between the direction of view and `up`; at smaller angles the top of the
 * picture is not defined. */
static const double least_angle_rad = 1e-6;

static enum pp_status check_size(enum pp_view_kind kind, double size,
                                 struct pp_error *err)
{
    static const struct {
        const char *name;
        double most; /* largest size (rad); NAN: metres */
        bool below_most;
    } kinds[] = {
        [PP_VIEW_PERSPECTIVE] = {"perspective", PP_PI, true},
        [PP_VIEW_PARALLEL] = {"parallel", NAN, false},
        [PP_VIEW_HEMISPHERICAL] = {"hemispherical", PP_PI, false},
        [PP_VIEW_ANGULAR] = {"angular", 2.0 * PP_PI, false},
    };
    double most = kinds[kind].most;
    if (isnan(most)) {
        if (size > 0.0 && isfinite(size))
            return PP_OK;
        return pp_fail(err, PP_BAD_INPUT,
                       "the parallel view is %g m wide or high; expected more than 0",
                       size);
    }
    double slack = kinds[kind].below_most ? -1e-9 : 1e-9;
    if (size > 0.0 && size <= most + slack)
        return PP_OK;
    return pp_fail(err, PP_BAD_INPUT,
                   "the angle of a %s view is %g degrees; expected more than 0, %s %g",
                   kinds[kind].name, size / PP_RAD,
                   kinds[kind].below_most ? "less than" : "up to", most / PP_RAD);
}

enum pp_status pp_camera_set(struct pp_camera *camera, enum pp_view_kind kind,
                             struct pp_vec3 eye, struct pp_vec3 toward,
                             struct pp_vec3 up, double across, double down,
                             struct pp_error *err)
{
    if (!isfinite(pp_vec_length(eye)))
        return pp_fail(err, PP_BAD_INPUT, "the position of the eye is not a number");
    if (!(pp_vec_length(toward) > 0.0) || !isfinite(pp_vec_length(toward))
        || !(pp_vec_length(up) > 0.0) || !isfinite(pp_vec_length(up)))
        return pp_fail(err, PP_BAD_INPUT,
                       "the view direction or the up direction is 0; expected a "
                       "direction");
    enum pp_status status = check_size(kind, across, err);
    if (status == PP_OK)
        status = check_size(kind, down, err);
    if (status != PP_OK)
        return status;
    toward = pp_vec_unit(toward);
    struct pp_vec3 right = pp_vec_cross(toward, pp_vec_unit(up));
    if (pp_vec_length(right) < least_angle_rad)
        return pp_fail(
            err, PP_BAD_INPUT,
            "the view direction is parallel to the up direction; expected another up "
            "direction");
    right = pp_vec_unit(right);
    *camera = (struct pp_camera){
        kind, eye, toward, right, pp_vec_cross(right, toward), across, down};
    return PP_OK;
}

/* Half the extent of the picture on its projection plane or dome. */
static double half_extent(enum pp_view_kind kind, double size)
{
    switch (kind) {
    case PP_VIEW_PERSPECTIVE:
        return tan(size / 2.0);
    case PP_VIEW_HEMISPHERICAL:
        return sin(size / 2.0);
    case PP_VIEW_PARALLEL:
    case PP_VIEW_ANGULAR:
        break;
    }
    return size / 2.0;
}

bool pp_camera_ray(const struct pp_camera *camera, double x, double y,
                   struct pp_vec3 *from, struct pp_vec3 *to)
{
    double h = (2.0 * x - 1.0) * half_extent(camera->kind, camera->across);
    double v = (1.0 - 2.0 * y) * half_extent(camera->kind, camera->down);
    double r = hypot(h, v), ahead = 1.0, aside = 1.0;
    *from = camera->eye;
    *to = camera->toward;
    switch (camera->kind) {
    case PP_VIEW_PARALLEL:
        *from =
            pp_vec_along(pp_vec_along(camera->eye, h, camera->right), v, camera->up);
        return true;
    case PP_VIEW_PERSPECTIVE:
        break;
    case PP_VIEW_HEMISPHERICAL:
        if (r > 1.0)
            return false;
        ahead = sqrt(1.0 - r * r);
        break;
    case PP_VIEW_ANGULAR:
        if (r > PP_PI)
            return false;
        ahead = cos(r);
        aside = r > 0.0 ? sin(r) / r : 1.0;
        break;
    }
    *to = pp_vec_unit(pp_vec_along(
        pp_vec_along(pp_vec_scale(camera->toward, ahead), aside * h, camera->right),
        aside * v, camera->up));
    return true;
}

bool pp_camera_project(const struct pp_camera *camera, struct pp_vec3 point, double *x,
                       double *y, double *distance_m)
{
    struct pp_vec3 way = pp_vec_sub(point, camera->eye);
    double ahead = pp_vec_dot(way, camera->toward);
    double h = pp_vec_dot(way, camera->right), v = pp_vec_dot(way, camera->up);
    double length = pp_vec_length(way), scale = 1.0;
    switch (camera->kind) {
    case PP_VIEW_PARALLEL:
        *distance_m = ahead;
        break;
    case PP_VIEW_PERSPECTIVE:
        if (!(ahead > 0.0))
            return false;
        scale = 1.0 / ahead;
        *distance_m = length;
        break;
    case PP_VIEW_HEMISPHERICAL:
        if (!(ahead >= 0.0) || !(length > 0.0))
            return false;
        scale = 1.0 / length;
        *distance_m = length;
        break;
    case PP_VIEW_ANGULAR: {
        double aside = hypot(h, v);
        if (!(length > 0.0) || (aside == 0.0 && ahead < 0.0))
            return false;
        scale = aside > 0.0 ? atan2(aside, ahead) / aside : 0.0;
        *distance_m = length;
        break;
    }
    }
    *x = 0.5 + 0.5 * scale * h / half_extent(camera->kind, camera->across);
    *y = 0.5 - 0.5 * scale * v / half_extent(camera->kind, camera->down);
    return true;
}

void pp_camera_options(const struct pp_camera *camera, char *text, size_t room)
{
    static const char letters[] = {[PP_VIEW_PERSPECTIVE] = 'v',
                                   [PP_VIEW_PARALLEL] = 'l',
                                   [PP_VIEW_HEMISPHERICAL] = 'h',
                                   [PP_VIEW_ANGULAR] = 'a'};
    double unit = camera->kind == PP_VIEW_PARALLEL ? 1.0 : PP_RAD;
    struct pp_vec3 p = camera->eye, d = camera->toward, u = camera->up;
    snprintf(text, room,
             "-vt%c -vp %.12g %.12g %.12g -vd %.12g %.12g %.12g -vu %.12g %.12g %.12g "
             "-vh %.12g -vv %.12g",
             letters[camera->kind], p.x, p.y, p.z, d.x, d.y, d.z, u.x, u.y, u.z,
             camera->across / unit, camera->down / unit);
}
