/* photon_counter.c - see photon_counter.h. */
#include "simulate/research/photons/photon_counter.h"

struct pp_photon_counter pp_photon_counter_disc(struct pp_vec3 point,
                                                struct pp_vec3 normal, double radius_m)
{
    return (struct pp_photon_counter){.point = point,
                                      .normal = normal,
                                      .area_m2 = PP_PI * radius_m * radius_m,
                                      .radius_m = radius_m};
}

struct pp_photon_counter pp_photon_counter_plane(const struct pp_light_scene *scene)
{
    return (struct pp_photon_counter){.point = scene->plane[0][0],
                                      .normal = {0.0, 0.0, 1.0},
                                      .area_m2 = scene->plane_area_m2,
                                      .triangles =
                                          (const struct pp_vec3(*)[3])scene->plane,
                                      .triangle_count = scene->plane_count};
}

/* Twice the signed area of the triangle of p and the edge from a to b, seen against the
 * normal. */
static double turned(struct pp_vec3 a, struct pp_vec3 b, struct pp_vec3 p,
                     struct pp_vec3 normal)
{
    return pp_vec_dot(normal, pp_vec_cross(pp_vec_sub(b, a), pp_vec_sub(p, a)));
}

static bool in_triangle(const struct pp_vec3 corners[3], struct pp_vec3 p,
                        struct pp_vec3 normal)
{
    double a = turned(corners[0], corners[1], p, normal);
    double b = turned(corners[1], corners[2], p, normal);
    double c = turned(corners[2], corners[0], p, normal);
    return (a >= 0.0 && b >= 0.0 && c >= 0.0) || (a <= 0.0 && b <= 0.0 && c <= 0.0);
}

static bool covers(const struct pp_photon_counter *counter, struct pp_vec3 p)
{
    if (counter->radius_m > 0.0)
        return pp_vec_length(pp_vec_sub(p, counter->point)) <= counter->radius_m;
    for (int i = 0; i < counter->triangle_count; i++)
        if (in_triangle(counter->triangles[i], p, counter->normal))
            return true;
    return false;
}

double pp_photon_counter_takes(const struct pp_photon_counter *counter,
                               const struct pp_photon *photon)
{
    const struct pp_light_ray *ray = &photon->ray;
    double down = -pp_vec_dot(counter->normal, ray->to);
    double over = pp_vec_dot(counter->normal, pp_vec_sub(ray->from, counter->point));
    if (!(down > 0.0) || !(over >= 0.0) || !(over <= photon->hit.distance_m * down)
        || !covers(counter, pp_vec_along(ray->from, over / down, ray->to)))
        return 0.0;
    return pp_rgb_luminance(photon->flux) / counter->area_m2;
}
