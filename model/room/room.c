/* room.c - see room.h. */
#include "model/room/room.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/room/room_parts.h"

/* ---- Copies ---- */

/* Copies a list; NULL for an empty one. *good becomes false if memory runs out. */
static void *copy_list(const void *list, int count, size_t size, bool *good)
{
    if (count == 0)
        return NULL;
    void *copy = malloc((size_t)count * size);
    if (copy)
        memcpy(copy, list, (size_t)count * size);
    else
        *good = false;
    return copy;
}

#define COPY_LIST(list, count, good)                                                   \
    ((list) = copy_list(list, *(good) ? (count) : 0, sizeof *(list), good),            \
     (count) = (list) ? (count) : 0)

static void copy_text(char **text, bool *good)
{
    if (!*text)
        return;
    *text = *good ? strdup(*text) : NULL;
    *good = *good && *text;
}

static void copy_vertices(struct pp_vertices *vertices, bool *good)
{
    int count = vertices->count;
    COPY_LIST(vertices->list, count, good);
    COPY_LIST(vertices->lines, count, good);
    vertices->count = count;
}

static void copy_plan(struct pp_plan_part *plan, bool *good)
{
    copy_vertices(&plan->vertices, good);
    COPY_LIST(plan->faces, plan->face_count, good);
    for (int i = 0; i < plan->face_count; i++) {
        copy_text(&plan->faces[i].name, good);
        copy_vertices(&plan->faces[i].vertices, good);
    }
}

/* Replaces all data that the room points to by copies. After a failure the remaining
 * parts are empty, so that the room can be cleared. */
static void copy_parts(struct pp_room *room, bool *good)
{
    copy_text(&room->name, good);
    copy_text(&room->ref, good);
    copy_text(&room->address, good);
    room->sky = pp_sky_words_copy(&room->sky);
    room->materials = pp_rough_finishes_hold(room->materials);
    copy_plan(&room->plan, good);
    COPY_LIST(room->finishes, room->finish_count, good);
    for (int i = 0; i < room->finish_count; i++)
        copy_text(&room->finishes[i].wall, good);
    COPY_LIST(room->wall_kinds, room->wall_kind_count, good);
    for (int i = 0; i < room->wall_kind_count; i++)
        copy_text(&room->wall_kinds[i].name, good);
    COPY_LIST(room->openings, room->opening_count, good);
    for (int i = 0; i < room->opening_count; i++) {
        copy_text(&room->openings[i].wall, good);
        copy_text(&room->openings[i].name, good);
        copy_vertices(&room->openings[i].vertices, good);
        COPY_LIST(room->openings[i].shades, room->openings[i].shade_count, good);
        pp_measured_pane_hold(room->openings[i].glazing.measured);
    }
    COPY_LIST(room->skylines, room->skyline_count, good);
    for (int i = 0; i < room->skyline_count; i++)
        copy_text(&room->skylines[i].wall, good);
    COPY_LIST(room->facades, room->facade_count, good);
    for (int i = 0; i < room->facade_count; i++)
        copy_text(&room->facades[i].wall, good);
    COPY_LIST(room->blocks, room->block_count, good);
    for (int i = 0; i < room->block_count; i++)
        copy_text(&room->blocks[i].name, good);
    COPY_LIST(room->fittings, room->fitting_count, good);
    for (int i = 0; i < room->fitting_count; i++)
        copy_text(&room->fittings[i].name, good);
    COPY_LIST(room->covers, room->cover_count, good);
    for (int i = 0; i < room->cover_count; i++) {
        copy_text(&room->covers[i].name, good);
        copy_text(&room->covers[i].wall, good);
    }
    COPY_LIST(room->gardens, room->garden_count, good);
    for (int i = 0; i < room->garden_count; i++) {
        copy_text(&room->gardens[i].name, good);
        copy_vertices(&room->gardens[i].vertices, good);
    }
    COPY_LIST(room->trees, room->tree_count, good);
    COPY_LIST(room->surfaces, room->surface_count, good);
    for (int i = 0; i < room->surface_count; i++) {
        copy_text(&room->surfaces[i].name, good);
        copy_vertices(&room->surfaces[i].vertices, good);
    }
    COPY_LIST(room->meshes, room->mesh_count, good);
    for (int i = 0; i < room->mesh_count; i++) {
        room->meshes[i].file->holders++;
        copy_text(&room->meshes[i].path, good);
        copy_text(&room->meshes[i].name, good);
    }
    COPY_LIST(room->receivers, room->receiver_count, good);
    COPY_LIST(room->views, room->view_count, good);
    for (int i = 0; i < room->view_count; i++)
        copy_text(&room->views[i].name, good);
    copy_text(&room->within.path, good);
    copy_text(&room->within.window, good);
    pp_world_hold(room->within.world);
}

