/* blocks.c - see blocks.h. */
#include "model/room/outside/blocks.h"

#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/geometry/tolerance.h"
#include "model/room/position.h"

/* A box with its own axes: unit vectors, right-handed, the third one up. */
struct block_box {
    struct pp_vec3 corner, axes[3];
    double size[3];
};

static struct block_box box_of(const struct pp_block *block)
{
    double c = cos(block->rotate_rad), s = sin(block->rotate_rad);
    return (struct block_box){
        .corner = block->corner,
        .axes = {{c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0}},
        .size = {block->width_m, block->depth_m, block->height_m}};
}

/* Corner of the box; u, v, w are 0 or 1, the end of each axis. */
static struct pp_vec3 box_corner(const struct block_box *box, int u, int v, int w)
{
    struct pp_vec3 p = pp_vec_along(box->corner, u * box->size[0], box->axes[0]);
    p = pp_vec_along(p, v * box->size[1], box->axes[1]);
    return pp_vec_along(p, w * box->size[2], box->axes[2]);
}

/* ---- clearance from the room ---- */

/* Clips the polygon to coordinates of at most `limit` along the axis. The result may
 * have overlapping edges along the cut, which do not change the area. Returns the
 * number of vertices of the result. */
static int clip(struct pp_vec3 *cut, const struct pp_vec3 *polygon, int count,
                struct pp_vec3 origin, struct pp_vec3 axis, double limit)
{
    int cut_count = 0;
    for (int i = 0; i < count; i++) {
        struct pp_vec3 p = polygon[i], q = polygon[(i + 1) % count];
        double over_p = pp_vec_dot(axis, pp_vec_sub(p, origin)) - limit;
        double over_q = pp_vec_dot(axis, pp_vec_sub(q, origin)) - limit;
        if (over_p <= 0.0)
            cut[cut_count++] = p;
        if ((over_p <= 0.0) != (over_q <= 0.0))
            cut[cut_count++] =
                pp_vec_along(p, over_p / (over_p - over_q), pp_vec_sub(q, p));
    }
    return cut_count;
}

/* Area (m2) of the polygon within the box reduced by PP_ROUNDING_M on all sides; 0 for
 * a polygon that only touches the box. */
static enum pp_status area_in_box(double *area_m2, const struct block_box *box,
                                  const struct pp_polygon *polygon,
                                  struct pp_error *err)
{
    /* Each of the six cuts adds at most one vertex for every two; 1.5^6 is under 12. */
    size_t space = 16 * (size_t)polygon->count;
    struct pp_vec3 *buffers = malloc(2 * space * sizeof *buffers);
    if (!buffers)
        return pp_fail_memory(err);
    struct pp_vec3 *from = buffers, *to = buffers + space;
    int count = polygon->count;
    memcpy(from, polygon->vertices, count * sizeof *from);
    for (int k = 0; k < 6 && count > 0; k++) {
        double sign = k % 2 ? 1.0 : -1.0;
        double limit = (k % 2 ? box->size[k / 2] : 0.0) - PP_ROUNDING_M;
        count = clip(to, from, count, box->corner, pp_vec_scale(box->axes[k / 2], sign),
                     limit);
        struct pp_vec3 *swap = from;
        from = to;
        to = swap;
    }
    *area_m2 = count > 2 ? pp_vec_length(pp_polygon_area_vector(from, count)) : 0.0;
    free(buffers);
    return PP_OK;
}

/* Reports a block in the room or in a reveal; *clear is true if it is in neither. */
static enum pp_status check_clear(bool *clear, struct pp_resolver *r,
                                  const struct pp_block *block,
                                  const struct block_box *box, struct pp_error *err)
{
    const struct pp_world *world = r->world;
    struct pp_vec3 middle = box->corner;
    for (int k = 0; k < 3; k++)
        middle = pp_vec_along(middle, 0.5 * box->size[k], box->axes[k]);
    bool overlaps = pp_position_in_room(world, middle);
    for (int i = 0; i < world->face_count && !overlaps; i++) {
        double area_m2 = 0.0;
        if (area_in_box(&area_m2, box, &world->surfaces[i].outline, err) != PP_OK)
            return PP_SYSTEM;
        overlaps = area_m2 > PP_ROUNDING_M;
    }
    *clear = !overlaps;
    if (overlaps && block->is_of_site) {
        char name[64];
        pp_mistakes_add(
            r->mistakes, block->line,
            "block: overlaps the room \"%s\" on line %d; expected outside all rooms "
            "of the building",
            pp_text_excerpt(name, sizeof name, world->name ? world->name : ""),
            r->room->line);
        return PP_OK;
    }
    if (overlaps) {
        pp_mistakes_add(r->mistakes, block->line,
                        "block: overlaps the room; expected outside the room (its "
                        "lower corner, about which it is rotated, is at x %g, y %g, "
                        "base %g)",
                        block->corner.x, block->corner.y, block->corner.z);
        return PP_OK;
    }
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        double area_m2 = 0.0;
        if (area_in_box(&area_m2, box, &opening->outer, err) != PP_OK)
            return PP_SYSTEM;
        if (!(area_m2 > PP_ROUNDING_M))
            continue;
        *clear = false;
        pp_mistakes_add(r->mistakes, block->line,
                        "block: extends into the reveal of the opening on line %d; "
                        "expected outside the glass",
                        opening->line);
    }
    return PP_OK;
}

