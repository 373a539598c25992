/* point_factor.c - sums over the region's triangles by closed form. */
#include "methods/reflected/point_factor.h"

#include <math.h>

#include "methods/exact/solid_angle.h"

/* The part of a region that is visible from a point, within half-spaces. */
struct view {
    struct pp_vec3 from, facing;
    bool turned; /* true: directions are reversed, so that they are the directions from
                  * which skylight through `from` reaches the region */
    int space_count;
    struct pp_vec3 spaces[PP_HALF_SPACES_MOST];
};

static struct pp_vec3 seen(const struct view *view, struct pp_vec3 place)
{
    struct pp_vec3 to = pp_vec_sub(place, view->from);
    return view->turned ? pp_vec_scale(to, -1.0) : to;
}

static struct view view_of(struct pp_vec3 from, struct pp_vec3 normal, bool turned)
{
    struct view view = {
        .from = from, .facing = normal, .turned = turned, .space_count = 1};
    if (turned)
        view.facing = pp_vec_scale(normal, -1.0);
    view.spaces[0] = view.facing;
    return view;
}

static struct pp_moments moments_of(const struct view *view,
                                    const struct pp_region *region, double z)
{
    struct pp_moments sum = {0};
    for (int r = 0; r < region->count; r++) {
        const struct pp_ring *ring = &region->rings[r];
        for (int i = 1; i + 1 < ring->count; i++) {
            const int corners[3] = {0, i, i + 1};
            struct pp_vec3 v[3];
            for (int k = 0; k < 3; k++) {
                const double *xy = ring->xy[corners[k]];
                v[k] = seen(view, pp_vec(xy[0], xy[1], z));
            }
            pp_solid_angle_add_moments(&sum, v, 3, view->facing, view->spaces,
                                       view->space_count);
        }
    }
    return sum;
}

/* The moments may be negative, since rings are counter-clockwise seen from above and
 * `from` may be above; hence fabs. */
double pp_point_factor(struct pp_vec3 from, struct pp_vec3 normal,
                       const struct pp_region *region, double z)
{
    const struct view view = view_of(from, normal, false);
    return fmin(fabs(moments_of(&view, region, z).cosine) / PP_PI, 1.0);
}

double pp_point_factor_sky(struct pp_vec3 from, struct pp_vec3 normal,
                           const struct pp_region *region, double z,
                           const struct pp_sky *sky)
{
    const struct view view = view_of(from, normal, true);
    struct pp_moments sum = moments_of(&view, region, z);
    return fabs(pp_solid_angle_sky_component(&sum, sky));
}

double pp_point_factor_through(struct pp_vec3 from, const struct pp_polygon *foot,
                               const struct pp_region *region, double z,
                               const struct pp_sky *sky)
{
    struct view view = view_of(from, foot->normal, true);
    struct pp_vec3 middle = seen(&view, pp_polygon_middle(foot));
    struct pp_moments whole = {0};
    for (int i = 0; i < foot->count && view.space_count < PP_HALF_SPACES_MOST; i++) {
        struct pp_vec3 v[3] = {middle, seen(&view, foot->vertices[i]),
                               seen(&view, foot->vertices[(i + 1) % foot->count])};
        struct pp_vec3 inward = pp_vec_cross(v[1], v[2]);
        double side = pp_vec_dot(inward, middle);
        view.spaces[view.space_count++] = pp_vec_scale(inward, side < 0.0 ? -1.0 : 1.0);
        pp_solid_angle_add_moments(&whole, v, 3, view.facing, &view.facing, 1);
    }
    struct pp_moments part = moments_of(&view, region, z);
    double of_foot = fabs(pp_solid_angle_sky_component(&whole, sky));
    return fmin(fabs(pp_solid_angle_sky_component(&part, sky)) / of_foot, 1.0);
}
