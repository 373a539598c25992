/* hidden_cones.c - makes a cone for each convex piece that reaches above the eye's
 * level and in front of the plane of the view. */
#include "methods/exact/hidden_cones.h"

#include <math.h>
#include <stdlib.h>

#include "methods/exact/exterior.h"
#include "methods/view/occluders.h"
#include "model/base/array.h"

void pp_hidden_cones_clear(struct pp_hidden_cones *cones)
{
    free(cones->half_spaces);
    free(cones->list);
    *cones = (struct pp_hidden_cones){0};
}

static enum pp_status add_half_space(struct pp_hidden_cones *cones, struct pp_vec3 n,
                                     struct pp_error *err)
{
    enum pp_status status =
        pp_array_reserve(&cones->half_spaces, &cones->half_space_capacity,
                         cones->half_space_count + 1, sizeof n, err);
    if (status == PP_OK)
        cones->half_spaces[cones->half_space_count++] = n;
    return status;
}

/* Completes a cone, without a cap, from the half-spaces added since the last cone. */
static enum pp_status end_cone(struct pp_hidden_cones *cones, struct pp_error *err)
{
    enum pp_status status = pp_array_reserve(
        &cones->list, &cones->capacity, cones->count + 1, sizeof *cones->list, err);
    if (status == PP_OK)
        cones->list[cones->count++] =
            (struct pp_hidden_cone){.end = cones->half_space_count};
    return status;
}

/* Corner i of a convex piece. of: indices of the piece's vertices (NULL: all, in
 * order). */
static struct pp_vec3 corner(const struct pp_polygon *polygon, const int *of, int i)
{
    return polygon->vertices[of ? of[i] : i];
}

/* Sets the cap of the last cone, about the mean of the corners' directions, if it is
 * not too wide. */
static void add_cap(struct pp_hidden_cones *cones, struct pp_vec3 eye,
                    const struct pp_polygon *polygon, const int *of, int count)
{
    /* Allowance for the rounding error of a direction. */
    const double hair = 1e-9;
    struct pp_vec3 sum = {0};
    for (int i = 0; i < count; i++)
        sum = pp_vec_add(sum, pp_vec_unit(pp_vec_sub(corner(polygon, of, i), eye)));
    /* A sum that is too short or NaN means that the eye is at a corner. */
    if (!(pp_vec_length(sum) > 0.5))
        return;
    struct pp_vec3 axis = pp_vec_unit(sum);
    double least = 1.0;
    for (int i = 0; i < count; i++) {
        struct pp_vec3 to = pp_vec_unit(pp_vec_sub(corner(polygon, of, i), eye));
        least = fmin(least, pp_vec_dot(axis, to));
    }
    if (!(least - hair > PP_HIDDEN_CONE_COS_WIDEST))
        return;
    struct pp_hidden_cone *cone = &cones->list[cones->count - 1];
    cone->axis = axis;
    cone->cos_radius = least - hair;
    cone->sin_radius = sqrt(1.0 - cone->cos_radius * cone->cos_radius);
}

/* Adds a convex piece. */
static enum pp_status add_convex(struct pp_hidden_cones *cones, struct pp_vec3 eye,
                                 const struct pp_polygon *polygon, const int *of,
                                 int count, struct pp_error *err)
{
    /* From the side of the polygon's normal, the corners run counter-clockwise. The
     * normals of the planes through the eye and the edges then point out of the cone,
     * and are reversed. */
    double facing = pp_vec_dot(polygon->normal, pp_vec_sub(eye, polygon->vertices[0]));
    double side = facing > 0.0 ? -1.0 : 1.0;
    enum pp_status status = PP_OK;
    for (int i = 0; i < count && status == PP_OK; i++) {
        int next = (i + 1) % count;
        struct pp_vec3 a = corner(polygon, of, i), b = corner(polygon, of, next);
        struct pp_vec3 n = pp_vec_cross(pp_vec_sub(a, eye), pp_vec_sub(b, eye));
        status = add_half_space(cones, pp_vec_scale(n, side), err);
    }
    if (status == PP_OK)
        status = end_cone(cones, err);
    if (status == PP_OK)
        add_cap(cones, eye, polygon, of, count);
    return status;
}

