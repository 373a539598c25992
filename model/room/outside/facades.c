/* facades.c - see facades.h.
 *
 * The sheet of a facade lies in the wall's plane, offset outwards by the facade's
 * depth. It is the bounding rectangle of the wall, extended by left, right, up and
 * down, less the openings. It is made of triangles that share corners with each other
 * and with the rims. A rim joins an opening's pane to its hole in the sheet if the pane
 * is recessed.
 *
 * A sheet in the plane of the wall has a gap for the wall; the back of the wall is then
 * the facade there. The sheet does not extend below ground level. Light can enter the
 * space between wall and sheet from the sides, where it meets only the back of the wall
 * and the back of the sheet.
 */
#include "model/room/outside/facades.h"

#include <stdlib.h>

#include "model/geometry/polygons_cross.h"
#include "model/geometry/tolerance.h"
#include "model/room/face_frame.h"
#include "model/room/position.h"

/* Larger depths are reported as probable typing errors. */
static const double depth_most_m = 10.0;

/* grid_m: grid of the clipper, so that an opening at the border of the sheet leaves no
 * slivers. same_corner_m: a returned corner nearer than this is the opening's own
 * corner. area_least_m2: smaller triangles are left out. */
static const double grid_m = 0x1p-30, same_corner_m = 1e-7, area_least_m2 = 1e-9;

/* A facade under construction. */
struct facade_site {
    const struct pp_facade_part *part;
    struct pp_face_frame frame; /* frame of the wall; frame.face is not used, since
                                 * adding surfaces invalidates it */
    struct pp_vec3 normal;      /* normal of the wall, into the room */
    int face;
    double depth_m;
    struct pp_bounds2 sheet;   /* extent of the sheet in the frame */
    struct pp_surface surface; /* properties shared by all its surfaces */
    bool reported;             /* true once a clash with the room is reported */
};

static bool is_flush(const struct facade_site *site)
{
    return site->depth_m < PP_SET_OFF_M;
}

/* ---- parts in the wall's plane ---- */

static bool is_in_plane(const struct facade_site *site, const struct pp_polygon *face)
{
    struct pp_vec3 from = pp_vec_sub(face->vertices[0], site->frame.origin);
    return pp_vec_length(pp_vec_cross(site->normal, face->normal)) < PP_LEVEL_RAD
           && pp_vec_dot(site->normal, face->normal) > 0.0
           && fabs(pp_vec_dot(site->normal, from)) < PP_ROUNDING_M;
}

static bool meets_sheet(const struct facade_site *site, const struct pp_vec3 *vertices,
                        int count)
{
    struct pp_bounds2 bounds = pp_bounds2_empty();
    for (int i = 0; i < count; i++) {
        double xy[1][2];
        pp_polygon_flatten(&vertices[i], 1, site->frame.origin, site->frame.along,
                           site->frame.up, xy);
        pp_bounds2_add(&bounds, xy[0][0], xy[0][1]);
    }
    for (int k = 0; k < 2; k++)
        if (bounds.low[k] > site->sheet.high[k] - PP_ROUNDING_M
            || bounds.high[k] < site->sheet.low[k] + PP_ROUNDING_M)
            return false;
    return true;
}

/* True if the opening is behind the sheet, so that the sheet needs a hole. */
static bool has_hole(const struct facade_site *site, const struct pp_world *world,
                     const struct pp_opening *opening)
{
    return is_in_plane(site, &world->surfaces[opening->face].outline)
           && meets_sheet(site, opening->inner.vertices, opening->inner.count);
}

/* Corner of the opening's outline, offset outwards to the sheet. */
static struct pp_vec3 hole_corner(const struct pp_opening *opening, int corner)
{
    return pp_vec_along(opening->outer.vertices[corner], -opening->recess_m,
                        opening->outer.normal);
}

/* ---- checks ---- */

/* Reports, once per facade, that it is in the room. */
static void note_clash(struct pp_resolver *r, struct facade_site *site,
                       struct pp_vec3 where)
{
    if (!site->reported)
        pp_mistakes_add(
            r->mistakes, site->part->line,
            "facade: intersects the room at (%g, %g, %g); expected all of it outside",
            where.x, where.y, where.z);
    site->reported = true;
}

