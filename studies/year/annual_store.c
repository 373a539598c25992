/* annual_store.c - hashes everything that the coefficients depend on. */
#include "studies/year/annual_store.h"

#include <string.h>

#include "model/base/text.h"
#include "simulate/sampling/hash.h"

static struct pp_year_origin origin_of(const struct pp_annual_work *work,
                                       const struct pp_annual_state *state)
{
    const struct pp_annual_options *options = work->options;
    struct pp_year_origin origin = {.room = options->room_number,
                                    .state = state == &work->open   ? 0
                                             : state == &work->bare ? 2
                                                                    : 1,
                                    .scene = pp_light_scene_hash(state->scene),
                                    .light = pp_environment_hash(state->environment),
                                    .north_rad = work->world->north_rad,
                                    .point_count = work->receiver_count,
                                    .group_count = work->groups.count,
                                    .patches = options->patches,
                                    .seed = options->seed};
    for (int x = 0; x < work->receiver_count; x++)
        origin.points =
            pp_hash_vec(pp_hash_vec(origin.points, work->receivers[x].position),
                        work->receivers[x].normal);
    for (int i = 0; i < work->world->opening_count; i++)
        origin.groups = pp_hash(origin.groups, (uint64_t)work->groups.of_opening[i]);
    if (work->world->name)
        snprintf(origin.name, sizeof origin.name, "%s", work->world->name);
    else
        snprintf(origin.name, sizeof origin.name, "room %d", options->room_number + 1);
    return origin;
}

enum pp_status pp_annual_store_begin(struct pp_year_stores *stores,
                                     const struct pp_annual_work *work,
                                     const struct pp_annual_state *state, int *samples,
                                     struct pp_error *err)
{
    const struct pp_annual_options *options = work->options;
    *stores = (struct pp_year_stores){options->stores, options->store_count,
                                      origin_of(work, state)};
    enum pp_status status = PP_OK;
    for (int i = 0; i < stores->count && status == PP_OK; i++)
        status = pp_year_store_check(stores->list[i], &stores->origin, samples, err);
    return status;
}

void pp_annual_store_record(char *text, size_t room,
                            const struct pp_year_origin *origin)
{
    char name[sizeof origin->name];
    size_t length = strlen(origin->name);
    for (size_t i = 0; i <= length; i++)
        name[i] = origin->name[i] == '\n' ? ' ' : origin->name[i];
    text[0] = '\0';
    pp_text_append(text, room,
                   "ROOM=%s\nPOINTS=%d\nPATCHES=%d\nSAMPLES=%d\nRANDOMISATIONS=%d\n"
                   "SEED=%llu\nNORTH=%g\n",
                   name, origin->point_count, origin->patches, origin->paths,
                   PP_YEAR_BATCHES, (unsigned long long)origin->seed,
                   origin->north_rad / PP_RAD);
    pp_text_append(text, room, "HASHES=%016llx %016llx %016llx %016llx\n",
                   (unsigned long long)origin->scene, (unsigned long long)origin->light,
                   (unsigned long long)origin->points,
                   (unsigned long long)origin->groups);
}
