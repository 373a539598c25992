/* building.c - see building.h. */
#include "model/room/building.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/read_file.h"
#include "model/room/outside/named_block.h"
#include "model/room/outside/building_site.h"
#include "model/room/read/read_elements.h"
#include "model/room/room_parts.h"

static enum pp_status parse(struct pp_building **building, const char *bytes,
                            size_t length, const char *folder,
                            struct pp_mistakes *mistakes, struct pp_error *err)
{
    int before = mistakes->count;
    *building = NULL;
    struct pp_building *made = calloc(1, sizeof *made);
    if (made)
        made->text = malloc(length + 1);
    if (made && folder)
        made->folder = strdup(folder);
    if (!made || !made->text || (folder && !made->folder)) {
        pp_building_destroy(made);
        return pp_fail_memory(err);
    }
    memcpy(made->text, bytes, length);
    made->text[length] = '\0';
    made->text_length = length;

    struct pp_xml xml;
    enum pp_status status =
        pp_xml_parse(&xml, bytes, length, &pp_read_elements_format, mistakes, err);
    if (status == PP_OK)
        status = pp_read_elements(made, &xml, folder, mistakes, err);
    if (status == PP_OK)
        status = pp_building_site_settle(made, PP_STATE_PROPOSED, err);
    bool whole = status == PP_OK && xml.whole && made->read_count > 0;
    pp_xml_clear(&xml);
    pp_mistakes_sort(mistakes);

    /* A truncated file may lack parts, so it gives no valid room. */
    if (whole)
        *building = made;
    else
        pp_building_destroy(made);
    if (status != PP_OK)
        return status;
    int count = mistakes->count - before;
    if (count > 0 || mistakes->truncated)
        return pp_fail(err, PP_BAD_INPUT, "%s: %d mistake%s%s",
                       mistakes->file ? mistakes->file : "room file", count,
                       count == 1 ? "" : "s", mistakes->truncated ? " or more" : "");
    return PP_OK;
}

enum pp_status pp_building_parse(struct pp_building **building, const char *bytes,
                                 size_t length, struct pp_mistakes *mistakes,
                                 struct pp_error *err)
{
    return parse(building, bytes, length, NULL, mistakes, err);
}

/* Folder of a path, including the final "/"; "" for the current folder. Freed by the
 * caller; NULL if memory runs out. */
static char *folder_of(const char *path)
{
    const char *end = strrchr(path, '/');
    return strndup(path, end ? (size_t)(end - path) + 1 : 0);
}

/* Parses the text after applying the changes. */
static enum pp_status parse_changed(struct pp_building **building, const char *bytes,
                                    size_t length, const char *path,
                                    const struct pp_room_changes *changes,
                                    struct pp_mistakes *mistakes, struct pp_error *err)
{
    char *folder = folder_of(path), *changed = NULL;
    enum pp_status status = folder ? PP_OK : pp_fail_memory(err);
    struct pp_error why = {0};
    if (status == PP_OK && changes->count > 0) {
        status = pp_room_change_text(&changed, &length, bytes, length, changes, &why);
        if (status != PP_OK)
            pp_fail(err, status, "%s: %s", mistakes->file, why.message);
        bytes = changed;
    }
    if (status == PP_OK)
        status = parse(building, bytes, length, folder, mistakes, err);
    free(changed);
    free(folder);
    return status;
}

/* Reads a file without the coarse models that its rooms are nested in. is_named: it is
 * named in another file. */
static enum pp_status read_alone(struct pp_building **building, const char *path,
                                 bool is_named, const struct pp_room_changes *changes,
                                 struct pp_mistakes *mistakes, struct pp_error *err)
{
    char *bytes;
    size_t length;
    *building = NULL;
    enum pp_status status =
        is_named
            ? pp_read_file_regular(&bytes, &length, path, PP_READ_ELEMENTS_BYTES_MOST,
                                   err)
            : pp_read_file(&bytes, &length, path, PP_READ_ELEMENTS_BYTES_MOST, err);
    if (status != PP_OK)
        return status;
    status = parse_changed(building, bytes, length, path, changes, mistakes, err);
    free(bytes);
    return status;
}

