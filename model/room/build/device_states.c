/* device_states.c - see device_states.h. */
#include "model/room/build/device_states.h"

#include <stdlib.h>
#include <string.h>

#include "model/light/slats/blind_follow.h"
#include "model/room/build/devices.h"

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

enum pp_status pp_device_states_copy(struct pp_world **copy,
                                     const struct pp_world *world, struct pp_error *err)
{
    *copy = copy_of_world(world);
    return *copy ? PP_OK : pp_fail_memory(err);
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

/* ---- slats that follow the sun ---- */

bool pp_device_states_follows(const struct pp_opening *opening)
{
    return opening->blind && opening->device.follows_sun;
}

double pp_device_states_tilt(const struct pp_opening *opening, struct pp_vec3 sun)
{
    struct pp_vec3 travel = pp_vec_scale(sun, -1.0);
    struct pp_vec3 inwards = opening->inner.normal;
    if (!(sun.z > 0.0) || !(pp_vec_dot(travel, inwards) > 0.0))
        return 0.0;
    double profile = pp_slats_profile(
        travel, inwards, opening->device.vertical ? opening->along : opening->up);
    return pp_blind_follow_tilt(&opening->device.slats, profile);
}

/* Turns the slats of opening i of a world. The data of the blind are shared with an
 * earlier opening that has the same slats. */
static enum pp_status turn_slats(struct pp_world *world, int i, double tilt_rad,
                                 struct pp_error *err)
{
    struct pp_opening *opening = &world->openings[i];
    struct pp_blind *old = opening->blind;
    opening->device.slats.tilt_rad = tilt_rad;
    enum pp_status status = pp_devices_hang(opening, world->openings, i, err);
    if (status == PP_OK)
        pp_blind_release(old);
    else
        opening->blind = old;
    return status;
}

enum pp_status pp_device_states_turn(struct pp_world *world, bool has_sun,
                                     struct pp_vec3 sun, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++)
        if (pp_device_states_follows(&world->openings[i]))
            status = turn_slats(
                world, i,
                has_sun ? pp_device_states_tilt(&world->openings[i], sun) : 0.0, err);
    return status;
}

/* Gives the blind of opening i a blind for the sun: that of the other state, or a new
 * one. */
static enum pp_status add_blind_for_sun(struct pp_world *state, int i,
                                        const struct pp_world *other,
                                        struct pp_error *err)
{
    struct pp_opening *opening = &state->openings[i];
    struct pp_blind *blind = opening->blind;
    if (blind->for_sun)
        return PP_OK; /* shared with an earlier opening */
    enum pp_status status = PP_OK;
    if (other) {
        blind->for_sun = other->openings[i].blind->for_sun;
        blind->for_sun->holders++;
    } else {
        status =
            pp_blind_follow_create(&blind->for_sun, &opening->device, &opening->glass,
                                   pp_devices_is_upright(opening), err);
    }
    if (status == PP_OK)
        blind->scatter.for_sun = &blind->for_sun->scatter;
    return status;
}

enum pp_status pp_device_states_tilted(struct pp_world **state,
                                       const struct pp_world *world, double tilt_rad,
                                       const struct pp_world *other,
                                       struct pp_error *err)
{
    *state = copy_of_world(world);
    enum pp_status status = *state ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        if (!pp_device_states_follows(&world->openings[i]))
            continue;
        status = turn_slats(*state, i, tilt_rad, err);
        if (status == PP_OK)
            status = add_blind_for_sun(*state, i, other, err);
    }
    if (status != PP_OK) {
        pp_device_states_destroy(*state);
        *state = NULL;
    }
    return status;
}
