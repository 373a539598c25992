/* glare_view.c - see glare_view.h. */
#include "studies/glare/glare_view.h"

#include <math.h>
#include <stdlib.h>

#include "model/light/slats/blind_scatter.h"
#include "simulate/year/sun_on_surface.h"
#include "studies/glare/dgp.h"

/* Points on indoor surfaces are in the middle of BLOCKS x BLOCKS blocks of rays.
 * Normals whose difference is less than SAME_NORMAL are treated as equal. */
enum { BLOCKS = 8, PLANES_MOST = 64 };
_Static_assert(BLOCKS *BLOCKS == PP_GLARE_SURFACES_MOST, "one point for each block");
static const double SAME_NORMAL = 1e-3;

/* Distance (m) of a simulated point from its surface. */
static const double OFF_M = 1e-3;

static bool is_outdoors(const struct pp_eye_ray *ray)
{
    return ray->end == PP_EYE_FACE || ray->end == PP_EYE_PANE
           || (ray->end == PP_EYE_SURFACE && ray->at.space == PP_OUTDOORS);
}

static bool is_indoor_surface(const struct pp_eye_ray *ray)
{
    return ray->end == PP_EYE_SURFACE && ray->at.space != PP_OUTDOORS;
}

/* ---- the field of view ---- */

static enum pp_status choose_surfaces(struct pp_glare_view *view, struct pp_error *err)
{
    const struct pp_eye_rays *rays = &view->rays;
    int step = rays->side / BLOCKS;
    view->surfaces = calloc(BLOCKS * BLOCKS, sizeof *view->surfaces);
    int *tags = calloc(BLOCKS * BLOCKS, sizeof *tags);
    if (!view->surfaces || !tags) {
        free(tags);
        return pp_fail_memory(err);
    }
    for (int b = 0; b < BLOCKS * BLOCKS; b++) {
        int row = b / BLOCKS * step + step / 2, column = b % BLOCKS * step + step / 2;
        const struct pp_eye_ray *ray = &rays->list[row * rays->side + column];
        if (!is_indoor_surface(ray))
            continue;
        struct pp_vec3 at = pp_vec_add(ray->at.point, rays->centre);
        tags[view->surface_count] = ray->tag;
        view->surfaces[view->surface_count++] =
            (struct pp_receiver){.position = pp_vec_along(at, OFF_M, ray->at.normal),
                                 .normal = ray->at.normal};
    }
    /* Assigns to each ray the nearest point on the same surface, or else the nearest of
     * all points. */
    for (int i = 0; i < rays->count; i++) {
        const struct pp_eye_ray *ray = &rays->list[i];
        double nearest = INFINITY;
        view->surface_of[i] = -1;
        if (!is_indoor_surface(ray))
            continue;
        struct pp_vec3 at = pp_vec_add(ray->at.point, rays->centre);
        for (int k = 0; k < view->surface_count; k++) {
            double d = pp_vec_length(pp_vec_sub(view->surfaces[k].position, at))
                       + (tags[k] == ray->tag ? 0.0 : 1e6);
            if (d < nearest) {
                nearest = d;
                view->surface_of[i] = k;
            }
        }
    }
    free(tags);
    return PP_OK;
}

/* Index of the plane with that normal. If there are too many planes, index of the plane
 * with the most similar normal. */
static int plane_with(struct pp_glare_view *view, struct pp_vec3 normal)
{
    int best = 0;
    double most = -2.0;
    for (int i = 0; i < view->plane_count; i++) {
        double like = pp_vec_dot(view->planes[i], normal);
        if (like > most) {
            most = like;
            best = i;
        }
    }
    if (most >= cos(SAME_NORMAL) || view->plane_count == PLANES_MOST)
        return best;
    view->planes[view->plane_count] = normal;
    return view->plane_count++;
}

/* Finds the planes of outdoor surfaces in front of panes that scatter light, and the
 * size of the work space: luminances of the rays of a pane, and of the rows. */
static void prepare_panes(struct pp_glare_view *view)
{
    int most = 0;
    for (int k = 0; k < view->panes.count; k++) {
        struct pp_glare_pane *pane = &view->panes.list[k];
        most = pane->ray_count > most ? pane->ray_count : most;
        for (int i = 0; i < pane->ray_count; i++)
            if (is_outdoors(&pane->rays[i]))
                pane->plane_of[i] = plane_with(view, pane->rays[i].at.normal);
    }
    view->work_count = view->panes.row_count + most;
}

