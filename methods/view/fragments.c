/* fragments.c - cuts convex fragments along the lines of convex rings. */
#include "methods/view/fragments.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

static void measure(struct pp_fragment *fragment)
{
    for (int axis = 0; axis < 2; axis++) {
        double low = fragment->xy[0][axis], high = low;
        for (int i = 1; i < fragment->count; i++) {
            double at = fragment->xy[i][axis];
            low = at < low ? at : low;
            high = at > high ? at : high;
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
    enum { MOST = PP_FRAGMENT_CORNERS };
    for (int first = 1; first + 1 < count && status == PP_OK; first += MOST - 2) {
        status = pp_array_reserve(&fragments->list, &fragments->capacity,
                                  fragments->count + 1, sizeof *fragments->list, err);
        if (status != PP_OK)
            return status;
        struct pp_fragment *part = &fragments->list[fragments->count++];
        part->owner = owner;
        part->count = 0;
        memcpy(part->xy[part->count++], xy[0], sizeof *xy);
        for (int i = first; i < count && part->count < MOST; i++)
            memcpy(part->xy[part->count++], xy[i], sizeof *xy);
        measure(part);
    }
    return status;
}

enum pp_status pp_fragments_add(struct pp_fragments *fragments, const double (*xy)[2],
                                int count, struct pp_error *err)
{
    return push(fragments, PP_FRAGMENT_FREE, xy, count, err);
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
            low = xy[i][axis] < low ? xy[i][axis] : low;
            high = xy[i][axis] > high ? xy[i][axis] : high;
        }
        ring->low[axis] = low;
        ring->high[axis] = high;
    }
}

/* ---- Cuts ---- */

/* A convex ring on its way through several cuts, each of which may add a corner. */
struct cut_ring {
    int count;
    double xy[2 * PP_FRAGMENT_CORNERS + 2][2];
};

/* The line a x + b y + c = 0. */
struct cut_line {
    double a, b, c;
};

/* The line of an edge, greater than 0 within the ring. */
static struct cut_line line_of_edge(const struct pp_fragment_ring *ring, int i)
{
    const double *p = ring->xy[i], *q = ring->xy[i + 1 < ring->count ? i + 1 : 0];
    double a = p[1] - q[1], b = q[0] - p[0];
    return (struct cut_line){a, b, -a * p[0] - b * p[1]};
}

/* Divides a ring by a line: `in` where it is greater than 0, `out` where it is less.
 * Either may come out without corners. `out` may be NULL. */