/* ---- coarse models ---- */

/* The room of a coarse model's file; NULL, with a mistake, if the file has no single
 * room, or a room that is itself nested. */
static const struct pp_room *coarse_room(const struct pp_building *coarse,
                                         struct pp_mistakes *found)
{
    const struct pp_room *room = coarse->rooms;
    if (coarse->room_count != 1)
        pp_mistakes_add(found, 0, "has %d rooms; expected one", coarse->room_count);
    else if (room->within.path)
        pp_mistakes_add(found, room->line,
                        "is itself nested in another model; expected a room without "
                        "within");
    else
        return room;
    return NULL;
}

/* Reads and resolves a coarse model. Its mistakes are reported on the line of the
 * nested room. */
static enum pp_status read_coarse(struct pp_within_part *within,
                                  struct pp_mistakes *mistakes, struct pp_error *err)
{
    const struct pp_room_changes none = {0};
    struct pp_mistakes found;
    struct pp_building *coarse = NULL;
    struct pp_error why = {0};
    pp_mistakes_init(&found, within->path);
    enum pp_status status =
        read_alone(&coarse, within->path, true, &none, &found, &why);
    const struct pp_room *room = status == PP_OK ? coarse_room(coarse, &found) : NULL;
    if (room)
        status = pp_world_create(&within->world, room, &found, &why);
    for (int i = 0; i < found.count; i++)
        pp_mistakes_add(mistakes, within->line, "room: within \"%.200s\", line %d: %s",
                        within->path, found.list[i].line, found.list[i].text);
    if (status == PP_BAD_INPUT && found.count == 0)
        pp_mistakes_add(mistakes, within->line, "room: within: %s", why.message);
    pp_mistakes_clear(&found);
    pp_building_destroy(coarse);
    return status == PP_OK || status == PP_BAD_INPUT
               ? PP_OK
               : pp_fail(err, status, "%s", why.message);
}

/* The coarse model of another room of the list that is nested in the same file. */
static struct pp_world *known_coarse(const struct pp_room *rooms, int count,
                                     const char *path)
{
    for (int i = 0; i < count; i++)
        if (rooms[i].within.world && strcmp(rooms[i].within.path, path) == 0)
            return rooms[i].within.world;
    return NULL;
}

/* Reads the coarse models of all rooms in both lists of the building. */
static enum pp_status read_coarse_models(struct pp_building *building,
                                         struct pp_mistakes *mistakes,
                                         struct pp_error *err)
{
    enum pp_status status = PP_OK;
    int before = mistakes->count;
    for (int i = 0; i < building->read_count + building->room_count && status == PP_OK;
         i++) {
        bool read = i < building->read_count;
        struct pp_room *room =
            read ? &building->read[i] : &building->rooms[i - building->read_count];
        struct pp_world *known = NULL;
        if (!room->within.path)
            continue;
        known = known_coarse(building->read, building->read_count, room->within.path);
        if (!known)
            known =
                known_coarse(building->rooms, building->room_count, room->within.path);
        room->within.world = pp_world_hold(known);
        if (!known)
            status = read_coarse(&room->within, mistakes, err);
    }
    pp_mistakes_sort(mistakes);
    if (status == PP_OK && mistakes->count > before)
        status = pp_fail(err, PP_BAD_INPUT, "%s: %d mistakes", mistakes->file,
                         mistakes->count);
    return status;
}

/* Adds coarse models to a building that has been read, unless that has failed. */
static enum pp_status complete(struct pp_building **building, enum pp_status status,
                               struct pp_mistakes *mistakes, struct pp_error *err)
{
    if (!*building || (status != PP_OK && status != PP_BAD_INPUT))
        return status;
    enum pp_status added = read_coarse_models(*building, mistakes, err);
    if (added != PP_OK && added != PP_BAD_INPUT) {
        pp_building_destroy(*building);
        *building = NULL;
    }
    return added != PP_OK ? added : status;
}

enum pp_status pp_building_read_changed(struct pp_building **building, const char *path,
                                        const struct pp_room_changes *changes,
                                        struct pp_mistakes *mistakes,
                                        struct pp_error *err)
{
    enum pp_status status = read_alone(building, path, false, changes, mistakes, err);
    return complete(building, status, mistakes, err);
}

