/* glare_panes.c - see glare_panes.h. */
#include "studies/glare/glare_panes.h"

#include <stdlib.h>

#include "model/base/array.h"
#include "model/light/sky_patches.h"

enum { PATCHES = 577 };

/* Directions on the outside of the pane. */
static enum pp_status look_from_pane(struct pp_glare_pane *pane,
                                     const struct pp_light_scene *scene,
                                     const struct pp_opening *opening,
                                     double ground_reflectance, struct pp_error *err)
{
    struct pp_sky_patches patches;
    pp_sky_patches_init(&patches, PATCHES, 0.0);
    pane->rays = calloc(2 * PATCHES, sizeof *pane->rays);
    pane->cos_sr = calloc(2 * PATCHES, sizeof *pane->cos_sr);
    pane->plane_of = calloc(2 * PATCHES, sizeof *pane->plane_of);
    if (!pane->rays || !pane->cos_sr || !pane->plane_of)
        return pp_fail_memory(err);
    for (int i = 0; i < 2 * PATCHES; i++) {
        struct pp_vec3 u = pp_sky_patches_centre(&patches, i / 2);
        u.z = i % 2 ? -u.z : u.z;
        double cosine = -pp_vec_dot(u, opening->inner.normal);
        if (!(cosine > 0.0))
            continue;
        pane->cos_sr[pane->ray_count] =
            cosine * pp_sky_patches_solid_angle(&patches, i / 2);
        pane->plane_of[pane->ray_count] = -1;
        pane->rays[pane->ray_count++] =
            pp_eye_rays_outwards(scene, pane->opening, u, ground_reflectance);
    }
    return PP_OK;
}

static struct pp_vec3 travel_in_pane(const struct pp_opening *opening, struct pp_vec3 u)
{
    return pp_vec(-pp_vec_dot(u, opening->along), -pp_vec_dot(u, opening->up),
                  -pp_vec_dot(u, opening->inner.normal));
}

/* Index of a pane, which is added if it is new; -1: out of memory. */
static int find_glare_pane(struct pp_glare_panes *panes,
                           const struct pp_light_scene *scene,
                           const struct pp_world *world, int opening,
                           double ground_reflectance, struct pp_error *err)
{
    for (int i = 0; i < panes->count; i++)
        if (panes->list[i].opening == opening)
            return i;
    if (pp_array_append(&panes->list, panes->count, sizeof *panes->list, err) != PP_OK)
        return -1;
    const struct pp_pane_scatter *scatter = world->openings[opening].scatter;
    struct pp_glare_pane *pane = &panes->list[panes->count++];
    *pane = (struct pp_glare_pane){.opening = opening};
    pane->row_of_class =
        malloc(((size_t)scatter->class_count + 1) * sizeof *pane->row_of_class);
    if (!pane->row_of_class) {
        pp_fail_memory(err);
        return -1;
    }
    for (int k = 0; k < scatter->class_count; k++)
        pane->row_of_class[k] = -1;
    return look_from_pane(pane, scene, &world->openings[opening], ground_reflectance,
                          err)
                   == PP_OK
               ? panes->count - 1
               : -1;
}

/* Index of a row, which is added if it is new; -1: out of memory. */
static int find_glare_row(struct pp_glare_panes *panes, const struct pp_world *world,
                          int index, int leaving, struct pp_error *err)
{
    struct pp_glare_pane *pane = &panes->list[index];
    const struct pp_opening *opening = &world->openings[pane->opening];
    if (pane->row_of_class[leaving] >= 0)
        return pane->row_of_class[leaving];
    if (pp_array_append(&panes->rows, panes->row_count, sizeof *panes->rows, err)
        != PP_OK)
        return -1;
    struct pp_glare_row *row = &panes->rows[panes->row_count++];
    *row = (struct pp_glare_row){.pane = index, .leaving = leaving};
    row->weights = malloc((size_t)pane->ray_count * sizeof *row->weights);
    if (!row->weights) {
        pp_fail_memory(err);
        return -1;
    }
    for (int i = 0; i < pane->ray_count; i++) {
        struct pp_vec3 in = travel_in_pane(opening, pane->rays[i].u);
        row->weights[i] = (float)(pane->cos_sr[i]
                                  * opening->scatter->class_btdf(opening->scatter->data,
                                                                 in, leaving));
    }
    return pane->row_of_class[leaving] = panes->row_count - 1;
}

enum pp_status pp_glare_panes_init(struct pp_glare_panes *panes,
                                   const struct pp_light_scene *scene,
                                   const struct pp_world *world,
                                   const struct pp_eye_rays *rays,
                                   double ground_reflectance, struct pp_error *err)
{
    *panes = (struct pp_glare_panes){.count = 0};
    panes->row_of_ray = malloc((size_t)rays->count * sizeof *panes->row_of_ray);
    if (!panes->row_of_ray)
        return pp_fail_memory(err);
    for (int i = 0; i < rays->count; i++) {
        const struct pp_eye_ray *ray = &rays->list[i];
        panes->row_of_ray[i] = -1;
        if (ray->pane < 0)
            continue;
        int pane =
            find_glare_pane(panes, scene, world, ray->pane, ground_reflectance, err);
        if (pane >= 0)
            panes->row_of_ray[i] =
                find_glare_row(panes, world, pane, ray->pane_class, err);
        if (panes->row_of_ray[i] < 0)
            return PP_SYSTEM;
    }
    return PP_OK;
}

void pp_glare_panes_clear(struct pp_glare_panes *panes)
{
    for (int i = 0; i < panes->count; i++) {
        free(panes->list[i].rays);
        free(panes->list[i].cos_sr);
        free(panes->list[i].plane_of);
        free(panes->list[i].row_of_class);
    }
    for (int i = 0; i < panes->row_count; i++)
        free(panes->rows[i].weights);
    free(panes->list);
    free(panes->rows);
    free(panes->row_of_ray);
    *panes = (struct pp_glare_panes){.count = 0};
}

double pp_glare_panes_luminance(const struct pp_glare_panes *panes, int row,
                                const double *luminances)
{
    const struct pp_glare_row *of = &panes->rows[row];
    double sum = 0.0;
    for (int i = 0; i < panes->list[of->pane].ray_count; i++)
        sum += of->weights[i] * luminances[i];
    return sum;
}
