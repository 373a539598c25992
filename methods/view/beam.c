/* beam.c - projects what beam_pieces.c has clipped along a direction, and overlays it. */
#include "methods/view/beam.h"

#include <math.h>
#include <stdlib.h>

#include "methods/view/beam_pieces.h"
#include "model/geometry/clip.h"

enum pp_status pp_beam_create(struct pp_beam **made, const struct pp_world *world,
                              const struct pp_opening *opening, bool with_outside,
                              struct pp_error *err)
{
    struct pp_beam *beam = calloc(1, sizeof *beam);
    if (!beam)
        return pp_fail_memory(err);
    beam->world = world;
    beam->opening = opening;
    beam->with_outside = with_outside;
    enum pp_status status = pp_beam_pieces_find(beam, err);
    if (status != PP_OK) {
        pp_beam_destroy(beam);
        beam = NULL;
    }
    *made = beam;
    return status;
}

void pp_beam_destroy(struct pp_beam *beam)
{
    if (!beam)
        return;
    free(beam->inner.list);
    free(beam->outer.list);
    free(beam->plane.list);
    free(beam->inside.list);
    free(beam->outside.list);
    free(beam->corners);
    free(beam);
}

void pp_beam_space_clear(struct pp_beam_space *space)
{
    pp_fragments_clear(&space->open);
    pp_fragments_clear(&space->cut);
    free(space->xy);
    free(space->rings);
    free(space->lights);
    *space = (struct pp_beam_space){0};
}

/* ---- Along one direction ---- */

/* A piece projected along the direction (a, b, 1) on to the face. */
static void project(struct pp_fragment_ring *ring, double (*xy)[2],
                    const struct pp_beam *beam, const struct beam_piece *piece,
                    double a, double b)
{
    const struct pp_vec3 *v = beam->corners + piece->first;
    for (int i = 0; i < piece->count; i++) {
        xy[i][0] = v[i].x - a * v[i].z;
        xy[i][1] = v[i].y - b * v[i].z;
    }
    pp_fragments_close_ring(ring, xy, piece->count);
}

/* Does a piece, projected along the direction (a, b, 1), lie beside the opening? By the
 * piece's extent, in the operations of project(), each of which rounds one way in its
 * arguments: never true of a piece whose projection meets the opening's extent. */
static bool lies_beside(const struct pp_beam *beam, const struct beam_piece *piece,
                        double a, double b)
{
    const double slope[2] = {a, b};
    const double low[2] = {piece->low.x, piece->low.y};
    const double high[2] = {piece->high.x, piece->high.y};
    for (int axis = 0; axis < 2; axis++) {
        double near = slope[axis] * piece->low.z, far = slope[axis] * piece->high.z;
        if (high[axis] - fmin(near, far) <= beam->low[axis]
            || low[axis] - fmax(near, far) >= beam->high[axis])
            return true;
    }
    return false;
}

/* The depth z at which the direction (a, b, 1) from (x, y) in the face meets a plane. */
static void set_depth(struct pp_fragment_ring *ring, struct pp_vec3 normal,
                      double offset, double facing)
{
    ring->depth[0] = offset / facing;
    ring->depth[1] = -normal.x / facing;
    ring->depth[2] = -normal.y / facing;
}

/* The opening within both its outlines and the plane's projection, less what hides it
 * inside. */
