/* reflectors.c - the glossy planes of a scene, combined with its emitters, and
 * directions drawn in proportion to their lobes. */
#include "simulate/scene/images/reflectors.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/sampling/scatter.h"
#include "simulate/scene/light_scene_parts.h"

enum {
    MOST_REFLECTORS = 8,
    MOST_EMITTERS = 32, /* most emitters of a scene whose reflections are sampled */
};

/* Greatest roughness. Wider lobes are sampled only by rays of the diffuse lobe. */
static const double WIDEST = 0.4;

/* ---- found ---- */

/* Makes a reflector from the part's side; false if the side has no gloss, is curved or
 * too rough, or has both a spike and a lobe. Panes and outdoor sides of a world, and
 * mirrors of a description, are not reflectors. */
static bool reflector_of(const struct pp_light_scene *scene, int index, int side,
                         struct pp_reflector *reflector)
{
    const struct pp_light_part *part = &scene->parts[index];
    const struct pp_material *material = &scene->materials[part->material[side]];
    int number = scene->gloss_of_material[part->material[side]];
    const struct pp_gloss *gloss = number < 0 ? NULL : &scene->glosses[number];
    bool reflects = scene->world ? part->window < 0 && part->space[side] == PP_INDOORS
                                 : gloss != NULL;
    if (part->round >= 0 || !reflects || material->rough
        || pp_rgb_is_black(material->gloss)
        || (gloss && (gloss->along > WIDEST || gloss->across > WIDEST)))
        return false;
    struct pp_lobes lobes;
    struct pp_vec3 n = side ? pp_vec_scale(part->normal, -1.0) : part->normal;
    pp_scatter_init(&lobes, material, gloss, n, n);
    *reflector =
        (struct pp_reflector){.frame = lobes.frame,
                              .offset_m = side ? -part->offset_m : part->offset_m,
                              .gloss = number,
                              .share = pp_rgb_most(material->gloss),
                              .area_m2 = part->area_m2};
    return true;
}

static bool same_reflector(const struct pp_reflector *a, const struct pp_reflector *b)
{
    return a->gloss == b->gloss && pp_vec_dot(a->frame.z, b->frame.z) > 1.0 - 1e-12
           && fabs(a->offset_m - b->offset_m) < 1e-6 * (1.0 + fabs(a->offset_m))
           && pp_vec_dot(a->frame.x, b->frame.x) > 1.0 - 1e-9;
}

/* Index of the reflector. Adds the reflector if there are not too many; otherwise
 * returns -1. */
static int reflector_number(struct pp_light_scene *scene,
                            const struct pp_reflector *reflector)
{
    int i = 0;
    while (i < scene->reflector_count
           && !same_reflector(&scene->reflectors[i], reflector))
        i++;
    if (i == MOST_REFLECTORS)
        return -1;
    if (i == scene->reflector_count)
        scene->reflectors[scene->reflector_count++] = *reflector;
    else
        scene->reflectors[i].area_m2 += reflector->area_m2;
    return i;
}

static double light_of(const struct pp_light_scene *scene, int index)
{
    const struct pp_emitter *emitter = &scene->emitters[index];
    double size = emitter->distant < 0 ? emitter->area_m2
                                       : scene->distants[emitter->distant].solid;
    return pp_rgb_luminance(emitter->radiance) * size;
}

/* Pairs every reflector with every emitter, with probabilities in proportion to their
 * possible light. */
static void make_reflections(struct pp_light_scene *scene)
{
    double sum = 0.0;
    for (int i = 0; i < scene->reflector_count; i++)
        for (int k = 0; k < scene->emitter_count; k++) {
            const struct pp_reflector *reflector = &scene->reflectors[i];
            struct pp_reflection *reflection =
                &scene->reflections[scene->reflection_count++];
            *reflection = (struct pp_reflection){
                i, k, reflector->share * reflector->area_m2 * light_of(scene, k)};
            sum += reflection->chance;
        }
    for (int i = 0; i < scene->reflection_count; i++)
        scene->reflections[i].chance /= sum;
    if (!(sum > 0.0))
        scene->reflection_count = 0;
}