/* Reports a facade whose rectangle crosses faces, reveals or panes. */
static enum pp_status check_clear(struct pp_resolver *r, struct facade_site *site,
                                  struct pp_error *err)
{
    const struct pp_world *world = r->world;
    struct pp_polygon whole;
    struct pp_vec3 where;
    bool cross = false;
    enum pp_status status =
        pp_polygon_of(&whole, world->facades[site->surface.owner].corners, 4, err);
    for (int i = 0; i < world->surface_count && status == PP_OK && !cross; i++)
        if (world->surfaces[i].inside)
            status = pp_polygons_cross(&cross, &whole, &world->surfaces[i].outline,
                                       &where, err);
    for (int i = 0; i < world->opening_count && status == PP_OK && !cross; i++)
        status =
            pp_polygons_cross(&cross, &whole, &world->openings[i].outer, &where, err);
    if (status == PP_OK && cross)
        note_clash(r, site, where);
    pp_polygon_clear(&whole);
    return status;
}

/* Reports a facade thicker than any wall, or thinner than the reveal of an opening. */
static bool check_depth(struct pp_resolver *r, const struct facade_site *site)
{
    if (site->depth_m > depth_most_m) {
        pp_mistakes_add(r->mistakes, site->part->line,
                        "facade: its depth is %g m; expected at most %g m",
                        site->depth_m, depth_most_m);
        return false;
    }
    for (int i = 0; i < r->world->opening_count; i++) {
        const struct pp_opening *opening = &r->world->openings[i];
        if (!has_hole(site, r->world, opening)
            || opening->reveal_m < site->depth_m + PP_ROUNDING_M)
            continue;
        pp_mistakes_add(r->mistakes, site->part->line,
                        "facade: its depth of %g m is less than the reveal depth of %g "
                        "m of the opening on line %d; expected at least the reveal "
                        "depth",
                        site->depth_m, opening->reveal_m, opening->line);
        return false;
    }
    return true;
}

/* Reports mistakes of a facade in that wall; true if there are none. */
static bool check_wall(struct pp_resolver *r, const struct pp_facade_part *part,
                       int face)
{
    const struct pp_world *world = r->world;
    for (int i = 0; i < world->facade_count; i++)
        if (world->facades[i].face == face) {
            pp_mistakes_add(
                r->mistakes, part->line,
                "facade: the wall already has a facade, on line %d; expected only one",
                world->facades[i].line);
            return false;
        }
    if (fabs(world->surfaces[face].outline.normal.z) > PP_LEVEL_RAD) {
        pp_mistakes_add(r->mistakes, part->line,
                        "facade: its wall is not vertical; expected a vertical wall");
        return false;
    }
    return true;
}

/* Reports a facade that overlaps another facade in the same plane. */
static bool check_others(struct pp_resolver *r, const struct facade_site *site)
{
    const struct pp_world *world = r->world;
    for (int i = 0; i < world->facade_count; i++) {
        const struct pp_facade *other = &world->facades[i];
        if (!is_in_plane(site, &world->surfaces[other->face].outline)
            || !meets_sheet(site, other->corners, 4))
            continue;
        pp_mistakes_add(r->mistakes, site->part->line,
                        "facade: overlaps the facade on line %d, whose wall is in the "
                        "same plane; expected one facade for both walls",
                        other->line);
        return false;
    }
    return true;
}

/* ---- rims ---- */

/* Adds the strip between the pane's outline and the sheet; it faces into the hole. */
static enum pp_status add_rim(struct pp_resolver *r, struct facade_site *site,
                              const struct pp_opening *opening, struct pp_error *err)
{
    int count = opening->outer.count;
    enum pp_status status = PP_OK;
    for (int i = 0; i < count && status == PP_OK; i++) {
        int next = (i + 1) % count;
        struct pp_vec3 quad[4] = {opening->outer.vertices[i],
                                  opening->outer.vertices[next],
                                  hole_corner(opening, next), hole_corner(opening, i)};
        status = pp_resolve_add_face(r, site->surface, quad, 4, err);
    }
    return status;
}

static enum pp_status add_rims(struct pp_resolver *r, struct facade_site *site,
                               struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < r->world->opening_count && status == PP_OK; i++) {
        struct pp_opening *opening = &r->world->openings[i];
        if (opening->recess_m > 0.0 && opening->facade == site->surface.owner)
            status = add_rim(r, site, opening, err);
    }
    return status;
}

/* ---- the sheet ---- */

/* Gap number `index` of the sheet: an opening or, for a sheet in the plane of the wall,
 * a wall in that plane. NULL if the opening or wall makes no gap. */
