/* render_view.c - places the camera: the default view of the room, modified by the
 * options. */
#include "cli/render/render_view.h"

#include <math.h>
#include <stdio.h>

#include "model/room/position.h"
#include "studies/pictures/default_view.h"

enum { LONG_SIDE = 640, SHORT_SIDE = 480, FISHEYE_SIDE = 512 };

static const double fisheye_deg = 180.0;

static bool is_fisheye(enum pp_view_choice view)
{
    return view == PP_CHOOSE_HEMISPHERICAL || view == PP_CHOOSE_ANGULAR;
}

static enum pp_room_view room_view(enum pp_view_choice view)
{
    switch (view) {
    case PP_CHOOSE_PLAN:
        return PP_ROOM_VIEW_PLAN;
    case PP_CHOOSE_SECTION:
        return PP_ROOM_VIEW_SECTION;
    case PP_CHOOSE_HEMISPHERICAL:
    case PP_CHOOSE_ANGULAR:
        return PP_ROOM_VIEW_FISHEYE;
    case PP_CHOOSE_PERSPECTIVE:
    case PP_CHOOSE_PARALLEL:
        break;
    }
    return PP_ROOM_VIEW_PERSPECTIVE;
}

static enum pp_view_kind view_kind(enum pp_view_choice view)
{
    switch (view) {
    case PP_CHOOSE_HEMISPHERICAL:
        return PP_VIEW_HEMISPHERICAL;
    case PP_CHOOSE_ANGULAR:
        return PP_VIEW_ANGULAR;
    case PP_CHOOSE_PERSPECTIVE:
        return PP_VIEW_PERSPECTIVE;
    case PP_CHOOSE_PARALLEL:
    case PP_CHOOSE_PLAN:
    case PP_CHOOSE_SECTION:
        break;
    }
    return PP_VIEW_PARALLEL;
}

/* Replaces parts of the room's default view by the values given. A height that is not
 * given remains unchanged. */
static enum pp_status take_typed(struct pp_view_place *place,
                                 const struct pp_render_choice *choice,
                                 struct pp_error *err)
{
    if (choice->from.count) {
        double height_m = place->eye.z;
        place->eye = choice->from.is;
        if (choice->from.count == 2)
            place->eye.z = height_m;
    }
    if (choice->direction.count)
        place->toward = choice->direction.is;
    if (choice->towards.count) {
        struct pp_vec3 target = choice->towards.is;
        if (choice->towards.count == 2)
            target.z = place->eye.z;
        place->toward = pp_vec_sub(target, place->eye);
        if (!(pp_vec_length(place->toward) > 1e-9))
            return pp_fail(err, PP_BAD_INPUT,
                           "--towards is (%g, %g, %g), which is the position of the "
                           "eye; expected another point, or --direction X,Y,Z",
                           target.x, target.y, target.z);
    }
    if (choice->up.count)
        place->up = choice->up.is;
    else if (hypot(place->toward.x, place->toward.y) < 1e-6 * fabs(place->toward.z))
        place->up = pp_vec(0.0, 1.0, 0.0);
    else
        place->up = pp_vec(0.0, 0.0, 1.0);
    return PP_OK;
}

/* Rejects an eye that lies in a surface. */
static enum pp_status check_eye(struct pp_vec3 eye, const struct pp_world *world,
                                struct pp_error *err)
{
    if (pp_position_in_surface(world, eye))
        return pp_fail(err, PP_BAD_INPUT,
                       "the eye at (%g, %g, %g) lies in a surface; expected --from "
                       "with a point in free space",
                       eye.x, eye.y, eye.z);
    return PP_OK;
}

/* Length of a side of a picture in pixels, rounded and limited. */
static int side(double pixels)
{
    return (int)fmin(fmax(lrint(pixels), 1.0), PP_PICTURE_SIDE_MOST);
}

/* Computes width and height of a parallel view (m), and the size of the picture such
 * that pixels are square. */
static void size_parallel(struct pp_picture_size *size, double *across, double *down,
                          const struct pp_render_choice *choice,
                          const struct pp_view_place *place)
{
    double shape = place->across_m > 0.0 ? place->down_m / place->across_m
                                         : (double)SHORT_SIDE / LONG_SIDE;
    *across = choice->across_m > 0.0  ? choice->across_m
              : place->across_m > 0.0 ? place->across_m
                                      : 10.0;
    if (choice->size.width)
        *size = choice->size;
    else if (shape < 1.0)
        *size = (struct pp_picture_size){LONG_SIDE, side(LONG_SIDE * shape)};
    else
        *size = (struct pp_picture_size){side(LONG_SIDE / shape), LONG_SIDE};
    /* If the width is not given, the view contains the whole room at any aspect ratio
     * of the picture. */
    double asked = (double)size->height / size->width;
    if (choice->across_m == 0.0 && asked < shape)
        *across *= shape / asked;
    *down = *across * asked;
}

