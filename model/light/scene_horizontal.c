/* scene_horizontal.c - midpoint sums over the hemisphere, in z^2 and azimuth, so that
 * all terms have equal weight on a horizontal plane:
 *
 *     E = pi / (rings turns) sum L(u),   u.z^2 = (i + 1/2) / rings
 */
#include "model/light/scene_horizontal.h"

#include <math.h>
#include <stddef.h>

enum { RINGS = 400, TURNS = 720 };

/* Limit on distant sources; a scene usually has two. */
enum { SOURCES_MOST = 256 };

static bool is_sky(const struct pp_scene_description *scene,
                   const struct pp_shape *shape)
{
    return shape->kind == PP_SHAPE_DISTANT
           && scene->materials[shape->material].emits == PP_EMITS_EXTENDED;
}

/* Distant sources that are skies. */
struct sources {
    const struct pp_scene_description *scene;
    int list[SOURCES_MOST];
    int count;
};

static struct sources sources_of(const struct pp_scene_description *scene)
{
    struct sources sources = {.scene = scene};
    for (int i = 0; i < scene->shape_count && sources.count < SOURCES_MOST; i++)
        if (is_sky(scene, &scene->shapes[i]))
            sources.list[sources.count++] = i;
    return sources;
}

/* Source seen in direction u; if there are several, the narrowest one. NULL: none. */
static const struct pp_shape *seen_in(const struct sources *sources, struct pp_vec3 u)
{
    const struct pp_shape *found = NULL;
    for (int i = 0; i < sources->count; i++) {
        const struct pp_shape *shape = &sources->scene->shapes[sources->list[i]];
        if (pp_vec_dot(u, shape->is.distant.direction)
                >= cos(shape->is.distant.half_angle_rad)
            && (!found
                || shape->is.distant.half_angle_rad < found->is.distant.half_angle_rad))
            found = shape;
    }
    return found;
}

static struct pp_rgb radiance_in(const struct sources *sources, struct pp_vec3 u)
{
    const struct pp_scene_description *scene = sources->scene;
    const struct pp_shape *shape = seen_in(sources, u);
    if (!shape)
        return pp_rgb_grey(0.0);
    const struct pp_material *material = &scene->materials[shape->material];
    if (material->pattern < 0)
        return material->radiance;
    struct pp_pattern pattern = scene->patterns[material->pattern];
    pattern.skyline_count = 0;
    return pp_rgb_scale(material->radiance,
                        pp_scene_description_pattern_value(&pattern, u));
}

static struct pp_rgb quadrature(const struct sources *sources)
{
    struct pp_rgb sum = pp_rgb_grey(0.0);
    for (int i = 0; i < RINGS; i++) {
        double z = sqrt((i + 0.5) / RINGS), r = sqrt(1.0 - z * z);
        for (int k = 0; k < TURNS; k++) {
            double turn = 2.0 * PP_PI * (k + 0.5) / TURNS;
            struct pp_vec3 u = pp_vec(r * cos(turn), r * sin(turn), z);
            sum = pp_rgb_add(sum, radiance_in(sources, u));
        }
    }
    return pp_rgb_scale(sum, PP_PI / ((double)RINGS * TURNS));
}

/* Material of the sky if it is a whole hemisphere of PP_PATTERN_SKY, whose factor is Eh
 * per unit of radiance; else NULL. */
static const struct pp_material *known_sky(const struct pp_scene_description *scene)
{
    const struct pp_shape *whole = NULL;
    for (int i = 0; i < scene->shape_count; i++) {
        const struct pp_shape *shape = &scene->shapes[i];
        if (!is_sky(scene, shape))
            continue;
        const struct pp_vec3 *to = &shape->is.distant.direction;
        bool half = fabs(shape->is.distant.half_angle_rad - PP_PI / 2.0) < 1e-9;
        if (half && to->z <= -1.0)
            continue; /* the ground */
        if (whole || !half || to->z < 1.0)
            return NULL;
        whole = shape;
    }
    const struct pp_material *material =
        whole ? &scene->materials[whole->material] : NULL;
    bool known = material && material->pattern >= 0
                 && scene->patterns[material->pattern].kind == PP_PATTERN_SKY;
    return known ? material : NULL;
}

struct pp_rgb pp_scene_horizontal(const struct pp_scene_description *scene)
{
    const struct pp_material *known = known_sky(scene);
    if (known)
        return pp_rgb_scale(known->radiance, scene->patterns[known->pattern].factor);
    struct sources sources = sources_of(scene);
    return sources.count > 0 ? quadrature(&sources) : pp_rgb_grey(0.0);
}
