/* building_site.c - see building_site.h. */
#include "model/room/outside/building_site.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/tolerance.h"
#include "model/room/outside/mirror_image.h"
#include "model/room/outside/outside_parts.h"
#include "model/room/outside/room_shell.h"
#include "model/room/outside/site_state.h"
#include "model/room/read/room_schema.h"
#include "model/room/room.h"

/* ---- parts of a room ---- */

/* True if the building's gardens are assessed with this room. Gardens are assessed with
 * only one room: the first one that exists in both states, or else the first one that
 * exists in this state. */
static bool has_gardens(const struct pp_building *building, int index,
                        enum pp_site_state state)
{
    int first = -1;
    for (int i = 0; i < building->read_count; i++) {
        if (building->read[i].state == PP_STATE_BOTH)
            return i == index;
        if (first < 0 && pp_site_state_has(state, building->read[i].state))
            first = i;
    }
    return first == index;
}

/* Adds the building's parts that are common to all rooms. */
static enum pp_status add_common(struct pp_room *room,
                                 const struct pp_room_shell *shell,
                                 const struct pp_room *common, enum pp_site_state state,
                                 struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < common->skyline_count && status == PP_OK; i++)
        if (pp_site_state_has(state, common->skylines[i].state)
            && pp_room_shell_has_wall(shell, common->skylines[i].wall))
            status = pp_outside_parts_add_skyline(room, &common->skylines[i], err);
    for (int i = 0; i < common->block_count && status == PP_OK; i++)
        if (pp_site_state_has(state, common->blocks[i].state))
            status = pp_outside_parts_add_block(room, &common->blocks[i], err);
    for (int i = 0; i < common->mesh_count && status == PP_OK; i++)
        if (pp_site_state_has(state, common->meshes[i].state))
            status = pp_outside_parts_add_mesh(room, &common->meshes[i], err);
    for (int i = 0; i < common->tree_count && status == PP_OK; i++)
        if (pp_site_state_has(state, common->trees[i].state))
            status = pp_outside_parts_add_tree(room, &common->trees[i], err);
    for (int i = 0; i < common->surface_count && status == PP_OK; i++) {
        struct pp_surface_part part = common->surfaces[i];
        part.is_of_site = true;
        if (pp_site_state_has(state, part.state))
            status = pp_outside_parts_add_surface(room, &part, part.vertices.list,
                                                  part.vertices.count, err);
    }
    return status;
}

/* ---- other rooms ---- */

static enum pp_status add_faces(struct pp_room *room, const struct pp_room *other,
                                const struct pp_room_shell *shell, struct pp_error *err)
{
    struct pp_surface_part part = {
        .name = other->name, .is_room_outside = true, .line = other->line};
    enum pp_status status = PP_OK;
    for (int i = 0; i < shell->body->face_count && status == PP_OK; i++) {
        const struct pp_polygon *face = &shell->body->surfaces[i].outline;
        part.reflectance = shell->body->surfaces[i].back;
        if (!shell->is_divided[i])
            status = pp_outside_parts_add_surface(room, &part, face->vertices,
                                                  face->count, err);
    }
    return status;
}

static enum pp_status add_sheet(struct pp_room *room, const struct pp_room *other,
                                const struct pp_room_front *front,
                                struct pp_clipper *clipper, struct pp_error *err)
{
    struct pp_surface_part part = pp_room_front_part(front);
    struct pp_region_pieces pieces;
    enum pp_status status = pp_room_front_cut(&pieces, front, clipper, err);
    part.name = other->name;
    for (int i = 0; i < pieces.count && status == PP_OK; i++)
        status = pp_outside_parts_add_surface(room, &part, pieces.list[i].corners,
                                              pieces.list[i].count, err);
    pp_region_pieces_clear(&pieces);
    return status;
}

/* Adds a front of another room, except where a front of this room overlaps it. The
 * world of this room contains the room's own fronts already. */
static enum pp_status add_front(struct pp_room *room, const struct pp_room_shell *own,
                                const struct pp_room *other,
                                const struct pp_room_front *front,
                                struct pp_clipper *clipper, struct pp_error *err)
{
    struct pp_room_front left;
    enum pp_status status = pp_room_front_copy(&left, front, err);
    for (int i = 0; i < own->front_count && status == PP_OK; i++)
        if (pp_room_front_overlaps(&left, &own->fronts[i]))
            status = pp_room_front_take_out(&left, &own->fronts[i], clipper, err);
    if (status == PP_OK)
        status = add_sheet(room, other, &left, clipper, err);
    pp_room_front_clear(&left);
    return status;
}

/* Adds the blocks and meshes of another room, except blocks that the room already
 * has. */
