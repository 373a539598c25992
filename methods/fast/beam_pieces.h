/* beam_pieces.h - clipping done once for an opening and a working plane. For beam.c
 * only. */
#ifndef PP_METHODS_FAST_BEAM_PIECES_H
#define PP_METHODS_FAST_BEAM_PIECES_H

#include "methods/fast/beam.h"
#include "model/geometry/projection.h"

/* A convex polygon in the beam's axes: `count` corners from beam->corners[first] on. */
struct beam_piece {
    int first, count;
    struct pp_vec3 low, high; /* extent of the corners */
    struct pp_vec3 normal;
    double offset; /* normal.v of the corners */
    double front, back, exitance;
    bool side_of_box; /* true: side of a block that is entirely outside; a side hides
                       * only what is behind its front */
};

struct beam_pieces {
    int count, capacity;
    struct beam_piece *list;
};

/* Axes: x along the opening, y up its face, z out through it, from the opening's first
 * corner. */
struct pp_beam {
    const struct pp_world *world;
    const struct pp_opening *opening;
    struct pp_projection axes;
    bool with_outside;
    bool one_light;                  /* all obstructions have the same reflectance and
                                      * exitance */
    double of_light[2];              /* the common reflectance and exitance if
                                      * one_light */
    struct beam_pieces inner, outer; /* the opening's outlines, in convex parts */
    struct beam_pieces plane;
    struct beam_pieces inside, outside;
    int node_count;
    struct beam_node *nodes; /* tree of the pieces outside (beam_tree.h) */
    int skylines;
    int corner_count, corner_capacity;
    struct pp_vec3 *corners;
    double low[2], high[2]; /* extent of the opening's outline */
};

/* Fills a beam in which world, opening and with_outside are set and all else is zero.
 * The caller destroys it, even after a failure. */
enum pp_status pp_beam_pieces_find(struct pp_beam *beam, struct pp_error *err);

#endif
