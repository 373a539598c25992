/* room_shell.c - see room_shell.h. */
#include "model/room/outside/room_shell.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/region_pieces.h"
#include "model/geometry/tolerance.h"
#include "model/room/build/corners.h"
#include "model/room/build/envelope.h"
#include "model/room/build/free_surfaces.h"
#include "model/room/build/place_openings.h"
#include "model/room/build/resolve.h"
#include "model/room/build/reveals.h"
#include "model/room/build/watertight.h"
#include "model/room/face_less_openings.h"
#include "model/room/outside/facades.h"
#include "model/room/outside/shades.h"
#include "model/room/outside/site_state.h"

/* Reflectance of the outer faces of walls and roofs. */
static const double outside_reflectance = 0.2;

void pp_room_shell_clear(struct pp_room_shell *shell)
{
    pp_world_destroy(shell->body);
    for (int i = 0; i < shell->wall_count; i++)
        free(shell->walls[i]);
    free(shell->walls);
    for (int i = 0; i < shell->carried_count; i++)
        pp_room_parts_clear_surface(&shell->carried[i].part);
    free(shell->carried);
    free(shell->is_divided);
    for (int i = 0; i < shell->front_count; i++)
        pp_room_front_clear(&shell->fronts[i]);
    free(shell->fronts);
    pp_room_destroy(shell->own);
    *shell = (struct pp_room_shell){0};
}

bool pp_room_shell_has_wall(const struct pp_room_shell *shell, const char *name)
{
    for (int i = 0; i < shell->wall_count; i++)
        if (name && strcmp(shell->walls[i], name) == 0)
            return true;
    return false;
}

bool pp_room_shell_shares_front(const struct pp_room_shell *shell,
                                const struct pp_room_carried *shade)
{
    for (int i = 0; i < shell->body->face_count; i++) {
        const struct pp_polygon *wall = &shell->body->surfaces[i].outline;
        if (pp_vec_length(pp_vec_cross(wall->normal, shade->out)) < PP_LEVEL_RAD
            && pp_vec_dot(wall->normal, shade->out) < 0.0
            && fabs(pp_polygon_height(wall, shade->at)) < PP_ROOM_FRONT_BEHIND_M)
            return true;
    }
    return false;
}

/* ---- parts fixed outside ---- */

static bool has_outside(const struct pp_room *room)
{
    bool some =
        room->facade_count + room->surface_count + room->block_count + room->mesh_count
        > 0;
    for (int i = 0; i < room->opening_count; i++)
        some |= room->openings[i].shade_count > 0;
    return some;
}

/* Adds a copy of the part with these corners, which are in the room's axes. */
static enum pp_status carry(struct pp_room_shell *shell,
                            const struct pp_room_carried *it,
                            const struct pp_vec3 *corners, int count,
                            struct pp_error *err)
{
    struct pp_room_carried added = *it;
    enum pp_status status =
        pp_room_parts_copy_surface(&added.part, &it->part, corners, count, err);
    if (status != PP_OK)
        return status;
    added.part.is_of_site = !added.part.is_room_outside;
    for (int i = 0; i < count; i++)
        added.part.vertices.list[i] =
            pp_placement_to_building(&shell->placement, corners[i]);
    status = pp_array_append(&shell->carried, shell->carried_count,
                             sizeof *shell->carried, err);
    if (status == PP_OK)
        shell->carried[shell->carried_count++] = added;
    else
        pp_room_parts_clear_surface(&added.part);
    return status;
}

/* Adds the shade of a window. */
static enum pp_status carry_shade(struct pp_room_shell *shell,
                                  const struct pp_surface *surface,
                                  struct pp_error *err)
{
    const struct pp_world *world = shell->body;
    const struct pp_placement *place = &shell->placement;
    const struct pp_opening *opening = &world->openings[surface->owner];
    const struct pp_polygon *wall = &world->surfaces[opening->face].outline;
    struct pp_room_carried shade = {
        .part = {.reflectance = surface->front,
                 .finish = surface->finish,
                 .what = pp_shades_word(&shell->own->openings[opening->part],
                                        surface->line),
                 .line = surface->line},
        .is_shade = true,
        .at = pp_placement_to_building(place, wall->vertices[0]),
        .out = pp_vec_scale(pp_placement_turn(wall->normal, place->rotate_rad), -1.0)};
    return carry(shell, &shade, surface->outline.vertices, surface->outline.count, err);
}

