/* keyhole.c - see keyhole.h.
 *
 * Holes are joined one by one, each time the hole with the shortest bridge. A bridge is
 * a line from a corner of the hole to a corner of the current outline that crosses no
 * edge.
 */
#include "model/room/keyhole.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "model/room/face_less_openings.h"

typedef double point[2];

static struct pp_face_axes axes_of(const struct pp_polygon *face)
{
    struct pp_face_axes axes = {.origin = face->vertices[0]};
    /* The first axis follows the first edge, so that vertical walls have vertical
     * coordinates. */
    axes.a = pp_vec_unit(pp_vec_sub(face->vertices[1], face->vertices[0]));
    axes.b = pp_vec_cross(face->normal, axes.a);
    return axes;
}

/* ---- bridges ---- */

struct closed_line {
    point *xy;
    int count;
};

static bool same(const double *a, const double *b)
{
    return a[0] == b[0] && a[1] == b[1];
}

/* True if p is inside the interior angle at corner `at` of a closed line that has its
 * interior on the left. */
static bool opens(const struct closed_line *line, int at, const double *p)
{
    const double *before = line->xy[(at + line->count - 1) % line->count];
    const double *here = line->xy[at];
    const double *behind = line->xy[(at + 1) % line->count];
    bool left_of_in = pp_region_turn(before, here, p) > 0.0;
    bool left_of_out = pp_region_turn(here, behind, p) > 0.0;
    return pp_region_turn(before, here, behind) > 0.0 ? left_of_in && left_of_out
                                                      : left_of_in || left_of_out;
}

/* True if the segments a b and c d meet, other than at a or b. */
static bool meet(const double *a, const double *b, const double *c, const double *d)
{
    if (same(c, a) || same(c, b) || same(d, a) || same(d, b))
        return false;
    double c_side = pp_region_turn(a, b, c), d_side = pp_region_turn(a, b, d);
    double a_side = pp_region_turn(c, d, a), b_side = pp_region_turn(c, d, b);
    if (c_side == 0.0 && d_side == 0.0) { /* collinear: test for overlap */
        int k = fabs(b[0] - a[0]) < fabs(b[1] - a[1]);
        return fmin(c[k], d[k]) <= fmax(a[k], b[k])
               && fmin(a[k], b[k]) <= fmax(c[k], d[k]);
    }
    return c_side * d_side <= 0.0 && a_side * b_side <= 0.0;
}

static bool blocked(const struct closed_line *line, const double *a, const double *b)
{
    for (int i = 0; i < line->count; i++)
        if (meet(a, b, line->xy[i], line->xy[(i + 1) % line->count]))
            return true;
    return false;
}

struct keyhole_bridge {
    int rim;          /* corner index in the outline */
    int hole, corner; /* index of the hole, and of its corner */
    double length;
};

/* Shortest bridge that no edge blocks; rim is -1 if there is none. */
static struct keyhole_bridge find_bridge(const struct closed_line *outline,
                                         const struct closed_line *holes, int count)
{
    struct keyhole_bridge best = {-1, -1, -1, INFINITY};
    for (int h = 0; h < count; h++)
        for (int k = 0; k < holes[h].count; k++)
            for (int r = 0; r < outline->count; r++) {
                const double *from = outline->xy[r], *to = holes[h].xy[k];
                double length = hypot(to[0] - from[0], to[1] - from[1]);
                if (!(length < best.length) || !opens(outline, r, to)
                    || !opens(&holes[h], k, from) || blocked(outline, from, to))
                    continue;
                bool free_way = true;
                for (int i = 0; i < count && free_way; i++)
                    free_way = !blocked(&holes[i], from, to);
                if (free_way)
                    best = (struct keyhole_bridge){r, h, k, length};
            }
    return best;
}

/* Extends the outline along the bridge, around the hole, and back; the outline has
 * space for it. */
static void join_hole(struct closed_line *outline, const struct closed_line *hole,
                      struct keyhole_bridge bridge)
{
    int more = hole->count + 2, behind = outline->count - bridge.rim;
    memmove(outline->xy + bridge.rim + more, outline->xy + bridge.rim,
            (size_t)behind * sizeof *outline->xy);
    point *to = outline->xy + bridge.rim;
    memcpy(to[0], to[more], sizeof *to);
    for (int i = 0; i <= hole->count; i++)
        memcpy(to[1 + i], hole->xy[(bridge.corner + i) % hole->count], sizeof *to);
    outline->count += more;
}