enum pp_status pp_glare_view_init(struct pp_glare_view *view,
                                  const struct pp_light_scene *scene,
                                  const struct pp_world *world,
                                  const struct pp_outside_light *light,
                                  const struct pp_receiver *eye, int side,
                                  struct pp_error *err)
{
    *view = (struct pp_glare_view){
        .scene = scene, .world = world, .light = light, .eye = *eye};
    enum pp_status status =
        pp_eye_rays_init(&view->rays, scene, eye, side, light->ground_reflectance, err);
    if (status != PP_OK)
        return status;
    size_t count = (size_t)view->rays.count;
    view->indices = calloc(count, sizeof *view->indices);
    view->surface_of = calloc(count, sizeof *view->surface_of);
    view->plane_of = calloc(count, sizeof *view->plane_of);
    view->planes = calloc(PLANES_MOST, sizeof *view->planes);
    if (!view->indices || !view->surface_of || !view->plane_of || !view->planes)
        return pp_fail_memory(err);
    pp_sky_patches_init(&view->patches, 145, 0.0);
    for (size_t i = 0; i < count; i++) {
        const struct pp_eye_ray *ray = &view->rays.list[i];
        view->indices[i] = pp_dgp_position_index(&view->rays.view, ray->u);
        view->plane_of[i] = is_outdoors(ray) ? plane_with(view, ray->at.normal) : -1;
    }
    status = pp_glare_panes_init(&view->panes, scene, world, &view->rays,
                                 light->ground_reflectance, err);
    if (status != PP_OK)
        return status;
    prepare_panes(view);
    return choose_surfaces(view, err);
}

void pp_glare_view_clear(struct pp_glare_view *view)
{
    pp_eye_rays_clear(&view->rays);
    pp_glare_panes_clear(&view->panes);
    free(view->indices);
    free(view->surface_of);
    free(view->plane_of);
    free(view->surfaces);
    free(view->planes);
}

/* ---- one hour ---- */

/* Light outside in one hour. */
struct outdoor_hour {
    const struct pp_glare_view *view;
    const struct pp_perez_sky *sky;
    double open_lx; /* horizontal illuminance from sky and sun */
    double ground_cd_m2;
    double plane_lx[PLANES_MOST]; /* illuminance from sky and ground on each plane */
};

static void light_planes(struct outdoor_hour *hour)
{
    const struct pp_glare_view *view = hour->view;
    for (int k = 0; k < view->plane_count; k++)
        hour->plane_lx[k] =
            PP_PI * hour->ground_cd_m2 * (1.0 - view->planes[k].z) / 2.0;
    for (int i = 0; i < view->patches.count && view->plane_count > 0; i++) {
        struct pp_vec3 u = pp_sky_patches_centre(&view->patches, i);
        double lx = pp_perez_sky_luminance(hour->sky, u)
                    * pp_sky_patches_solid_angle(&view->patches, i);
        for (int k = 0; k < view->plane_count; k++)
            hour->plane_lx[k] += lx * fmax(0.0, pp_vec_dot(view->planes[k], u));
    }
}

static struct outdoor_hour hour_of(const struct pp_glare_view *view,
                                   const struct pp_perez_sky *sky)
{
    struct outdoor_hour hour = {.view = view, .sky = sky, .open_lx = sky->diffuse_lx};
    if (sky->sun.z > 0.0)
        hour.open_lx += sky->direct_lx * sky->sun.z;
    hour.ground_cd_m2 = view->light->ground_reflectance * hour.open_lx / PP_PI;
    light_planes(&hour);
    return hour;
}

static double sun_lx(const struct outdoor_hour *hour, const struct pp_eye_ray *ray)
{
    int opening;
    if (!(hour->sky->direct_lx > 0.0))
        return 0.0;
    if (ray->end == PP_EYE_FACE)
        return hour->sky->sun.z > 0.0
                   ? hour->sky->direct_lx
                         * fmax(0.0, pp_vec_dot(ray->at.normal, hour->sky->sun))
                   : 0.0;
    return hour->sky->direct_lx
           * pp_sun_on_surface(hour->view->scene, &ray->at, hour->sky->sun, &opening);
}

/* Luminance behind the panes of a ray, cd/m2. plane: index of the plane of an outdoor
 * surface, or -1; rest_lx: illuminance of an indoor surface without direct sun. */
static double luminance_behind(const struct outdoor_hour *hour,
                               const struct pp_eye_ray *ray, int plane, double rest_lx)
{
    double lx = rest_lx;
    switch (ray->end) {
    case PP_EYE_NOTHING:
        return 0.0;
    case PP_EYE_SKY:
        return ray->transmittance * pp_perez_sky_luminance(hour->sky, ray->u);
    case PP_EYE_GROUND:
        return ray->transmittance * hour->ground_cd_m2;
    case PP_EYE_FACE:
    case PP_EYE_SURFACE:
    case PP_EYE_PANE:
        lx += sun_lx(hour, ray);
        break;
    }
    if (plane >= 0)
        lx += hour->plane_lx[plane];
    return ray->transmittance * (ray->reflectance * lx + ray->exitance * hour->open_lx)
           / PP_PI;
}

