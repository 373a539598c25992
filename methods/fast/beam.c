/* beam.c - projects the pieces of beam_pieces.c along one direction on to the opening's
 * face, and overlays them. */
#include "methods/fast/beam.h"

#include <math.h>
#include <stdlib.h>

#include "methods/fast/beam_tree.h"
#include "model/geometry/clip.h"
#include "model/geometry/min_max.h"

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
    free(beam->nodes);
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

/* Projects a piece along the direction (a, b, 1) on to the face. */
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

/* A part of the face, from low to high. */
struct face_extent {
    double low[2], high[2];
};

/* True if a box in the beam's axes, projected along the direction (a, b, 1), is
 * entirely outside the extent. The operations are those of project(), and their
 * rounding is monotonic. The function is therefore never true for a piece whose
 * projection meets the extent. */
static bool lies_beside(const struct face_extent *extent, const struct pp_vec3 *low,
                        const struct pp_vec3 *high, double a, double b)
{
    double near = a * low->z, far = a * high->z;
    if (high->x - pp_min(near, far) <= extent->low[0]
        || low->x - pp_max(near, far) >= extent->high[0])
        return true;
    near = b * low->z;
    far = b * high->z;
    return high->y - pp_min(near, far) <= extent->low[1]
           || low->y - pp_max(near, far) >= extent->high[1];
}

static struct face_extent fragments_face_extent(const struct pp_fragments *fragments)
{
    struct face_extent extent = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int i = 0; i < fragments->count; i++)
        for (int axis = 0; axis < 2; axis++) {
            const struct pp_fragment *fragment = &fragments->list[i];
            extent.low[axis] = fmin(extent.low[axis], fragment->low[axis]);
            extent.high[axis] = fmax(extent.high[axis], fragment->high[axis]);
        }
    return extent;
}

/* Sets the coefficients of depth: the z at which a line in the direction (a, b, 1) from
 * (x, y) in the face meets a plane. */
static void set_depth(struct pp_fragment_ring *ring, struct pp_vec3 normal,
                      double offset, double facing)
{
    ring->depth[0] = offset / facing;
    ring->depth[1] = -normal.x / facing;
    ring->depth[2] = -normal.y / facing;
}

/* Finds the part of the opening within both its outlines and the plane's projection,
 * less the parts hidden by surfaces inside. */
