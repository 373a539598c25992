/* beam_pieces.c - divides the opening's outlines, the working plane, and the surfaces
 * inside and outside into convex pieces, in the opening's axes. */
#include "methods/fast/beam_pieces.h"

#include <math.h>
#include <stdlib.h>

#include "methods/fast/beam_tree.h"
#include "methods/view/occluders.h"
#include "model/base/array.h"
#include "model/geometry/clip.h"
#include "model/geometry/clipper.h"
#include "model/geometry/convex_parts.h"

/* A half-space normal.v > offset, to which a piece is clipped. */
struct beam_limit {
    struct pp_vec3 normal;
    double offset;
};

enum { LIMITS_MOST = 2 };

static void add_piece_corner(struct pp_beam *beam, struct beam_piece *piece,
                             struct pp_vec3 v)
{
    struct pp_vec3 *low = &piece->low, *high = &piece->high;
    if (piece->count == 0)
        *low = *high = v;
    *low = pp_vec(fmin(low->x, v.x), fmin(low->y, v.y), fmin(low->z, v.z));
    *high = pp_vec(fmax(high->x, v.x), fmax(high->y, v.y), fmax(high->z, v.z));
    beam->corners[piece->first + piece->count++] = v;
}

/* Adds a convex polygon in pieces of at most PP_FRAGMENT_CORNERS corners; all other
 * members are copied from `like`. */
static enum pp_status add_fan(struct pp_beam *beam, struct beam_pieces *pieces,
                              struct beam_piece like, const struct pp_vec3 *corners,
                              int count, struct pp_error *err)
{
    enum { MOST = PP_FRAGMENT_CORNERS };
    enum pp_status status = PP_OK;
    for (int from = 1; from + 1 < count && status == PP_OK; from += MOST - 2) {
        status = pp_array_reserve(&pieces->list, &pieces->capacity, pieces->count + 1,
                                  sizeof *pieces->list, err);
        if (status == PP_OK)
            status =
                pp_array_reserve(&beam->corners, &beam->corner_capacity,
                                 beam->corner_count + MOST, sizeof *beam->corners, err);
        if (status != PP_OK)
            return status;
        struct beam_piece *piece = &pieces->list[pieces->count++];
        *piece = like;
        piece->first = beam->corner_count;
        piece->count = 0;
        add_piece_corner(beam, piece, corners[0]);
        for (int i = from; i < count && piece->count < MOST; i++)
            add_piece_corner(beam, piece, corners[i]);
        beam->corner_count += piece->count;
    }
    return status;
}

static enum pp_status add_convex(struct pp_beam *beam, struct beam_pieces *pieces,
                                 struct beam_piece like, const struct pp_vec3 *corners,
                                 int count, const struct beam_limit *limits,
                                 int limit_count, struct pp_error *err)
{
    /* If a polygon lies in the limit's plane, rounding may clip every other corner.
     * Each limit may thus add corners, at most as many as there are. */
    size_t most = (size_t)count << LIMITS_MOST;
    struct pp_vec3 *buffer = malloc((2 * most + 1) * sizeof *buffer);
    if (!buffer)
        return pp_fail_memory(err);
    const struct pp_vec3 *from = corners;
    for (int i = 0; i < limit_count; i++) {
        struct pp_vec3 *to = i % 2 ? buffer + most : buffer;
        count = pp_clip_convex(to, from, count, limits[i].normal, limits[i].offset);
        from = to;
    }
    enum pp_status status = add_fan(beam, pieces, like, from, count, err);
    free(buffer);
    return status;
}

/* Adds a polygon given in the room's axes. triangles: its triangulation; NULL if it is
 * convex. */
static enum pp_status add_polygon(struct pp_beam *beam, struct beam_pieces *pieces,
                                  struct beam_piece like,
                                  const struct pp_polygon *outline,
                                  const int (*triangles)[3], int triangle_count,
                                  const struct beam_limit *limits, int limit_count,
                                  struct pp_error *err)
{
    struct pp_vec3 *corners = malloc((size_t)outline->count * sizeof *corners);
    if (!corners)
        return pp_fail_memory(err);
    for (int i = 0; i < outline->count; i++)
        corners[i] = pp_projection_point(&beam->axes, outline->vertices[i]);
    like.normal = pp_projection_direction(&beam->axes, outline->normal);
    like.offset = pp_vec_dot(like.normal, corners[0]);
    enum pp_status status = PP_OK;
    if (!triangles)
        status = add_convex(beam, pieces, like, corners, outline->count, limits,
                            limit_count, err);
    for (int t = 0; status == PP_OK && t < triangle_count; t++) {
        const int *of = triangles[t];
        struct pp_vec3 three[3] = {corners[of[0]], corners[of[1]], corners[of[2]]};
        status = add_convex(beam, pieces, like, three, 3, limits, limit_count, err);
    }
    free(corners);
    return status;
}

