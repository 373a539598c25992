/* building_site.c - see building_site.h. */
#include "model/room/outside/building_site.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/room/build/envelope.h"
#include "model/room/build/resolve.h"
#include "model/room/read/room_schema.h"
#include "model/room/room.h"

/* Of outer faces of walls and roofs. */
static const double outside_reflectance = 0.2;

/* A room's faces and walls, in its own axes. */
struct shell {
    struct pp_world world; /* nothing but surfaces */
    char **walls;
    int wall_count;
};

static void clear_shell(struct shell *shell)
{
    for (int i = 0; i < shell->world.surface_count; i++) {
        pp_polygon_clear(&shell->world.surfaces[i].outline);
        free((char *)shell->world.surfaces[i].name);
    }
    free(shell->world.surfaces);
    for (int i = 0; i < shell->wall_count; i++)
        free(shell->walls[i]);
    free(shell->walls);
}

/* Mistakes in a room's faces are noted where the room itself is resolved. */
static enum pp_status make_shell(struct shell *shell, const struct pp_room *room,
                                 struct pp_error *err)
{
    struct pp_mistakes unsaid;
    pp_mistakes_init(&unsaid, "room");
    struct pp_resolver r = {.room = room, .world = &shell->world, .mistakes = &unsaid};
    struct pp_error fault = {0};
    enum pp_status status = pp_clipper_create(&r.clipper, &fault);
    if (status == PP_OK)
        status = pp_build_envelope(&r, &fault);
    pp_clipper_destroy(r.clipper);
    shell->walls = r.walls;
    shell->wall_count = r.wall_count;
    free(r.wall_faces);
    free(r.corners);
    pp_mistakes_clear(&unsaid);
    return status == PP_SYSTEM ? pp_fail(err, status, "%s", fault.message) : PP_OK;
}

/* ---- What a room gets ---- */

static bool has_wall(const struct shell *shell, const char *name)
{
    for (int i = 0; i < shell->wall_count; i++)
        if (name && strcmp(shell->walls[i], name) == 0)
            return true;
    return false;
}

static bool stands_in(enum pp_site_state it, enum pp_site_state state)
{
    return it == PP_STATE_BOTH || it == state;
}