static const struct pp_polygon *gap_at(const struct pp_world *world,
                                       const struct facade_site *site, int index)
{
    const struct pp_polygon *gap = is_flush(site) ? &world->surfaces[index].outline
                                                  : &world->openings[index].inner;
    bool is_gap = is_flush(site) ? is_in_plane(site, gap)
                                 : has_hole(site, world, &world->openings[index]);
    return is_gap ? gap : NULL;
}

/* The polygon as a region in the frame's coordinates. */
static enum pp_status region_of(struct pp_region *region, struct pp_clipper *clipper,
                                const struct facade_site *site,
                                const struct pp_polygon *polygon, struct pp_error *err)
{
    double(*xy)[2] = malloc(sizeof *xy * (size_t)polygon->count);
    if (!xy)
        return pp_fail_memory(err);
    pp_polygon_flatten(polygon->vertices, polygon->count, site->frame.origin,
                       site->frame.along, site->frame.up, xy);
    enum pp_status status = pp_clipper_by_crossings(
        clipper, region, (const double(*)[2])xy, polygon->count, err);
    free(xy);
    return status;
}

/* Union of all gaps. */
static enum pp_status find_gaps(struct pp_region *gaps, const struct pp_resolver *r,
                                const struct facade_site *site, struct pp_error *err)
{
    const struct pp_world *world = r->world;
    int most = is_flush(site) ? world->face_count : world->opening_count, count = 0;
    struct pp_region *parts = calloc((size_t)most + 1, sizeof *parts);
    enum pp_status status = parts ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < most && status == PP_OK; i++) {
        const struct pp_polygon *gap = gap_at(world, site, i);
        if (gap)
            status = region_of(&parts[count++], r->clipper, site, gap, err);
    }
    if (status == PP_OK)
        status = pp_clipper_union(r->clipper, gaps, parts, count, err);
    for (int i = 0; i < count; i++)
        pp_region_clear(&parts[i]);
    free(parts);
    return status;
}

