/* world.c - resolves a room into its world, step by step. Large steps have their own
 * files in build/ and outside/. */
#include "model/room/world.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/convex_parts.h"
#include "model/room/build/corners.h"
#include "model/room/build/covers.h"
#include "model/room/build/envelope.h"
#include "model/room/build/fittings.h"
#include "model/room/build/mean_patterns.h"
#include "model/room/build/free_surfaces.h"
#include "model/room/build/outline.h"
#include "model/light/slats/blind.h"
#include "model/room/build/place_openings.h"
#include "model/room/build/receivers.h"
#include "model/room/build/views.h"
#include "model/room/build/resolve.h"
#include "model/room/build/reveals.h"
#include "model/room/build/watertight.h"
#include "model/room/corrections.h"
#include "model/room/outside/blocks.h"
#include "model/room/outside/facades.h"
#include "model/room/outside/meshes.h"
#include "model/room/outside/nested.h"
#include "model/room/outside/shades.h"
#include "model/room/outside/skylines.h"
#include "model/room/outside/trees.h"
#include "model/room/section.h"

struct pp_world *pp_world_hold(struct pp_world *world)
{
    if (world)
        world->holders++;
    return world;
}

void pp_world_destroy(struct pp_world *world)
{
    if (!world || world->holders-- > 0)
        return;
    pp_world_destroy(world->within);
    for (int i = 0; i < world->outer_pane_count; i++)
        pp_polygon_clear(&world->outer_panes[i].outline);
    free(world->outer_panes);
    free(world->trees);
    pp_rough_finishes_release(world->materials);
    for (int i = 0; i < world->surface_count; i++) {
        pp_polygon_clear(&world->surfaces[i].outline);
        free(world->surfaces[i].triangles);
        free((char *)world->surfaces[i].name);
    }
    for (int i = 0; i < world->opening_count; i++) {
        pp_polygon_clear(&world->openings[i].inner);
        pp_polygon_clear(&world->openings[i].outer);
        free(world->openings[i].name);
        pp_blind_release(world->openings[i].blind);
        pp_measured_pane_release(world->openings[i].measured);
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
    for (int i = 0; i < world->view_count; i++)
        free(world->views[i].name);
    free(world->views);
    free(world->name);
    free(world->ref);
    free(world->address);
    pp_region_clear(&world->plane);
    free(world);
}

const char *pp_world_label(const struct pp_world *world, int line)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].line == line)
            return world->openings[i].label;
    return "";
}

const char *pp_world_kind(const struct pp_world *world, int line)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].line == line
            && world->surfaces[world->openings[i].face].role != PP_WALL)
            return "rooflight";
    return "window";
}

double pp_world_floor_m2(const struct pp_world *world)
{
    double area_m2 = 0.0;
    for (int i = 0; i < world->face_count; i++)
        if (world->surfaces[i].role == PP_FLOOR)
            area_m2 += world->surfaces[i].outline.area_m2;
    return area_m2;
}

int pp_world_coarse_panes(const struct pp_world *world)
{
    int count = 0;
    for (int i = 0; i < world->outer_pane_count; i++)
        count += world->outer_panes[i].tree < 0;
    return count;
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
    world->bare_from = room->site.bare_from;
    world->bare_to = room->site.bare_to;
    world->use = room->use;
    world->name = room->name ? strdup(room->name) : NULL;
    world->ref = room->ref ? strdup(room->ref) : NULL;
    world->address = room->address ? strdup(room->address) : NULL;
    if ((room->name && !world->name) || (room->ref && !world->ref)
        || (room->address && !world->address))
        return pp_fail_memory(err);
    return PP_OK;
}

