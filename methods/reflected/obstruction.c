/* obstruction.c - the obstruction angle alpha of an opening from its skylines or from
 * VSC, and the printed factor C. */
#include "methods/reflected/obstruction.h"

#include "methods/exact/exterior.h"
#include "methods/interpolate.h"
#include "model/light/graded_sky.h"

/* obstruction (degrees), C (per cent) */
static const double printed[][2] = {
#include "tables/bre_obstruction_factors.inc"
};

enum { ROWS = sizeof printed / sizeof printed[0] };

double pp_obstruction_factor(double angle_rad)
{
    return pp_interpolate_linear(printed, ROWS, angle_rad / PP_RAD) / 100.0;
}

/* True if any vertex lies in front of the opening's outside: in front of its plane or,
 * if the opening is set back from a facade, in front of the facade. */
static bool reaches_in_front(const struct pp_polygon *outline,
                             const struct pp_opening *opening)
{
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 from =
            pp_vec_sub(outline->vertices[i], opening->outer.vertices[0]);
        if (pp_vec_dot(from, opening->outer.normal) < -opening->recess_m - 1e-6)
            return true;
    }
    return false;
}

/* True if surfaces other than the skylines of the opening's own wall stand in front of
 * the opening. */
static bool has_surface_in_front(const struct pp_world *world,
                                 const struct pp_opening *opening)
{
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = world->surfaces + i;
        bool out_of_doors = i < world->face_count || !surface->inside;
        bool own_skyline = surface->role == PP_SKYLINE
                           && world->skylines[surface->owner].face == opening->face;
        if (out_of_doors && !own_skyline
            && reaches_in_front(&surface->outline, opening))
            return true;
    }
    return false;
}

static double skyline_angle(const struct pp_world *world,
                            const struct pp_opening *opening)
{
    double angle_rad = 0.0;
    for (int i = 0; i < world->skyline_count; i++) {
        const struct pp_skyline *skyline = world->skylines + i;
        if (skyline->face != opening->face)
            continue;
        angle_rad =
            fmax(angle_rad, pp_world_skyline_angle(skyline, opening->middle_z_m, 0.0));
    }
    return angle_rad;
}

enum pp_status pp_obstruction_angle(double *angle_rad, const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_opening *opening,
                                    struct pp_error *err)
{
    if (!has_surface_in_front(world, opening)) {
        *angle_rad = skyline_angle(world, opening);
        return PP_OK;
    }
    struct pp_sky sky = pp_sky_graded(light->sky.gradation);
    struct pp_vec3 out = pp_vec_scale(opening->inner.normal, -1.0);
    struct pp_vec3 level = pp_vec(out.x, out.y, 0.0);
    bool horizontal = pp_vec_length(level) < 1e-6;
    struct pp_vec3 facing = horizontal ? out : pp_vec_unit(level);

    double share;
    enum pp_status status =
        pp_exterior_sky_on_plane(&share, world, opening, facing, &sky, err);
    if (status != PP_OK)
        return status;
    *angle_rad = horizontal ? PP_PI / 2.0 * fmin(fmax(1.0 - share, 0.0), 1.0)
                            : pp_graded_sky_skyline(sky.gradation, share);
    return PP_OK;
}
