/* exterior.c - a hemicube of views about a point outside, summed by direct.h, or the
 * open sky in closed form if no surface is in front of the plane. */
#include "methods/exact/exterior.h"

#include <stdlib.h>

#include "methods/exact/solid_angle.h"
#include "methods/view/occluders.h"
#include "methods/view/visible.h"
#include "model/geometry/frame.h"

/* True if any surface, other than the plane's own face and reveals, reaches in front of
 * the plane. */
static bool has_surface_in_front(const struct pp_world *world, struct pp_vec3 position,
                                 struct pp_vec3 normal, int face)
{
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        if (i == face || surface->role == PP_REVEAL || surface->role == PP_COVER)
            continue;
        for (int k = 0; k < surface->outline.count; k++)
            if (pp_vec_dot(pp_vec_sub(surface->outline.vertices[k], position), normal)
                > PP_OCCLUDERS_COPLANAR_M)
                return true;
    }
    return false;
}

bool pp_exterior_is_uniform(const struct pp_world *world,
                            const struct pp_opening *opening)
{
    return !has_surface_in_front(world, opening->outer.vertices[0],
                                 pp_vec_scale(opening->inner.normal, -1.0),
                                 opening->face);
}

/* A frame with z along n. */
static struct pp_frame frame_about(struct pp_vec3 n)
{
    struct pp_vec3 level = {-n.y, n.x, 0.0};
    struct pp_vec3 a =
        hypot(n.x, n.y) > 1e-6 ? pp_vec_unit(level) : pp_vec(1.0, 0.0, 0.0);
    struct pp_vec3 b = pp_vec_unit(pp_vec_cross(n, a));
    return (struct pp_frame){pp_vec_cross(b, n), b, n};
}

enum pp_status pp_exterior_light_within(struct pp_exterior_light *outside,
                                        const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        struct pp_vec3 position, struct pp_vec3 normal,
                                        int face, const struct pp_direct *how,
                                        struct pp_error *err)
{
    bool hidden = has_surface_in_front(world, position, normal, face);
    for (int i = 0; i < world->skyline_count; i++)
        hidden = hidden || pp_world_skyline_is_far(&world->skylines[i], face);
    if (!hidden) {
        *outside = (struct pp_exterior_light){
            pp_outside_light_sky_on_plane(light, normal),
            light->ground_reflectance * (1.0 - normal.z) / 2.0};
        return PP_OK;
    }

    /* Hemicube about the position: one face in front and half of each of the four faces
     * beside it. */
    struct pp_frame frame = frame_about(normal);
    struct pp_vec3 a = frame.x, b = frame.y;
    struct pp_vec3 toward[5] = {normal, a, pp_vec_scale(a, -1.0), b,
                                pp_vec_scale(b, -1.0)};
    struct pp_direct sum = {.unglazed_error = how->unglazed_error,
                            .tables = how->tables};
    struct pp_glass none = pp_glass_none();
    for (int i = 0; i < 5; i++) {
        struct pp_vec3 up = i == 0 ? b : normal;
        struct pp_projection view = {position, pp_vec_cross(toward[i], up), up,
                                     toward[i], 1.0};
        double low[2] = {-1.0, i == 0 ? -1.0 : 0.0}, high[2] = {1.0, 1.0};
        struct pp_visible visible;
        enum pp_status status =
            pp_visible_in_air(&visible, world, &view, low, high, face, err);
        if (status != PP_OK)
            return status;
        status = pp_direct_add(&sum, &visible, normal, &none, light, err);
        pp_visible_clear(&visible);
        if (status != PP_OK)
            return status;
    }
    *outside = (struct pp_exterior_light){sum.sky, sum.external};
    return PP_OK;
}

enum pp_status pp_exterior_light_on_plane(struct pp_exterior_light *outside,
                                          const struct pp_world *world,
                                          const struct pp_outside_light *light,
                                          struct pp_vec3 position,
                                          struct pp_vec3 normal, int face,
                                          struct pp_error *err)
{
    const struct pp_direct how = {.unglazed_error = PP_QUADRATURE_UNGLAZED};
    return pp_exterior_light_within(outside, world, light, position, normal, face, &how,
                                    err);
}

struct pp_vec3 pp_exterior_opening_centroid(const struct pp_opening *opening)
{
    const struct pp_polygon *outline = &opening->outer;
    const struct pp_vec3 *v = outline->vertices;
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    double area = 0.0;
    for (int i = 2; i < outline->count; i++) {
        double part =
            pp_vec_dot(pp_vec_cross(pp_vec_sub(v[i - 1], v[0]), pp_vec_sub(v[i], v[0])),
                       outline->normal);
        struct pp_vec3 middle =
            pp_vec_add(pp_vec_sub(v[i - 1], v[0]), pp_vec_sub(v[i], v[0]));
        sum = pp_vec_along(sum, part / 3.0, middle);
        area += part;
    }
    struct pp_vec3 middle = pp_vec_along(v[0], 1.0 / area, sum);
    return pp_vec_along(middle, -opening->recess_m, outline->normal);
}

enum pp_status pp_exterior_sky_on_plane(double *share, const struct pp_world *world,
                                        const struct pp_opening *opening,
                                        struct pp_vec3 normal, const struct pp_sky *sky,
                                        struct pp_error *err)
{
    const struct pp_outside_light light = {.sky = *sky}; /* no ground */
    struct pp_exterior_light outside;
    enum pp_status status = pp_exterior_light_on_plane(
        &outside, world, &light, pp_exterior_opening_centroid(opening), normal,
        opening->face, err);
    if (status == PP_OK)
        *share = outside.sky;
    return status;
}

enum pp_status pp_exterior_sky_solid_angle(double *solid_angle,
                                           const struct pp_world *world,
                                           struct pp_vec3 eye, struct pp_error *err)
{
    const struct pp_vec3 zenith = {0.0, 0.0, 1.0};
    *solid_angle = 0.0;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if (opening->glass.diffusing)
            continue;
        struct pp_visible visible;
        enum pp_status status = pp_visible_sky(&visible, world, opening, eye, err);
        if (status != PP_OK)
            return status;
        for (int k = 0; k < visible.patch_count && status == PP_OK; k++) {
            struct pp_moments moments;
            if (visible.patches[k].hidden)
                continue;
            status = pp_direct_moments(&moments, &visible, &visible.patches[k], zenith,
                                       &zenith, 1, err);
            *solid_angle += moments.omega;
        }
        pp_visible_clear(&visible);
        if (status != PP_OK)
            return status;
    }
    return PP_OK;
}
