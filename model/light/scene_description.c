/* scene_description.c - see scene_description.h. */
#include "model/light/scene_description.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/polygon.h"

/* Largest distance of a polygon's corner from its plane, divided by the polygon's size;
 * chosen, not measured. */
static const double MOST_UNEVEN = 1e-3;

void pp_scene_description_init(struct pp_scene_description *scene)
{
    *scene = (struct pp_scene_description){.shapes = NULL};
}

void pp_scene_description_clear(struct pp_scene_description *scene)
{
    free(scene->shapes);
    free(scene->vertices);
    free(scene->materials);
    free(scene->patterns);
    for (int i = 0; i < scene->pane_count; i++)
        pp_measured_pane_release(scene->panes[i]);
    free(scene->panes);
    pp_scene_description_init(scene);
}

/* Ensures space for `more` items after count. */
static enum pp_status grow_shape_list(void *list, int count, int *space, int more,
                                      size_t size, struct pp_error *err)
{
    if (more > INT_MAX / 2 - count)
        return pp_fail(err, PP_BAD_INPUT,
                       "the scene has more than %d parts of the same kind",
                       INT_MAX / 2);
    return pp_array_reserve(list, space, count + more, size, err);
}

#define GROW(scene, list, what, more, err)                                             \
    grow_shape_list(&(scene)->list, (scene)->what##_count, &(scene)->what##_space,     \
                    more, sizeof *(scene)->list, err)

enum pp_status pp_scene_description_add_material(struct pp_scene_description *scene,
                                                 const struct pp_material *material,
                                                 int *index, struct pp_error *err)
{
    enum pp_status status = pp_material_check(material, err);
    if (status == PP_OK)
        status = GROW(scene, materials, material, 1, err);
    if (status != PP_OK)
        return status;
    if (index)
        *index = scene->material_count;
    scene->materials[scene->material_count++] = *material;
    return PP_OK;
}

enum pp_status pp_scene_description_add_pattern(struct pp_scene_description *scene,
                                                const struct pp_pattern *pattern,
                                                int *index, struct pp_error *err)
{
    enum pp_status status = GROW(scene, patterns, pattern, 1, err);
    if (status != PP_OK)
        return status;
    if (index)
        *index = scene->pattern_count;
    scene->patterns[scene->pattern_count++] = *pattern;
    return PP_OK;
}

/* ---- shapes ---- */

