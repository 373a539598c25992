/* site_state.c - see site_state.h. */
#include "model/room/outside/site_state.h"

#include <stdlib.h>

bool pp_site_state_has(enum pp_site_state state, enum pp_site_state it)
{
    return it == PP_STATE_BOTH || it == state
           || (it == PP_STATE_PROPOSED && state == PP_STATE_CUMULATIVE);
}

void pp_site_state_keep(struct pp_room *room, enum pp_site_state state)
{
    int kept = 0;
    for (int i = 0; i < room->skyline_count; i++)
        if (pp_site_state_has(state, room->skylines[i].state))
            room->skylines[kept++] = room->skylines[i];
        else
            free(room->skylines[i].wall);
    room->skyline_count = kept;
    kept = 0;
    for (int i = 0; i < room->block_count; i++)
        if (pp_site_state_has(state, room->blocks[i].state))
            room->blocks[kept++] = room->blocks[i];
        else
            free(room->blocks[i].name);
    room->block_count = kept;
    kept = 0;
    for (int i = 0; i < room->surface_count; i++)
        if (pp_site_state_has(state, room->surfaces[i].state))
            room->surfaces[kept++] = room->surfaces[i];
        else
            pp_room_parts_clear_surface(&room->surfaces[i]);
    room->surface_count = kept;
    kept = 0;
    for (int i = 0; i < room->mesh_count; i++)
        if (pp_site_state_has(state, room->meshes[i].state))
            room->meshes[kept++] = room->meshes[i];
        else
            pp_room_parts_clear_mesh(&room->meshes[i]);
    room->mesh_count = kept;
    kept = 0;
    for (int i = 0; i < room->garden_count; i++)
        if (pp_site_state_has(state, room->gardens[i].state))
            room->gardens[kept++] = room->gardens[i];
        else
            pp_room_parts_clear_garden(&room->gardens[i]);
    room->garden_count = kept;
    kept = 0;
    for (int i = 0; i < room->tree_count; i++)
        if (pp_site_state_has(state, room->trees[i].state))
            room->trees[kept++] = room->trees[i];
    room->tree_count = kept;
}

unsigned pp_site_state_set(const struct pp_room *room)
{
    unsigned set = 1u << PP_STATE_BOTH | 1u << room->state;
    for (int i = 0; i < room->skyline_count; i++)
        set |= 1u << room->skylines[i].state;
    for (int i = 0; i < room->block_count; i++)
        set |= 1u << room->blocks[i].state;
    for (int i = 0; i < room->surface_count; i++)
        set |= 1u << room->surfaces[i].state;
    for (int i = 0; i < room->mesh_count; i++)
        set |= 1u << room->meshes[i].state;
    for (int i = 0; i < room->garden_count; i++)
        set |= 1u << room->gardens[i].state;
    for (int i = 0; i < room->tree_count; i++)
        set |= 1u << room->trees[i].state;
    return set;
}
