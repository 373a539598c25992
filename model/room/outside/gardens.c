/* gardens.c - see gardens.h. */
#include "model/room/outside/gardens.h"

#include <stdlib.h>
#include <string.h>

#include "model/room/build/outline.h"

static enum pp_status add_garden(struct pp_resolver *r,
                                 const struct pp_garden_part *part,
                                 struct pp_error *err)
{
    struct pp_world *world = r->world;
    struct pp_garden *garden = &world->gardens[world->garden_count];
    *garden = (struct pp_garden){.line = part->line};
    enum pp_status status =
        pp_polygon_of(&garden->outline, part->vertices.list, part->vertices.count, err);
    if (status != PP_OK)
        return status;
    world->garden_count++;
    for (int i = 0; i < garden->outline.count; i++)
        garden->outline.vertices[i].z = world->ground_level_m;
    if (garden->outline.normal.z < 0.0)
        for (int i = 0, k = garden->outline.count - 1; i < k; i++, k--) {
            struct pp_vec3 kept = garden->outline.vertices[i];
            garden->outline.vertices[i] = garden->outline.vertices[k];
            garden->outline.vertices[k] = kept;
        }
    pp_polygon_measure(&garden->outline);
    garden->name = part->name ? strdup(part->name) : NULL;
    return part->name && !garden->name ? pp_fail_memory(err) : PP_OK;
}

enum pp_status pp_build_gardens(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    r->world->gardens =
        calloc((size_t)room->garden_count + 1, sizeof(struct pp_garden));
    if (!r->world->gardens)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    for (int i = 0; i < room->garden_count && status == PP_OK; i++) {
        const struct pp_garden_part *part = &room->gardens[i];
        if (pp_build_outline_is_good(r, "garden", part->line, &part->vertices))
            status = add_garden(r, part, err);
    }
    return status;
}