/* Computes the horizontal and vertical angles of view (rad), and the size of the
 * picture such that pixels are square. */
static void size_angles(struct pp_picture_size *size, double *across, double *down,
                        const struct pp_render_choice *choice)
{
    bool fisheye = is_fisheye(choice->view);
    double deg = choice->angle_deg > 0.0 ? choice->angle_deg
                 : fisheye               ? fisheye_deg
                                         : PP_PERSPECTIVE_DEG;
    *size = choice->size.width ? choice->size
            : fisheye          ? (struct pp_picture_size){FISHEYE_SIDE, FISHEYE_SIDE}
                               : (struct pp_picture_size){LONG_SIDE, SHORT_SIDE};
    double shape = (double)size->height / size->width;
    *across = *down = deg * PP_RAD;
    if (choice->view == PP_CHOOSE_PERSPECTIVE && deg < 180.0)
        *down = 2.0 * atan(shape * tan(*across / 2.0));
    else if (choice->view == PP_CHOOSE_HEMISPHERICAL && deg <= 180.0)
        *down = 2.0 * asin(fmin(shape * sin(*across / 2.0), 1.0));
    else if (choice->view == PP_CHOOSE_ANGULAR)
        *down = fmin(shape * *across, 2.0 * PP_PI);
}

enum pp_status pp_render_view(struct pp_camera *camera, struct pp_picture_size *size,
                              const struct pp_render_choice *choice,
                              const struct pp_light_scene *scene,
                              const struct pp_world *world, struct pp_error *err)
{
    struct pp_view_place place;
    pp_default_view(&place, scene, world, room_view(choice->view));
    enum pp_view_kind kind = view_kind(choice->view);
    enum pp_status status = take_typed(&place, choice, err);
    if (status == PP_OK && kind != PP_VIEW_PARALLEL)
        status = check_eye(place.eye, world, err);
    if (status != PP_OK)
        return status;
    double across, down;
    if (kind == PP_VIEW_PARALLEL)
        size_parallel(size, &across, &down, choice, &place);
    else
        size_angles(size, &across, &down, choice);
    return pp_camera_set(camera, kind, place.eye, place.toward, place.up, across, down,
                         err);
}

/* Rounds to centimetres. Adding 0.0 avoids -0. */
static double to_centimetres(double m)
{
    return round(100.0 * m) / 100.0 + 0.0;
}

void pp_render_view_words(char *text, size_t room, const struct pp_camera *camera,
                          const struct pp_world *world)
{
    static const char *const kinds[] = {[PP_VIEW_PERSPECTIVE] = "Perspective",
                                        [PP_VIEW_PARALLEL] = "Parallel view",
                                        [PP_VIEW_HEMISPHERICAL] =
                                            "Hemispherical fisheye",
                                        [PP_VIEW_ANGULAR] = "Angular fisheye"};
    struct pp_vec3 eye = camera->eye, to = camera->toward;
    double level = hypot(to.x, to.y);
    char way[64];
    if (level < 1e-6) {
        snprintf(way, sizeof way, "straight %s", to.z > 0.0 ? "up" : "down");
    } else {
        double bearing = fmod(atan2(to.x, to.y) + world->north_rad, 2.0 * PP_PI);
        double tilt = atan2(to.z, level) / PP_RAD;
        int length = snprintf(
            way, sizeof way, "to bearing %.0f°",
            fmod(round((bearing < 0.0 ? bearing + 2.0 * PP_PI : bearing) / PP_RAD),
                 360.0));
        if (fabs(tilt) >= 0.5 && length > 0)
            snprintf(way + length, sizeof way - (size_t)length, ", %.0f° %s",
                     fabs(tilt), tilt > 0.0 ? "up" : "down");
    }
    snprintf(text, room, "%s from (%.7g, %.7g, %.7g) m %s", kinds[camera->kind],
             to_centimetres(eye.x), to_centimetres(eye.y), to_centimetres(eye.z), way);
}