static enum pp_status add_solids(struct pp_room *room, const struct pp_room *own,
                                 struct pp_error *err)
{
    const struct pp_placement *place = &own->placement;
    enum pp_status status = PP_OK;
    for (int i = 0; i < own->block_count && status == PP_OK; i++) {
        struct pp_block block = own->blocks[i];
        block.corner = pp_placement_to_building(place, block.corner);
        block.rotate_rad += place->rotate_rad;
        if (!pp_outside_parts_has_block(room, &block))
            status = pp_outside_parts_add_block(room, &block, err);
    }
    for (int i = 0; i < own->mesh_count && status == PP_OK; i++) {
        struct pp_mesh_part mesh = own->meshes[i];
        mesh.corner = pp_placement_to_building(place, mesh.corner);
        mesh.rotate_rad += place->rotate_rad;
        status = pp_outside_parts_add_mesh(room, &mesh, err);
    }
    return status;
}

/* Adds another room and the parts fixed to its outside. */
static enum pp_status add_neighbour(struct pp_room *room,
                                    const struct pp_room_shell *own,
                                    const struct pp_room *other,
                                    const struct pp_room_shell *shell,
                                    struct pp_clipper *clipper, struct pp_error *err)
{
    enum pp_status status = add_faces(room, other, shell, err);
    for (int i = 0; i < shell->front_count && status == PP_OK; i++)
        status = add_front(room, own, other, &shell->fronts[i], clipper, err);
    for (int i = 0; i < shell->carried_count && status == PP_OK; i++) {
        const struct pp_room_carried *it = &shell->carried[i];
        struct pp_surface_part part = it->part;
        part.is_shade = it->is_shade && pp_room_shell_shares_front(own, it);
        /* A surface that several rooms of the file describe is added once. */
        if (part.what || part.is_room_outside
            || !pp_outside_parts_has_surface(room, &part))
            status = pp_outside_parts_add_surface(room, &part, part.vertices.list,
                                                  part.vertices.count, err);
    }
    return status == PP_OK && shell->own ? add_solids(room, shell->own, err) : status;
}

/* ---- a state of the site ---- */

/* True if the building has parts that are added to its rooms. */
static bool holds(const struct pp_room *common)
{
    return common->skyline_count + common->block_count + common->surface_count
               + common->mesh_count + common->garden_count + common->tree_count
           > 0;
}

/* True if the number of placed rooms exceeds the limit; the reader of the file has
 * reported that. */
static bool has_too_many(const struct pp_building *building)
{
    int placed = 0;
    for (int i = 0; i < building->read_count && placed <= PP_ROOM_PLACED_MOST; i++)
        placed += building->read[i].placement.given;
    return placed > PP_ROOM_PLACED_MOST;
}

/* Data for building one state of the site. */
struct settling {
    struct pp_building *building;
    enum pp_site_state state;
    struct pp_room_shell *shells; /* one per room of the file */
    struct pp_room_shell *images; /* mirror images; NULL: no mirror line */
    struct pp_clipper *clipper;
};

/* True if the room exists in the state and obstructs others. */
static bool stands(const struct settling *site, int index)
{
    const struct pp_room *room = &site->building->read[index];
    return room->placement.given && pp_site_state_has(site->state, room->state);
}

static enum pp_status add_neighbours(struct pp_room *room, int index,
                                     const struct settling *site, struct pp_error *err)
{
    const struct pp_room_shell *own = &site->shells[index];
    enum pp_status status = PP_OK;
    for (int i = 0; i < site->building->read_count && status == PP_OK; i++) {
        const struct pp_room *other = &site->building->read[i];
        if (!stands(site, i))
            continue;
        if (i != index)
            status =
                add_neighbour(room, own, other, &site->shells[i], site->clipper, err);
        if (site->images && status == PP_OK)
            status =
                add_neighbour(room, own, other, &site->images[i], site->clipper, err);
    }
    return status;
}

/* Makes room `index` in the state, with everything outside it. */
static enum pp_status settle_room(const struct settling *site, int index,
                                  struct pp_error *err)
{
    struct pp_building *building = site->building;
    const struct pp_room *common = &building->common;
    struct pp_room *read = &building->read[index], *room = NULL;
    bool stays =
        !read->placement.given && !holds(common) && pp_site_state_set(read) == 1;
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
    pp_site_state_keep(room, site->state);
    status = add_common(room, &site->shells[index], common, site->state, err);
    for (int i = 0; i < common->garden_count && status == PP_OK
                    && has_gardens(building, index, site->state);
         i++)
        if (pp_site_state_has(site->state, common->gardens[i].state))
            status = pp_outside_parts_add_garden(room, &common->gardens[i], err);
    if (status == PP_OK && room->placement.given && !has_too_many(building))
        status = add_neighbours(room, index, site, err);
    return status;
}

/* Trims a room's facades where they meet other rooms, or facades of earlier rooms of
 * the file. */
