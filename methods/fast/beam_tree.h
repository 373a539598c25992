/* beam_tree.h - a bounding box hierarchy of the pieces outside. The tree limits the
 * test of a direction to pieces that may hide the opening in that direction. For beam.c
 * and beam_pieces.c only. */
#ifndef PP_METHODS_FAST_BEAM_TREE_H
#define PP_METHODS_FAST_BEAM_TREE_H

#include "methods/fast/beam_pieces.h"

/* Neighbouring pieces, from `first` on, in a box of the beam's axes. A node is followed
 * in the array by its descendants, then by node `next`. */
struct beam_node {
    struct pp_vec3 low, high;
    int first, count; /* count 0: the pieces are in the nodes below */
    int next;
};

/* Sorts beam->outside and fills beam->nodes. Called once, after all pieces are
 * added. */
enum pp_status pp_beam_tree_grow(struct pp_beam *beam, struct pp_error *err);

#endif
