/* photon_sources.c - see photon_sources.h. */
#include "simulate/research/photons/photon_sources.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "simulate/sampling/lobe.h"
#include "simulate/sampling/scatter.h"
#include "simulate/sampling/triangle.h"
#include "simulate/scene/light_scene_parts.h"

/* Limit of cos cos'/d^2 in units of pi over the area. This unit is the mean of cos
 * cos'/d^2 over a source (or over all surfaces) that fills the half space. Chosen by
 * trial, for the least work for a given error. */
static const double SOURCE_LIMIT = 1.0, SURFACE_LIMIT = 8.0;

/* Weight added to every direction of a table, relative to the mean luminance. */
static const double LEAST_CELL = 0.2;

/* Luminance over Eh that is added to the estimate outside an opening, since perhaps
 * only black surfaces are visible from its middle. */
static const double LEAST_LUMINANCE = 0.003;

/* Estimated illuminance on a shaded surface outside, relative to an unshaded one. */
static const double SHADED = 0.3;

/* Least probability of a visible opening, relative to its probability under uniform
 * brightness. */
static const double LEAST_IMPORTANCE = 0.02;

double pp_photon_sources_limit(double area_m2, double chance)
{
    return SOURCE_LIMIT * PP_PI * chance / area_m2;
}

/* ---- the light outside, as guessed ---- */

static double guessed_outside(const struct pp_light_scene *scene,
                              const struct pp_environment *environment,
                              const struct pp_light_ray *ray)
{
    struct pp_light_hit hit;
    enum pp_meeting meeting = pp_light_scene_meet(scene, ray, &hit);
    if (meeting == PP_MEETS_GROUND)
        return pp_outside_light_ground(&environment->light) / PP_PI;
    if (meeting == PP_MEETS_ENVIRONMENT)
        return pp_rgb_luminance(
            pp_light_scene_environment(scene, environment, ray->to, NULL));
    if (meeting != PP_MEETS_PART)
        return 0.0;
    const struct pp_material *material = &scene->materials[hit.material];
    return pp_rgb_luminance(material->radiance)
           + SHADED * pp_rgb_luminance(material->diffuse) / PP_PI;
}

/* Estimated mean of luminance times transmittance over the cosine lobe; fills the table
 * with the relative weights of its cells. */
static double fill_table(struct pp_photon_source *source,
                         const struct pp_light_scene *scene,
                         const struct pp_environment *environment)
{
    enum { N = PP_PHOTON_CELLS };
    const struct pp_light_part *part = &scene->parts[source->part];
    const struct pp_material *material = &scene->materials[part->material[0]];
    struct pp_vec3 out = pp_vec_scale(part->normal, -1.0);
    struct pp_light_ray ray = {scene->panes[source->pane].target.middle, out, out,
                               PP_OUTDOORS};
    double sum = 0.0, passed = 0.0;
    for (int i = 0; i < N * N; i++) {
        ray.to = pp_lobe_sample_in_frame(part->a, part->b, out, (i / N + 0.5) / N,
                                         (i % N + 0.5) / N);
        double through = pp_rgb_luminance(
            source->clear
                ? pp_scatter_regular_transmittance(material, pp_vec_dot(out, ray.to))
                : material->through_diffuse);
        source->cells[i / N][i % N] =
            through * guessed_outside(scene, environment, &ray);
        sum += source->cells[i / N][i % N];
        passed += through;
    }
    double mean = sum / (N * N);
    for (int i = 0; i < N; i++) {
        source->rows[i] = 0.0;
        for (int k = 0; k < N; k++) {
            double share = mean > 0.0 ? source->cells[i][k] / mean : 1.0;
            source->cells[i][k] = (share + LEAST_CELL) / (1.0 + LEAST_CELL);
            source->rows[i] += source->cells[i][k] / N;
        }
    }
    return mean + LEAST_LUMINANCE * passed / (N * N);
}

/* ---- making ---- */

static void add_pane(struct pp_photon_sources *sources,
                     const struct pp_light_scene *scene,
                     const struct pp_environment *environment, int index)
{
    const struct pp_pane *pane = &scene->panes[index];
    const struct pp_target *target = &pane->target;
    struct pp_photon_source *source = &sources->list[sources->count++];
    int material = scene->parts[pane->part].material[0];
    *source = (struct pp_photon_source){
        .pane = index,
        .part = pane->part,
        .triangles = (const struct pp_vec3(*)[3])target->triangles,
        .triangle_count = target->triangle_count,
        .area_m2 = target->area_m2,
        .clear = scene->materials[material].kind == PP_MATERIAL_GLASS};
    double mean = fill_table(source, scene, environment);
    source->power = PP_PI * mean * source->area_m2;
    sources->pane_power += source->power;
}