enum pp_status pp_building_read(struct pp_building **building, const char *path,
                                struct pp_mistakes *mistakes, struct pp_error *err)
{
    const struct pp_room_changes none = {0};
    return pp_building_read_changed(building, path, &none, mistakes, err);
}

enum pp_status pp_building_read_again(struct pp_building **building,
                                      const struct pp_building *other,
                                      struct pp_mistakes *mistakes,
                                      struct pp_error *err)
{
    enum pp_status status =
        parse(building, other->text, other->text_length, other->folder, mistakes, err);
    return complete(building, status, mistakes, err);
}

void pp_building_destroy(struct pp_building *building)
{
    if (!building)
        return;
    pp_building_site_clear(building);
    for (int i = 0; i < building->read_count; i++)
        pp_room_parts_clear(&building->read[i]);
    free(building->read);
    pp_room_parts_clear(&building->common);
    for (int i = 0; i < PP_PROJECT_FACTS; i++)
        free((char *)pp_project_at(&building->project, i));
    free(building->name);
    free(building->folder);
    free(building->text);
    free(building);
}

const char *pp_building_name(const struct pp_building *building)
{
    return building->name;
}

const struct pp_project *pp_building_project(const struct pp_building *building)
{
    return &building->project;
}

const char *pp_building_text(const struct pp_building *building, size_t *length)
{
    *length = building->text_length;
    return building->text;
}

int pp_building_room_count(const struct pp_building *building)
{
    return building->room_count;
}

struct pp_room *pp_building_room(struct pp_building *building, int index)
{
    return &building->rooms[index];
}

int pp_building_place(const struct pp_building *building, int index)
{
    return building->places[index];
}

int pp_building_openings_before(const struct pp_building *building, int index)
{
    int count = 0;
    for (int i = 0; i < building->places[index]; i++)
        count += building->openings[i];
    return count;
}

bool pp_building_has_states(const struct pp_building *building)
{
    return building->states != 1;
}

bool pp_building_has_cumulative(const struct pp_building *building)
{
    return (building->states & 1u << PP_STATE_CUMULATIVE) != 0;
}

enum pp_status pp_building_set_state(struct pp_building *building,
                                     enum pp_site_state state, struct pp_error *err)
{
    return pp_building_site_settle(building, state, err);
}

enum pp_status pp_building_mirror(struct pp_building *building,
                                  const struct pp_mirror_line *line,
                                  struct pp_error *err)
{
    building->boundary = *line;
    return pp_building_site_settle(building, PP_STATE_BOTH, err);
}

/* ---- blocks by name ---- */

/* The room that stores the building's blocks: the common part or, if there is only one
 * room and the common part has no blocks, surfaces or meshes, that room. */
static struct pp_room *holder(const struct pp_building *building)
{
    bool lone = building->read_count == 1 && building->common.block_count == 0
                && building->common.surface_count == 0
                && building->common.mesh_count == 0;
    struct pp_building *own = (struct pp_building *)building;
    if (!lone)
        return &own->common;
    return building->room_count == 1 && building->moved[0] ? &own->rooms[0]
                                                           : &own->read[0];
}

double pp_building_block_height(const struct pp_building *building, const char *name)
{
    int box;
    const struct pp_room *room = holder(building);
    int line = pp_named_block_find(room, name, &box);
    if (!line)
        return NAN;
    double reach_m[2];
    pp_named_block_reach(reach_m, room, line);
    return box >= 0 ? room->blocks[box].height_m : reach_m[1] - reach_m[0];
}

void pp_building_set_block_height(struct pp_building *building, const char *name,
                                  double height_m)
{
    int box;
    struct pp_room *room = holder(building);
    int line = pp_named_block_find(room, name, &box);
    double more = height_m - pp_building_block_height(building, name), reach_m[2];
    if (!line || !isfinite(more))
        return;
    pp_named_block_reach(reach_m, room, line);
    double base = box >= 0 ? room->blocks[box].corner.z : reach_m[0];
    if (box >= 0)
        room->blocks[box].height_m = height_m;
    for (int i = 0; i < room->surface_count; i++) {
        struct pp_surface_part *part = &room->surfaces[i];
        for (int k = 0;
             k < part->vertices.count && part->is_of_block && part->line == line; k++)
            if (part->vertices.list[k].z > base)
                part->vertices.list[k].z += more;
    }
}

