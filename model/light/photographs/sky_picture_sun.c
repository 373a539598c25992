/* sky_picture_sun.c - see sky_picture_sun.h. */
#include "model/light/photographs/sky_picture_sun.h"

#include <math.h>

/* Angular radius of the sun. */
static const double RADIUS_RAD = 0.2665 * PP_RAD;

/* Points that represent the disc, on rings of equal area. */
enum { RINGS = 32, AROUND = 32 };

/* ---- pixels ---- */

/* Solid angle of a pixel; 0 if a corner is outside the picture. */
static double solid_angle_of(const struct pp_sky_frame *frame, int x, int y)
{
    struct pp_vec3 corner[4];
    for (int i = 0; i < 4; i++)
        if (!pp_sky_picture_direction(frame, x + (i == 1 || i == 2), y + i / 2,
                                      &corner[i]))
            return 0.0;
    struct pp_vec3 across = pp_vec_cross(pp_vec_sub(corner[2], corner[0]),
                                         pp_vec_sub(corner[3], corner[1]));
    return pp_vec_length(across) / 2.0;
}

/* The pixel that shows a direction; false if none does. */
static bool pixel_of(const struct pp_sky_frame *frame, struct pp_vec3 to, int *x,
                     int *y)
{
    struct pp_vec3 own = pp_vec(pp_vec_dot(to, frame->right), pp_vec_dot(to, frame->up),
                                pp_vec_dot(to, frame->toward));
    double place[2];
    pp_sky_projection_place(frame->projection, frame->half_angle_rad, own, place);
    *x = (int)floor(frame->centre[0] + frame->radius[0] * place[0]);
    *y = (int)floor(frame->centre[1] - frame->radius[1] * place[1]);
    return *x >= 0 && *y >= 0 && *x < frame->width && *y < frame->height
           && solid_angle_of(frame, *x, *y) > 0.0;
}

/* ---- cells ---- */

/* Adds light from a direction, in lux, to the cell that contains it. */
static void add_to_cell(struct pp_sky_picture *picture, struct pp_vec3 to, double lux)
{
    int cell = pp_sky_picture_cell(to);
    picture->cells[cell] += (float)(lux / pp_sky_picture_solid_angle(cell));
}

/* Adds the light of a pixel, in lux, to the cells. Between pixel centres, luminance is
 * interpolated: the light decreases linearly to the centres of the neighbours. */
static void add_to_cells(struct pp_sky_picture *picture,
                         const struct pp_sky_frame *frame, int x, int y, double lux)
{
    enum { FINE = 16 };
    for (int i = 0; i < FINE * FINE; i++) {
        double dx = 2.0 * (i % FINE + 0.5) / FINE - 1.0;
        double dy = 2.0 * (i / FINE + 0.5) / FINE - 1.0;
        double share = 4.0 * (1.0 - fabs(dx)) * (1.0 - fabs(dy)) / (FINE * FINE);
        struct pp_vec3 to;
        if (pp_sky_picture_direction(frame, x + 0.5 + dx, y + 0.5 + dy, &to)
            || pp_sky_picture_direction(frame, x + 0.5, y + 0.5, &to))
            add_to_cell(picture, to, share * lux);
    }
}

/* ---- the sun ---- */

/* Adds light from a direction to the pixels that show it and to the cells. */
static void add_light(struct pp_sky_picture *picture, struct pp_vec3 to, double lux)
{
    int x[2], y[2], shown = 0;
    bool shows[2] = {false, false};
    for (int i = 0; i < picture->frame_count; i++)
        shown += shows[i] = pixel_of(&picture->frames[i], to, &x[i], &y[i]);
    for (int i = 0; i < picture->frame_count; i++) {
        struct pp_sky_frame *frame = &picture->frames[i];
        if (!shows[i])
            continue;
        size_t index = (size_t)y[i] * (size_t)frame->width + (size_t)x[i];
        frame->luminance[index] += (float)(lux / solid_angle_of(frame, x[i], y[i]));
        add_to_cells(picture, frame, x[i], y[i], lux / shown);
    }
}

static bool shows_direction(const struct pp_sky_picture *picture, struct pp_vec3 to)
{
    int x, y;
    bool shown = false;
    for (int i = 0; i < picture->frame_count; i++)
        shown = shown || pixel_of(&picture->frames[i], to, &x, &y);
    return shown && to.z > 0.0 && to.z >= sin(picture->horizon_rad);
}

enum pp_status pp_sky_picture_sun_add(struct pp_sky_picture *picture,
                                      struct pp_error *err)
{
    if (!shows_direction(picture, picture->sun))
        return pp_fail(
            err, PP_BAD_INPUT,
            "the sun at altitude %.1f, bearing %.1f degrees is outside the "
            "picture or below its horizon; expected a sun in the picture",
            asin(picture->sun.z) / PP_RAD,
            fmod(atan2(picture->sun.x, picture->sun.y) / PP_RAD + 360.0, 360.0));
    struct pp_vec3 a = pp_vec_unit(pp_vec_cross(picture->sun, pp_vec(0.6, 0.8, 0.0)));
    struct pp_vec3 b = pp_vec_cross(picture->sun, a);
    for (int ring = 0; ring < RINGS; ring++)
        for (int k = 0; k < AROUND; k++) {
            double radius = sin(RADIUS_RAD) * sqrt((ring + 0.5) / RINGS);
            double angle = 2.0 * PP_PI * (k + 0.5) / AROUND;
            struct pp_vec3 to = pp_vec_along(picture->sun, radius * cos(angle), a);
            to = pp_vec_unit(pp_vec_along(to, radius * sin(angle), b));
            add_light(picture, to, picture->sun_lx / (RINGS * AROUND));
        }
    picture->horizontal_lx += picture->sun_lx * picture->sun.z;
    return PP_OK;
}