/* Adds a rim of a hole in a facade. The facade's sheet is added as a front. */
static enum pp_status carry_rim(struct pp_room_shell *shell,
                                const struct pp_surface *surface, struct pp_error *err)
{
    struct pp_room_carried rim = {.part = {.reflectance = surface->front,
                                           .finish = surface->finish,
                                           .what = "facade",
                                           .line = surface->line}};
    return carry(shell, &rim, surface->outline.vertices, surface->outline.count, err);
}

static enum pp_status carry_surfaces(struct pp_room_shell *shell, struct pp_error *err)
{
    const struct pp_world *world = shell->body;
    const struct pp_room *own = shell->own;
    int index = 0; /* free-standing surfaces in file order */
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->surface_count && status == PP_OK; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        if (surface->role == PP_FACADE && !pp_room_front_is_of_sheet(world, i))
            status = carry_rim(shell, surface, err);
        if (surface->role != PP_FREE_SURFACE)
            continue;
        if (surface->is_shade) {
            if (!surface->inside)
                status = carry_shade(shell, surface, err);
            continue;
        }
        if (!surface->inside) {
            const struct pp_surface_part *part = &own->surfaces[index];
            status = carry(shell, &(struct pp_room_carried){.part = *part},
                           part->vertices.list, part->vertices.count, err);
        }
        index++;
    }
    return status;
}

static enum pp_status make_fronts(struct pp_room_shell *shell,
                                  struct pp_clipper *clipper, struct pp_error *err)
{
    const struct pp_world *world = shell->body;
    shell->fronts = calloc((size_t)world->facade_count + 1, sizeof *shell->fronts);
    enum pp_status status = shell->fronts ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < world->facade_count && status == PP_OK; i++)
        status = pp_room_front_of(&shell->fronts[shell->front_count++], world, i,
                                  &shell->placement, clipper, err);
    return status;
}

/* ---- faces with windows ---- */

static enum pp_status carry_rest(struct pp_room_shell *shell,
                                 const struct pp_room_carried *wall, int face,
                                 struct pp_clipper *clipper, struct pp_error *err)
{
    const struct pp_polygon *outline = &shell->body->surfaces[face].outline;
    const struct pp_face_axes axes = pp_face_less_openings_axes(outline);
    struct pp_region rest;
    struct pp_region_pieces pieces = {0};
    enum pp_status status =
        pp_face_less_openings(&rest, clipper, &axes, outline, shell->body, face, err);
    if (status == PP_OK)
        status = pp_region_pieces_cut(&pieces, &rest, axes.origin, axes.a, axes.b,
                                      PP_ROOM_FRONT_PIECE_M2, clipper, err);
    for (int i = 0; i < pieces.count && status == PP_OK; i++)
        status = carry(shell, wall, pieces.list[i].corners, pieces.list[i].count, err);
    pp_region_pieces_clear(&pieces);
    pp_region_clear(&rest);
    return status;
}

/* Divides faces with windows into panes, in the plane of the face, and the rest of the
 * face. */
static enum pp_status divide_faces(struct pp_room_shell *shell,
                                   double glass_reflectance, struct pp_clipper *clipper,
                                   struct pp_error *err)
{
    const struct pp_world *world = shell->body;
    struct pp_room_carried piece = {.part = {.reflectance = glass_reflectance,
                                             .name = shell->own->name,
                                             .is_room_outside = true,
                                             .line = shell->own->line}};
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_polygon *pane = &world->openings[i].inner;
        shell->is_divided[world->openings[i].face] = true;
        status = carry(shell, &piece, pane->vertices, pane->count, err);
    }
    for (int i = 0; i < world->face_count && status == PP_OK; i++) {
        piece.part.reflectance = world->surfaces[i].back;
        if (shell->is_divided[i])
            status = carry_rest(shell, &piece, i, clipper, err);
    }
    return status;
}

/* ---- the room alone ---- */

/* Resolves the faces and, if `outside`, all parts needed to place those outside,
 * without offsetting surfaces. *sound: there were no mistakes. Mistakes are reported
 * where the room itself is resolved, not here. */