enum pp_status pp_room_copy(struct pp_room **copy, const struct pp_room *room,
                            struct pp_error *err)
{
    bool good = true;
    *copy = malloc(sizeof **copy);
    if (!*copy)
        return pp_fail_memory(err);
    **copy = *room;
    copy_parts(*copy, &good);
    if (good)
        return PP_OK;
    pp_room_destroy(*copy);
    *copy = NULL;
    return pp_fail_memory(err);
}

void pp_room_destroy(struct pp_room *room)
{
    if (room)
        pp_room_parts_clear(room);
    free(room);
}

/* ---- Openings ---- */

int pp_room_opening_count(const struct pp_room *room)
{
    return room->opening_count;
}

struct pp_room_opening pp_room_opening_at(const struct pp_room *room, int index)
{
    const struct pp_opening_part *part = &room->openings[index];
    struct pp_room_opening opening = {.kind = part->kind,
                                      .wall = part->wall,
                                      .place = {NAN, NAN, NAN, NAN},
                                      .glass = part->glazing.glass,
                                      .frame_factor = part->glazing.frame_factor,
                                      .maintenance = part->glazing.maintenance,
                                      .line = part->line};
    if (part->kind == PP_WINDOW)
        opening.place = (struct pp_opening_place){part->left_m, part->width_m,
                                                  part->sill_m, part->height_m};
    else if (part->kind == PP_ROOFLIGHT)
        opening.place =
            (struct pp_opening_place){part->x, part->width_m, part->y, part->depth_m};
    return opening;
}

static void put_place(struct pp_opening_part *part, struct pp_opening_place place)
{
    if (part->kind == PP_WINDOW) {
        part->left_m = place.left_m;
        part->sill_m = place.sill_m;
        part->height_m = place.height_m;
    } else {
        part->x = place.left_m;
        part->y = place.sill_m;
        part->depth_m = place.height_m;
    }
    part->width_m = place.width_m;
}

void pp_room_set_place(struct pp_room *room, int index, struct pp_opening_place place)
{
    put_place(&room->openings[index], place);
}

enum pp_status pp_room_repeat_opening(struct pp_room *room, int index,
                                      struct pp_opening_place place,
                                      struct pp_error *err)
{
    int count = room->opening_count;
    int space = count;
    enum pp_status status = pp_array_reserve(&room->openings, &space, count + 1,
                                             sizeof *room->openings, err);
    if (status != PP_OK)
        return status;
    bool good = true;
    struct pp_opening_part *added = &room->openings[count];
    *added = room->openings[index];
    added->name = NULL;
    copy_text(&added->wall, &good);
    copy_vertices(&added->vertices, &good);
    COPY_LIST(added->shades, added->shade_count, &good);
    pp_measured_pane_hold(added->glazing.measured);
    put_place(added, place);
    room->opening_count++;
    return good ? PP_OK : pp_fail_memory(err);
}

enum pp_status pp_room_set_wall(struct pp_room *room, int index, const char *wall,
                                struct pp_error *err)
{
    char *copy = strdup(wall);
    if (!copy)
        return pp_fail_memory(err);
    free(room->openings[index].wall);
    room->openings[index].wall = copy;
    return PP_OK;
}

void pp_room_remove_opening(struct pp_room *room, int index)
{
    struct pp_opening_part *part = &room->openings[index];
    free(part->wall);
    free(part->name);
    free(part->shades);
    pp_measured_pane_release(part->glazing.measured);
    pp_room_parts_clear_vertices(&part->vertices);
    int behind = --room->opening_count - index;
    memmove(part, part + 1, (size_t)behind * sizeof *part);
}

void pp_room_set_glass(struct pp_room *room, int index, struct pp_glass glass)
{
    struct pp_glazing_part *glazing = &room->openings[index].glazing;
    if (pp_glass_is_same(&glazing->glass, &glass))
        return;
    glazing->glass = glass;
    pp_measured_pane_release(glazing->measured);
    glazing->measured = NULL;
}

void pp_room_set_frame_factor(struct pp_room *room, int index, double frame_factor)
{
    room->openings[index].glazing.frame_factor = frame_factor;
}