/* True if this side of a part emits light into the room. */
static bool is_lamp(const struct pp_light_scene *scene, int index, int side)
{
    const struct pp_light_part *part = &scene->parts[index];
    return scene->has_room && part->space[side] == PP_INDOORS
           && (side == 0 || part->back_emits)
           && scene->materials[part->material[side]].emits != PP_EMITS_NOTHING;
}

static enum pp_status add_lamp(struct pp_photon_sources *sources,
                               const struct pp_light_scene *scene, int index, int side,
                               int first, int count, struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&sources->list, sources->count, sizeof *sources->list, err);
    if (status != PP_OK)
        return status;
    struct pp_photon_source lamp = {.pane = -1, .part = index, .back = side};
    lamp.radiance = scene->materials[scene->parts[index].material[side]].radiance;
    lamp.triangles = (const struct pp_vec3(*)[3])(sources->triangles + first);
    lamp.triangle_count = count;
    for (int i = first; i < first + count; i++)
        lamp.area_m2 += pp_triangle_area(sources->triangles[i]);
    lamp.power = PP_PI * pp_rgb_luminance(lamp.radiance) * lamp.area_m2;
    if (lamp.power > 0.0)
        sources->list[sources->count++] = lamp;
    return PP_OK;
}

/* Adds the surfaces that emit light into the room as sources, with their triangles. */
static enum pp_status add_lamps(struct pp_photon_sources *sources,
                                const struct pp_light_scene *scene,
                                struct pp_error *err)
{
    struct pp_triangles list = {.facet_of = NULL};
    struct pp_clipper *clipper = NULL;
    enum pp_status status = pp_clipper_create(&clipper, err);
    for (int i = 0; status == PP_OK && i < scene->world->surface_count; i++)
        if (is_lamp(scene, i, 0) || is_lamp(scene, i, 1))
            status = pp_triangles_of_surface(&list, clipper, scene->world, i,
                                             scene->centre, err);
    pp_clipper_destroy(clipper);
    sources->triangles = list.corners;
    list.corners = NULL;
    for (int i = 0, end; status == PP_OK && i < list.count; i = end) {
        int part = list.facet_of[i];
        for (end = i; end < list.count && list.facet_of[end] == part;)
            end++;
        for (int side = 0; side < 2 && status == PP_OK; side++)
            if (is_lamp(scene, part, side))
                status = add_lamp(sources, scene, part, side, i, end - i, err);
    }
    pp_triangles_clear(&list);
    return status;
}

/* Area of all sides of parts that face the room; in a convex room its surface area. */
static double area_inside(const struct pp_light_scene *scene)
{
    double area = 0.0;
    for (int i = 0; i < scene->part_count; i++)
        for (int side = 0; side < 2; side++)
            if (scene->parts[i].space[side] == PP_INDOORS)
                area += scene->parts[i].area_m2;
    return area;
}

static void share(struct pp_photon_sources *sources, const struct pp_light_scene *scene)
{
    for (int i = 0; i < sources->count; i++)
        sources->power += sources->list[i].power;
    for (int i = 0; i < sources->count && sources->power > 0.0; i++) {
        struct pp_photon_source *source = &sources->list[i];
        source->chance = source->power / sources->power;
        source->limit = pp_photon_sources_limit(source->area_m2, source->chance);
    }
    sources->all_seen = scene->convex && !scene->has_niches;
    double area = area_inside(scene);
    sources->limit = area > 0.0 ? SURFACE_LIMIT * PP_PI / area : INFINITY;
}

enum pp_status pp_photon_sources_create(struct pp_photon_sources **result,
                                        const struct pp_light_scene *scene,
                                        const struct pp_environment *environment,
                                        struct pp_error *err)
{
    struct pp_photon_sources *sources = calloc(1, sizeof *sources);
    *result = NULL;
    if (!sources)
        return pp_fail_memory(err);
    sources->pane_count = scene->pane_count;
    sources->list = calloc((size_t)scene->pane_count + 1, sizeof *sources->list);
    enum pp_status status = sources->list ? PP_OK : pp_fail_memory(err);
    for (int i = 0; status == PP_OK && i < scene->pane_count; i++)
        add_pane(sources, scene, environment, i);
    if (status == PP_OK)
        status = add_lamps(sources, scene, err);
    if (status != PP_OK) {
        pp_photon_sources_destroy(sources);
        return status;
    }
    share(sources, scene);
    *result = sources;
    return PP_OK;
}