static enum pp_status resolve_shell(struct pp_room_shell *shell,
                                    const struct pp_room *room, bool outside,
                                    bool *sound, struct pp_clipper *clipper,
                                    struct pp_error *err)
{
    static enum pp_status (*const steps[])(struct pp_resolver *, struct pp_error *) = {
        pp_build_envelope,       pp_build_corners, pp_build_watertight,
        pp_build_place_openings, pp_build_reveals, pp_build_facades,
        pp_build_free_surfaces,  pp_build_shades};
    const size_t count = outside ? sizeof steps / sizeof *steps : 1;
    struct pp_mistakes unsaid;
    pp_mistakes_init(&unsaid, "room");
    struct pp_resolver r = {.room = room,
                            .world = shell->body,
                            .clipper = clipper,
                            .mistakes = &unsaid,
                            .keeps_places = true};
    struct pp_error fault = {0};
    shell->body->ground_level_m = room->site.ground_level_m;
    enum pp_status status = PP_OK;
    for (size_t i = 0; i < count && status == PP_OK; i++)
        status = steps[i](&r, &fault);
    shell->walls = r.walls;
    shell->wall_count = r.wall_count;
    *sound = status == PP_OK && unsaid.count == 0;
    free(r.wall_faces);
    free(r.corners);
    pp_mistakes_clear(&unsaid);
    return status == PP_SYSTEM ? pp_fail(err, status, "%s", fault.message) : PP_OK;
}

/* Sets the outer reflectances of the faces. A wall whose facade lies in its plane has
 * the facade's reflectance. */
static void set_reflectances(struct pp_world *body)
{
    for (int i = 0; i < body->face_count; i++)
        body->surfaces[i].back = outside_reflectance;
    for (int i = 0; i < body->facade_count; i++)
        if (body->facades[i].depth_m < PP_SET_OFF_M)
            body->surfaces[body->facades[i].face].back = body->facades[i].reflectance;
}

static void turn_body(struct pp_room_shell *shell)
{
    for (int i = 0; i < shell->body->face_count; i++) {
        struct pp_polygon *face = &shell->body->surfaces[i].outline;
        for (int k = 0; k < face->count; k++)
            face->vertices[k] =
                pp_placement_to_building(&shell->placement, face->vertices[k]);
        pp_polygon_measure(face);
    }
}

/* Adds the parts fixed outside a room without mistakes, and the panes in its faces. */
static enum pp_status fit_out(struct pp_room_shell *shell, double glass_reflectance,
                              struct pp_clipper *clipper, struct pp_error *err)
{
    enum pp_status status = carry_surfaces(shell, err);
    if (status == PP_OK && shell->body->facade_count > 0)
        status = make_fronts(shell, clipper, err);
    if (status == PP_OK && !isnan(glass_reflectance))
        status = divide_faces(shell, glass_reflectance, clipper, err);
    return status;
}

enum pp_status pp_room_shell_make(struct pp_room_shell *shell,
                                  const struct pp_room *room, enum pp_site_state state,
                                  bool outside, double glass_reflectance,
                                  struct pp_clipper *clipper, struct pp_error *err)
{
    outside = outside && (has_outside(room) || !isnan(glass_reflectance))
              && pp_resolve_is_comparable(room);
    bool sound = false;
    *shell = (struct pp_room_shell){.placement = room->placement,
                                    .body = calloc(1, sizeof *shell->body)};
    enum pp_status status = shell->body ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK && outside)
        status = pp_room_copy(&shell->own, room, err);
    if (status != PP_OK)
        return status;
    if (outside)
        pp_site_state_keep(shell->own, state);
    status = resolve_shell(shell, outside ? shell->own : room, outside, &sound, clipper,
                           err);
    shell->is_divided =
        calloc((size_t)shell->body->face_count + 1, sizeof *shell->is_divided);
    if (status == PP_OK && !shell->is_divided)
        status = pp_fail_memory(err);
    set_reflectances(shell->body);
    if (status == PP_OK && outside && sound)
        status = fit_out(shell, glass_reflectance, clipper, err);
    if (!sound) {
        pp_room_destroy(shell->own);
        shell->own = NULL;
    }
    turn_body(shell);
    return status;
}
