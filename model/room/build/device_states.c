/* device_states.c - see device_states.h. */
#include "model/room/build/device_states.h"

#include <stdlib.h>
#include <string.h>

#include "model/light/slats/blind.h"

bool pp_device_states_exist(const struct pp_world *world)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].device.kind != PP_DEVICE_NONE)
            return true;
    return false;
}

/* A copy of the world whose openings can be changed. */
static struct pp_world *copy_of_world(const struct pp_world *world)
{
    size_t count = (size_t)world->opening_count;
    struct pp_world *copy = malloc(sizeof *copy);
    struct pp_opening *openings = malloc((count + 1) * sizeof *openings);
    if (!copy || !openings) {
        free(copy);
        free(openings);
        return NULL;
    }
    *copy = *world;
    if (count > 0)
        memcpy(openings, world->openings, count * sizeof *openings);
    copy->openings = openings;
    for (size_t i = 0; i < count; i++)
        if (openings[i].blind)
            openings[i].blind->holders++;
    return copy;
}

static void remove_device(struct pp_opening *opening)
{
    if (opening->device.kind == PP_DEVICE_NONE)
        return;
    pp_blind_release(opening->blind);
    opening->blind = NULL;
    opening->scatter = NULL;
    opening->glass = opening->uncovered;
    opening->device = (struct pp_window_device){.kind = PP_DEVICE_NONE};
}

enum pp_status pp_device_states_open(struct pp_world **open,
                                     const struct pp_world *world, struct pp_error *err)
{
    *open = copy_of_world(world);
    if (!*open)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count; i++)
        remove_device(&(*open)->openings[i]);
    return PP_OK;
}

void pp_device_states_destroy(struct pp_world *state)
{
    if (!state)
        return;
    for (int i = 0; i < state->opening_count; i++)
        pp_blind_release(state->openings[i].blind);
    free(state->openings);
    free(state);
}