static bool check_comparable(struct pp_resolver *r)
{
    const struct pp_room *room = r->room;
    if (pp_resolve_is_comparable(room))
        return true;
    pp_mistakes_add(r->mistakes, room->line,
                    "room: has %d faces, %d openings, %d blocks and %d surfaces, too "
                    "many to check for overlaps; expected fewer",
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

/* ---- inner walls ---- */

/* Thickest wall between two rooms; chosen, not measured. */
static const double inner_wall_most_m = 0.6;

/* Marks walls that the file declares as inner ones; reports those with openings. */
static void mark_stated_inner_walls(struct pp_resolver *r)
{
    for (int i = 0; i < r->room->wall_kind_count; i++) {
        const struct pp_wall_part *part = &r->room->wall_kinds[i];
        int face = pp_resolve_wall(r, part->name, "wall", part->line);
        if (face < 0 || !part->is_inner)
            continue;
        r->world->surfaces[face].is_inner = true;
        for (int k = 0; k < r->world->opening_count; k++) {
            if (r->world->openings[k].face != face)
                continue;
            pp_mistakes_add(r->mistakes, part->line,
                            "wall: is an internal wall, but has the opening on line "
                            "%d; expected no opening, or kind \"outer\"",
                            r->world->openings[k].line);
            break;
        }
    }
}

/* True if the other room's face is opposite the wall and close behind its centre. */
static bool is_behind(const struct pp_polygon *wall, const struct pp_polygon *other)
{
    return pp_vec_dot(wall->normal, other->normal) < -0.5
           && pp_polygon_distance(other, pp_polygon_middle(wall)) <= inner_wall_most_m;
}

/* Marks inner walls: those declared in the file, and those with another placed room
 * directly behind them. */
static enum pp_status mark_inner_walls(struct pp_resolver *r, struct pp_error *err)
{
    struct pp_world *world = r->world;
    mark_stated_inner_walls(r);
    for (int i = 0; i < r->room->surface_count; i++) {
        const struct pp_surface_part *part = &r->room->surfaces[i];
        struct pp_polygon other;
        if (!part->is_room_outside)
            continue;
        if (pp_polygon_of(&other, part->vertices.list, part->vertices.count, err)
            != PP_OK)
            return PP_SYSTEM;
        for (int k = 0; k < world->face_count; k++) {
            struct pp_surface *wall = &world->surfaces[k];
            wall->is_inner |=
                wall->role == PP_WALL && is_behind(&wall->outline, &other);
        }
        pp_polygon_clear(&other);
    }
    return PP_OK;
}

/* ---- gardens ---- */

/* Adds a garden at ground level, with its normal up. */
static enum pp_status add_garden(struct pp_resolver *r,
                                 const struct pp_garden_part *part,
                                 struct pp_error *err)
{
    struct pp_world *world = r->world;
    struct pp_garden *garden = &world->gardens[world->garden_count];
    *garden = (struct pp_garden){.line = part->line};
    enum pp_status status =
        pp_polygon_of(&garden->outline, part->vertices.list, part->vertices.count, err);
    if (status != PP_OK)
        return status;
    world->garden_count++;
    for (int i = 0; i < garden->outline.count; i++)
        garden->outline.vertices[i].z = world->ground_level_m;
    if (garden->outline.normal.z < 0.0)
        for (int i = 0, k = garden->outline.count - 1; i < k; i++, k--) {
            struct pp_vec3 kept = garden->outline.vertices[i];
            garden->outline.vertices[i] = garden->outline.vertices[k];
            garden->outline.vertices[k] = kept;
        }
    pp_polygon_measure(&garden->outline);
    garden->name = part->name ? strdup(part->name) : NULL;
    return part->name && !garden->name ? pp_fail_memory(err) : PP_OK;
}

static enum pp_status resolve_gardens(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    r->world->gardens =
        calloc((size_t)room->garden_count + 1, sizeof(struct pp_garden));
    if (!r->world->gardens)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    for (int i = 0; i < room->garden_count && status == PP_OK; i++) {
        const struct pp_garden_part *part = &room->gardens[i];
        if (pp_build_outline_is_good(r, "garden", part->line, &part->vertices))
            status = add_garden(r, part, err);
    }
    return status;
}

/* ---- working plane ---- */

/* Sets the working plane and the room's section at its height. */
static enum pp_status resolve_working_plane(struct pp_resolver *r, struct pp_error *err)
{
    struct pp_world *world = r->world;
    double z = r->room->working_plane_m;
    world->working_plane_m = z;
    if (!r->watertight || !isfinite(z))
        return PP_OK;

    double low = INFINITY;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++)
            low = fmin(low, world->surfaces[i].outline.vertices[k].z);
    if (!(z >= low) || !(z < world->height_m)) {
        int line = r->room->working_plane_line;
        pp_mistakes_add(r->mistakes, line ? line : r->room->line,
                        "working-plane: its height is %g m%s; expected at least %g m, "
                        "the floor of the room, and less than %g m, its top",
                        z, line ? "" : ", the default", low, world->height_m);
        return PP_OK;
    }

    return pp_section_cut(&world->plane, world, r->corners, z, err);
}

/* ---- self-occlusion ---- */

/* Compares the corners of the opening with the planes of faces, and the corners of
 * faces with the plane of its glass. */
static void find_self_occlusion(struct pp_opening *opening,
                                const struct pp_world *world)
{
    opening->faces_open_in = opening->faces_open_out = true;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        opening->faces_open_in &= pp_polygon_is_before(&opening->inner, face);
        opening->faces_open_out &= pp_polygon_is_before(face, &opening->outer);
    }
}

/* Sets for each opening whether faces can hide it from inside or from outside, and for
 * the world whether there are free-standing surfaces in the room. */
static enum pp_status resolve_self_occlusion(struct pp_resolver *r,
                                             struct pp_error *err)
{
    (void)err;
    struct pp_world *world = r->world;
    for (int i = 0; i < world->opening_count; i++)
        find_self_occlusion(&world->openings[i], world);
    world->is_empty = true;
    for (int i = 0; i < world->surface_count; i++)
        world->is_empty &=
            !(world->surfaces[i].inside && world->surfaces[i].role == PP_FREE_SURFACE);
    return PP_OK;
}

/* ---- all steps ---- */

static enum pp_status resolve_world(struct pp_resolver *r, struct pp_error *err)
{
    if (!check_comparable(r))
        return PP_OK;
    static enum pp_status (*const steps[])(struct pp_resolver *, struct pp_error *) = {
        resolve_site,           pp_build_envelope,       pp_build_corners,
        pp_build_watertight,    pp_build_place_openings, pp_build_reveals,
        pp_build_facades,       pp_build_blocks,         pp_build_skylines,
        pp_build_free_surfaces, pp_build_fittings,       pp_build_covers,
        mark_inner_walls,       pp_build_mean_patterns,  pp_build_shades,
        resolve_gardens,        resolve_working_plane,   pp_build_receivers,
        pp_build_views,         pp_build_nested,         pp_build_trees,
        find_triangles,         pp_build_meshes,         resolve_self_occlusion};
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
    made->materials = pp_rough_finishes_hold(room->materials);
    made->within = pp_world_hold(room->within.world);
    struct pp_resolver r = {.room = room, .world = made, .mistakes = mistakes};
    struct pp_error fault = {0};
    enum pp_status status = resolve_world(&r, &fault);
    /* A fault of the input, such as polygons that GEOS cannot overlay, is reported as a
     * mistake. */
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