static enum pp_status add_block(struct pp_room *room, const struct pp_block *block,
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

/* A copy of the part with these vertices in the building's axes. */
static enum pp_status add_surface(struct pp_room *room,
                                  const struct pp_surface_part *part,
                                  const struct pp_vec3 *vertices, int count,
                                  struct pp_error *err)
{
    struct pp_surface_part added = *part;
    added.name = part->name ? strdup(part->name) : NULL;
    added.vertices =
        (struct pp_vertices){.list = malloc((size_t)count * sizeof *vertices),
                             .lines = calloc((size_t)count, sizeof(int)),
                             .count = count};
    if ((part->name && !added.name) || !added.vertices.list || !added.vertices.lines
        || pp_array_append(&room->surfaces, room->surface_count, sizeof *room->surfaces,
                           NULL)
               != PP_OK) {
        pp_room_parts_clear_surface(&added);
        return pp_fail_memory(err);
    }
    for (int i = 0; i < count; i++) {
        added.vertices.list[i] = pp_placement_to_room(&room->placement, vertices[i]);
        added.vertices.lines[i] = part->line;
    }
    room->surfaces[room->surface_count++] = added;
    return PP_OK;
}

static enum pp_status add_mesh(struct pp_room *room, const struct pp_mesh_part *part,
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

static enum pp_status add_garden(struct pp_room *room,
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

/* A building's gardens are those of one of its rooms, so that they are judged once: of the
 * first that stands in every state, or else of the first. */
static bool has_gardens(const struct pp_building *building, int index,
                        enum pp_site_state state)
{
    int first = -1;
    for (int i = 0; i < building->read_count; i++) {
        if (building->read[i].state == PP_STATE_BOTH)
            return i == index;
        if (first < 0 && stands_in(building->read[i].state, state))
            first = i;
    }
    return first == index;
}

static enum pp_status add_skyline(struct pp_room *room,
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

/* Adds what the building holds for all rooms. */
static enum pp_status add_common(struct pp_room *room, const struct shell *shell,
                                 const struct pp_room *common, enum pp_site_state state,
                                 struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < common->skyline_count && status == PP_OK; i++)
        if (stands_in(common->skylines[i].state, state)
            && has_wall(shell, common->skylines[i].wall))
            status = add_skyline(room, &common->skylines[i], err);
    for (int i = 0; i < common->block_count && status == PP_OK; i++)
        if (stands_in(common->blocks[i].state, state))
            status = add_block(room, &common->blocks[i], err);
    for (int i = 0; i < common->mesh_count && status == PP_OK; i++)
        if (stands_in(common->meshes[i].state, state))
            status = add_mesh(room, &common->meshes[i], err);
    for (int i = 0; i < common->surface_count && status == PP_OK; i++) {
        struct pp_surface_part part = common->surfaces[i];
        part.is_of_site = true;
        if (stands_in(part.state, state))
            status =
                add_surface(room, &part, part.vertices.list, part.vertices.count, err);
    }
    return status;
}

/* Adds the faces of another room. */
static enum pp_status add_neighbour(struct pp_room *room, const struct pp_room *other,
                                    const struct shell *shell, struct pp_error *err)
{
    struct pp_surface_part part = {.reflectance = outside_reflectance,
                                   .name = other->name,
                                   .is_room_outside = true,
                                   .line = other->line};
    for (int i = 0; i < shell->world.face_count; i++) {
        const struct pp_polygon *face = &shell->world.surfaces[i].outline;
        struct pp_vec3 *vertices = malloc((size_t)face->count * sizeof *vertices);
        if (!vertices)
            return pp_fail_memory(err);
        for (int k = 0; k < face->count; k++)
            vertices[k] =
                pp_placement_to_building(&other->placement, face->vertices[k]);
        enum pp_status status = add_surface(room, &part, vertices, face->count, err);
        free(vertices);
        if (status != PP_OK)
            return status;
    }
    return PP_OK;
}

/* ---- A state ---- */

/* Leaves only what there is in the state; parts keep their order. */
static void keep_state(struct pp_room *room, enum pp_site_state state)
{
    int kept = 0;
    for (int i = 0; i < room->skyline_count; i++)
        if (stands_in(room->skylines[i].state, state))
            room->skylines[kept++] = room->skylines[i];
        else
            free(room->skylines[i].wall);
    room->skyline_count = kept;
    kept = 0;
    for (int i = 0; i < room->block_count; i++)
        if (stands_in(room->blocks[i].state, state))
            room->blocks[kept++] = room->blocks[i];
        else
            free(room->blocks[i].name);
    room->block_count = kept;
    kept = 0;
    for (int i = 0; i < room->surface_count; i++)
        if (stands_in(room->surfaces[i].state, state))
            room->surfaces[kept++] = room->surfaces[i];
        else
            pp_room_parts_clear_surface(&room->surfaces[i]);
    room->surface_count = kept;
    kept = 0;
    for (int i = 0; i < room->mesh_count; i++)
        if (stands_in(room->meshes[i].state, state))
            room->meshes[kept++] = room->meshes[i];
        else
            pp_room_parts_clear_mesh(&room->meshes[i]);
    room->mesh_count = kept;
    kept = 0;
    for (int i = 0; i < room->garden_count; i++)
        if (stands_in(room->gardens[i].state, state))
            room->gardens[kept++] = room->gardens[i];
        else
            pp_room_parts_clear_garden(&room->gardens[i]);
    room->garden_count = kept;
}

static bool has_states(const struct pp_room *room)
{
    bool some = room->state != PP_STATE_BOTH;
    for (int i = 0; i < room->skyline_count; i++)
        some |= room->skylines[i].state != PP_STATE_BOTH;
    for (int i = 0; i < room->block_count; i++)
        some |= room->blocks[i].state != PP_STATE_BOTH;
    for (int i = 0; i < room->surface_count; i++)
        some |= room->surfaces[i].state != PP_STATE_BOTH;
    for (int i = 0; i < room->mesh_count; i++)
        some |= room->meshes[i].state != PP_STATE_BOTH;
    for (int i = 0; i < room->garden_count; i++)
        some |= room->gardens[i].state != PP_STATE_BOTH;
    return some;
}

/* Does the building hold anything that goes to its rooms? */
static bool holds(const struct pp_room *common)
{
    return common->skyline_count + common->block_count + common->surface_count
               + common->mesh_count + common->garden_count
           > 0;
}

/* More placed rooms than can stand before each other? That is a mistake, noted where the
 * file was read. */
static bool has_too_many(const struct pp_building *building)
{
    int placed = 0;
    for (int i = 0; i < building->read_count && placed <= PP_ROOM_PLACED_MOST; i++)
        placed += building->read[i].placement.given;
    return placed > PP_ROOM_PLACED_MOST;
}

/* Room `index` as it stands in the state, with all that is outside it. */
static enum pp_status settle_room(struct pp_building *building, int index,
                                  const struct shell *shells, enum pp_site_state state,
                                  struct pp_error *err)
{
    const struct pp_room *common = &building->common;
    struct pp_room *read = &building->read[index], *room = NULL;
    bool stays = !read->placement.given && !holds(common) && !has_states(read);
    enum pp_status status = PP_OK;
    building->places[building->room_count] = index;
    building->moved[building->room_count] = stays;
    if (!stays) {
        status = pp_room_copy(&room, read, err);
        if (status != PP_OK)
            return status;
        building->rooms[building->room_count] = *room;
        free(room);
    } else {
        building->rooms[building->room_count] = *read;
        *read = (struct pp_room){0};
    }
    room = &building->rooms[building->room_count++];
    double north_rad = isnan(common->north_rad) ? 0.0 : common->north_rad;
    if (isnan(room->north_rad))
        room->north_rad = north_rad - room->placement.rotate_rad;
    if (stays)
        return PP_OK;
    keep_state(room, state);
    status = add_common(room, &shells[index], common, state, err);
    for (int i = 0; i < common->garden_count && status == PP_OK
                    && has_gardens(building, index, state);
         i++)
        if (stands_in(common->gardens[i].state, state))
            status = add_garden(room, &common->gardens[i], err);
    bool neighbours = room->placement.given && !has_too_many(building);
    for (int i = 0; i < building->read_count && status == PP_OK; i++) {
        const struct pp_room *other = &building->read[i];
        if (i != index && neighbours && other->placement.given
            && stands_in(other->state, state))
            status = add_neighbour(room, other, &shells[i], err);
    }
    return status;
}

void pp_building_site_clear(struct pp_building *building)
{
    for (int i = 0; i < building->room_count; i++)
        if (building->moved[i])
            building->read[building->places[i]] = building->rooms[i];
        else
            pp_room_parts_clear(&building->rooms[i]);
    free(building->rooms);
    free(building->places);
    free(building->moved);
    free(building->openings);
    building->rooms = NULL;
    building->places = building->openings = NULL;
    building->moved = NULL;
    building->room_count = 0;
}

enum pp_status pp_building_site_settle(struct pp_building *building,
                                       enum pp_site_state state, struct pp_error *err)
{
    int count = building->read_count;
    pp_building_site_clear(building);
    building->rooms = calloc((size_t)count + 1, sizeof *building->rooms);
    building->places = calloc((size_t)count + 1, sizeof *building->places);
    building->moved = calloc((size_t)count + 1, sizeof *building->moved);
    building->openings = calloc((size_t)count + 1, sizeof *building->openings);
    struct shell *shells = calloc((size_t)count + 1, sizeof *shells);
    enum pp_status status = PP_OK;
    if (!building->rooms || !building->places || !building->moved || !building->openings
        || !shells)
        status = pp_fail_memory(err);
    building->has_states = has_states(&building->common);
    for (int i = 0; i < count && status == PP_OK; i++) {
        building->openings[i] = building->read[i].opening_count;
        building->has_states |= has_states(&building->read[i]);
        if (building->read[i].placement.given || building->common.skyline_count > 0)
            status = make_shell(&shells[i], &building->read[i], err);
    }
    for (int i = 0; i < count && status == PP_OK; i++)
        if (stands_in(building->read[i].state, state))
            status = settle_room(building, i, shells, state, err);
    for (int i = 0; shells && i < count; i++)
        clear_shell(&shells[i]);
    free(shells);
    if (status != PP_OK)
        pp_building_site_clear(building);
    return status;
}