void pp_room_set_maintenance(struct pp_room *room, int index, double maintenance)
{
    room->openings[index].glazing.maintenance = maintenance;
}

/* ---- the room and its surroundings ---- */

enum pp_status pp_room_set_sky(struct pp_room *room, const char *spec,
                               struct pp_error *err)
{
    return pp_sky_words_parse(&room->sky, spec, err);
}

void pp_room_set_working_plane(struct pp_room *room, double height_m)
{
    room->working_plane_m = height_m;
}

void pp_room_take_sky(struct pp_room *room, const struct pp_room *other)
{
    struct pp_sky_part sky = pp_sky_words_copy(&other->sky);
    pp_sky_words_clear(&room->sky);
    room->sky = sky;
}

void pp_room_lighten(struct pp_room *room, enum pp_role role, double reflectance)
{
    double *shared = role == PP_FLOOR  ? &room->floor
                     : role == PP_WALL ? &room->walls
                                       : &room->ceiling;
    *shared = fmax(*shared, reflectance);
    for (int i = 0; i < room->finish_count && role == PP_WALL; i++)
        room->finishes[i].reflectance =
            fmax(room->finishes[i].reflectance, reflectance);
    for (int i = 0; i < room->plan.face_count; i++) {
        struct pp_face_part *face = &room->plan.faces[i];
        if (face->role == role && !isnan(face->reflectance))
            face->reflectance = fmax(face->reflectance, reflectance);
    }
}

void pp_room_set_ground(struct pp_room *room, double reflectance, bool open)
{
    room->site.ground_reflectance = reflectance;
    room->site.ground_is_open = open;
}

enum pp_status pp_room_add_skyline(struct pp_room *room, const char *wall,
                                   double angle_rad, double reflectance,
                                   struct pp_error *err)
{
    int count = room->skyline_count, space = count;
    enum pp_status status = pp_array_reserve(&room->skylines, &space, count + 1,
                                             sizeof *room->skylines, err);
    if (status != PP_OK)
        return status;
    char *name = strdup(wall);
    if (!name)
        return pp_fail_memory(err);
    room->skylines[room->skyline_count++] =
        (struct pp_skyline_part){.wall = name,
                                 .angle_rad = angle_rad,
                                 .distance_m = INFINITY,
                                 .reflectance = reflectance,
                                 .line = room->line};
    return PP_OK;
}

void pp_room_clear_surroundings(struct pp_room *room, const struct pp_world *world)
{
    for (int i = 0; i < room->skyline_count; i++)
        free(room->skylines[i].wall);
    for (int i = 0; i < room->block_count; i++)
        free(room->blocks[i].name);
    for (int i = 0; i < room->mesh_count; i++)
        pp_room_parts_clear_mesh(&room->meshes[i]);
    room->skyline_count = room->block_count = room->mesh_count = 0;

    /* Free-standing surfaces of the world are in file order. */
    int kept = 0, index = 0;
    for (int i = 0; i < world->surface_count && index < room->surface_count; i++) {
        if (world->surfaces[i].role != PP_FREE_SURFACE)
            continue;
        struct pp_surface_part *part = &room->surfaces[index++];
        if (world->surfaces[i].inside) {
            room->surfaces[kept++] = *part;
        } else {
            pp_room_parts_clear_surface(part);
        }
    }
    room->surface_count = kept;
}

void pp_room_clear_facades(struct pp_room *room)
{
    for (int i = 0; i < room->facade_count; i++)
        free(room->facades[i].wall);
    room->facade_count = 0;
}

/* ---- validity ---- */

enum pp_status pp_room_is_sound(bool *sound, const struct pp_room *room,
                                struct pp_error *err)
{
    struct pp_mistakes mistakes;
    struct pp_world *world = NULL;
    pp_mistakes_init(&mistakes, "room");
    enum pp_status status = pp_world_create(&world, room, &mistakes, err);
    *sound = status == PP_OK;
    pp_world_destroy(world);
    pp_mistakes_clear(&mistakes);
    return status == PP_BAD_INPUT ? PP_OK : status;
}

double pp_room_grid_spacing(const struct pp_room *room)
{
    double finest = NAN;
    for (int i = 0; i < room->receiver_count; i++)
        if (room->receivers[i].kind == PP_GRID)
            finest = fmin(finest, room->receivers[i].spacing_m);
    return finest;
}
