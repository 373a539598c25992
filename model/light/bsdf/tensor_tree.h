/* tensor_tree.h - the tensor trees of genBSDF, read into the cells of a grid.
 *
 * A tree divides the space of three or four coordinates from 0 to 1. Rank 4: x and y of
 * the arriving light on the unit square (angle_basis.h), then x and y of the leaving
 * light. Rank 3, for isotropic panes: (1 - sin t)/2 for arriving light at an angle t
 * from the normal, then x and y of the leaving light, turned so that the arriving light
 * travels towards +x.
 *
 * In the text, a brace that contains braces halves every coordinate; bit k of a child's
 * index selects the half of coordinate k. A brace that contains numbers is a regular
 * grid of values; the last coordinate varies fastest. For rank 4, this order was found
 * by comparison with values that Radiance reads from the same file. For rank 3 it was
 * not compared.
 *
 * Cells of the result are at least 1/32 of a coordinate wide (rank 3: 1/16); finer data
 * are averaged.
 */
#ifndef PP_MODEL_LIGHT_BSDF_TENSOR_TREE_H
#define PP_MODEL_LIGHT_BSDF_TENSOR_TREE_H

#include "model/light/bsdf/bsdf.h"

/* Reads a tree of rank 3 or 4 into an empty block. *fault: the reason if the text is
 * not a valid tree (a static string), else NULL. Fails only if memory runs out. */
enum pp_status pp_tensor_tree_read(struct pp_bsdf_block *block, const char *text,
                                   int rank, const char **fault, struct pp_error *err);

#endif