enum pp_status pp_reflectors_find(struct pp_light_scene *scene, struct pp_error *err)
{
    if ((scene->emitter_count == 0 && scene->pane_count == 0)
        || scene->emitter_count > MOST_EMITTERS)
        return PP_OK;
    scene->reflectors = calloc(MOST_REFLECTORS, sizeof *scene->reflectors);
    scene->reflections =
        calloc((size_t)MOST_REFLECTORS * (size_t)scene->emitter_count + 1,
               sizeof *scene->reflections);
    if (!scene->reflectors || !scene->reflections)
        return pp_fail_memory(err);
    for (int i = 0; i < scene->part_count; i++)
        for (int side = 0; side < 2; side++) {
            struct pp_reflector reflector;
            if (reflector_of(scene, i, side, &reflector))
                scene->parts[i].reflector[side] = reflector_number(scene, &reflector);
        }
    make_reflections(scene);
    return PP_OK;
}

/* ---- sampled ---- */

int pp_reflectors_choose(const struct pp_light_scene *scene, double u)
{
    int chosen = -1;
    for (int i = 0; i < scene->reflection_count && (i == 0 || u >= 0.0); i++) {
        chosen = i;
        u -= scene->reflections[i].chance;
    }
    return chosen;
}

int pp_reflectors_reflection(const struct pp_light_scene *scene, int reflector,
                             int emitter)
{
    if (reflector < 0 || scene->reflection_count == 0)
        return -1;
    return reflector * scene->emitter_count + emitter;
}

/* Direction, in the reflector's frame, from the place of a mirror reflection to the
 * emitter's middle, for light that reaches the point. False unless point and emitter
 * are in front of the reflector. */
static bool mirrored_from(const struct pp_light_scene *scene,
                          const struct pp_reflection *reflection, struct pp_vec3 from,
                          struct pp_vec3 *light)
{
    const struct pp_reflector *reflector = &scene->reflectors[reflection->reflector];
    const struct pp_emitter *emitter = &scene->emitters[reflection->emitter];
    double over = pp_vec_dot(reflector->frame.z, from) - reflector->offset_m;
    struct pp_vec3 to;
    if (emitter->distant >= 0)
        to = scene->distants[emitter->distant].direction;
    else
        to = pp_vec_unit(pp_vec_sub(
            emitter->middle, pp_vec_along(from, -2.0 * over, reflector->frame.z)));
    *light = pp_frame_in(&reflector->frame, to);
    return over > 0.0 && light->z > 1e-3;
}

bool pp_reflectors_sample(const struct pp_light_scene *scene, int index,
                          struct pp_vec3 from, double u, double v, struct pp_vec3 *to)
{
    const struct pp_reflection *reflection = &scene->reflections[index];
    const struct pp_reflector *reflector = &scene->reflectors[reflection->reflector];
    struct pp_vec3 light, out;
    if (!mirrored_from(scene, reflection, from, &light)
        || !(pp_gloss_sample(&scene->glosses[reflector->gloss], light, u, v, &out)
             > 0.0))
        return false;
    *to = pp_vec_scale(pp_frame_out(&reflector->frame, out), -1.0);
    return true;
}

double pp_reflectors_pdf(const struct pp_light_scene *scene, int index,
                         struct pp_vec3 from, struct pp_vec3 to)
{
    const struct pp_reflection *reflection = &scene->reflections[index];
    const struct pp_reflector *reflector = &scene->reflectors[reflection->reflector];
    struct pp_vec3 light;
    struct pp_vec3 out = pp_vec_scale(pp_frame_in(&reflector->frame, to), -1.0);
    if (!(out.z > 0.0) || !mirrored_from(scene, reflection, from, &light))
        return 0.0;
    return reflection->chance
           * pp_gloss_pdf(&scene->glosses[reflector->gloss], light, out);
}
