/* outside_parts.c - see outside_parts.h. */
#include "model/room/outside/outside_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/tolerance.h"

enum pp_status pp_outside_parts_add_block(struct pp_room *room,
                                          const struct pp_block *block,
                                          struct pp_error *err)
{
    struct pp_block added = *block;
    added.name = block->name ? strdup(block->name) : NULL;
    added.is_of_site = true;
    added.corner = pp_placement_to_room(&room->placement, block->corner);
    added.rotate_rad -= room->placement.rotate_rad;
    if ((block->name && !added.name)
        || pp_array_append(&room->blocks, room->block_count, sizeof *room->blocks, NULL)
               != PP_OK) {
        free(added.name);
        return pp_fail_memory(err);
    }
    room->blocks[room->block_count++] = added;
    return PP_OK;
}

enum pp_status pp_outside_parts_add_surface(struct pp_room *room,
                                            const struct pp_surface_part *part,
                                            const struct pp_vec3 *vertices, int count,
                                            struct pp_error *err)
{
    struct pp_surface_part added;
    enum pp_status status =
        pp_room_parts_copy_surface(&added, part, vertices, count, err);
    if (status != PP_OK)
        return status;
    for (int i = 0; i < count; i++)
        added.vertices.list[i] = pp_placement_to_room(&room->placement, vertices[i]);
    status = pp_array_append(&room->surfaces, room->surface_count,
                             sizeof *room->surfaces, err);
    if (status == PP_OK)
        room->surfaces[room->surface_count++] = added;
    else
        pp_room_parts_clear_surface(&added);
    return status;
}

enum pp_status pp_outside_parts_add_mesh(struct pp_room *room,
                                         const struct pp_mesh_part *part,
                                         struct pp_error *err)
{
    struct pp_mesh_part added = *part;
    added.name = part->name ? strdup(part->name) : NULL;
    added.path = strdup(part->path);
    added.file->holders++;
    added.is_of_site = true;
    added.corner = pp_placement_to_room(&room->placement, part->corner);
    added.rotate_rad -= room->placement.rotate_rad;
    if ((part->name && !added.name) || !added.path
        || pp_array_append(&room->meshes, room->mesh_count, sizeof *room->meshes, NULL)
               != PP_OK) {
        pp_room_parts_clear_mesh(&added);
        return pp_fail_memory(err);
    }
    room->meshes[room->mesh_count++] = added;
    return PP_OK;
}

enum pp_status pp_outside_parts_add_tree(struct pp_room *room,
                                         const struct pp_tree_part *part,
                                         struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&room->trees, room->tree_count, sizeof *room->trees, err);
    if (status != PP_OK)
        return status;
    struct pp_tree_part *added = &room->trees[room->tree_count++];
    *added = *part;
    added->tree.foot = pp_placement_to_room(&room->placement, part->tree.foot);
    return PP_OK;
}

enum pp_status pp_outside_parts_add_garden(struct pp_room *room,
                                           const struct pp_garden_part *part,
                                           struct pp_error *err)
{
    int count = part->vertices.count;
    struct pp_garden_part added = *part;
    added.name = part->name ? strdup(part->name) : NULL;
    added.vertices = (struct pp_vertices){malloc(count * sizeof *part->vertices.list),
                                          malloc(count * sizeof(int)), count};
    if (!added.vertices.list || !added.vertices.lines || (part->name && !added.name)
        || pp_array_append(&room->gardens, room->garden_count, sizeof *room->gardens,
                           NULL)
               != PP_OK) {
        pp_room_parts_clear_garden(&added);
        return pp_fail_memory(err);
    }
    for (int i = 0; i < count; i++) {
        added.vertices.list[i] =
            pp_placement_to_room(&room->placement, part->vertices.list[i]);
        added.vertices.lines[i] = part->vertices.lines[i];
    }
    room->gardens[room->garden_count++] = added;
    return PP_OK;
}

enum pp_status pp_outside_parts_add_skyline(struct pp_room *room,
                                            const struct pp_skyline_part *part,
                                            struct pp_error *err)
{
    struct pp_skyline_part added = *part;
    added.wall = strdup(part->wall);
    if (!added.wall
        || pp_array_append(&room->skylines, room->skyline_count, sizeof *room->skylines,
                           NULL)
               != PP_OK) {
        free(added.wall);
        return pp_fail_memory(err);
    }
    room->skylines[room->skyline_count++] = added;
    return PP_OK;
}

bool pp_outside_parts_has_block(const struct pp_room *room,
                                const struct pp_block *block)
{
    struct pp_vec3 corner = pp_placement_to_room(&room->placement, block->corner);
    double rotate_rad = block->rotate_rad - room->placement.rotate_rad;
    for (int i = 0; i < room->block_count; i++) {
        const struct pp_block *own = &room->blocks[i];
        if (pp_vec_length(pp_vec_sub(own->corner, corner)) < PP_SAME_M
            && fabs(own->width_m - block->width_m) < PP_SAME_M
            && fabs(own->depth_m - block->depth_m) < PP_SAME_M
            && fabs(own->height_m - block->height_m) < PP_SAME_M
            && cos(own->rotate_rad - rotate_rad) > 1.0 - PP_LEVEL_RAD)
            return true;
    }
    return false;
}

bool pp_outside_parts_has_surface(const struct pp_room *room,
                                  const struct pp_surface_part *part)
{
    const struct pp_vertices *its = &part->vertices;
    for (int i = 0; i < room->surface_count; i++) {
        const struct pp_vertices *own = &room->surfaces[i].vertices;
        bool same = own->count == its->count;
        for (int k = 0; k < its->count && same; k++) {
            struct pp_vec3 corner =
                pp_placement_to_room(&room->placement, its->list[k]);
            same = pp_vec_length(pp_vec_sub(own->list[k], corner)) < PP_SAME_M;
        }
        if (same)
            return true;
    }
    return false;
}
