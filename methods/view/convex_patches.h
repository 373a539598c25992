/* convex_patches.h - divides the open part of a view among the obstructions outside, by
 * convex cuts. For visible.c and patch_builder.c only.
 *
 * Convex cuts are many times as fast as an overlay, and robust for any position of
 * edges. However, a patch is returned as adjacent convex rings and not as its outline.
 */
#ifndef PP_METHODS_VIEW_CONVEX_PATCHES_H
#define PP_METHODS_VIEW_CONVEX_PATCHES_H

#include "methods/view/patch_builder.h"

/* Fills `visible` with one patch for the sky and one for each light. The open part is
 * builder->open or, if that is empty, the convex ring visible->ring. builder->inside is
 * subtracted from the open part, and the rest is divided by builder->outside. */
enum pp_status pp_convex_patches_fill(struct pp_visible *visible,
                                      const struct pp_patch_builder *builder,
                                      struct pp_error *err);

#endif