static bool is_finite(struct pp_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

static bool same_point(struct pp_vec3 a, struct pp_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static enum pp_status append_shape(struct pp_scene_description *scene,
                                   const struct pp_shape *shape, int *index,
                                   struct pp_error *err)
{
    enum pp_status status = GROW(scene, shapes, shape, 1, err);
    if (status != PP_OK)
        return status;
    if (shape->material < 0 || shape->material >= scene->material_count
        || shape->back_material >= scene->material_count)
        return pp_fail(err, PP_BAD_INPUT, "a shape has a material that does not exist");
    if (index)
        *index = scene->shape_count;
    scene->shapes[scene->shape_count++] = *shape;
    return PP_OK;
}

/* Appends the corners without repeated ones to the scene's vertices; returns their
 * number. */
static int copy_corners(struct pp_scene_description *scene,
                        const struct pp_vec3 *corners, int count)
{
    struct pp_vec3 *to = &scene->vertices[scene->vertex_count];
    int kept = 0;
    for (int i = 0; i < count; i++)
        if (kept == 0 || !same_point(to[kept - 1], corners[i]))
            to[kept++] = corners[i];
    while (kept > 1 && same_point(to[kept - 1], to[0]))
        kept--;
    return kept;
}

static enum pp_status check_plane(const struct pp_vec3 *corners, int count,
                                  struct pp_error *err)
{
    struct pp_vec3 area = pp_polygon_area_vector(corners, count);
    double twice = 2.0 * pp_vec_length(area), size = 0.0, uneven = 0.0;
    for (int i = 1; i < count; i++)
        size = fmax(size, pp_vec_length(pp_vec_sub(corners[i], corners[0])));
    if (count < 3 || !(twice > 1e-12 * size * size))
        return pp_fail(err, PP_BAD_INPUT, "a polygon has no area");
    struct pp_vec3 n = pp_vec_unit(area);
    for (int i = 1; i < count; i++)
        uneven = fmax(uneven, fabs(pp_vec_dot(n, pp_vec_sub(corners[i], corners[0]))));
    if (uneven > MOST_UNEVEN * size)
        return pp_fail(err, PP_BAD_INPUT,
                       "a polygon is not planar, because a corner is %g m off the "
                       "plane",
                       uneven);
    return PP_OK;
}

enum pp_status pp_scene_description_add_pane(struct pp_scene_description *scene,
                                             struct pp_measured_pane *pane,
                                             struct pp_error *err)
{
    enum pp_status status = GROW(scene, panes, pane, 1, err);
    if (status == PP_OK)
        scene->panes[scene->pane_count++] = pane;
    else
        pp_measured_pane_release(pane);
    return status;
}

enum pp_status pp_scene_description_add_polygon(struct pp_scene_description *scene,
                                                const struct pp_vec3 *corners,
                                                int count, int material, int *index,
                                                struct pp_error *err)
{
    for (int i = 0; i < count; i++)
        if (!is_finite(corners[i]))
            return pp_fail(err, PP_BAD_INPUT,
                           "a coordinate of a polygon corner is not a number");
    enum pp_status status = GROW(scene, vertices, vertex, count, err);
    if (status != PP_OK)
        return status;
    int kept = copy_corners(scene, corners, count);
    status = check_plane(&scene->vertices[scene->vertex_count], kept, err);
    struct pp_shape shape = {.kind = PP_SHAPE_POLYGON,
                             .material = material,
                             .back_material = -1,
                             .is.polygon = {scene->vertex_count, kept}};
    if (status == PP_OK)
        status = append_shape(scene, &shape, index, err);
    if (status == PP_OK)
        scene->vertex_count += kept;
    return status;
}

static enum pp_status make_unit(struct pp_vec3 *v, const char *what,
                                struct pp_error *err)
{
    double length = pp_vec_length(*v);
    if (!(length > 0.0) || !isfinite(length))
        return pp_fail(err, PP_BAD_INPUT, "%s has no direction", what);
    *v = pp_vec_scale(*v, 1.0 / length);
    return PP_OK;
}

static enum pp_status check_cone(const struct pp_shape *shape, struct pp_error *err)
{
    const struct pp_vec3 *ends = shape->is.cone.ends;
    const double *radii = shape->is.cone.radii_m;
    if (!is_finite(ends[0]) || !is_finite(ends[1]) || same_point(ends[0], ends[1]))
        return pp_fail(err, PP_BAD_INPUT, "a cone or cylinder has no length");
    if (!(radii[0] >= 0.0) || !(radii[1] >= 0.0) || !(radii[0] + radii[1] > 0.0)
        || isinf(radii[0] + radii[1]))
        return pp_fail(err, PP_BAD_INPUT, "a cone has the invalid radii %g and %g",
                       radii[0], radii[1]);
    return PP_OK;
}

static enum pp_status check_shape(struct pp_shape *shape, struct pp_error *err)
{
    enum pp_status status;
    switch (shape->kind) {
    case PP_SHAPE_SPHERE:
        if (!is_finite(shape->is.sphere.centre) || !(shape->is.sphere.radius_m > 0.0)
            || isinf(shape->is.sphere.radius_m))
            return pp_fail(err, PP_BAD_INPUT, "a sphere has the invalid radius %g",
                           shape->is.sphere.radius_m);
        return PP_OK;
    case PP_SHAPE_CONE:
        return check_cone(shape, err);
    case PP_SHAPE_RING:
        status = make_unit(&shape->is.ring.axis, "a ring", err);
        if (status == PP_OK
            && (!is_finite(shape->is.ring.centre) || !(shape->is.ring.radii_m[0] >= 0.0)
                || !(shape->is.ring.radii_m[1] > shape->is.ring.radii_m[0])
                || isinf(shape->is.ring.radii_m[1])))
            return pp_fail(err, PP_BAD_INPUT, "a ring has the invalid radii %g and %g",
                           shape->is.ring.radii_m[0], shape->is.ring.radii_m[1]);
        return status;
    case PP_SHAPE_DISTANT:
        if (!(shape->is.distant.half_angle_rad > 0.0)
            || !(shape->is.distant.half_angle_rad <= PP_PI))
            return pp_fail(err, PP_BAD_INPUT,
                           "a distant source has the invalid angle of %g degrees",
                           2.0 * shape->is.distant.half_angle_rad / PP_RAD);
        return make_unit(&shape->is.distant.direction, "a distant source", err);
    default:
        return pp_fail(err, PP_BAD_INPUT, "a polygon has no corners");
    }
}

enum pp_status pp_scene_description_add_shape(struct pp_scene_description *scene,
                                              const struct pp_shape *shape, int *index,
                                              struct pp_error *err)
{
    struct pp_shape copy = *shape;
    enum pp_status status = check_shape(&copy, err);
    return status == PP_OK ? append_shape(scene, &copy, index, err) : status;
}

/* ---- patterns ---- */

/* Skies of skybright.cal [WS98], and Perez's of perezlum.cal [PSM93], with their
 * symbols: gamma is the angle from the sun; zt and eta are the zenith angles of the sun
 * and of the direction.
 *
 *     clear         Lz (0.91 + 10 exp(-3 gamma) + 0.45 cos^2 gamma)
 *                      (1 - exp(-0.32 / cos eta)) / norm
 *     overcast      Lz (1 + 2 cos eta) / 3
 *     intermediate  Lz ((1.35 sin(5.631 - 3.59 eta) + 3.12) sin(4.396 - 2.6 zt)
 *                       + 6.37 - eta) / 2.326
 *                      exp(-0.563 gamma ((2.629 - eta) (1.562 - zt) + 0.812)) / norm
 *     Perez         Lz (1 + a exp(b / cos eta)) (1 + c exp(d gamma) + e cos^2 gamma)
 *
 * Lz of Perez's skies is a factor, not the luminance of the zenith. Their cos eta is at
 * least 0.01.
 */
static double gensky_sky(const struct pp_pattern *pattern, struct pp_vec3 u)
{
    double cosgamma = fmax(-1.0, fmin(1.0, pp_vec_dot(u, pattern->sun)));
    double gamma = acos(cosgamma);
    double zt = acos(fmax(-1.0, fmin(1.0, pattern->sun.z)));
    double eta = acos(fmax(-1.0, fmin(1.0, u.z)));
    const double *n = pattern->perez;
    switch (pattern->type) {
    case PP_GENSKY_CLEAR:
        return pattern->zenith
               * (0.91 + 10.0 * exp(-3.0 * gamma) + 0.45 * cosgamma * cosgamma)
               * (u.z > 0.01 ? 1.0 - exp(-0.32 / u.z) : 1.0) / pattern->norm;
    case PP_GENSKY_OVERCAST:
        return pattern->zenith * (1.0 + 2.0 * u.z) / 3.0;
    case PP_GENSKY_INTERMEDIATE:
        return pattern->zenith
               * ((1.35 * sin(5.631 - 3.59 * eta) + 3.12) * sin(4.396 - 2.6 * zt) + 6.37
                  - eta)
               / 2.326 * exp(gamma * -0.563 * ((2.629 - eta) * (1.562 - zt) + 0.812))
               / pattern->norm;
    case PP_GENSKY_PEREZ:
        return pattern->zenith * (1.0 + n[0] * exp(n[1] / fmax(u.z, 0.01)))
               * (1.0 + n[2] * exp(n[3] * gamma) + n[4] * cosgamma * cosgamma);
    default:
        return pattern->zenith;
    }
}

double pp_scene_description_pattern_value(const struct pp_pattern *pattern,
                                          struct pp_vec3 u)
{
    if (pattern->kind == PP_PATTERN_SKY) {
        for (int i = 0; i < pattern->skyline_count && u.z > 0.0; i++)
            if (u.z < pattern->skylines[i].slope
                          * pp_vec_dot(u, pattern->skylines[i].outward))
                return pattern->skylines[i].radiance;
        return pattern->factor * pp_sky_luminance(&pattern->sky, u);
    }
    /* Mean of sky and ground weighted by tenth powers; the ground's weight is 0.45 at
     * the horizon, 0.1 at 6 degrees, 3e-4 at 30. */
    double above = pow(u.z + 1.01, 10.0), below = 1.0 / above;
    double value =
        (above * gensky_sky(pattern, u) + below * pattern->ground) / (above + below);
    return value > 0.0 ? value : 0.0;
}