static enum pp_status sheet_region(struct pp_region *region,
                                   const struct pp_resolver *r,
                                   const struct facade_site *site, struct pp_error *err)
{
    const double *low = site->sheet.low, *high = site->sheet.high;
    const double ring[4][2] = {
        {low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
    struct pp_region whole = {0}, gaps = {0};
    enum pp_status status = pp_clipper_of_ring(r->clipper, &whole, ring, 4, err);
    if (status == PP_OK)
        status = find_gaps(&gaps, r, site, err);
    if (status == PP_OK)
        status = pp_clipper_difference(r->clipper, region, &whole, &gaps, err);
    pp_region_clear(&whole);
    pp_region_clear(&gaps);
    return status;
}

/* Point of the sheet at xy; exactly the corner of a hole if there is one. */
static struct pp_vec3 sheet_point(const struct pp_world *world,
                                  const struct facade_site *site, const double xy[2])
{
    const struct pp_face_frame *frame = &site->frame;
    struct pp_vec3 point = pp_vec_along(pp_face_frame_point(frame, xy[0], xy[1]),
                                        -site->depth_m, site->normal);
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        bool has_corners = opening->facade == site->surface.owner;
        for (int k = 0; k < opening->outer.count && has_corners; k++) {
            struct pp_vec3 corner = hole_corner(opening, k);
            if (pp_vec_length(pp_vec_sub(corner, point)) < same_corner_m)
                return corner;
        }
    }
    return point;
}

static enum pp_status add_sheet(struct pp_resolver *r, struct facade_site *site,
                                struct pp_error *err)
{
    struct pp_region region = {0};
    double(*triangles)[3][2] = NULL;
    int count = 0;
    pp_clipper_set_grid(r->clipper, grid_m);
    enum pp_status status = sheet_region(&region, r, site, err);
    pp_clipper_set_grid(r->clipper, 0.0);
    if (status == PP_OK)
        status = pp_clipper_triangulate(r->clipper, &triangles, &count, &region, err);
    for (int t = 0; t < count && status == PP_OK; t++) {
        struct pp_vec3 corners[3]; /* reversed, since the frame is seen from inside */
        for (int k = 0; k < 3; k++)
            corners[2 - k] = sheet_point(r->world, site, triangles[t][k]);
        struct pp_vec3 middle = pp_vec_add(corners[0], corners[1]);
        middle = pp_vec_scale(pp_vec_add(middle, corners[2]), 1.0 / 3.0);
        if (r->watertight && pp_position_in_room(r->world, middle))
            note_clash(r, site, middle);
        if (pp_vec_length(pp_polygon_area_vector(corners, 3)) > area_least_m2)
            status = pp_resolve_add_face(r, site->surface, corners, 3, err);
    }
    free(triangles);
    pp_region_clear(&region);
    return status;
}

/* ---- one facade ---- */

/* Finds the extent of the sheet. `left` is seen from outside, so it extends the sheet
 * beyond the high end of `along`. */
static void find_facade_extent(struct facade_site *site, double ground_level_m)
{
    const struct pp_facade_part *part = site->part;
    const struct pp_bounds2 *wall = &site->frame.bounds;
    double ground = ground_level_m - site->frame.origin.z;
    site->sheet.low[0] = wall->low[0] - part->right_m;
    site->sheet.high[0] = wall->high[0] + part->left_m;
    site->sheet.low[1] = fmin(wall->low[1], fmax(wall->low[1] - part->down_m, ground));
    site->sheet.high[1] = wall->high[1] + part->up_m;
}

static void find_depth(struct facade_site *site, const struct pp_world *world)
{
    site->depth_m = isnan(site->part->depth_m) ? 0.0 : site->part->depth_m;
    for (int i = 0; i < world->opening_count && isnan(site->part->depth_m); i++)
        if (world->openings[i].face == site->face)
            site->depth_m = fmax(site->depth_m, world->openings[i].reveal_m);
}

static void find_recesses(struct pp_world *world, const struct facade_site *site)
{
    for (int i = 0; i < world->opening_count; i++) {
        struct pp_opening *opening = &world->openings[i];
        if (!has_hole(site, world, opening))
            continue;
        double recess_m = site->depth_m - opening->reveal_m;
        opening->facade = world->facade_count;
        opening->recess_m = recess_m > PP_ROUNDING_M ? recess_m : 0.0;
    }
}

static void note_facade(struct pp_world *world, const struct facade_site *site)
{
    const struct pp_facade_part *part = site->part;
    const double *low = site->sheet.low, *high = site->sheet.high;
    const double ring[4][2] = {
        {high[0], low[1]}, {low[0], low[1]}, {low[0], high[1]}, {high[0], high[1]}};
    struct pp_facade *facade = &world->facades[world->facade_count++];
    *facade = (struct pp_facade){.face = site->face,
                                 .left_m = part->left_m,
                                 .right_m = part->right_m,
                                 .up_m = part->up_m,
                                 .down_m = site->frame.bounds.low[1] - low[1],
                                 .depth_m = site->depth_m,
                                 .reflectance = part->reflectance,
                                 .line = part->line};
    for (int k = 0; k < 4; k++)
        facade->corners[k] = sheet_point(world, site, ring[k]);
    if (is_flush(site))
        world->surfaces[site->face].back = part->reflectance;
}

static enum pp_status build_facade(struct pp_resolver *r, struct facade_site *site,
                                   struct pp_error *err)
{
    struct pp_world *world = r->world;
    find_facade_extent(site, world->ground_level_m);
    find_depth(site, world);
    if (!check_depth(r, site) || !check_others(r, site))
        return PP_OK;
    find_recesses(world, site);
    site->surface = (struct pp_surface){.role = PP_FACADE,
                                        .front = site->part->reflectance,
                                        .back = site->part->reflectance,
                                        .finish = site->part->finish,
                                        .owner = world->facade_count,
                                        .line = site->part->line};
    note_facade(world, site);
    enum pp_status status = r->watertight ? check_clear(r, site, err) : PP_OK;
    if (status == PP_OK)
        status = add_sheet(r, site, err);
    return status == PP_OK ? add_rims(r, site, err) : status;
}

static bool is_read(const struct pp_facade_part *part)
{
    return isfinite(part->left_m) && isfinite(part->right_m) && isfinite(part->up_m)
           && isfinite(part->down_m) && isfinite(part->reflectance);
}

enum pp_status pp_build_facades(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    struct pp_world *world = r->world;
    world->facades =
        calloc(room->facade_count ? room->facade_count : 1, sizeof *world->facades);
    if (!world->facades)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    for (int i = 0; i < room->facade_count && status == PP_OK; i++) {
        struct facade_site site = {.part = &room->facades[i]};
        site.face = pp_resolve_wall(r, site.part->wall, "facade", site.part->line);
        if (site.face < 0 || !is_read(site.part)
            || !check_wall(r, site.part, site.face))
            continue;
        site.normal = world->surfaces[site.face].outline.normal;
        status = pp_face_frame_init(&site.frame, &world->surfaces[site.face], err);
        site.frame.face = NULL;
        if (status == PP_OK)
            status = build_facade(r, &site, err);
        pp_face_frame_clear(&site.frame);
    }
    return status;
}
