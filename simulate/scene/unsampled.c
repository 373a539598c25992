/* unsampled.c - sums and upper bounds of the light that rays can find only by
 * chance. */
#include "simulate/scene/unsampled.h"

#include <math.h>

#include "model/results/reading.h"
#include "model/light/graded_sky.h"
#include "simulate/sampling/lobe.h"
#include "simulate/sampling/sample_polygon.h"
#include "simulate/sampling/sobol.h"
#include "simulate/scene/light_scene_parts.h"

static struct pp_rgb greater(struct pp_rgb a, struct pp_rgb b)
{
    return pp_rgb(fmax(a.r, b.r), fmax(a.g, b.g), fmax(a.b, b.b));
}

/* Adds one emitter with a solid angle of `solid` sr; `share` is the fraction of its
 * light that is found only by chance. */
static void add_emitter(struct pp_unsampled *light, struct pp_rgb radiance,
                        double solid, double share)
{
    double cone = fmin(solid, PP_PI);
    light->all = pp_rgb_along(light->all, cone, radiance);
    if (!(share > 0.0))
        return;
    light->by_chance = pp_rgb_along(light->by_chance, share * cone, radiance);
    light->brightest = greater(light->brightest, radiance);
}

void pp_unsampled_find_glow(struct pp_light_scene *scene)
{
    for (int i = 0; i < scene->part_count; i++)
        for (int side = 0; side <= (int)scene->parts[i].back_emits; side++) {
            const struct pp_material *material =
                &scene->materials[scene->parts[i].material[side]];
            if (material->emits == PP_EMITS_EXTENDED)
                scene->glow = greater(scene->glow, material->radiance);
        }
}

struct pp_unsampled pp_unsampled_at(const struct pp_light_scene *scene,
                                    struct pp_vec3 point, bool by_chance,
                                    const double *shares)
{
    struct pp_unsampled light = {.all = pp_rgb_grey(0.0)};
    struct pp_vec3 from = pp_vec_sub(point, scene->centre);
    for (int i = 0; i < scene->emitter_count; i++) {
        double spread = pp_emitters_angular_size(&scene->emitters[i], scene, from);
        add_emitter(&light, scene->emitters[i].radiance, spread * spread,
                    by_chance ? 1.0 : shares[i]);
    }
    for (int i = 0; i < scene->distant_count; i++) {
        const struct pp_distant *distant = &scene->distants[i];
        const struct pp_material *material = &scene->materials[distant->material];
        if (distant->emitter < 0)
            add_emitter(&light, material->radiance, distant->solid,
                        material->pattern < 0 ? 1.0 : 0.0);
    }
    add_emitter(&light, scene->glow, PP_PI, 1.0);
    return light;
}

struct pp_rgb pp_unsampled_bound(const struct pp_unsampled *unsampled, bool found,
                                 double paths)
{
    struct pp_rgb one = pp_rgb_scale(unsampled->brightest, PP_PI / paths);
    struct pp_rgb chance =
        pp_rgb(fmin(unsampled->by_chance.r, one.r), fmin(unsampled->by_chance.g, one.g),
               fmin(unsampled->by_chance.b, one.b));
    return found ? chance : greater(chance, pp_rgb_scale(unsampled->all, 1.0 / paths));
}

/* ---- probes ---- */

enum {
    PROBES = 4096,   /* rays from a distant emitter, over the scene's cross-section */
    MOST_EVENTS = 16 /* most reflections and transmissions of a ray */
};

/* Beams with less than this fraction of the emitter's light are not followed. */
static const double LEAST_BEAM = 1e-4;

/* The mirror path that consists of the mirrors a beam has met, in the order from a
 * point to the emitter; -1: there is none. */
static int mirrors_met(const struct pp_light_scene *scene, const int *met, int count)
{
    int path = -1;
    for (int i = count - 1; i >= 0; i--) {
        path = met[i] < 0 ? -1 : pp_mirrors_path_extend(scene, path, met[i]);
        if (path < 0)
            return -1;
    }
    return path;
}

/* Follows the emitter's light through mirrors and clear surfaces. *most: greatest
 * fraction of the light that arrives by reflections which next-event estimation does
 * not sample. */
static void probe(const struct pp_light_scene *scene, struct pp_light_ray ray,
                  double share, const int *met, int count, int events, double *most)
{
    struct pp_light_hit hit;
    if (share < LEAST_BEAM || events == MOST_EVENTS
        || pp_light_scene_meet(scene, &ray, &hit) != PP_MEETS_PART)
        return;
    struct pp_light_ray on = ray, back = ray;
    struct pp_rgb through = pp_rgb_grey(1.0), mirrored = through;
    if (pp_light_scene_parts_pass(scene, &hit, &on, &through))
        probe(scene, on, share * pp_rgb_most(through), met, count, events + 1, most);
    if (!pp_light_scene_parts_reflect(scene, &hit, &back, &mirrored)
        || share * pp_rgb_most(mirrored) < LEAST_BEAM)
        return;
    share *= pp_rgb_most(mirrored);
    int more[MOST_EVENTS + 1];
    for (int i = 0; i < count; i++)
        more[i] = met[i];
    more[count] = scene->parts[hit.part].mirror;
    if (mirrors_met(scene, more, count + 1) < 0)
        *most = fmax(*most, share);
    probe(scene, back, share, more, count + 1, events + 1, most);
}