static enum pp_status open_part(const struct pp_beam *beam, struct pp_beam_space *space,
                                double a, double b, struct pp_error *err)
{
    double xy[PP_FRAGMENT_CORNERS][2];
    struct pp_fragment_ring ring;
    struct pp_fragments *open = &space->open, *cut = &space->cut;
    enum pp_status status = PP_OK;
    open->count = 0;
    for (int i = 0; i < beam->inner.count && status == PP_OK; i++) {
        project(&ring, xy, beam, &beam->inner.list[i], a, b);
        status = pp_fragments_add(open, ring.xy, ring.count, err);
    }
    const struct beam_pieces *within[2] = {&beam->outer, &beam->plane};
    for (int w = beam->outer.count == 0; w < 2 && status == PP_OK; w++) {
        cut->count = 0;
        for (int i = 0; i < within[w]->count && status == PP_OK; i++) {
            if (lies_beside(beam, &within[w]->list[i], a, b))
                continue;
            project(&ring, xy, beam, &within[w]->list[i], a, b);
            status = pp_fragments_intersect(cut, open, &ring, err);
        }
        struct pp_fragments *swap = open;
        open = cut;
        cut = swap;
    }
    for (int i = 0; i < beam->inside.count && open->count > 0 && status == PP_OK; i++) {
        if (lies_beside(beam, &beam->inside.list[i], a, b))
            continue;
        project(&ring, xy, beam, &beam->inside.list[i], a, b);
        status = pp_fragments_subtract(open, &ring, err);
    }
    if (open != &space->open) {
        struct pp_fragments swap = space->open;
        space->open = space->cut;
        space->cut = swap;
    }
    return status;
}

/* A skyline as a ring: the part of the opening's extent from where the direction meets
 * its plane between ground and head. False: nowhere. */
static bool project_skyline(struct pp_fragment_ring *ring, double (*xy)[2],
                            const struct pp_beam *beam,
                            const struct pp_skyline *skyline, struct pp_vec3 u)
{
    const struct pp_world *world = beam->world;
    const struct pp_polygon *wall = &world->surfaces[skyline->face].outline;
    struct pp_vec3 out = pp_vec_unit(pp_vec(-wall->normal.x, -wall->normal.y, 0.0));
    double facing = pp_vec_dot(out, u);
    const double *low = beam->low, *high = beam->high;
    struct pp_vec3 left[16], ring3[16] = {{low[0], low[1], 0.0},
                                          {high[0], low[1], 0.0},
                                          {high[0], high[1], 0.0},
                                          {low[0], high[1], 0.0}};
    int count = 4;
    if (!(facing > 0.0))
        return false;
    if (isinf(skyline->distance_m)) {
        if (cos(skyline->angle_rad) * u.z > sin(skyline->angle_rad) * facing)
            return false;
        ring->depth[0] = 1e9; /* behind everything */
        ring->depth[1] = ring->depth[2] = 0.0;
    } else {
        /* The wall's plane at the openings' middle height, and from there on. */
        struct pp_vec3 v = wall->vertices[0],
                       level = pp_vec(v.x, v.y, skyline->middle_z_m);
        double to_wall = pp_vec_dot(pp_vec_sub(v, level), wall->normal)
                         / pp_vec_dot(out, wall->normal);
        double offset = pp_vec_dot(out, pp_vec_sub(level, beam->axes.eye)) + to_wall
                        + skyline->distance_m;
        struct pp_vec3 normal = pp_projection_direction(&beam->axes, out);
        struct pp_vec3 up = pp_projection_direction(&beam->axes, pp_vec(0.0, 0.0, 1.0));
        /* Height where the direction from (x, y) meets that plane. */
        double rise = u.z / facing;
        struct pp_vec3 height = pp_vec_along(up, -rise, normal);
        double at_origin = beam->axes.eye.z + rise * offset;
        count = pp_clip_convex(left, ring3, count, pp_vec_scale(height, -1.0),
                               at_origin - skyline->head_z_m);
        count = pp_clip_convex(ring3, left, count, height,
                               world->ground_level_m - at_origin);
        struct pp_vec3 own = pp_projection_direction(&beam->axes, u);
        set_depth(ring, normal, offset, facing / own.z);
    }
    for (int i = 0; i < count; i++) {
        xy[i][0] = ring3[i].x;
        xy[i][1] = ring3[i].y;
    }
    if (count >= 3)
        pp_fragments_close_ring(ring, xy, count);
    return count >= 3;
}