static enum pp_status join_holes(struct closed_line *outline, struct closed_line *holes,
                                 int count, struct pp_error *err)
{
    while (count > 0) {
        struct keyhole_bridge bridge = find_bridge(outline, holes, count);
        if (bridge.rim < 0)
            return pp_fail(
                err, PP_BAD_INPUT,
                "the openings of a wall cannot be joined to the edge of the wall");
        join_hole(outline, &holes[bridge.hole], bridge);
        holes[bridge.hole] = holes[--count];
    }
    return PP_OK;
}

/* ---- conversion to points of the room ---- */

/* Adds an outline made of an outer ring, rings[0], and its holes, rings[1] to
 * rings[count - 1]. */
static enum pp_status add_outline(struct pp_keyhole_outlines *cut,
                                  const struct pp_face_axes *axes,
                                  const struct pp_ring *rings, int count,
                                  const struct pp_world *world, int face,
                                  struct pp_error *err)
{
    size_t total = 0;
    for (int i = 0; i < count; i++)
        total += (size_t)rings[i].count + 2;
    struct closed_line outline = {malloc(total * sizeof(point)), rings[0].count};
    struct closed_line *holes = malloc((size_t)count * sizeof *holes);
    struct pp_vec3 *corners = malloc(total * sizeof *corners);
    enum pp_status status =
        outline.xy && holes && corners ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK) {
        memcpy(outline.xy, rings[0].xy, (size_t)rings[0].count * sizeof(point));
        for (int i = 1; i < count; i++)
            holes[i - 1] = (struct closed_line){rings[i].xy, rings[i].count};
        status = join_holes(&outline, holes, count - 1, err);
    }
    if (status == PP_OK) {
        for (int i = 0; i < outline.count; i++)
            corners[i] = pp_face_less_openings_corner(
                axes, outline.xy[i], &world->surfaces[face].outline, world, face);
        cut->outlines[cut->count++] = (struct pp_ring_3d){outline.count, corners};
        corners = NULL;
    }
    free(corners);
    free(holes);
    free(outline.xy);
    return status;
}

static bool is_hole(const struct pp_ring *ring)
{
    return pp_region_ring_area((const double(*)[2])ring->xy, ring->count) < 0.0;
}

static enum pp_status add_whole_face(struct pp_keyhole_outlines *cut,
                                     const struct pp_polygon *face,
                                     struct pp_error *err)
{
    size_t size = (size_t)face->count * sizeof *face->vertices;
    struct pp_vec3 *corners = malloc(size);
    if (!corners)
        return pp_fail_memory(err);
    memcpy(corners, face->vertices, size);
    cut->outlines[cut->count++] = (struct pp_ring_3d){face->count, corners};
    return PP_OK;
}

enum pp_status pp_keyhole_outlines_init(struct pp_keyhole_outlines *cut,
                                        const struct pp_world *world, int face,
                                        struct pp_error *err)
{
    const struct pp_polygon *outline = &world->surfaces[face].outline;
    struct pp_face_axes axes = axes_of(outline);
    struct pp_region region = {0, NULL};
    struct pp_clipper *clipper = NULL;
    bool whole = true;
    for (int i = 0; i < world->opening_count && whole; i++)
        whole = world->openings[i].face != face;
    *cut = (struct pp_keyhole_outlines){0};
    enum pp_status status = PP_OK;
    if (!whole)
        status = pp_clipper_create(&clipper, err);
    if (!whole && status == PP_OK)
        status =
            pp_face_less_openings(&region, clipper, &axes, outline, world, face, err);
    cut->outlines = calloc((size_t)region.count + 1, sizeof *cut->outlines);
    if (status == PP_OK && !cut->outlines)
        status = pp_fail_memory(err);
    if (status == PP_OK && whole)
        status = add_whole_face(cut, outline, err);
    for (int i = 0, next; i < region.count && status == PP_OK; i = next) {
        next = i + 1;
        while (next < region.count && is_hole(&region.rings[next]))
            next++;
        status = add_outline(cut, &axes, region.rings + i, next - i, world, face, err);
    }
    pp_region_clear(&region);
    pp_clipper_destroy(clipper);
    if (status != PP_OK)
        pp_keyhole_outlines_clear(cut);
    return status;
}

void pp_keyhole_outlines_clear(struct pp_keyhole_outlines *cut)
{
    for (int i = 0; i < cut->count; i++)
        free(cut->outlines[i].corners);
    free(cut->outlines);
    *cut = (struct pp_keyhole_outlines){0};
}
