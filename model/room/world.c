/* world.c - see world.h: from a room to its world, step by step (build/). */
#include "model/room/world.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/convex_parts.h"
#include "model/room/outside/blocks.h"
#include "model/room/build/corners.h"
#include "model/room/build/covers.h"
#include "model/room/build/envelope.h"
#include "model/room/outside/facades.h"
#include "model/room/build/fittings.h"
#include "model/room/build/free_surfaces.h"
#include "model/room/outside/gardens.h"
#include "model/room/build/inner_walls.h"
#include "model/room/build/place_openings.h"
#include "model/room/build/receivers.h"
#include "model/room/build/resolve.h"
#include "model/room/outside/meshes.h"
#include "model/room/outside/shades.h"
#include "model/room/build/reveals.h"
#include "model/room/build/self_occlusion.h"
#include "model/room/outside/skylines.h"
#include "model/room/build/watertight.h"
#include "model/room/build/working_plane.h"
#include "model/room/corrections.h"

void pp_world_destroy(struct pp_world *world)
{
    if (!world)
        return;
    for (int i = 0; i < world->surface_count; i++) {
        pp_polygon_clear(&world->surfaces[i].outline);
        free(world->surfaces[i].triangles);
        free((char *)world->surfaces[i].name);
    }
    for (int i = 0; i < world->opening_count; i++) {
        pp_polygon_clear(&world->openings[i].inner);
        pp_polygon_clear(&world->openings[i].outer);
        free(world->openings[i].name);
    }
    free(world->surfaces);
    for (int i = 0; i < world->block_count; i++)
        free(world->blocks[i].name);
    for (int i = 0; i < world->mesh_count; i++)
        free(world->meshes[i].name);
    free(world->meshes);
    for (int i = 0; i < world->garden_count; i++) {
        pp_polygon_clear(&world->gardens[i].outline);
        free(world->gardens[i].name);
    }
    free(world->gardens);
    free(world->openings);
    free(world->skylines);
    free(world->facades);
    free(world->blocks);
    free(world->fittings);
    free(world->receivers);
    free(world->name);
    free(world->ref);
    pp_region_clear(&world->plane);
    free(world);
}

int pp_world_before_meshes(const struct pp_world *world)
{
    return world->mesh_count > 0 ? world->meshes[0].first_side : world->surface_count;
}

int pp_world_next_but_blocks(const struct pp_world *world, int i)
{
    if (world->surfaces[i].role != PP_BLOCK)
        return i + 1;
    const struct pp_block *last = &world->blocks[world->block_count - 1];
    return last->first_side + last->side_count;
}

static enum pp_status resolve_site(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    struct pp_world *world = r->world;
    world->placement = room->placement;
    world->north_rad = room->north_rad;
    world->latitude_rad = room->site.latitude_rad;
    world->longitude_rad = room->site.longitude_rad;
    memcpy(world->country, room->site.country, sizeof world->country);
    world->surroundings = room->site.surroundings;
    world->work = room->site.work;
    world->dirt = room->site.dirt;
    world->decorations =
        isnan(room->decorations)
            ? pp_corrections_decorations(world->surroundings, world->work)
            : room->decorations;
    world->ground_level_m = room->site.ground_level_m;
    world->ground_is_open = room->site.ground_is_open;
    world->use = room->use;
    world->name = room->name ? strdup(room->name) : NULL;
    world->ref = room->ref ? strdup(room->ref) : NULL;
    if ((room->name && !world->name) || (room->ref && !world->ref))
        return pp_fail_memory(err);
    return PP_OK;
}

static bool check_comparable(struct pp_resolver *r)
{
    const struct pp_room *room = r->room;
    if (pp_resolve_is_comparable(room))
        return true;
    pp_mistakes_add(
        r->mistakes, room->line,
        "room: has %d faces, %d openings, %d blocks and %d surfaces, too many to "
        "compare with each other; expected fewer",
        room->plan.face_count, room->opening_count, room->block_count,
        room->surface_count);
    return false;
}

static enum pp_status find_triangles(struct pp_resolver *r, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < r->world->surface_count && status == PP_OK; i++) {
        struct pp_surface *surface = &r->world->surfaces[i];
        status = pp_convex_parts_triangles(
            &surface->triangles, &surface->triangle_count, &surface->outline, err);
    }
    return status;
}

static enum pp_status resolve_world(struct pp_resolver *r, struct pp_error *err)
{
    if (!check_comparable(r))
        return PP_OK;
    static enum pp_status (*const steps[])(struct pp_resolver *, struct pp_error *) = {
        resolve_site,           pp_build_envelope,       pp_build_corners,
        pp_build_watertight,    pp_build_place_openings, pp_build_reveals,
        pp_build_facades,       pp_build_blocks,         pp_build_skylines,
        pp_build_free_surfaces, pp_build_fittings,       pp_build_covers,
        pp_build_inner_walls,   pp_build_shades,         pp_build_gardens,
        pp_build_working_plane, pp_build_receivers,      find_triangles,
        pp_build_meshes,        pp_build_self_occlusion};
    enum pp_status status = pp_clipper_create(&r->clipper, err);
    for (size_t i = 0; i < sizeof steps / sizeof *steps && status == PP_OK; i++)
        status = steps[i](r, err);

    pp_clipper_destroy(r->clipper);
    for (int i = 0; i < r->wall_count; i++)
        free(r->walls[i]);
    free(r->walls);
    free(r->wall_faces);
    free(r->corners);
    return status;
}

bool pp_world_skyline_is_far(const struct pp_skyline *skyline, int face)
{
    return skyline->face == face && isinf(skyline->distance_m);
}

double pp_world_skyline_angle(const struct pp_skyline *skyline, double z_m,
                              double behind_m)
{
    if (isinf(skyline->distance_m))
        return skyline->angle_rad;
    return atan2(skyline->head_z_m - z_m, skyline->distance_m + behind_m);
}

enum pp_status pp_world_create(struct pp_world **world, const struct pp_room *room,
                               struct pp_mistakes *mistakes, struct pp_error *err)
{
    *world = NULL;
    struct pp_world *made = calloc(1, sizeof *made);
    if (!made)
        return pp_fail_memory(err);
    struct pp_resolver r = {.room = room, .world = made, .mistakes = mistakes};
    struct pp_error fault = {0};
    enum pp_status status = resolve_world(&r, &fault);
    /* For example polygons that GEOS can't overlay. */
    if (status == PP_BAD_INPUT)
        pp_mistakes_add(mistakes, room->line, "room: %s", fault.message);
    else if (status != PP_OK)
        pp_fail(err, status, "%s", fault.message);
    int count = mistakes->count;
    if (status != PP_SYSTEM && (count > 0 || mistakes->truncated))
        status = pp_fail(err, PP_BAD_INPUT, "%s: %d mistake%s",
                         mistakes->file ? mistakes->file : "room file", count,
                         count == 1 ? "" : "s");
    if (status != PP_OK) {
        pp_world_destroy(made);
        return status;
    }
    *world = made;
    return PP_OK;
}