/* Memory for the rings of all pieces outside and all skylines. */
static enum pp_status make_room(struct pp_beam_space *space, const struct pp_beam *beam,
                                struct pp_error *err)
{
    size_t most = (size_t)beam->outside.count + (size_t)beam->skylines;
    if (space->rings || most == 0)
        return PP_OK;
    space->rings = malloc(most * sizeof *space->rings);
    space->lights = malloc(most * sizeof *space->lights);
    space->xy = malloc(most * PP_FRAGMENT_CORNERS * sizeof *space->xy);
    return space->rings && space->lights && space->xy ? PP_OK : pp_fail_memory(err);
}

/* The rings that lie before the opening. */
static int find_rings(struct pp_beam_space *space, const struct pp_beam *beam,
                      struct pp_vec3 u, struct pp_vec3 own)
{
    double a = own.x / own.z, b = own.y / own.z;
    int count = 0;
    for (int i = 0; i < beam->outside.count; i++) {
        const struct beam_piece *piece = &beam->outside.list[i];
        double facing = pp_vec_dot(piece->normal, own) / own.z;
        if (facing == 0.0 || (piece->side_of_box && facing > 0.0)
            || lies_beside(beam, piece, a, b))
            continue;
        struct pp_fragment_ring *ring = &space->rings[count];
        project(ring, space->xy + count * PP_FRAGMENT_CORNERS, beam, piece, a, b);
        if (ring->low[0] >= beam->high[0] || ring->high[0] <= beam->low[0]
            || ring->low[1] >= beam->high[1] || ring->high[1] <= beam->low[1])
            continue;
        set_depth(ring, piece->normal, piece->offset, facing);
        space->lights[count][0] = facing < 0.0 ? piece->front : piece->back;
        space->lights[count++][1] = piece->exitance;
    }
    const struct pp_world *world = beam->world;
    for (int i = 0; beam->skylines > 0 && i < world->skyline_count; i++)
        if (world->skylines[i].face == beam->opening->face
            && project_skyline(&space->rings[count],
                               space->xy + count * PP_FRAGMENT_CORNERS, beam,
                               &world->skylines[i], u)) {
            space->lights[count][0] = world->skylines[i].reflectance;
            space->lights[count++][1] = 0.0;
        }
    return count;
}

static double sum_areas(const struct pp_fragments *fragments)
{
    double sum = 0.0;
    for (int i = 0; i < fragments->count; i++)
        sum += pp_fragments_area(&fragments->list[i]);
    return sum;
}

enum pp_status pp_beam_areas(struct pp_beam_areas *areas, const struct pp_beam *beam,
                             struct pp_beam_space *space, struct pp_vec3 u,
                             struct pp_error *err)
{
    *areas = (struct pp_beam_areas){0};
    struct pp_vec3 own = pp_projection_direction(&beam->axes, u);
    if (!(own.z > 0.0 && u.z > 0.0))
        return PP_OK;
    struct pp_fragments *open = &space->open;
    enum pp_status status = make_room(space, beam, err);
    if (status == PP_OK)
        status = open_part(beam, space, own.x / own.z, own.y / own.z, err);
    if (status != PP_OK || open->count == 0)
        return status;
    int count = find_rings(space, beam, u, own);
    if (count == 0 || beam->one_light) {
        double whole = sum_areas(open);
        for (int i = 0; i < count && open->count > 0 && status == PP_OK; i++)
            status = pp_fragments_subtract(open, &space->rings[i], err);
        areas->sky = count > 0 ? sum_areas(open) : whole;
        double hidden = whole - areas->sky;
        areas->reflecting = count > 0 ? hidden * space->lights[0][0] : 0.0;
        areas->emitting = count > 0 ? hidden * space->lights[0][1] : 0.0;
        return status;
    }
    for (int i = 0; i < count && status == PP_OK; i++)
        status = pp_fragments_cover(open, space->rings, i, err);
    for (int i = 0; i < open->count; i++) {
        double area = pp_fragments_area(&open->list[i]);
        int owner = open->list[i].owner;
        if (owner == PP_FRAGMENT_FREE) {
            areas->sky += area;
        } else {
            areas->reflecting += area * space->lights[owner][0];
            areas->emitting += area * space->lights[owner][1];
        }
    }
    return status;
}
