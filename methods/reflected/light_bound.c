/* light_bound.c - equations (1) and (2) of light_bound.h, as conservative bounds. */
#include "methods/reflected/light_bound.h"

#include <math.h>

#include "methods/reflected/interior.h"
#include "methods/refusals.h"

/* Ground reflectance built into `bre` and its variants, used in place of the room's
 * ground reflectance. */
static const double built_in_ground = 0.1;

/* `bre` uses 0.85 for the diffuse transmittance of clear single glass, whose true value
 * is 0.827. */
static const double printed_over_own = 0.85 / 0.827;

/* Allowance for reading errors of methods with scales. */
static const double reading = 1.1;

static double entering(const struct pp_outside_light *light,
                       const struct pp_opening *opening)
{
    const struct pp_glass *glass = &opening->glass;
    double tau = fmin(fmax(glass->normal, printed_over_own * glass->diffuse), 1.0);
    double area_m2 = fmax(opening->inner.area_m2, opening->outer.area_m2);
    double ground = fmax(light->ground_reflectance, built_in_ground);
    struct pp_vec3 outward = pp_vec_scale(opening->inner.normal, -1.0);
    double outside = pp_outside_light_sky_on_plane(light, outward)
                     + ground * (1.0 - outward.z) / 2.0;
    return area_m2 * opening->frame_factor * tau * outside;
}

struct pp_light_bound pp_light_bound(const struct pp_world *world,
                                     const struct pp_outside_light *light)
{
    struct pp_light_bound bound = {INFINITY, INFINITY};
    struct pp_interior inside = pp_interior_all(world);
    double plane_m2 = pp_region_area(&world->plane), flux = 0.0;
    if (!(plane_m2 > 0.0) || !(inside.reflectance < 1.0)
        || pp_refusals_if_luminous(world))
        return bound;
    for (int i = 0; i < world->opening_count; i++)
        flux += entering(light, &world->openings[i]);
    bound.direct = reading * flux / plane_m2;
    bound.any = bound.direct / (1.0 - inside.reflectance);
    return bound;
}
