/* room_parts.c - see room_parts.h. */
#include "model/room/room_parts.h"

#include <stdlib.h>
#include <string.h>

void pp_room_parts_clear_vertices(struct pp_vertices *vertices)
{
    free(vertices->list);
    free(vertices->lines);
    *vertices = (struct pp_vertices){0};
}

void pp_room_parts_clear_garden(struct pp_garden_part *garden)
{
    free(garden->name);
    pp_room_parts_clear_vertices(&garden->vertices);
    *garden = (struct pp_garden_part){0};
}

void pp_room_parts_clear_mesh(struct pp_mesh_part *mesh)
{
    if (mesh->file && --mesh->file->holders == 0) {
        pp_mesh_triangles_clear(&mesh->file->mesh);
        free(mesh->file);
    }
    free(mesh->path);
    free(mesh->name);
    *mesh = (struct pp_mesh_part){0};
}

void pp_room_parts_clear_surface(struct pp_surface_part *surface)
{
    free(surface->name);
    pp_room_parts_clear_vertices(&surface->vertices);
    *surface = (struct pp_surface_part){0};
}

enum pp_status pp_room_parts_copy_surface(struct pp_surface_part *copy,
                                          const struct pp_surface_part *part,
                                          const struct pp_vec3 *vertices, int count,
                                          struct pp_error *err)
{
    *copy = *part;
    copy->name = part->name ? strdup(part->name) : NULL;
    copy->vertices = (struct pp_vertices){malloc((size_t)count * sizeof *vertices),
                                          malloc((size_t)count * sizeof(int)), count};
    if (!copy->vertices.list || !copy->vertices.lines || (part->name && !copy->name)) {
        pp_room_parts_clear_surface(copy);
        return pp_fail_memory(err);
    }
    for (int i = 0; i < count; i++) {
        copy->vertices.list[i] = vertices[i];
        copy->vertices.lines[i] = part->line;
    }
    return PP_OK;
}

void pp_room_parts_clear_plan(struct pp_plan_part *plan)
{
    pp_room_parts_clear_vertices(&plan->vertices);
    for (int i = 0; i < plan->face_count; i++) {
        free(plan->faces[i].name);
        pp_room_parts_clear_vertices(&plan->faces[i].vertices);
    }
    free(plan->faces);
    *plan = (struct pp_plan_part){0};
}

void pp_room_parts_clear(struct pp_room *room)
{
    free(room->name);
    free(room->ref);
    free(room->address);
    pp_sky_words_clear(&room->sky);
    pp_room_parts_clear_plan(&room->plan);
    for (int i = 0; i < room->finish_count; i++)
        free(room->finishes[i].wall);
    for (int i = 0; i < room->opening_count; i++) {
        free(room->openings[i].wall);
        free(room->openings[i].name);
        free(room->openings[i].shades);
        pp_measured_pane_release(room->openings[i].glazing.measured);
        pp_room_parts_clear_vertices(&room->openings[i].vertices);
    }
    for (int i = 0; i < room->skyline_count; i++)
        free(room->skylines[i].wall);
    for (int i = 0; i < room->facade_count; i++)
        free(room->facades[i].wall);
    for (int i = 0; i < room->block_count; i++)
        free(room->blocks[i].name);
    for (int i = 0; i < room->fitting_count; i++)
        free(room->fittings[i].name);
    for (int i = 0; i < room->cover_count; i++) {
        free(room->covers[i].name);
        free(room->covers[i].wall);
    }
    for (int i = 0; i < room->garden_count; i++)
        pp_room_parts_clear_garden(&room->gardens[i]);
    for (int i = 0; i < room->surface_count; i++)
        pp_room_parts_clear_surface(&room->surfaces[i]);
    for (int i = 0; i < room->mesh_count; i++)
        pp_room_parts_clear_mesh(&room->meshes[i]);
    for (int i = 0; i < room->view_count; i++)
        free(room->views[i].name);
    free(room->views);
    free(room->within.path);
    free(room->within.window);
    pp_world_destroy(room->within.world);
    for (int i = 0; i < room->wall_kind_count; i++)
        free(room->wall_kinds[i].name);
    pp_rough_finishes_release(room->materials);
    free(room->wall_kinds);
    free(room->finishes);
    free(room->openings);
    free(room->skylines);
    free(room->facades);
    free(room->blocks);
    free(room->fittings);
    free(room->covers);
    free(room->gardens);
    free(room->trees);
    free(room->surfaces);
    free(room->meshes);
    free(room->receivers);
    *room = (struct pp_room){0};
}