static enum pp_status make_way(struct settling *site, int index, struct pp_error *err)
{
    const struct pp_room_shell *shells = site->shells;
    enum pp_status status = PP_OK;
    for (int f = 0; f < shells[index].front_count; f++) {
        struct pp_room_front *front = &shells[index].fronts[f];
        for (int i = 0; i < site->building->read_count && status == PP_OK; i++) {
            if (i == index || !stands(site, i))
                continue;
            status = pp_room_front_give_way(front, shells[i].body, site->clipper, err);
            for (int k = 0; k < shells[i].front_count && i < index && status == PP_OK;
                 k++)
                if (pp_room_front_overlaps(front, &shells[i].fronts[k]))
                    status = pp_room_front_take_out(front, &shells[i].fronts[k],
                                                    site->clipper, err);
        }
    }
    return status;
}

/* Makes the shells of placed rooms. If the building has skylines, other rooms get
 * shells too, for their wall names. */
static enum pp_status make_shells(struct settling *site, struct pp_error *err)
{
    const struct pp_building *building = site->building;
    int count = building->read_count;
    enum pp_status status = PP_OK;
    bool too_many = has_too_many(building);
    for (int i = 0; i < count && status == PP_OK; i++) {
        const struct pp_room *room = &building->read[i];
        if (room->placement.given || building->common.skyline_count > 0)
            status = pp_room_shell_make(
                &site->shells[i], room, site->state, stands(site, i) && !too_many,
                building->glass_reflectance, site->clipper, err);
    }
    for (int i = 0; i < count && status == PP_OK; i++)
        status = make_way(site, i, err);
    return status;
}

static const char *site_room_name(const struct settling *site, int index)
{
    const char *name = site->building->read[index].name;
    return name ? name : "";
}

/* Checks that the whole building is on one side of the line, as its mirror image
 * requires. */
static enum pp_status check_sides(const struct settling *site, struct pp_error *err)
{
    const struct pp_mirror_line *line = &site->building->boundary;
    int on[2] = {-1, -1};
    for (int i = 0; i < site->building->read_count; i++) {
        double sides_m[2];
        if (!stands(site, i))
            continue;
        pp_mirror_image_sides(sides_m, &site->shells[i], line);
        for (int k = 0; k < 2; k++)
            if (sides_m[k] > PP_SAME_M)
                on[k] = i;
        if (on[0] == i && on[1] == i)
            return pp_fail(err, PP_BAD_INPUT,
                           "the line from (%g, %g) to (%g, %g) crosses the room "
                           "\"%.60s\"; expected all rooms on one side of it",
                           line->from[0], line->from[1], line->to[0], line->to[1],
                           site_room_name(site, i));
    }
    if (on[0] < 0 && on[1] < 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "there is no building to mirror; expected rooms with x, y, z "
                       "or rotate that exist both before and after the development");
    if (on[0] < 0 || on[1] < 0)
        return PP_OK;
    return pp_fail(err, PP_BAD_INPUT,
                   "the rooms \"%.60s\" and \"%.60s\" are on opposite sides of the "
                   "line from (%g, %g) to (%g, %g); expected all on one side",
                   site_room_name(site, on[0]), site_room_name(site, on[1]),
                   line->from[0], line->from[1], line->to[0], line->to[1]);
}

static enum pp_status make_images(struct settling *site, struct pp_error *err)
{
    enum pp_status status = check_sides(site, err);
    if (status != PP_OK)
        return status;
    int count = site->building->read_count;
    site->images = calloc((size_t)count + 1, sizeof *site->images);
    if (!site->images)
        return pp_fail_memory(err);
    for (int i = 0; i < count && status == PP_OK; i++)
        if (stands(site, i))
            status =
                pp_mirror_image_make(&site->images[i], &site->shells[i],
                                     &site->building->boundary, site->clipper, err);
    return status;
}

static void clear_site(struct settling *site)
{
    for (int i = 0; i < site->building->read_count; i++) {
        if (site->shells)
            pp_room_shell_clear(&site->shells[i]);
        if (site->images)
            pp_room_shell_clear(&site->images[i]);
    }
    free(site->shells);
    free(site->images);
    pp_clipper_destroy(site->clipper);
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
    struct settling site = {.building = building,
                            .state = state,
                            .shells = calloc((size_t)count + 1, sizeof *site.shells)};
    enum pp_status status = PP_OK;
    if (!building->rooms || !building->places || !building->moved || !building->openings
        || !site.shells)
        status = pp_fail_memory(err);
    building->states = pp_site_state_set(&building->common);
    for (int i = 0; i < count && status == PP_OK; i++) {
        building->openings[i] = building->read[i].opening_count;
        building->states |= pp_site_state_set(&building->read[i]);
    }
    if (status == PP_OK)
        status = pp_clipper_create(&site.clipper, err);
    if (status == PP_OK)
        status = make_shells(&site, err);
    if (status == PP_OK && state == PP_STATE_BOTH)
        status = make_images(&site, err);
    for (int i = 0; i < count && status == PP_OK; i++)
        if (pp_site_state_has(state, building->read[i].state))
            status = settle_room(&site, i, err);
    clear_site(&site);
    if (status != PP_OK)
        pp_building_site_clear(building);
    return status;
}
