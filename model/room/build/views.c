/* views.c - see views.h. */
#include "model/room/build/views.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/room/position.h"

/* Limit on views, since each one is simulated separately. */
enum { VIEWS_MOST = 1000 };

enum pp_status pp_build_views(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    struct pp_world *world = r->world;
    world->views = calloc((size_t)room->view_count + 1, sizeof *world->views);
    if (!world->views)
        return pp_fail_memory(err);
    if (room->view_count > VIEWS_MOST) {
        pp_mistakes_add(r->mistakes, room->views[VIEWS_MOST].line,
                        "view: the room has %d views; expected at most %d",
                        room->view_count, VIEWS_MOST);
        return PP_OK;
    }
    for (int i = 0; i < room->view_count; i++) {
        const struct pp_view_part *part = &room->views[i];
        struct pp_world_view view = pp_position_view(
            world, pp_vec(part->x, part->y, part->z), part->bearing_rad);
        view.line = part->line;
        if (!isfinite(part->x) || !isfinite(part->y) || !isfinite(part->z)
            || !isfinite(part->bearing_rad))
            continue;
        const char *fault =
            r->watertight ? pp_position_receiver_fault(world, view.eye, view.direction)
                          : NULL;
        if (fault)
            pp_mistakes_add(r->mistakes, part->line,
                            "view: (%g, %g, %g) %s; expected an eye in the free space "
                            "of the room",
                            part->x, part->y, part->z, fault);
        if (part->name && !(view.name = strdup(part->name)))
            return pp_fail_memory(err);
        world->views[world->view_count++] = view;
    }
    return PP_OK;
}