/* Adds a polygon; triangulates it if it is not convex. */
static enum pp_status add_outline(struct pp_beam *beam, struct beam_pieces *pieces,
                                  const struct pp_polygon *outline,
                                  const struct beam_limit *limits, int limit_count,
                                  struct pp_error *err)
{
    const struct beam_piece none = {0};
    int(*triangles)[3], count;
    enum pp_status status = pp_convex_parts_triangles(&triangles, &count, outline, err);
    if (status == PP_OK)
        status = add_polygon(beam, pieces, none, outline, (const int(*)[3])triangles,
                             count, limits, limit_count, err);
    free(triangles);
    return status;
}

/* ---- Clipping done once ---- */

/* Adds the part of the working plane on the room's side of the opening's face. */
static enum pp_status add_plane(struct pp_beam *beam, struct pp_error *err)
{
    const struct pp_world *world = beam->world;
    const struct beam_limit inside = {{0.0, 0.0, -1.0}, PP_OCCLUDERS_COPLANAR_M};
    struct pp_clipper *clipper = NULL;
    double(*triangles)[3][2] = NULL;
    int count = 0;
    const struct beam_piece none = {0};
    double z = world->working_plane_m;
    if (world->plane.count == 1 && world->plane.rings[0].count == 4) {
        /* A quadrilateral is either convex or two triangles, so that no clipper is
         * needed. */
        struct pp_vec3 four[4];
        struct pp_polygon outline;
        for (int i = 0; i < 4; i++)
            four[i] = pp_vec(world->plane.rings[0].xy[i][0],
                             world->plane.rings[0].xy[i][1], z);
        enum pp_status status = pp_polygon_of(&outline, four, 4, err);
        if (status == PP_OK)
            status = add_outline(beam, &beam->plane, &outline, &inside, 1, err);
        pp_polygon_clear(&outline);
        return status;
    }
    enum pp_status status = pp_clipper_create(&clipper, err);
    if (status == PP_OK)
        status =
            pp_clipper_triangulate(clipper, &triangles, &count, &world->plane, err);
    for (int t = 0; t < count && status == PP_OK; t++) {
        struct pp_vec3 three[3];
        for (int i = 0; i < 3; i++)
            three[i] = pp_projection_point(
                &beam->axes, pp_vec(triangles[t][i][0], triangles[t][i][1], z));
        status = add_convex(beam, &beam->plane, none, three, 3, &inside, 1, err);
    }
    free(triangles);
    pp_clipper_destroy(clipper);
    return status;
}

/* True if the opening and the working plane lie on one side of a surface's plane: the
 * surface then hides nothing inside. */
static bool cannot_hide(const struct pp_beam *beam, struct pp_vec3 normal,
                        double offset)
{
    double low = 0.0, high = 0.0;
    const struct beam_pieces *all[2] = {&beam->inner, &beam->plane};
    for (int a = 0; a < 2; a++)
        for (int i = 0; i < all[a]->count; i++)
            for (int k = 0; k < all[a]->list[i].count; k++) {
                struct pp_vec3 v = beam->corners[all[a]->list[i].first + k];
                double side = pp_vec_dot(normal, v) - offset;
                low = fmin(low, side);
                high = fmax(high, side);
            }
    return low >= -PP_OCCLUDERS_COPLANAR_M || high <= PP_OCCLUDERS_COPLANAR_M;
}

/* True if the whole block is outside the opening's face. */
static bool is_block_outside(const struct pp_beam *beam, int index)
{
    const struct pp_block *block = &beam->world->blocks[index];
    struct pp_vec3 t = beam->axes.toward;
    double nearest = pp_vec_dot(pp_vec_sub(block->corner, beam->axes.eye), t)
                     + fmin(0.0, pp_vec_dot(block->along, t))
                     + fmin(0.0, pp_vec_dot(block->across, t))
                     + fmin(0.0, block->height_m * t.z);
    return nearest > PP_OCCLUDERS_COPLANAR_M;
}

