/* named_block.c - see named_block.h. */
#include "model/room/outside/named_block.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool is_called(const char *own, const char *name)
{
    return own && strcmp(own, name) == 0;
}

void pp_named_block_reach(double reach_m[2], const struct pp_room *room, int line)
{
    reach_m[0] = INFINITY;
    reach_m[1] = -INFINITY;
    for (int i = 0; i < room->surface_count; i++)
        for (int k = 0;
             k < room->surfaces[i].vertices.count && room->surfaces[i].is_of_block
             && room->surfaces[i].line == line;
             k++) {
            double z = room->surfaces[i].vertices.list[k].z;
            reach_m[0] = fmin(reach_m[0], z);
            reach_m[1] = fmax(reach_m[1], z);
        }
}

int pp_named_block_find(const struct pp_room *room, const char *name, int *box)
{
    int line = 0;
    *box = -1;
    for (int i = 0; i < room->block_count; i++)
        if (is_called(room->blocks[i].name, name)) {
            if (line)
                return 0;
            line = room->blocks[i].line;
            *box = i;
        }
    for (int i = 0; i < room->surface_count; i++)
        if (room->surfaces[i].is_of_block && is_called(room->surfaces[i].name, name)) {
            if (line && line != room->surfaces[i].line)
                return 0;
            line = room->surfaces[i].line;
        }
    return line;
}

bool pp_named_block_take_out(struct pp_block *like, struct pp_room *room,
                             const char *name)
{
    int kept = 0;
    bool found = false;
    for (int i = 0; i < room->surface_count; i++) {
        struct pp_surface_part *part = &room->surfaces[i];
        if (!part->is_of_block || !is_called(part->name, name)) {
            room->surfaces[kept++] = *part;
            continue;
        }
        *like = (struct pp_block){.reflectance = part->reflectance,
                                  .finish = part->finish,
                                  .state = part->state,
                                  .line = part->line};
        found = true;
        pp_room_parts_clear_surface(part);
    }
    room->surface_count = kept;
    kept = 0;
    for (int i = 0; i < room->block_count; i++) {
        if (!is_called(room->blocks[i].name, name)) {
            room->blocks[kept++] = room->blocks[i];
            continue;
        }
        free(room->blocks[i].name);
        *like = room->blocks[i];
        like->name = NULL;
        found = true;
    }
    room->block_count = kept;
    return found;
}
