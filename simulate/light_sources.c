/* light_sources.c - light from concentrated emitters, aimed at. See light_path.h. */
#include <math.h>

#include "simulate/choose.h"
#include "simulate/light_path.h"

enum {
    /* Clear surfaces between a point and what it aims at, at most. */
    MOST_PANES = 64,
    /* At the first surface each of so many emitters is aimed at; of more, one a path.
     */
    MOST_EMITTERS = 64,
};

bool pp_emitter_counted(const struct pp_radiance_walk *walk,
                        const struct pp_light_path *path, int emitter)
{
    if (!walk->options.sources || path->aimed == PP_AIMED_AT_NOTHING)
        return false;
    if (path->aimed == PP_AIMED_AT_ALL)
        return true;
    return pp_emitter_spread(&walk->scene->emitters[emitter], walk->scene, path->from)
           < path->width;
}

struct pp_rgb pp_lit_sends_on(const struct pp_lit *lit, struct pp_vec3 o, double spread)
{
    const struct pp_lobes *lobes = lit->lobes;
    bool through = pp_dot(lobes->n, lit->normal) < 0.0;
    struct pp_rgb diffuse =
        lobes->share[through ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE];
    struct pp_rgb f = pp_rgb_scale(diffuse, 1.0 / PP_PI);
    if (spread < PP_AIMED_WIDTHS * pp_lobes_width(lobes))
        f = pp_rgb_add(f, pp_lobes_gloss(lobes, o));
    return f;
}

bool pp_lit_reach(struct pp_radiance_walk *walk, struct pp_light_ray ray, int part,
                  double distance_m, struct pp_rgb *through)
{
    const struct pp_light_scene *scene = walk->scene;
    double gone = 0.0;
    for (int i = 0; i < MOST_PANES; i++) {
        struct pp_light_hit hit;
        enum pp_meeting meeting = pp_light_path_meet(walk, &ray, &hit);
        if (meeting == PP_MEETS_BEYOND)
            return part < 0 && isinf(hit.distance_m);
        if (meeting == PP_MEETS_CRACK)
            return false;
        gone += hit.distance_m;
        if (hit.part == part && fabs(gone - distance_m) < 1e-4 * distance_m + 1e-5)
            return true;
        *through =
            pp_rgb_times(*through, pp_straight_through(&scene->materials[hit.material],
                                                       -pp_dot(hit.normal, ray.to)));
        if (pp_rgb_is_black(*through))
            return false;
        ray.from = hit.point;
        ray.off = pp_scale(hit.normal, -1.0);
        ray.space = pp_part_space(scene, hit.part, !hit.back);
    }
    return false;
}

/* Light from one direction to an emitter. */
static struct pp_rgb from_emitter(struct pp_radiance_walk *walk,
                                  const struct pp_lit *lit,
                                  const struct pp_emitter *emitter, double spread,
                                  const struct pp_aimed *aimed)
{
    struct pp_rgb none = pp_rgb_grey(0.0), through = pp_rgb_grey(1.0);
    double facing = pp_dot(lit->normal, aimed->direction);
    if (!(facing > 0.0))
        return none;
    struct pp_rgb f = pp_lit_sends_on(lit, aimed->direction, spread);
    if (pp_rgb_is_black(f)
        || !pp_lit_reach(walk, pp_lit_ray(lit, aimed->direction), emitter->part,
                         aimed->distance_m, &through))
        return none;
    struct pp_rgb radiance =
        emitter->distant < 0
            ? emitter->radiance
            : pp_distant_radiance(walk->scene, emitter->distant, aimed->direction);
    return pp_rgb_scale(pp_rgb_times(pp_rgb_times(f, through), radiance),
                        facing * aimed->per_density);
}

static struct pp_rgb light_of_emitter(struct pp_radiance_walk *walk,
                                      const struct pp_lit *lit, int index, int vertex)
{
    const struct pp_emitter *emitter = &walk->scene->emitters[index];
    struct pp_rgb sum = pp_rgb_grey(0.0);
    struct pp_emitter_aim aim;
    if (!pp_emitter_aim_init(&aim, walk->scene, emitter, lit->point, lit->normal))
        return sum;
    double spread = pp_emitter_spread(emitter, walk->scene, lit->point);
    uint32_t count = lit->many ? pp_directions_to(spread, walk->options.source_size,
                                                  walk->options.source_most)
                               : 1;
    for (uint32_t i = 0; i < count; i++) {
        double u[2];
        struct pp_aimed aimed;
        pp_sequence_draw(&walk->sequence, walk->index * count + i, vertex, 2, u);
        if (pp_emitter_aim_sample(&aim, u[0], u[1], &aimed))
            sum = pp_rgb_add(sum, from_emitter(walk, lit, emitter, spread, &aimed));
    }
    return pp_rgb_scale(sum, 1.0 / count);
}

/* What emitters may count for a lit surface. */
struct lit_scene {
    const struct pp_light_scene *scene;
    const struct pp_lit *lit;
};

static double importance_of(const void *of, int emitter)
{
    const struct lit_scene *here = of;
    return pp_emitter_importance(&here->scene->emitters[emitter], here->scene,
                                 here->lit->point, here->lit->normal);
}

struct pp_rgb pp_light_from_sources(struct pp_radiance_walk *walk,
                                    const struct pp_lit *lit)
{
    const struct pp_light_scene *scene = walk->scene;
    struct pp_rgb sum = pp_rgb_grey(0.0);
    if (!walk->options.sources || scene->emitter_count == 0)
        return sum;
    int vertex = lit->vertex * PP_DRAWS + PP_DRAW_SOURCES;
    if (scene->emitter_count == 1
        || (lit->many && scene->emitter_count <= MOST_EMITTERS)) {
        for (int i = 0; i < scene->emitter_count; i++)
            sum = pp_rgb_add(
                sum, light_of_emitter(walk, lit, i,
                                      i == 0 ? vertex : pp_branch_off(vertex, i)));
        return sum;
    }
    double u, probability;
    pp_sequence_draw(&walk->sequence, walk->index, pp_branch_off(vertex, 0), 1, &u);
    struct lit_scene here = {scene, lit};
    int chosen = pp_choose(importance_of, &here, scene->emitter_count, u, &probability);
    if (chosen < 0)
        return sum;
    return pp_rgb_scale(light_of_emitter(walk, lit, chosen, vertex), 1.0 / probability);
}
