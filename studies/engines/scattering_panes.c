/* scattering_panes.c - see scattering_panes.h. */
#include "studies/engines/scattering_panes.h"

enum pp_status pp_scattering_panes_refuse(const struct pp_world *world,
                                          const char *engine, struct pp_error *err)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].scatter)
            return pp_fail(err, PP_BAD_INPUT,
                           "engine %s: %s %s has a pane that scatters light by "
                           "direction, which this engine cannot follow; expected the "
                           "engine path or cache",
                           engine, pp_world_kind(world, world->openings[i].line),
                           world->openings[i].label);
    return PP_OK;
}
