/* fragments.c - cuts convex fragments along the edges of convex rings. */
#include "methods/view/fragments.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/min_max.h"

static void measure_fragment(struct pp_fragment *fragment)
{
    for (int axis = 0; axis < 2; axis++) {
        double low = fragment->xy[0][axis], high = low;
        for (int i = 1; i < fragment->count; i++) {
            double at = fragment->xy[i][axis];
            low = pp_min(at, low);
            high = pp_max(at, high);
        }
        fragment->low[axis] = low;
        fragment->high[axis] = high;
    }
}

/* Adds a convex ring of any number of corners as a fan of fragments. */
static enum pp_status push(struct pp_fragments *fragments, int owner,
                           const double (*xy)[2], int count, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    enum { MOST = PP_FRAGMENT_CORNERS, FEW = 8 };
    for (int first = 1; first + 1 < count && status == PP_OK; first += MOST - 2) {
        int wanted = fragments->count + 1;
        status =
            pp_array_reserve(&fragments->list, &fragments->capacity,
                             wanted > FEW ? wanted : FEW, sizeof *fragments->list, err);
        if (status != PP_OK)
            return status;
        struct pp_fragment *part = &fragments->list[fragments->count++];
        part->owner = owner;
        part->count = 0;
        memcpy(part->xy[part->count++], xy[0], sizeof *xy);
        for (int i = first; i < count && part->count < MOST; i++)
            memcpy(part->xy[part->count++], xy[i], sizeof *xy);
        measure_fragment(part);
    }
    return status;
}

enum pp_status pp_fragments_add(struct pp_fragments *fragments, const double (*xy)[2],
                                int count, struct pp_error *err)
{
    return push(fragments, PP_FRAGMENT_FREE, xy, count, err);
}

enum pp_status pp_fragments_append(struct pp_fragments *fragments,
                                   const struct pp_fragments *more,
                                   struct pp_error *err)
{
    if (more->count == 0)
        return PP_OK;
    enum pp_status status =
        pp_array_reserve(&fragments->list, &fragments->capacity,
                         fragments->count + more->count, sizeof *fragments->list, err);
    if (status == PP_OK) {
        memcpy(fragments->list + fragments->count, more->list,
               (size_t)more->count * sizeof *more->list);
        fragments->count += more->count;
    }
    return status;
}

void pp_fragments_close_ring(struct pp_fragment_ring *ring, double (*xy)[2], int count)
{
    double twice = 0.0;
    for (int i = 2; i < count; i++)
        twice += (xy[i - 1][0] - xy[0][0]) * (xy[i][1] - xy[0][1])
                 - (xy[i][0] - xy[0][0]) * (xy[i - 1][1] - xy[0][1]);
    if (twice < 0.0)
        for (int a = 0, b = count - 1; a < b; a++, b--) {
            double swap[2] = {xy[a][0], xy[a][1]};
            memcpy(xy[a], xy[b], sizeof swap);
            memcpy(xy[b], swap, sizeof swap);
        }
    ring->count = count;
    ring->xy = (const double(*)[2])xy;
    for (int axis = 0; axis < 2; axis++) {
        double low = xy[0][axis], high = low;
        for (int i = 1; i < count; i++) {
            low = pp_min(xy[i][axis], low);
            high = pp_max(xy[i][axis], high);
        }
        ring->low[axis] = low;
        ring->high[axis] = high;
    }
}

/* ---- Cuts ---- */

/* A convex ring during several cuts, each of which may add a corner. */
struct cut_ring {
    int count;
    double xy[2 * PP_FRAGMENT_CORNERS + 2][2];
};

/* The line a x + b y + c = 0. */
struct cut_line {
    double a, b, c;
};

/* The line of an edge; its expression is greater than 0 within the ring. */
static struct cut_line line_of_edge(const struct pp_fragment_ring *ring, int i)
{
    const double *p = ring->xy[i], *q = ring->xy[i + 1 < ring->count ? i + 1 : 0];
    double a = p[1] - q[1], b = q[0] - p[0];
    return (struct cut_line){a, b, -a * p[0] - b * p[1]};
}

/* Divides a ring by a line. Returns > 0 if the whole ring is on the side where the
 * expression is >= 0, < 0 if it is on the other side, and 0 if it was divided into `in`
 * (> 0) and `out` (< 0). */