static enum pp_status open_part(const struct pp_beam *beam, struct pp_beam_space *space,
                                double a, double b, struct pp_error *err)
{
    double xy[PP_FRAGMENT_CORNERS][2];
    struct pp_fragment_ring ring;
    struct pp_fragments *open = &space->open, *cut = &space->cut;
    const struct face_extent whole = {{beam->low[0], beam->low[1]},
                                      {beam->high[0], beam->high[1]}};
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
            if (lies_beside(&whole, &within[w]->list[i].low, &within[w]->list[i].high,
                            a, b))
                continue;
            project(&ring, xy, beam, &within[w]->list[i], a, b);
            status = pp_fragments_intersect(cut, open, &ring, err);
        }
        struct pp_fragments *swap = open;
        open = cut;
        cut = swap;
    }
    for (int i = 0; i < beam->inside.count && open->count > 0 && status == PP_OK; i++) {
        if (lies_beside(&whole, &beam->inside.list[i].low, &beam->inside.list[i].high,
                        a, b))
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

/* Represents a skyline without a distance by a ring over the whole extent of the
 * opening, behind all other pieces. Returns false if the skyline does not hide the
 * direction. */
static bool project_skyline(struct pp_fragment_ring *ring, double (*xy)[2],
                            const struct pp_beam *beam,
                            const struct pp_skyline *skyline, struct pp_vec3 u)
{
    const struct pp_polygon *wall = &beam->world->surfaces[skyline->face].outline;
    struct pp_vec3 out = pp_vec_unit(pp_vec(-wall->normal.x, -wall->normal.y, 0.0));
    double facing = pp_vec_dot(out, u);
    if (!(facing > 0.0)
        || cos(skyline->angle_rad) * u.z > sin(skyline->angle_rad) * facing)
        return false;
    ring->depth[0] = 1e9;
    ring->depth[1] = ring->depth[2] = 0.0;
    for (int i = 0; i < 4; i++) {
        xy[i][0] = i == 0 || i == 3 ? beam->low[0] : beam->high[0];
        xy[i][1] = i < 2 ? beam->low[1] : beam->high[1];
    }
    pp_fragments_close_ring(ring, xy, 4);
    return true;
}

/* Allocates the rings of all pieces outside and all skylines. */
static enum pp_status make_room_for_rings(struct pp_beam_space *space,
                                          const struct pp_beam *beam,
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

/* State of the calculation for one direction, with the extent of the part of the
 * opening that is not yet hidden. */
struct beam_look {
    const struct pp_beam *beam;
    int at;                /* index of the next node to visit */
    struct pp_vec3 u, own; /* the direction in the room's axes and the beam's */
    double a, b;           /* the direction is along (a, b, 1) */
    struct face_extent open;
};

/* Projects the pieces of a leaf that may hide the open part: their outlines go to
 * rings, their reflectance and exitance to lights. Returns their number. */
static int find_leaf(const struct beam_look *look, const struct beam_node *leaf,
                     struct pp_fragment_ring *rings, double (*xy)[2],
                     double (*lights)[2])
{
    int count = 0;
    for (int i = leaf->first; i < leaf->first + leaf->count; i++) {
        const struct beam_piece *piece = &look->beam->outside.list[i];
        double facing = pp_vec_dot(piece->normal, look->own) / look->own.z;
        if (facing == 0.0 || (piece->side_of_box && facing > 0.0)
            || lies_beside(&look->open, &piece->low, &piece->high, look->a, look->b))
            continue;
        struct pp_fragment_ring *ring = &rings[count];
        project(ring, xy + count * PP_FRAGMENT_CORNERS, look->beam, piece, look->a,
                look->b);
        set_depth(ring, piece->normal, piece->offset, facing);
        lights[count][0] = facing < 0.0 ? piece->front : piece->back;
        lights[count++][1] = piece->exitance;
    }
    return count;
}

/* Next leaf in front of the open part; NULL: no more. */
static const struct beam_node *next_leaf(struct beam_look *look)
{
    const struct pp_beam *beam = look->beam;
    while (look->at < beam->node_count) {
        const struct beam_node *node = &beam->nodes[look->at];
        bool beside =
            lies_beside(&look->open, &node->low, &node->high, look->a, look->b);
        look->at = beside ? node->next : look->at + 1;
        if (!beside && node->count > 0)
            return node;
    }
    return NULL;
}

/* Projects those skylines of the opening's wall that have no distance; returns their
 * number. */
static int find_skylines(const struct beam_look *look, struct pp_fragment_ring *rings,
                         double (*xy)[2], double (*lights)[2])
{
    const struct pp_world *world = look->beam->world;
    int count = 0;
    for (int i = 0; look->beam->skylines > 0 && i < world->skyline_count; i++)
        if (pp_world_skyline_is_far(&world->skylines[i], look->beam->opening->face)
            && project_skyline(&rings[count], xy + count * PP_FRAGMENT_CORNERS,
                               look->beam, &world->skylines[i], look->u)) {
            lights[count][0] = world->skylines[i].reflectance;
            lights[count++][1] = 0.0;
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

bool pp_beam_budget_exhausted(const struct pp_beam_space *space)
{
    return space->work_budget > 0 && space->work > space->work_budget;
}

/* Removes the parts hidden by any obstruction from the open part; stops when nothing is
 * left or the work budget is exhausted. */
static enum pp_status subtract_all(struct beam_look *look, struct pp_beam_space *space,
                                   struct pp_error *err)
{
    struct pp_fragments *open = &space->open;
    enum pp_status status = PP_OK;
    int count = find_skylines(look, space->rings, space->xy, space->lights);
    do {
        for (int i = 0; i < count && status == PP_OK; i++) {
            space->work += open->count;
            status = pp_fragments_subtract(open, &space->rings[i], err);
        }
        if (pp_beam_budget_exhausted(space))
            return status;
        const struct beam_node *leaf = open->count > 0 ? next_leaf(look) : NULL;
        if (status != PP_OK || !leaf)
            return status;
        count = find_leaf(look, leaf, space->rings, space->xy, space->lights);
    } while (true);
}

/* Assigns each fragment of the open part to the nearest obstruction that covers it. */
static enum pp_status cover_all(struct beam_look *look, struct pp_beam_space *space,
                                struct pp_error *err)
{
    int count = 0;
    const struct beam_node *leaf;
    while ((leaf = next_leaf(look)))
        count +=
            find_leaf(look, leaf, space->rings + count,
                      space->xy + count * PP_FRAGMENT_CORNERS, space->lights + count);
    count +=
        find_skylines(look, space->rings + count,
                      space->xy + count * PP_FRAGMENT_CORNERS, space->lights + count);
    enum pp_status status = PP_OK;
    for (int i = 0; i < count && status == PP_OK && !pp_beam_budget_exhausted(space);
         i++) {
        space->work += space->open.count;
        status = pp_fragments_cover(&space->open, space->rings, i, err);
    }
    return status;
}

enum pp_status pp_beam_areas(struct pp_beam_areas *areas, const struct pp_beam *beam,
                             struct pp_beam_space *space, struct pp_vec3 u,
                             struct pp_error *err)
{
    *areas = (struct pp_beam_areas){0};
    struct pp_vec3 own = pp_projection_direction(&beam->axes, u);
    if (!(own.z > 0.0 && u.z > 0.0))
        return PP_OK;
    struct beam_look look = {
        .beam = beam, .u = u, .own = own, .a = own.x / own.z, .b = own.y / own.z};
    struct pp_fragments *open = &space->open;
    enum pp_status status = make_room_for_rings(space, beam, err);
    if (status == PP_OK)
        status = open_part(beam, space, look.a, look.b, err);
    if (status != PP_OK || open->count == 0)
        return status;
    look.open = fragments_face_extent(open);
    if (beam->one_light) {
        double whole = sum_areas(open);
        status = subtract_all(&look, space, err);
        areas->sky = sum_areas(open);
        areas->reflecting = (whole - areas->sky) * beam->of_light[0];
        areas->emitting = (whole - areas->sky) * beam->of_light[1];
        return status;
    }
    status = cover_all(&look, space, err);
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
