/* loose.c - opaque polygons inside the room or outside it. */
#include <stdlib.h>

#include "model/resolve.h"
#include "model/tolerance.h"

enum pp_status pp_resolve_loose(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    for (int i = 0; i < room->surface_count; i++) {
        const struct pp_surface_part *part = &room->surfaces[i];
        if (!pp_resolve_good_outline(r, "surface", part->line, &part->vertices)
            || !r->closed)
            continue;
        struct pp_vec3 middle = {0.0, 0.0, 0.0};
        for (int k = 0; k < part->vertices.count; k++)
            middle =
                pp_along(middle, 1.0 / part->vertices.count, part->vertices.list[k]);
        struct pp_surface surface = {.role = PP_LOOSE,
                                     .inside = pp_world_contains(r->world, middle),
                                     .front = part->reflectance,
                                     .back = part->reflectance,
                                     .exitance = part->exitance,
                                     .owner = -1,
                                     .line = part->line};
        if (pp_resolve_add_face(r, surface, part->vertices.list, part->vertices.count,
                                err)
            != PP_OK)
            return PP_SYSTEM;
    }
    return PP_OK;
}
