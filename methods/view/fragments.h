/* fragments.h - a plane region as convex fragments, from which convex rings are cut one
 * after another.
 *
 * A cut conserves area except for rounding. Unlike an overlay, a cut does not need
 * topologically valid input. A fragment is free, or has an owner: the ring that covers
 * it and is in front of all others.
 */
#ifndef PP_METHODS_VIEW_FRAGMENTS_H
#define PP_METHODS_VIEW_FRAGMENTS_H

#include <stdbool.h>

#include "model/base/error.h"

/* The most corners of a fragment, and of a ring that cuts. A fragment that would have
 * more is divided. */
enum { PP_FRAGMENT_CORNERS = 12 };

enum { PP_FRAGMENT_FREE = -1 };

struct pp_fragment {
    int owner; /* index of the covering ring; PP_FRAGMENT_FREE: none */
    int count;
    double xy[PP_FRAGMENT_CORNERS][2]; /* corners, counter-clockwise */
    double low[2], high[2];
};

/* Initialise with zeros; clear after use. */
struct pp_fragments {
    int count, capacity;
    struct pp_fragment *list;
};

/* A ring to be cut out: convex, counter-clockwise, with its extent. Its depth at (x, y)
 * is depth[0] + depth[1] x + depth[2] y. Depths are compared only: of two rings the one
 * with the smaller depth is in front. */
struct pp_fragment_ring {
    int count;
    const double (*xy)[2];
    double low[2], high[2];
    double depth[3];
};

/* Makes a ring from the corners of a convex polygon, which are put in counter-clockwise
 * order. depth is left unchanged. */
void pp_fragments_close_ring(struct pp_fragment_ring *ring, double (*xy)[2], int count);

void pp_fragments_clear(struct pp_fragments *fragments);

/* Adds a convex ring, counter-clockwise, as free fragments. */
enum pp_status pp_fragments_add(struct pp_fragments *fragments, const double (*xy)[2],
                                int count, struct pp_error *err);

/* Adds the fragments of a list. */
enum pp_status pp_fragments_append(struct pp_fragments *fragments,
                                   const struct pp_fragments *more,
                                   struct pp_error *err);

/* Adds the parts within the ring to `result`. */
enum pp_status pp_fragments_intersect(struct pp_fragments *result,
                                      const struct pp_fragments *fragments,
                                      const struct pp_fragment_ring *ring,
                                      struct pp_error *err);

/* Keeps the parts outside the ring. */
enum pp_status pp_fragments_subtract(struct pp_fragments *fragments,
                                     const struct pp_fragment_ring *ring,
                                     struct pp_error *err);

/* Keeps the parts outside the ring. Adds the parts inside to `taken`, unless `taken` is
 * NULL. */
enum pp_status pp_fragments_move(struct pp_fragments *taken,
                                 struct pp_fragments *fragments,
                                 const struct pp_fragment_ring *ring,
                                 struct pp_error *err);

/* Makes rings[index] the owner of the parts within that ring that are free or belong to
 * a ring behind it. */
enum pp_status pp_fragments_cover(struct pp_fragments *fragments,
                                  const struct pp_fragment_ring *rings, int index,
                                  struct pp_error *err);

double pp_fragments_area(const struct pp_fragment *fragment);

#endif
