/* pane_sun.c - see pane_sun.h. */
#include "simulate/year/pane_sun.h"

#include <stdlib.h>

#include "simulate/scene/light_scene_parts.h"
#include "simulate/year/sun_on_surface.h"

int pp_pane_sun_classes(const struct pp_light_scene *scene)
{
    int most = 0;
    for (int i = 0; i < scene->world->opening_count; i++) {
        const struct pp_pane_scatter *scatter = scene->world->openings[i].scatter;
        if (scatter && scatter->class_count > most)
            most = scatter->class_count;
    }
    return most;
}

static void find_panes(struct pp_pane_sun *panes, const struct pp_year_task *task)
{
    const struct pp_world *world = task->scene->world;
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].scatter)
            panes->panes[task->group_of_opening[i]] = &world->openings[i];
}

enum pp_status pp_pane_sun_init(struct pp_pane_sun *panes,
                                const struct pp_year_task *task,
                                const struct pp_light_columns *light,
                                struct pp_error *err)
{
    *panes =
        (struct pp_pane_sun){.class_count = task->class_count, .hours = light->count};
    if (task->class_count == 0)
        return PP_OK;
    size_t groups = (size_t)task->group_count, classes = (size_t)task->class_count;
    panes->panes = calloc(groups, sizeof *panes->panes);
    panes->btdf = calloc(groups * (size_t)light->count * classes + 1, sizeof(float));
    if (!panes->panes || !panes->btdf)
        return pp_fail_memory(err);
    find_panes(panes, task);
    for (size_t g = 0; g < groups; g++)
        for (int t = 0; t < light->count && panes->panes[g]; t++) {
            const struct pp_perez_sky *sky = &light->skies[t];
            float *btdf =
                panes->btdf + (g * (size_t)light->count + (size_t)t) * classes;
            for (int k = 0;
                 sky->direct_lx > 0.0 && k < panes->panes[g]->scatter->class_count; k++)
                btdf[k] =
                    (float)pp_sun_on_surface_scattered(panes->panes[g], sky->sun, k);
        }
    return PP_OK;
}

void pp_pane_sun_clear(struct pp_pane_sun *panes)
{
    free(panes->panes);
    free(panes->btdf);
    *panes = (struct pp_pane_sun){.class_count = 0};
}

float pp_pane_sun_share(const struct pp_pane_sun *panes, const float *coefficients,
                        int group, int hour)
{
    const float *btdf = panes->btdf
                        + ((size_t)group * (size_t)panes->hours + (size_t)hour)
                              * (size_t)panes->class_count;
    float sum = 0.0f;
    for (int k = 0; k < panes->class_count; k++)
        sum += coefficients[k] * btdf[k];
    return sum;
}

double pp_pane_sun_lx(const struct pp_year_task *task,
                      const struct pp_year_batch *batch, int group,
                      const struct pp_perez_sky *sky)
{
    double share = 0.0;
    int opening;
    const struct pp_lit_point *points =
        batch->pane_points + group * PP_YEAR_PANE_POINTS;
    for (int i = 0; i < PP_YEAR_PANE_POINTS && sky->direct_lx > 0.0; i++)
        share += pp_sun_on_surface(task->scene, &points[i], sky->sun, &opening);
    return sky->direct_lx * share / PP_YEAR_PANE_POINTS;
}