/* True if the polygon reaches in front of the view's plane and above the eye, and is
 * not seen edge-on. */
static bool may_hide(const struct pp_polygon *polygon,
                     const struct pp_hidden_view *view)
{
    const double hair = PP_OCCLUDERS_COPLANAR_M;
    bool before = false, above = false;
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 off = pp_vec_sub(polygon->vertices[i], view->eye);
        before |= pp_vec_dot(off, view->out) > hair;
        above |= off.z > hair;
    }
    double height =
        pp_vec_dot(polygon->normal, pp_vec_sub(view->eye, polygon->vertices[0]));
    return before && above && fabs(height) > hair;
}

static enum pp_status add_hidden_surface(struct pp_hidden_cones *cones,
                                         const struct pp_surface *surface,
                                         const struct pp_hidden_view *view,
                                         struct pp_error *err)
{
    const struct pp_polygon *polygon = &surface->outline;
    if (!may_hide(polygon, view))
        return PP_OK;
    if (!surface->triangles)
        return add_convex(cones, view->eye, polygon, NULL, polygon->count, err);
    enum pp_status status = PP_OK;
    for (int t = 0; t < surface->triangle_count && status == PP_OK; t++)
        status = add_convex(cones, view->eye, polygon, surface->triangles[t], 3, err);
    return status;
}

static enum pp_status add_skyline(struct pp_hidden_cones *cones,
                                  const struct pp_world *world,
                                  const struct pp_skyline *skyline,
                                  struct pp_error *err)
{
    struct pp_band band = pp_occluders_band(world, skyline);
    enum pp_status status = add_half_space(cones, pp_vec_scale(band.above, -1.0), err);
    if (status == PP_OK)
        status = add_half_space(cones, pp_vec_scale(band.below, -1.0), err);
    return status == PP_OK ? end_cone(cones, err) : status;
}

struct pp_hidden_view pp_hidden_cones_outside(const struct pp_opening *opening)
{
    return (struct pp_hidden_view){
        .eye = pp_exterior_opening_centroid(opening),
        .out = pp_vec_scale(opening->inner.normal, -1.0),
        .face = opening->face,
    };
}

enum pp_status pp_hidden_cones_init(struct pp_hidden_cones *cones,
                                    const struct pp_world *world,
                                    const struct pp_hidden_view *view,
                                    struct pp_error *err)
{
    *cones = (struct pp_hidden_cones){0};
    enum pp_status status = add_half_space(cones, pp_vec_scale(view->out, -1.0), err);
    if (status == PP_OK)
        status = end_cone(cones, err);
    for (int i = 0; i < world->surface_count && status == PP_OK; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        bool own = view->opening && surface->role == PP_REVEAL
                   && &world->openings[surface->owner] == view->opening;
        if (i != view->face && surface->role != PP_COVER
            && (surface->role != PP_REVEAL || own))
            status = add_hidden_surface(cones, surface, view, err);
    }
    for (int i = 0; i < world->skyline_count && status == PP_OK; i++)
        if (pp_world_skyline_is_far(&world->skylines[i], view->face))
            status = add_skyline(cones, world, &world->skylines[i], err);
    if (status != PP_OK)
        pp_hidden_cones_clear(cones);
    return status;
}

bool pp_hidden_cones_hide(const struct pp_hidden_cones *cones, struct pp_vec3 u)
{
    int from = 0;
    for (int i = 0; i < cones->count; from = cones->list[i++].end) {
        int k = from;
        while (k < cones->list[i].end && pp_vec_dot(cones->half_spaces[k], u) >= 0.0)
            k++;
        if (k == cones->list[i].end)
            return true;
    }
    return false;
}

enum pp_status pp_hidden_cones_add_half_space(struct pp_hidden_cones *cones,
                                              struct pp_vec3 n, struct pp_error *err)
{
    enum pp_status status = add_half_space(cones, n, err);
    return status == PP_OK ? end_cone(cones, err) : status;
}
