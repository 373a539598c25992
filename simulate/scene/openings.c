/* openings.c - the openings of a world as targets, properties of their visibility that
 * save rays, and the choice among openings. */
#include "simulate/scene/openings.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "simulate/sampling/sample_discrete.h"
#include "simulate/scene/light_scene_parts.h"

static bool is_unobstructed(const struct pp_world *world,
                            const struct pp_opening *opening)
{
    for (int i = 0; i < world->surface_count; i++)
        if (!pp_polygon_is_before(&world->surfaces[i].outline, &opening->outer))
            return false;
    for (int i = 0; i < world->opening_count; i++)
        if (!pp_polygon_is_before(&world->openings[i].outer, &opening->outer))
            return false;
    for (int i = 0; i < world->outer_pane_count; i++)
        if (!pp_polygon_is_before(&world->outer_panes[i].outline, &opening->outer))
            return false;
    return true;
}

/* True if any opening has a reveal. From points inside a reveal, its sides may hide any
 * pane. */
static bool has_reveals(const struct pp_world *world)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].reveal_m > 0.0)
            return true;
    return false;
}

struct pp_target pp_openings_target(const struct pp_opening *opening,
                                    struct pp_vec3 centre)
{
    const struct pp_polygon *outer = &opening->outer;
    struct pp_target target = {.normal = outer->normal,
                               .area_m2 = outer->area_m2,
                               .rectangle = opening->rectangle,
                               .along = opening->along,
                               .up = opening->up,
                               .width_m = opening->width_m,
                               .height_m = opening->height_m};
    double right = DBL_MAX, top = DBL_MAX;
    struct pp_vec3 base = outer->vertices[0], sum = {0.0, 0.0, 0.0};
    for (int i = 0; i < outer->count; i++) {
        struct pp_vec3 v = pp_vec_sub(outer->vertices[i], base);
        right = fmin(right, pp_vec_dot(v, opening->along));
        top = fmin(top, pp_vec_dot(v, opening->up));
        sum = pp_vec_add(sum, v);
    }
    base = pp_vec_sub(base, centre);
    target.corner =
        pp_vec_along(pp_vec_along(base, right, opening->along), top, opening->up);
    target.middle = pp_vec_along(base, 1.0 / outer->count, sum);
    return target;
}

enum pp_status pp_openings_find(struct pp_light_scene *scene,
                                const struct pp_triangles *triangles, int first,
                                struct pp_error *err)
{
    const struct pp_world *world = scene->world;
    size_t own = (size_t)(triangles->count - first);
    bool convex = world->opening_count > 0 && pp_convex_room_is(world);
    scene->has_niches = has_reveals(world);
    bool seen_by_all = convex && !scene->has_niches;
    scene->panes = calloc((size_t)world->opening_count + 1, sizeof *scene->panes);
    scene->pane_triangles = calloc(own + 1, sizeof *scene->pane_triangles);
    if (!scene->panes || !scene->pane_triangles)
        return pp_fail_memory(err);
    scene->pane_count = world->opening_count;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        scene->panes[i] =
            (struct pp_pane){.target = pp_openings_target(opening, scene->centre),
                             .opening = opening,
                             .part = world->surface_count + i,
                             .seen_by_all = seen_by_all,
                             .unobstructed = is_unobstructed(world, opening),
                             .sides = {-1, -1, -1, -1}};
        scene->panes[i].mouth = scene->panes[i].target;
    }
    if (own > 0)
        memcpy(scene->pane_triangles, triangles->corners + first,
               own * sizeof *scene->pane_triangles);
    for (size_t i = 0; i < own; i++) {
        int part = triangles->facet_of[(size_t)first + i];
        struct pp_target *target = &scene->panes[part - world->surface_count].target;
        if (!target->triangles)
            target->triangles = &scene->pane_triangles[i];
        target->triangle_count++;
    }
    return PP_OK;
}

/* The openings that a viewer chooses from. */
struct pane_choice {
    const struct pp_light_scene *scene;
    const struct pp_openings_viewer *viewer;
};

static double importance_of(const void *of, int pane)
{
    const struct pane_choice *choice = of;
    const struct pp_openings_viewer *viewer = choice->viewer;
    return pp_sample_polygon_importance(
        pp_openings_aim(&choice->scene->panes[pane], viewer->mouths), viewer->point,
        viewer->normal, viewer->brightness);
}

static void find_shares(struct pp_openings_shares *shares,
                        const struct pane_choice *choice)
{
    const struct pp_openings_viewer *viewer = choice->viewer;
    if (pp_vec_same(shares->point, viewer->point)
        && pp_vec_same(shares->normal, viewer->normal)
        && shares->mouths == viewer->mouths)
        return;
    shares->point = viewer->point;
    shares->normal = viewer->normal;
    shares->mouths = viewer->mouths;
    for (int i = 0; i < choice->scene->pane_count; i++)
        shares->of[i] = importance_of(choice, i);
}

int pp_openings_choose(const struct pp_light_scene *scene,
                       const struct pp_openings_viewer *viewer,
                       struct pp_openings_shares *shares, double u, double *probability)
{
    if (scene->pane_count == 1) {
        const struct pp_target *aim = pp_openings_aim(&scene->panes[0], viewer->mouths);
        *probability = 1.0;
        return pp_sample_polygon_in_sight(aim, viewer->point, viewer->normal) ? 0 : -1;
    }
    struct pane_choice choice = {scene, viewer};
    if (scene->pane_count > PP_OPENINGS_KEPT)
        return pp_sample_discrete_of(importance_of, &choice, scene->pane_count,
                                     PP_SAMPLE_DISCRETE_UNIFORM, u, probability);
    find_shares(shares, &choice);
    return pp_sample_discrete_defensive(shares->of, scene->pane_count, u, probability);
}

double pp_openings_angular_size(const struct pp_pane *pane, struct pp_vec3 from)
{
    struct pp_vec3 to = pp_vec_sub(pane->target.middle, from);
    return sqrt(pane->target.area_m2 / pp_vec_dot(to, to));
}