static enum pp_status copy_corners(struct pp_vec3 **corners, int *count,
                                   const struct pp_vec3 *from, int from_count,
                                   double base_m, struct pp_error *err)
{
    *corners = malloc((size_t)from_count * sizeof **corners);
    if (!*corners)
        return pp_fail_memory(err);
    for (int i = 0; i < from_count; i++)
        (*corners)[i] = pp_vec(from[i].x, from[i].y, base_m);
    *count = from_count;
    return PP_OK;
}

enum pp_status pp_building_block_footprint(struct pp_vec3 **corners, int *count,
                                           const struct pp_building *building,
                                           const char *name, struct pp_error *err)
{
    int box;
    const struct pp_room *room = holder(building);
    int line = pp_named_block_find(room, name, &box);
    *corners = NULL;
    *count = 0;
    if (box >= 0 && line) {
        const struct pp_block *b = &room->blocks[box];
        double c = cos(b->rotate_rad), s = sin(b->rotate_rad);
        struct pp_vec3 along = pp_vec(c * b->width_m, s * b->width_m, 0.0),
                       across = pp_vec(-s * b->depth_m, c * b->depth_m, 0.0),
                       right = pp_vec_add(b->corner, along);
        struct pp_vec3 four[] = {b->corner, right, pp_vec_add(right, across),
                                 pp_vec_add(b->corner, across)};
        return copy_corners(corners, count, four, 4, b->corner.z, err);
    }
    /* The roof is the last surface of a block with a footprint. */
    const struct pp_surface_part *roof = NULL;
    for (int i = 0; i < room->surface_count && line; i++)
        if (room->surfaces[i].is_of_block && room->surfaces[i].line == line)
            roof = &room->surfaces[i];
    if (!roof)
        return pp_fail(err, PP_BAD_INPUT, "expected exactly one block named \"%.60s\"",
                       name);
    double reach_m[2];
    pp_named_block_reach(reach_m, room, line);
    return copy_corners(corners, count, roof->vertices.list, roof->vertices.count,
                        reach_m[0], err);
}

enum pp_status pp_building_divide_block(struct pp_building *building, const char *name,
                                        const struct pp_building_cell *cells, int count,
                                        struct pp_error *err)
{
    struct pp_room *room = holder(building);
    struct pp_block like;
    if (!pp_named_block_take_out(&like, room, name))
        return pp_fail(err, PP_BAD_INPUT, "no block is named \"%.60s\"", name);
    for (int i = 0; i < count; i++) {
        struct pp_block added = like;
        added.corner = cells[i].corner;
        added.width_m = cells[i].width_m;
        added.depth_m = cells[i].depth_m;
        added.height_m = cells[i].height_m;
        added.rotate_rad = cells[i].rotate_rad;
        added.name = strdup(name);
        if (!added.name
            || pp_array_append(&room->blocks, room->block_count, sizeof *room->blocks,
                               NULL)
                   != PP_OK) {
            free(added.name);
            return pp_fail_memory(err);
        }
        room->blocks[room->block_count++] = added;
    }
    return PP_OK;
}

int pp_building_block_names(const struct pp_building *building, const char **names,
                            int most)
{
    const struct pp_room *room = holder(building);
    int count = 0, line = 0;
    for (int i = 0; i < room->block_count && count < most; i++)
        if (room->blocks[i].name)
            names[count++] = room->blocks[i].name;
    for (int i = 0; i < room->surface_count && count < most; i++) {
        const struct pp_surface_part *part = &room->surfaces[i];
        bool is_roof = false;
        for (int k = 0; k < room->block_count; k++)
            is_roof |= room->blocks[k].line == part->line;
        if (part->is_of_block && part->name && part->line != line && !is_roof)
            names[count++] = part->name;
        line = part->line;
    }
    return count;
}