/* Luminances of the rows without direct sun; work: a pane's rays follow the rows. */
static void light_rows(const struct outdoor_hour *hour, double *work)
{
    const struct pp_glare_panes *panes = &hour->view->panes;
    double *outside = work + panes->row_count;
    for (int k = 0; k < panes->count; k++) {
        const struct pp_glare_pane *pane = &panes->list[k];
        for (int i = 0; i < pane->ray_count; i++)
            outside[i] = luminance_behind(hour, &pane->rays[i], pane->plane_of[i], 0.0);
        for (int r = 0; r < panes->row_count; r++)
            if (panes->rows[r].pane == k)
                work[r] = pp_glare_panes_luminance(panes, r, outside);
    }
}

/* Luminance by the light that a pane scatters towards the eye, cd/m2. */
static double scattered_luminance(const struct outdoor_hour *hour, int i,
                                  const double *rows)
{
    const struct pp_glare_view *view = hour->view;
    const struct pp_eye_ray *ray = &view->rays.list[i];
    int row = view->panes.row_of_ray[i], opening;
    if (row < 0)
        return 0.0;
    double L = rows[row];
    if (hour->sky->direct_lx > 0.0)
        L += hour->sky->direct_lx
             * pp_sun_on_surface(view->scene, &ray->pane_at, hour->sky->sun, &opening)
             * pp_sun_on_surface_scattered(&view->world->openings[ray->pane],
                                           hour->sky->sun, ray->pane_class);
    return ray->pane_share * L;
}

/* Luminance of ray i, cd/m2. */
static double luminance_of(const struct outdoor_hour *hour, int i, const float *rest_lx,
                           const double *rows)
{
    const struct pp_glare_view *view = hour->view;
    int surface = view->surface_of[i];
    return luminance_behind(hour, &view->rays.list[i], view->plane_of[i],
                            surface >= 0 ? fmax(0.0, rest_lx[surface]) : 0.0)
           + scattered_luminance(hour, i, rows);
}

/* Share of the sun's disc that is visible between the slats of an opening; 1 without
 * slats. */
static double visible_share(const struct pp_opening *opening, struct pp_vec3 sun)
{
    if (!opening->blind)
        return 1.0;
    return pp_blind_scatter_gaps(opening->blind,
                                 pp_vec(-pp_vec_dot(sun, opening->along),
                                        -pp_vec_dot(sun, opening->up),
                                        -pp_vec_dot(sun, opening->inner.normal)));
}

static struct pp_glare_sun sun_seen(const struct pp_glare_view *view,
                                    const struct pp_perez_sky *sky)
{
    struct pp_glare_sun sun = {.opening = -1};
    if (!(sky->direct_lx > 0.0) || !(sky->sun.z > 0.0)
        || !(pp_vec_dot(sky->sun, view->eye.normal) > 0.0))
        return sun;
    double share =
        pp_eye_rays_to_sun(view->scene, view->eye.position, sky->sun, &sun.opening);
    if (!(share > 0.0))
        return sun;
    double visible = sun.opening >= 0
                         ? visible_share(&view->world->openings[sun.opening], sky->sun)
                         : 1.0;
    sun.visible = true;
    sun.omega_sr = visible * PP_GLARE_SUN_SR;
    sun.cd_m2 = share * sky->direct_lx / sun.omega_sr;
    sun.index = pp_dgp_position_index(&view->rays.view, sky->sun);
    sun.sum = sun.cd_m2 * sun.cd_m2 * sun.omega_sr / (sun.index * sun.index);
    return sun;
}

double pp_glare_view_sources(const struct pp_glare_view *view,
                             const struct pp_perez_sky *sky, const float *rest_lx,
                             double threshold_cd_m2, struct pp_glare_part *parts,
                             int opening_count, struct pp_glare_sun *sun, double *work)
{
    struct outdoor_hour hour = hour_of(view, sky);
    double total = 0.0;
    light_rows(&hour, work);
    for (int k = 0; k <= opening_count; k++)
        parts[k] = (struct pp_glare_part){0};
    for (int i = 0; i < view->rays.count; i++) {
        const struct pp_eye_ray *ray = &view->rays.list[i];
        double L = luminance_of(&hour, i, rest_lx, work), P = view->indices[i];
        if (!(L >= threshold_cd_m2))
            continue;
        struct pp_glare_part *part =
            &parts[ray->opening >= 0 ? ray->opening : opening_count];
        double omega_sr = view->rays.solid_angle_sr * ray->clear_share;
        part->omega_sr += omega_sr;
        part->light += L * omega_sr;
        part->square += L * L * omega_sr;
        part->sum += L * L * omega_sr / (P * P);
    }
    for (int k = 0; k <= opening_count; k++)
        total += parts[k].sum;
    *sun = sun_seen(view, sky);
    return total + sun->sum;
}