double pp_unsampled_probe(const struct pp_light_scene *scene,
                          const struct pp_emitter *emitter)
{
    if (emitter->distant < 0 || !(scene->unsampled_share > 0.0))
        return scene->unsampled_share;
    struct pp_vec3 to = pp_vec_scale(scene->distants[emitter->distant].direction, -1.0);
    struct pp_vec3 across, up, low = pp_vec_sub(scene->bounds.low, scene->centre);
    struct pp_vec3 size = pp_vec_sub(scene->bounds.high, scene->bounds.low);
    struct pp_vec3 middle = pp_vec_along(low, 0.5, size);
    double radius = 0.5 * pp_vec_length(size), most = 0.0;
    pp_lobe_frame(to, &across, &up);
    struct pp_sobol sobol;
    struct pp_sobol_sequence sequence;
    pp_sobol_init(&sobol);
    pp_sobol_sequence_init(&sequence, &sobol, 1);
    for (uint32_t i = 0; i < PROBES; i++) {
        double u[2];
        pp_sobol_sequence_draw(&sequence, i, 0, 2, u);
        struct pp_light_ray ray = {.to = to};
        ray.from = pp_vec_along(middle, -2.0 * radius, to);
        ray.from = pp_vec_along(ray.from, radius * (2.0 * u[0] - 1.0), across);
        ray.from = pp_vec_along(ray.from, radius * (2.0 * u[1] - 1.0), up);
        ray.space = pp_light_scene_space(scene, pp_vec_add(ray.from, scene->centre));
        probe(scene, ray, 1.0, NULL, 0, 0, &most);
    }
    return most > 0.0 ? scene->unsampled_share : scene->unsampled_share / PROBES;
}

/* ---- rooms ---- */

/* Approximate daylight factor from an unobstructed opening. The importance is in units
 * of the luminance of an overcast horizon. */
static double pane_importance(const struct pp_light_scene *scene,
                              const struct pp_vec3 *position, struct pp_vec3 normal,
                              const struct pp_pane *pane)
{
    if (!position)
        return fmin(1.0, pane->target.area_m2 / scene->plane_area_m2);
    const struct pp_brightness bright = {.ground = 1.0,
                                         .gradation = PP_GRADED_SKY_OVERCAST};
    return fmin(1.0, pp_graded_sky_horizon(PP_GRADED_SKY_OVERCAST) / PP_PI
                         * pp_sample_polygon_importance(&pane->target, *position,
                                                        normal, &bright));
}

/* True if a ray from the point to the opening may point upwards (rising) or downwards
 * (not rising). Conservative: an opening partly behind the point's plane counts as a
 * whole. */
static bool shows(const struct pp_vec3 *position, struct pp_vec3 n,
                  const struct pp_pane *pane, bool rising)
{
    const struct pp_target *target = &pane->target;
    bool spreads = pane->opening->glass.diffusing || pane->opening->scatter;
    if (spreads || !position)
        return rising || spreads;
    if (!rising && n.z > 0.0 && n.x == 0.0 && n.y == 0.0)
        return false;
    for (int i = 0; i < target->triangle_count; i++)
        for (int k = 0; k < 3; k++) {
            double over = target->triangles[i][k].z - position->z;
            if (rising ? over > 0.0 : over < 0.0)
                return true;
        }
    return false;
}

struct pp_room_bound pp_unsampled_of_room(const struct pp_light_scene *scene,
                                          const struct pp_vec3 *position,
                                          struct pp_vec3 normal)
{
    struct pp_room_bound most = {{0.0, 0.0, 0.0}};
    double exitance = scene->most_exitance;
    if (!scene->has_room) {
        most.part[PP_SC] = 1.0;
        most.part[PP_ERC] = 1.0 + exitance;
        return most;
    }
    double area = 0.0;
    bool skylines = scene->skylines.far_count > 0;
    for (int i = 0; i < scene->pane_count; i++) {
        const struct pp_pane *pane = &scene->panes[i];
        double share = pane_importance(scene, position, normal, pane);
        if (shows(position, normal, pane, true))
            most.part[PP_SC] += share;
        if (!pane->unobstructed || skylines || shows(position, normal, pane, false))
            most.part[PP_ERC] += share * (1.0 + exitance);
        area += pane->target.area_m2;
    }
    if (exitance > 0.0 || (area > 0.0 && scene->reflects))
        most.part[PP_IRC] =
            scene->decorations
            * (exitance + fmin(1.0, area / (scene->size_m * scene->size_m)));
    return most;
}

double pp_unsampled_of_component(const struct pp_room_bound *most, int component,
                                 unsigned found, double straight, double reflected)
{
    double sum = 0.0;
    for (int i = PP_SC; i <= PP_IRC; i++)
        if ((component == i || component == PP_DF) && !(found >> i & 1))
            sum += most->part[i] / (i == PP_IRC ? reflected : straight);
    return sum;
}
