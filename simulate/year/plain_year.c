/* plain_year.c - see plain_year.h. */
#include "simulate/year/plain_year.h"

#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/year/sun_on_surface.h"
#include "simulate/year/year_path.h"

struct pp_plain_year {
    const struct pp_light_scene *scene;
    const struct pp_environment *environment;
    const struct pp_receiver *receivers;
    const int *group_of_opening;
    int group_count, paths;
    uint64_t seed;
    struct pp_sobol sobol;
};

/* theory: plain year */
/* The events of a point's paths in one randomisation. */
struct event_list {
    int count, capacity;
    struct kept_event {
        enum { MET_SKY, MET_COLUMN, MET_SUN, MET_PANE } kind;
        int group;  /* group of the opening through which the path left; 0: none */
        int column; /* column of light, for ground and skylines */
        double weight;
        struct pp_vec3 u;       /* direction of sky */
        struct pp_lit_point at; /* point lit by the sun */
        int opening, leaving;   /* of a pane lit by the sun */
    } * list;
    const struct pp_plain_year *plain;
    int horizontal_column;
    bool out_of_memory;
};

static void keep(struct event_list *events, const struct pp_year_event *event,
                 struct kept_event kept)
{
    if (pp_array_reserve(&events->list, &events->capacity, events->count + 1,
                         sizeof *events->list, NULL)
        != PP_OK) {
        events->out_of_memory = true;
        return;
    }
    kept.group =
        event->opening >= 0 ? events->plain->group_of_opening[event->opening] : 0;
    kept.weight = event->weight / events->plain->paths;
    events->list[events->count++] = kept;
}

static void keep_sky(void *data, const struct pp_year_event *event)
{
    keep(data, event, (struct kept_event){.kind = MET_SKY, .u = event->u});
}

static void keep_horizontal(void *data, const struct pp_year_event *event)
{
    struct event_list *events = data;
    keep(events, event,
         (struct kept_event){.kind = MET_COLUMN, .column = events->horizontal_column});
}

static void keep_skyline(void *data, const struct pp_year_event *event)
{
    struct event_list *events = data;
    keep(events, event,
         (struct kept_event){.kind = MET_COLUMN,
                             .column = events->horizontal_column + 1 + event->far});
}

static void keep_lit(void *data, const struct pp_year_event *event)
{
    keep(data, event, (struct kept_event){.kind = MET_SUN, .at = event->at});
}

static void keep_pane_sun(void *data, const struct pp_year_event *event)
{
    keep(data, event,
         (struct kept_event){.kind = MET_PANE,
                             .at = event->at,
                             .opening = event->opening,
                             .leaving = event->leaving});
}

static void follow_paths(const struct pp_plain_year *plain, int receiver, int batch,
                         struct event_list *events)
{
    const struct pp_receiver *from = &plain->receivers[receiver];
    const struct pp_year_sink sink = {.data = events,
                                      .sky = keep_sky,
                                      .skyline = keep_skyline,
                                      .horizontal = keep_horizontal,
                                      .lit = keep_lit,
                                      .pane_sun = keep_pane_sun};
    struct pp_path_walk walk = {.scene = plain->scene,
                                .environment = plain->environment};
    struct pp_lit_point at = {pp_vec_sub(from->position, plain->scene->centre),
                              from->normal, PP_INDOORS};
    uint64_t place = pp_hash_vec(pp_hash_vec(0, from->position), from->normal);
    uint64_t seed = pp_hash(pp_hash(plain->seed, (uint64_t)batch), place);
    pp_sobol_sequence_init(&walk.sequence, &plain->sobol, seed);
    events->count = 0;
    for (int i = 0; i < plain->paths; i++) {
        walk.index = (uint32_t)i;
        walk.vertex = 0;
        pp_year_path_openings(&walk, &sink, &at);
        pp_year_path_lobe(&walk, &sink, &at);
    }
}

/* The light of one event in one hour (lx), and the group it belongs to. */
static double light_of(const struct pp_plain_year *plain,
                       const struct kept_event *event,
                       const struct pp_light_columns *light, bool by_patch, int hour,
                       int *group)
{
    const struct pp_perez_sky *sky = &light->skies[hour];
    int opening;
    *group = event->group;
    switch (event->kind) {
    case MET_SKY:
        if (by_patch)
            return event->weight
                   * pp_light_columns_at(
                       light, pp_sky_patches_of(&light->patches, event->u), hour);
        return event->weight * pp_perez_sky_luminance(sky, event->u);
    case MET_COLUMN:
        return event->weight * pp_light_columns_at(light, event->column, hour);
    case MET_SUN:
    case MET_PANE:
        break;
    }
    if (!(sky->direct_lx > 0.0))
        return 0.0;
    double share = pp_sun_on_surface(plain->scene, &event->at, sky->sun, &opening);
    if (share > 0.0 && opening >= 0)
        *group = plain->group_of_opening[opening];
    if (share > 0.0 && event->kind == MET_PANE)
        share *= pp_sun_on_surface_scattered(
            &plain->scene->world->openings[event->opening], sky->sun, event->leaving);
    return event->weight * share * sky->direct_lx;
}
/* theory: end */

enum pp_status pp_plain_year_point(const struct pp_plain_year *plain, int receiver,
                                   const struct pp_light_columns *light, bool by_patch,
                                   struct pp_year_point *point, struct pp_error *err)
{
    size_t step = (size_t)light->tiles * PP_LIGHT_LANES;
    size_t all = (size_t)plain->group_count * PP_YEAR_BATCHES * step;
    struct event_list events = {.plain = plain,
                                .horizontal_column = light->patches.count};
    memset(point->sky, 0, all * sizeof *point->sky);
    memset(point->sun, 0, all * sizeof *point->sun);
    for (int b = 0; b < PP_YEAR_BATCHES; b++) {
        follow_paths(plain, receiver, b, &events);
        for (int i = 0; i < events.count; i++)
            for (int t = 0; t < light->count; t++) {
                int group;
                double lx =
                    light_of(plain, &events.list[i], light, by_patch, t, &group);
                size_t row = (size_t)(group * PP_YEAR_BATCHES + b) * step + (size_t)t;
                (events.list[i].kind >= MET_SUN ? point->sun : point->sky)[row] +=
                    (float)lx;
            }
    }
    free(events.list);
    return events.out_of_memory ? pp_fail_memory(err) : PP_OK;
}

enum pp_status pp_plain_year_create(struct pp_plain_year **plain,
                                    const struct pp_light_scene *scene,
                                    const struct pp_environment *environment,
                                    const struct pp_receiver *receivers,
                                    const int *group_of_opening, int group_count,
                                    int paths, uint64_t seed, struct pp_error *err)
{
    *plain = calloc(1, sizeof **plain);
    if (!*plain)
        return pp_fail_memory(err);
    **plain = (struct pp_plain_year){.scene = scene,
                                     .environment = environment,
                                     .receivers = receivers,
                                     .group_of_opening = group_of_opening,
                                     .group_count = group_count,
                                     .paths = paths,
                                     .seed = seed};
    pp_sobol_init(&(*plain)->sobol);
    return PP_OK;
}

void pp_plain_year_destroy(struct pp_plain_year *plain)
{
    free(plain);
}