static enum pp_status add_beam_surface(struct pp_beam *beam,
                                       const struct pp_surface *surface,
                                       struct pp_error *err)
{
    const struct pp_polygon *outline = &surface->outline;
    struct pp_vec3 up = pp_projection_direction(&beam->axes, pp_vec(0.0, 0.0, 1.0));
    double plane_z = beam->world->working_plane_m - beam->axes.eye.z;
    double nearest = INFINITY, farthest = -INFINITY;
    for (int i = 0; i < outline->count; i++) {
        double z = pp_projection_point(&beam->axes, outline->vertices[i]).z;
        nearest = fmin(nearest, z);
        farthest = fmax(farthest, z);
    }
    struct beam_piece like = {
        .front = surface->front, .back = surface->back, .exitance = surface->exitance};
    struct pp_vec3 normal = pp_projection_direction(&beam->axes, outline->normal);
    double offset =
        pp_vec_dot(normal, pp_projection_point(&beam->axes, outline->vertices[0]));
    bool is_near = nearest < -PP_OCCLUDERS_COPLANAR_M;
    bool is_far = farthest > PP_OCCLUDERS_COPLANAR_M;
    if (!is_near && !is_far) /* a plate in the face's plane is outside */
        is_far = surface->role == PP_FREE_SURFACE || surface->role == PP_BLOCK;
    enum pp_status status = PP_OK;
    if (is_near && !cannot_hide(beam, normal, offset)) {
        const struct beam_limit limits[2] = {{{0.0, 0.0, -1.0}, 0.0},
                                             {up, plane_z + PP_OCCLUDERS_COPLANAR_M}};
        status = add_polygon(beam, &beam->inside, like, outline,
                             (const int(*)[3])surface->triangles,
                             surface->triangle_count, limits, 2, err);
    }
    if (is_far && beam->with_outside && status == PP_OK) {
        double from = nearest >= -PP_OCCLUDERS_COPLANAR_M
                          ? nearest - PP_OCCLUDERS_COPLANAR_M
                          : 0.0;
        const struct beam_limit limits[2] = {{{0.0, 0.0, 1.0}, from}, {up, plane_z}};
        like.side_of_box =
            surface->role == PP_BLOCK && is_block_outside(beam, surface->owner);
        status = add_polygon(beam, &beam->outside, like, outline,
                             (const int(*)[3])surface->triangles,
                             surface->triangle_count, limits, 2, err);
    }
    return status;
}

static void find_outline_extent(struct pp_beam *beam)
{
    for (int axis = 0; axis < 2; axis++) {
        beam->low[axis] = INFINITY;
        beam->high[axis] = -INFINITY;
    }
    for (int i = 0; i < beam->opening->inner.count; i++) {
        struct pp_vec3 v =
            pp_projection_point(&beam->axes, beam->opening->inner.vertices[i]);
        beam->low[0] = fmin(beam->low[0], v.x);
        beam->high[0] = fmax(beam->high[0], v.x);
        beam->low[1] = fmin(beam->low[1], v.y);
        beam->high[1] = fmax(beam->high[1], v.y);
    }
}

/* True if all pieces and skylines outside have the same reflectance and exitance;
 * stores these in the beam. */
static bool has_one_light(struct pp_beam *beam)
{
    double reflectance = NAN, exitance = 0.0;
    for (int i = 0; i < beam->outside.count; i++) {
        const struct beam_piece *piece = &beam->outside.list[i];
        if (i == 0) {
            reflectance = piece->front;
            exitance = piece->exitance;
        }
        if (piece->front != reflectance || piece->exitance != exitance
            || (!piece->side_of_box && piece->back != reflectance))
            return false;
    }
    for (int i = 0; i < beam->world->skyline_count; i++) {
        const struct pp_skyline *skyline = &beam->world->skylines[i];
        if (!pp_world_skyline_is_far(skyline, beam->opening->face))
            continue;
        if (isnan(reflectance))
            reflectance = skyline->reflectance;
        if (skyline->reflectance != reflectance || exitance != 0.0)
            return false;
    }
    beam->of_light[0] = isnan(reflectance) ? 0.0 : reflectance;
    beam->of_light[1] = exitance;
    return true;
}

enum pp_status pp_beam_pieces_find(struct pp_beam *beam, struct pp_error *err)
{
    const struct pp_world *world = beam->world;
    const struct pp_opening *opening = beam->opening;
    beam->axes =
        (struct pp_projection){opening->inner.vertices[0], opening->along, opening->up,
                               pp_vec_scale(opening->inner.normal, -1.0), 1.0};
    find_outline_extent(beam);
    enum pp_status status =
        add_outline(beam, &beam->inner, &opening->inner, NULL, 0, err);
    if (status == PP_OK && opening->reveal_m > 0.0)
        status = add_outline(beam, &beam->outer, &opening->outer, NULL, 0, err);
    if (status == PP_OK)
        status = add_plane(beam, err);
    for (int i = 0; i < world->surface_count && status == PP_OK; i++)
        if (i != opening->face && world->surfaces[i].role != PP_REVEAL
            && world->surfaces[i].role != PP_COVER)
            status = add_beam_surface(beam, &world->surfaces[i], err);
    for (int i = 0; beam->with_outside && i < world->skyline_count; i++)
        beam->skylines += pp_world_skyline_is_far(&world->skylines[i], opening->face);
    beam->one_light = has_one_light(beam);
    return status == PP_OK ? pp_beam_tree_grow(beam, err) : status;
}
