/* occluder_rings.h - the pieces of a view as rings of few corners, which cut fragments.
 * For convex_patches.c and patch_builder.c only.
 */
#ifndef PP_METHODS_VIEW_OCCLUDER_RINGS_H
#define PP_METHODS_VIEW_OCCLUDER_RINGS_H

#include "methods/view/fragments.h"
#include "methods/view/occluders.h"

struct pp_occluder_rings {
    int count;
    struct pp_fragment_ring *rings;
    int *of; /* index of the piece that each ring is a part of */
    double (*xy)[2];
};

/* Finds the rings, in the order of the pieces, with depths for a view whose plane is at
 * that distance. The caller clears the rings, even after a failure. */
enum pp_status pp_occluder_rings_find(struct pp_occluder_rings *rings,
                                      const struct pp_occluders *pieces,
                                      double distance_m, struct pp_error *err);
void pp_occluder_rings_clear(struct pp_occluder_rings *rings);

/* Sorts the rings by the area of their bounding boxes, largest first: later ones are
 * then mostly hidden. */
enum pp_status pp_occluder_rings_sort(struct pp_occluder_rings *rings,
                                      struct pp_error *err);

/* Assigns each part of the open fragments to the nearest ring. Sorts the rings, nearest
 * first: later ones then divide few fragments. */
enum pp_status pp_occluder_rings_cover(struct pp_fragments *open,
                                       struct pp_occluder_rings *rings,
                                       struct pp_error *err);

/* Removes pieces that other pieces hide entirely, within the extent of the scene.
 * one_light: all pieces have the same reflectance and exitance, so that any may hide
 * another; otherwise only a nearer piece hides. */
enum pp_status pp_occluder_rings_drop_hidden(struct pp_occluders *pieces,
                                             const struct pp_occluders_scene *scene,
                                             bool one_light, struct pp_error *err);

#endif
