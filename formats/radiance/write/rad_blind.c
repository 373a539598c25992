/* rad_blind.c - see rad_blind.h. */
#include "formats/radiance/write/rad_blind.h"

#include <math.h>
#include <stdio.h>

#include "model/geometry/tolerance.h"

enum { CURVED_PARTS = 6 };

static const double GAP_M = 0.001;

/* Axes of a blind: inwards, along the sequence of slats, and along a slat. */
struct blind_axes {
    struct pp_vec3 corner; /* corner of the glass where `sequence` and `length`
                            * begin */
    struct pp_vec3 inwards, sequence, length;
    double sequence_m, length_m;
    double centre_m; /* distance of the slats' middle from the glass, inwards */
};

static struct blind_axes blind_axes_of(const struct pp_opening *opening)
{
    const struct pp_window_device *device = &opening->device;
    struct blind_axes axes = {
        .inwards = opening->inner.normal,
        .sequence = device->vertical ? opening->along : opening->up,
        .length = device->vertical ? opening->up : opening->along,
        .sequence_m = device->vertical ? opening->width_m : opening->height_m,
        .length_m = device->vertical ? opening->height_m : opening->width_m};
    double low = INFINITY, deepest = 0.0;
    for (int i = 0; i < opening->outer.count; i++) {
        struct pp_vec3 v = opening->outer.vertices[i];
        double at = pp_vec_dot(v, axes.sequence) + pp_vec_dot(v, axes.length);
        if (at < low) {
            low = at;
            axes.corner = v;
        }
    }
    for (int i = 0; i <= CURVED_PARTS; i++) {
        double a, b;
        pp_slats_point(&device->slats, (double)i / CURVED_PARTS, &a, &b);
        deepest = fmax(deepest, fabs(a));
    }
    axes.centre_m = deepest + GAP_M;
    if (device->position == PP_DEVICE_OUTSIDE)
        axes.centre_m = -axes.centre_m;
    return axes;
}

/* Adds the part of a slat between two fractions of its arc; its front is its upper
 * side. */
static enum pp_status add_slat_part(struct pp_scene_description *scene,
                                    const struct blind_axes *axes,
                                    const struct pp_slats *slats, double middle_m,
                                    const double fractions[2], const int materials[2],
                                    struct pp_error *err)
{
    struct pp_vec3 corners[4];
    for (int i = 0; i < 2; i++) {
        double a, b;
        pp_slats_point(slats, fractions[i], &a, &b);
        struct pp_vec3 end =
            pp_vec_along(axes->corner, axes->centre_m + a, axes->inwards);
        end = pp_vec_along(end, middle_m + b, axes->sequence);
        struct pp_vec3 other = pp_vec_along(end, axes->length_m, axes->length);
        corners[i == 0 ? 0 : 3] = end;
        corners[i == 0 ? 1 : 2] = other;
    }
    struct pp_vec3 normal = pp_vec_cross(pp_vec_sub(corners[1], corners[0]),
                                         pp_vec_sub(corners[3], corners[0]));
    struct pp_vec3 upper =
        pp_vec_along(pp_vec_scale(axes->inwards, sin(slats->tilt_rad)),
                     cos(slats->tilt_rad), axes->sequence);
    if (pp_vec_dot(normal, upper) < 0.0) {
        struct pp_vec3 swapped = corners[1];
        corners[1] = corners[3];
        corners[3] = swapped;
    }
    int index;
    enum pp_status status =
        pp_scene_description_add_polygon(scene, corners, 4, materials[0], &index, err);
    if (status == PP_OK)
        scene->shapes[index].back_material = materials[1];
    return status;
}

/* Adds the materials of both sides; materials[1] is -1 if they are equal. */
static enum pp_status add_slat_materials(struct pp_scene_description *scene,
                                         const struct pp_opening *opening,
                                         int materials[2], struct pp_error *err)
{
    const struct pp_slats *slats = &opening->device.slats;
    enum pp_status status = PP_OK;
    materials[1] = -1;
    for (int i = 0; i < (slats->upper == slats->lower ? 1 : 2) && status == PP_OK;
         i++) {
        struct pp_material side =
            pp_material_diffuse(pp_rgb_grey(i == 0 ? slats->upper : slats->lower));
        snprintf(side.name, sizeof side.name, "slats of %s%s", opening->label,
                 i == 0 ? "" : ", below");
        status = pp_scene_description_add_material(scene, &side, &materials[i], err);
    }
    return status;
}

enum pp_status pp_rad_blind_add(struct pp_scene_description *scene,
                                const struct pp_opening *opening, struct pp_error *err)
{
    const struct pp_slats *slats = &opening->device.slats;
    if (opening->device.position == PP_DEVICE_BETWEEN || !opening->rectangle)
        return pp_fail(err, PP_BAD_INPUT,
                       opening->rectangle
                           ? "line %d: a blind between panes cannot be written, since "
                             "the panes are one surface; expected one inside or outside"
                           : "line %d: the blind of an opening that is not rectangular "
                             "cannot be written; expected a rectangle",
                       opening->device.line);
    struct blind_axes axes = blind_axes_of(opening);
    int materials[2], parts = slats->rise == 0.0 ? 1 : CURVED_PARTS;
    int count = (int)fmax(1.0, round(axes.sequence_m / slats->spacing));
    enum pp_status status = add_slat_materials(scene, opening, materials, err);
    for (int i = 0; i < count; i++) {
        double middle =
            0.5 * axes.sequence_m + (i - 0.5 * (count - 1)) * slats->spacing;
        for (int k = 0; k < parts && status == PP_OK; k++) {
            double fractions[2] = {(double)k / parts, (k + 1.0) / parts};
            status =
                add_slat_part(scene, &axes, slats, middle, fractions, materials, err);
        }
    }
    return status;
}
