/* shared_density.c - a density that is constant on each patch of the control
 * variate. */
#include "simulate/fast/shared_density.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/scene/light_scene_parts.h"

/* Fraction of the mean of G that is added to each patch's G. Patches are drawn in
 * proportion to their area times the square root of the sum. The noise of D grows with
 * G, but so does the light at nearby receivers, whose relative error matters. Measured
 * in the deep office: a constant density needs half as many points again, a density
 * proportional to G twice as many. */
static const double LEAST_SHARE = 0.1;

/* Factor for patches below the working plane, which receivers usually face away from.
 * Chosen by trial. */
static const double BELOW_SHARE = 0.15;

/* Place of a patch. */
struct density_patch {
    int part;
    double a, b; /* lower corner, along the part's a and b */
    double width_m, height_m;
};

struct pp_shared_density {
    const struct pp_light_scene *scene;       /* not owned */
    const struct pp_control_variate *variate; /* not owned */
    struct density_patch *patches;
    double *values; /* p of each patch, 1/m2 */
    double *below;  /* cumulative probability of all patches before each patch */
};

/* All patches are on front sides, since the room is convex. */
static void place_patches(struct pp_shared_density *density)
{
    const struct pp_light_scene *scene = density->scene;
    for (int i = 0; i < scene->part_count; i++) {
        const struct pp_control_variate_grid *grid = &density->variate->grids[i][0];
        for (int k = 0; grid->first >= 0 && k < grid->columns * grid->rows; k++)
            density->patches[grid->first + k] = (struct density_patch){
                .part = i,
                .a = grid->a0 + (k % grid->columns - 0.5) / grid->per_a,
                .b = grid->b0 + (k / grid->columns - 0.5) / grid->per_b,
                .width_m = 1.0 / grid->per_a,
                .height_m = 1.0 / grid->per_b};
    }
}

/* The point of a patch given by two numbers in (0, 1). */
static struct pp_vec3 patch_point(const struct pp_light_scene *scene,
                                  const struct density_patch *patch, double u, double v)
{
    return pp_light_scene_parts_point(&scene->parts[patch->part],
                                      patch->a + u * patch->width_m,
                                      patch->b + v * patch->height_m);
}

bool pp_shared_density_serves(const struct pp_shared_density *density,
                              struct pp_vec3 point)
{
    return pp_convex_room_encloses(density->scene->convex, point);
}

static void weigh_patches(struct pp_shared_density *density)
{
    const struct pp_light_scene *scene = density->scene;
    const double *values = density->variate->values;
    double plane_z = scene->world->working_plane_m - scene->centre.z;
    int count = density->variate->count;
    double mean = 0.0, area = 0.0, total = 0.0;
    for (int i = 0; i < count; i++) {
        double cell = density->patches[i].width_m * density->patches[i].height_m;
        mean += cell * values[i];
        area += cell;
    }
    mean /= area;
    for (int i = 0; i < count; i++) {
        const struct density_patch *patch = &density->patches[i];
        double share = sqrt(fmax(values[i], 0.0) + LEAST_SHARE * mean);
        if (!(mean > 0.0))
            share = 1.0;
        if (patch_point(scene, patch, 0.5, 0.5).z < plane_z)
            share *= BELOW_SHARE;
        if (patch->part >= scene->world->face_count) /* the side of a niche */
            share = 0.0;
        density->values[i] = share;
        density->below[i] = total;
        total += share * patch->width_m * patch->height_m;
    }
    for (int i = 0; i < count; i++) {
        density->values[i] /= total;
        density->below[i] /= total;
    }
}

/* The patch selected by u in (0, 1). */
static int patch_of(const struct pp_shared_density *density, double u)
{
    int low = 0, high = density->variate->count;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (density->below[middle] < u)
            low = middle;
        else
            high = middle;
    }
    return low;
}

enum pp_status pp_shared_density_create(struct pp_shared_density **result,
                                        const struct pp_light_scene *scene,
                                        const struct pp_control_variate *variate,
                                        struct pp_error *err)
{
    *result = NULL;
    if (!variate || !scene->convex)
        return PP_OK;
    struct pp_shared_density *density = calloc(1, sizeof *density);
    if (!density)
        return pp_fail_memory(err);
    density->scene = scene;
    density->variate = variate;
    size_t count = (size_t)variate->count;
    density->patches = calloc(count, sizeof *density->patches);
    density->values = calloc(count, sizeof *density->values);
    density->below = calloc(count, sizeof *density->below);
    if (!density->patches || !density->values || !density->below) {
        pp_shared_density_destroy(density);
        return pp_fail_memory(err);
    }
    place_patches(density);
    weigh_patches(density);
    *result = density;
    return PP_OK;
}

void pp_shared_density_destroy(struct pp_shared_density *density)
{
    if (!density)
        return;
    free(density->patches);
    free(density->values);
    free(density->below);
    free(density);
}

struct pp_shared_place pp_shared_density_draw(const struct pp_shared_density *density,
                                              const double u[3])
{
    int patch = patch_of(density, u[0]);
    struct pp_vec3 point =
        patch_point(density->scene, &density->patches[patch], u[1], u[2]);
    return (struct pp_shared_place){
        .part = density->patches[patch].part,
        .sight = pp_convex_room_sight(density->scene->convex, point),
        .per_density = 1.0 / (PP_PI * density->values[patch])};
}

double pp_shared_density_left(const struct pp_shared_density *density,
                              const struct pp_light_ray *ray,
                              const struct pp_light_hit *met)
{
    int patch = pp_control_variate_nearest(density->variate, density->scene, met);
    if (patch < 0)
        return 1.0;
    struct pp_vec3 to = pp_vec_sub(met->point, ray->from);
    double square = pp_vec_dot(to, to);
    double geometry = pp_vec_dot(ray->off, to) * -pp_vec_dot(met->normal, to);
    double most = PP_SHARED_DENSITY_MOST_WEIGHT * PP_PI * density->values[patch];
    return geometry > most * square * square ? 1.0 - most * square * square / geometry
                                             : 0.0;
}