static void divide(struct cut_ring *in, struct cut_ring *out,
                   const struct cut_ring *whole, struct cut_line line)
{
    double side[2 * PP_FRAGMENT_CORNERS + 2];
    int count = whole->count, above = 0, below = 0;
    for (int i = 0; i < count; i++) {
        side[i] = line.a * whole->xy[i][0] + line.b * whole->xy[i][1] + line.c;
        above += side[i] > 0.0;
        below += side[i] < 0.0;
    }
    in->count = 0;
    if (out)
        out->count = 0;
    struct cut_ring *all = below == 0 ? in : above == 0 ? out : NULL;
    if (all) {
        all->count = count;
        memcpy(all->xy, whole->xy, (size_t)count * sizeof *whole->xy);
    }
    if (below == 0 || above == 0)
        return;
    for (int i = 0, last = count - 1; i < count; last = i++) {
        const double *a = whole->xy[last], *b = whole->xy[i];
        if ((side[i] > 0.0 && side[last] < 0.0)
            || (side[i] < 0.0 && side[last] > 0.0)) {
            double t = side[last] / (side[last] - side[i]);
            double at[2] = {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
            memcpy(in->xy[in->count++], at, sizeof at);
            if (out)
                memcpy(out->xy[out->count++], at, sizeof at);
        }
        if (side[i] >= 0.0)
            memcpy(in->xy[in->count++], b, 2 * sizeof *b);
        if (side[i] <= 0.0 && out)
            memcpy(out->xy[out->count++], b, 2 * sizeof *b);
    }
}

static bool apart(const struct pp_fragment *fragment,
                  const struct pp_fragment_ring *ring)
{
    return fragment->low[0] >= ring->high[0] || fragment->high[0] <= ring->low[0]
           || fragment->low[1] >= ring->high[1] || fragment->high[1] <= ring->low[1];
}

static struct cut_ring cut_ring_of(const struct pp_fragment *fragment)
{
    struct cut_ring ring;
    ring.count = fragment->count;
    memcpy(ring.xy, fragment->xy, (size_t)fragment->count * sizeof *fragment->xy);
    return ring;
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

/* The part of a fragment within a ring; false where there is none but slivers of
 * rounding errors. */
static bool part_within(struct cut_ring *part, const struct pp_fragment *fragment,
                        const struct pp_fragment_ring *ring)
{
    if (apart(fragment, ring))
        return false;
    struct cut_ring other = cut_ring_of(fragment);
    struct cut_ring *from = &other, *to = part;
    for (int i = 0; i < ring->count; i++) {
        divide(to, NULL, from, line_of_edge(ring, i));
        if (to->count < 3)
            return false;
        struct cut_ring *swap = from;
        from = to;
        to = swap;
    }
    if (from != part)
        *part = *from;
    double extent =
        (fragment->high[0] - fragment->low[0]) * (fragment->high[1] - fragment->low[1]);
    return area_of((const double(*)[2])part->xy, part->count) > 1e-15 * extent;
}

/* Adds what of a fragment lies outside a ring that it meets, edge by edge. */
static enum pp_status add_outside(struct pp_fragments *fragments, int owner,
                                  const struct cut_ring *whole,
                                  const struct pp_fragment_ring *ring,
                                  struct pp_error *err)
{
    struct cut_ring left = *whole, in, out;
    enum pp_status status = PP_OK;
    for (int i = 0; i < ring->count && left.count >= 3 && status == PP_OK; i++) {
        divide(&in, &out, &left, line_of_edge(ring, i));
        status = push(fragments, owner, (const double(*)[2])out.xy, out.count, err);
        left = in;
    }
    return status;
}

/* Takes a fragment out of the list; the last one moves to its place. */
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
    struct cut_ring part;
    for (int i = 0; i < fragments->count && status == PP_OK; i++)
        if (part_within(&part, &fragments->list[i], ring))
            status = push(result, fragments->list[i].owner, (const double(*)[2])part.xy,
                          part.count, err);
    return status;
}

/* Is the ring nearer than the owner, by the line on which both are at the same depth? */
static struct cut_line nearer_than(const struct pp_fragment_ring *ring,
                                   const struct pp_fragment_ring *owner)
{
    return (struct cut_line){owner->depth[1] - ring->depth[1],
                             owner->depth[2] - ring->depth[2],
                             owner->depth[0] - ring->depth[0]};
}

/* Gives the ring what it hides of a fragment. */
static enum pp_status cover_one(struct pp_fragments *fragments, int at,
                                const struct pp_fragment_ring *rings, int index,
                                struct pp_error *err)
{
    const struct pp_fragment_ring *ring = &rings[index];
    struct cut_ring within, front, behind = {0};
    if (!part_within(&within, &fragments->list[at], ring))
        return PP_OK;
    int owner = fragments->list[at].owner;
    front = within;
    if (owner != PP_FRAGMENT_FREE)
        divide(&front, &behind, &within, nearer_than(ring, &rings[owner]));
    if (front.count < 3)
        return PP_OK;
    struct cut_ring whole = cut_ring_of(&fragments->list[at]);
    drop(fragments, at);
    enum pp_status status =
        push(fragments, index, (const double(*)[2])front.xy, front.count, err);
    if (status == PP_OK)
        status =
            push(fragments, owner, (const double(*)[2])behind.xy, behind.count, err);
    if (status == PP_OK)
        status = add_outside(fragments, owner, &whole, ring, err);
    return status;
}

enum pp_status pp_fragments_cover(struct pp_fragments *fragments,
                                  const struct pp_fragment_ring *rings, int index,
                                  struct pp_error *err)
{
    enum pp_status status = PP_OK;
    /* Backwards: what is added, and what moves to a free place, has had its turn. */
    for (int i = fragments->count - 1; i >= 0 && status == PP_OK; i--)
        status = cover_one(fragments, i, rings, index, err);
    return status;
}

enum pp_status pp_fragments_move(struct pp_fragments *taken,
                                 struct pp_fragments *fragments,
                                 const struct pp_fragment_ring *ring,
                                 struct pp_error *err)
{
    struct cut_ring part;
    enum pp_status status = PP_OK;
    for (int i = fragments->count - 1; i >= 0 && status == PP_OK; i--) {
        if (!part_within(&part, &fragments->list[i], ring))
            continue;
        struct cut_ring whole = cut_ring_of(&fragments->list[i]);
        int owner = fragments->list[i].owner;
        drop(fragments, i);
        if (taken)
            status = push(taken, owner, (const double(*)[2])part.xy, part.count, err);
        if (status == PP_OK)
            status = add_outside(fragments, owner, &whole, ring, err);
    }
    return status;
}

enum pp_status pp_fragments_subtract(struct pp_fragments *fragments,
                                     const struct pp_fragment_ring *ring,
                                     struct pp_error *err)
{
    return pp_fragments_move(NULL, fragments, ring, err);
}