static int divide_ring(struct cut_ring *in, struct cut_ring *out,
                       const struct cut_ring *whole, struct cut_line line)
{
    double side[2 * PP_FRAGMENT_CORNERS + 2];
    int count = whole->count, above = 0, below = 0;
    for (int i = 0; i < count; i++) {
        side[i] = line.a * whole->xy[i][0] + line.b * whole->xy[i][1] + line.c;
        above += side[i] > 0.0;
        below += side[i] < 0.0;
    }
    if (below == 0 || above == 0)
        return below == 0 ? 1 : -1;
    in->count = out->count = 0;
    for (int i = 0, last = count - 1; i < count; last = i++) {
        const double *a = whole->xy[last], *b = whole->xy[i];
        if ((side[i] > 0.0 && side[last] < 0.0)
            || (side[i] < 0.0 && side[last] > 0.0)) {
            double t = side[last] / (side[last] - side[i]);
            double at[2] = {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
            memcpy(in->xy[in->count++], at, sizeof at);
            memcpy(out->xy[out->count++], at, sizeof at);
        }
        if (side[i] >= 0.0)
            memcpy(in->xy[in->count++], b, 2 * sizeof *b);
        if (side[i] <= 0.0)
            memcpy(out->xy[out->count++], b, 2 * sizeof *b);
    }
    return 0;
}

static bool apart(const struct pp_fragment *fragment,
                  const struct pp_fragment_ring *ring)
{
    return fragment->low[0] >= ring->high[0] || fragment->high[0] <= ring->low[0]
           || fragment->low[1] >= ring->high[1] || fragment->high[1] <= ring->low[1];
}

static double area_of(const double (*p)[2], int count)
{
    double twice = 0.0;
    for (int i = 2; i < count; i++)
        twice += (p[i - 1][0] - p[0][0]) * (p[i][1] - p[0][1])
                 - (p[i][0] - p[0][0]) * (p[i - 1][1] - p[0][1]);
    return twice / 2.0;
}

double pp_fragments_area(const struct pp_fragment *fragment)
{
    return area_of((const double(*)[2])fragment->xy, fragment->count);
}

/* A fragment divided by a ring: the part within, and the part outside each edge. */
struct cut_parts {
    const struct cut_ring *within; /* points to one of the two rings */
    struct cut_ring rings[2];
    int outside_count;
    struct cut_ring outside[PP_FRAGMENT_CORNERS];
};

/* Divides a fragment by a ring, edge by edge. Returns false if nothing, or only a
 * sliver due to rounding errors, lies within. */
static bool divide_by_ring(struct cut_parts *parts, const struct pp_fragment *fragment,
                           const struct pp_fragment_ring *ring)
{
    if (apart(fragment, ring))
        return false;
    int at = 0;
    parts->outside_count = 0;
    parts->rings[0].count = fragment->count;
    memcpy(parts->rings[0].xy, fragment->xy,
           (size_t)fragment->count * sizeof *fragment->xy);
    for (int i = 0; i < ring->count; i++) {
        struct cut_ring *out = &parts->outside[parts->outside_count];
        int side = divide_ring(&parts->rings[1 - at], out, &parts->rings[at],
                               line_of_edge(ring, i));
        if (side < 0)
            return false;
        if (side > 0)
            continue;
        parts->outside_count += out->count >= 3;
        at = 1 - at;
        if (parts->rings[at].count < 3)
            return false;
    }
    parts->within = &parts->rings[at];
    double extent =
        (fragment->high[0] - fragment->low[0]) * (fragment->high[1] - fragment->low[1]);
    return area_of((const double(*)[2])parts->within->xy, parts->within->count)
           > 1e-15 * extent;
}

static enum pp_status push_ring(struct pp_fragments *fragments, int owner,
                                const struct cut_ring *ring, struct pp_error *err)
{
    return push(fragments, owner, (const double(*)[2])ring->xy, ring->count, err);
}

/* Adds the part of a fragment outside a ring. */
static enum pp_status add_outside(struct pp_fragments *fragments, int owner,
                                  const struct cut_parts *parts, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < parts->outside_count && status == PP_OK; i++)
        status = push_ring(fragments, owner, &parts->outside[i], err);
    return status;
}

/* Removes a fragment from the list; the last one moves to its place. */
static void drop(struct pp_fragments *fragments, int index)
{
    fragments->list[index] = fragments->list[--fragments->count];
}