/* ---- sides ---- */

/* Moves a side that lies in the plane of a face of the room back into the block. */
static void set_off(const struct pp_world *world, struct pp_vec3 *side)
{
    struct pp_vec3 area = pp_polygon_area_vector(side, 4);
    struct pp_vec3 normal = pp_vec_unit(area);
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        double farthest = 0.0;
        for (int k = 0; k < 4; k++)
            farthest = fmax(farthest, fabs(pp_polygon_height(face, side[k])));
        if (farthest >= PP_SET_OFF_M || pp_vec_dot(normal, face->normal) < 0.0)
            continue;
        for (int k = 0; k < 4; k++)
            side[k] = pp_vec_along(side[k], -PP_SET_OFF_M, normal);
        return;
    }
}

static enum pp_status add_sides(struct pp_resolver *r, int index,
                                const struct block_box *box, struct pp_error *err)
{
    /* Corners by the bits of u, v, w; each side counter-clockwise seen from outside. */
    static const int sides[6][4][3] = {
        {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, /* -v */
        {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}, /* +u */
        {{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {1, 1, 1}}, /* +v */
        {{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}}, /* -u */
        {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, /* top */
        {{0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}, /* bottom */
    };
    struct pp_block *block = &r->world->blocks[index];
    struct pp_surface surface = {.role = PP_BLOCK,
                                 .front = block->reflectance,
                                 .back = block->reflectance,
                                 .finish = block->finish,
                                 .owner = index,
                                 .line = block->line};
    block->along = pp_vec_scale(box->axes[0], box->size[0]);
    block->across = pp_vec_scale(box->axes[1], box->size[1]);
    block->first_side = r->world->surface_count;
    bool floats = block->corner.z > r->world->ground_level_m;
    for (int i = 0; i < (floats ? 6 : 5); i++) {
        struct pp_vec3 side[4];
        for (int k = 0; k < 4; k++)
            side[k] = box_corner(box, sides[i][k][0], sides[i][k][1], sides[i][k][2]);
        set_off(r->world, side);
        if (pp_resolve_add_face(r, surface, side, 4, err) != PP_OK)
            return PP_SYSTEM;
    }
    block->side_count = r->world->surface_count - block->first_side;
    return PP_OK;
}

static bool is_read(const struct pp_block *block)
{
    return isfinite(block->corner.x + block->corner.y + block->corner.z)
           && isfinite(block->rotate_rad) && isfinite(block->reflectance)
           && block->width_m >= PP_SAME_M && block->depth_m >= PP_SAME_M
           && block->height_m >= PP_SAME_M && isfinite(block->width_m)
           && isfinite(block->depth_m) && isfinite(block->height_m);
}

enum pp_status pp_build_blocks(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    struct pp_world *world = r->world;
    world->blocks =
        calloc(room->block_count ? room->block_count : 1, sizeof *world->blocks);
    if (!world->blocks)
        return pp_fail_memory(err);
    for (int i = 0; i < room->block_count; i++) {
        const struct pp_block *block = &room->blocks[i];
        if (!is_read(block))
            continue;
        struct block_box box = box_of(block);
        bool clear = true;
        if (r->watertight && check_clear(&clear, r, block, &box, err) != PP_OK)
            return PP_SYSTEM;
        if (!clear)
            continue;
        char *name = block->name ? strdup(block->name) : NULL;
        if (block->name && !name)
            return pp_fail_memory(err);
        world->blocks[world->block_count] = *block;
        world->blocks[world->block_count++].name = name;
        if (add_sides(r, world->block_count - 1, &box, err) != PP_OK)
            return PP_SYSTEM;
    }
    return PP_OK;
}