void pp_photon_sources_destroy(struct pp_photon_sources *sources)
{
    if (!sources)
        return;
    free(sources->list);
    free(sources->triangles);
    free(sources);
}

/* ---- drawing ---- */

int pp_photon_sources_choose(const struct pp_photon_sources *sources, int count,
                             double u)
{
    double total = count < sources->count ? sources->pane_power : sources->power;
    double left = u * total;
    int chosen = -1;
    for (int i = 0; i < count && total > 0.0; i++) {
        if (!(sources->list[i].power > 0.0))
            continue;
        chosen = i;
        if (left < sources->list[i].power)
            break;
        left -= sources->list[i].power;
    }
    return chosen;
}

struct pp_vec3 pp_photon_sources_point(const struct pp_light_scene *scene,
                                       const struct pp_photon_source *source, double u,
                                       double v)
{
    const struct pp_target *target =
        source->pane >= 0 ? &scene->panes[source->pane].target : NULL;
    if (target && target->rectangle)
        return pp_target_point(target, u * target->width_m, v * target->height_m);
    return pp_triangle_point_of(source->triangles, source->triangle_count,
                                source->area_m2, u, v);
}

/* Cell drawn by u in (0, 1) according to the weights, whose mean is `mean`. u becomes
 * the position within the cell, 0 to 1. */
static int source_cell(const double *weights, double mean, double *u)
{
    double left = *u * PP_PHOTON_CELLS * mean;
    int i = 0;
    while (i + 1 < PP_PHOTON_CELLS && left >= weights[i])
        left -= weights[i++];
    *u = fmin(left / weights[i], 1.0);
    return i;
}

struct pp_vec3 pp_photon_sources_direction(const struct pp_light_scene *scene,
                                           const struct pp_photon_source *source,
                                           struct pp_vec3 n, double u, double v,
                                           double *density)
{
    const struct pp_light_part *part = &scene->parts[source->part];
    int row = source_cell(source->rows, 1.0, &u);
    int column = source_cell(source->cells[row], source->rows[row], &v);
    *density = source->cells[row][column];
    return pp_lobe_sample_in_frame(part->a, part->b, n, (row + u) / PP_PHOTON_CELLS,
                                   (column + v) / PP_PHOTON_CELLS);
}

/* ---- the openings that a receiver sees ---- */

/* cos cos'/d^2 for a point of the opening, at most the value for a surface that fills
 * the half space. */
static double projected(const struct pp_target *target, struct pp_vec3 on,
                        struct pp_vec3 point, struct pp_vec3 normal)
{
    struct pp_vec3 to = pp_vec_sub(on, point);
    double d2 = pp_vec_dot(to, to);
    double here = pp_vec_dot(normal, to), there = -pp_vec_dot(target->normal, to);
    if (!(here > 0.0 && there > 0.0))
        return 0.0;
    return fmin(here * there / (d2 * d2), PP_PI / target->area_m2);
}

/* Projected area of a triangle over the squared distance, estimated from its corners
 * and middle. Sets *seen if the value is above 0 at one of these points. */
static double projected_triangle(const struct pp_target *target, int index,
                                 struct pp_vec3 point, struct pp_vec3 normal,
                                 bool *seen)
{
    const struct pp_vec3 *corners = target->triangles[index];
    struct pp_vec3 middle = pp_vec_scale(
        pp_vec_add(corners[0], pp_vec_add(corners[1], corners[2])), 1.0 / 3.0);
    double sum = 3.0 * projected(target, middle, point, normal);
    for (int i = 0; i < 3; i++)
        sum += projected(target, corners[i], point, normal);
    *seen |= sum > 0.0;
    return sum / 6.0 * pp_triangle_area(corners);
}

bool pp_photon_sources_for(double *chances, const struct pp_photon_sources *sources,
                           const struct pp_light_scene *scene, struct pp_vec3 point,
                           struct pp_vec3 normal)
{
    double total = 0.0;
    for (int i = 0; i < sources->pane_count; i++) {
        const struct pp_target *target = &scene->panes[i].target;
        bool seen = false;
        double sum = 0.0;
        for (int k = 0; k < target->triangle_count; k++)
            sum += projected_triangle(target, k, point, normal, &seen);
        if (seen) {
            struct pp_vec3 to = pp_vec_sub(target->middle, point);
            sum += LEAST_IMPORTANCE * target->area_m2
                   / (target->area_m2 + pp_vec_dot(to, to));
        }
        chances[i] = sum * sources->list[i].power / target->area_m2;
        total += chances[i];
    }
    for (int i = 0; i < sources->pane_count && total > 0.0; i++)
        chances[i] /= total;
    return total > 0.0;
}