void pp_fragments_clear(struct pp_fragments *fragments)
{
    free(fragments->list);
    *fragments = (struct pp_fragments){0};
}

enum pp_status pp_fragments_intersect(struct pp_fragments *result,
                                      const struct pp_fragments *fragments,
                                      const struct pp_fragment_ring *ring,
                                      struct pp_error *err)
{
    enum pp_status status = PP_OK;
    struct cut_parts parts;
    for (int i = 0; i < fragments->count && status == PP_OK; i++)
        if (divide_by_ring(&parts, &fragments->list[i], ring))
            status = push_ring(result, fragments->list[i].owner, parts.within, err);
    return status;
}

/* The line on which the ring and the owner have the same depth, positive where the ring
 * is nearer. */
static struct cut_line nearer_than(const struct pp_fragment_ring *ring,
                                   const struct pp_fragment_ring *owner)
{
    return (struct cut_line){owner->depth[1] - ring->depth[1],
                             owner->depth[2] - ring->depth[2],
                             owner->depth[0] - ring->depth[0]};
}

/* True if the ring is behind the owner of the fragment, over the whole fragment. */
static bool is_behind(const struct pp_fragment *fragment,
                      const struct pp_fragment_ring *rings, int index)
{
    if (fragment->owner == PP_FRAGMENT_FREE)
        return false;
    struct cut_line line = nearer_than(&rings[index], &rings[fragment->owner]);
    for (int i = 0; i < fragment->count; i++)
        if (line.a * fragment->xy[i][0] + line.b * fragment->xy[i][1] + line.c > 0.0)
            return false;
    return true;
}

/* Assigns to the ring the part of a fragment that it hides. */
static enum pp_status cover_one(struct pp_fragments *fragments, int at,
                                const struct pp_fragment_ring *rings, int index,
                                struct pp_error *err)
{
    const struct pp_fragment_ring *ring = &rings[index];
    struct cut_parts parts;
    if (apart(&fragments->list[at], ring)
        || is_behind(&fragments->list[at], rings, index)
        || !divide_by_ring(&parts, &fragments->list[at], ring))
        return PP_OK;
    int owner = fragments->list[at].owner;
    const struct cut_ring *front = parts.within;
    struct cut_ring nearer, behind;
    behind.count = 0;
    if (owner != PP_FRAGMENT_FREE) {
        int side =
            divide_ring(&nearer, &behind, front, nearer_than(ring, &rings[owner]));
        if (side < 0)
            return PP_OK;
        front = side > 0 ? front : &nearer;
    }
    if (front->count < 3)
        return PP_OK;
    drop(fragments, at);
    enum pp_status status = push_ring(fragments, index, front, err);
    if (status == PP_OK)
        status = push_ring(fragments, owner, &behind, err);
    return status == PP_OK ? add_outside(fragments, owner, &parts, err) : status;
}

enum pp_status pp_fragments_cover(struct pp_fragments *fragments,
                                  const struct pp_fragment_ring *rings, int index,
                                  struct pp_error *err)
{
    enum pp_status status = PP_OK;
    /* Runs backwards: fragments added, or moved to a free place, are already done. */
    for (int i = fragments->count - 1; i >= 0 && status == PP_OK; i--)
        status = cover_one(fragments, i, rings, index, err);
    return status;
}

enum pp_status pp_fragments_move(struct pp_fragments *taken,
                                 struct pp_fragments *fragments,
                                 const struct pp_fragment_ring *ring,
                                 struct pp_error *err)
{
    struct cut_parts parts;
    enum pp_status status = PP_OK;
    for (int i = fragments->count - 1; i >= 0 && status == PP_OK; i--) {
        if (!divide_by_ring(&parts, &fragments->list[i], ring))
            continue;
        int owner = fragments->list[i].owner;
        drop(fragments, i);
        if (taken)
            status = push_ring(taken, owner, parts.within, err);
        if (status == PP_OK)
            status = add_outside(fragments, owner, &parts, err);
    }
    return status;
}

enum pp_status pp_fragments_subtract(struct pp_fragments *fragments,
                                     const struct pp_fragment_ring *ring,
                                     struct pp_error *err)
{
    return pp_fragments_move(NULL, fragments, ring, err);
}
