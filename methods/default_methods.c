/* default_methods.c - tests whether the internal method of each pair covers the room;
 * the direct method, exact, covers all rooms. */
#include "methods/default_methods.h"

#include <stdbool.h>
#include <stdio.h>

#include "methods/method.h"

static const struct {
    const char *name;
    const struct pp_method *internal;
} pairs[] = {{"exact+bre", &pp_method_bre},
             {"exact+split-flux", &pp_method_split_flux}};

/* Returns true if the method does not cover the room for a receiver (NULL: the room as
 * a whole), and writes the reason. */
static bool is_refused(char *why, size_t size, const struct pp_method *method,
                       const struct pp_world *world,
                       const struct pp_outside_light *light,
                       const struct pp_receiver *receiver)
{
    const char *reason = pp_method_refuses_room(method, world, light, receiver);
    if (reason) {
        snprintf(why, size, "%s: %s", method->name, reason);
        return true;
    }
    for (int i = 0; i < world->opening_count; i++) {
        reason = pp_method_refuses_opening(method, world, light, &world->openings[i],
                                           receiver);
        if (!reason)
            continue;
        snprintf(why, size, "%s: %s %s %s", method->name,
                 pp_world_kind(world, world->openings[i].line),
                 world->openings[i].label, reason);
        return true;
    }
    return false;
}

struct pp_default_methods pp_default_methods(const struct pp_world *world,
                                             const struct pp_outside_light *light,
                                             const struct pp_receiver *receivers,
                                             int count)
{
    struct pp_default_methods pair = {.name = pairs[0].name};
    const struct pp_method *first = pairs[0].internal;
    bool refused = is_refused(pair.why, sizeof pair.why, first, world, light, NULL);
    for (int i = 0; i < count && !refused; i++)
        refused =
            is_refused(pair.why, sizeof pair.why, first, world, light, &receivers[i]);
    if (refused) {
        pair.instead = pairs[0].name;
        pair.name = pairs[1].name;
    }
    return pair;
}
