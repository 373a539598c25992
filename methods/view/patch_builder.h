/* patch_builder.h - builds the patches of a view (visible.h) from the outline of the
 * opening and the occluders on either side of the plane. For visible.c only.
 */
#ifndef PP_METHODS_VIEW_PATCH_BUILDER_H
#define PP_METHODS_VIEW_PATCH_BUILDER_H

#include "methods/view/occluders.h"
#include "methods/view/visible.h"
#include "model/geometry/clipper.h"

/* The caller sets scene, in_parts, sky_only and, for an outline that is not a
 * rectangle, clipper and open; all other members are zero. */
struct pp_patch_builder {
    struct pp_occluders_scene scene;
    struct pp_occluders inside, outside;
    struct pp_clipper *clipper; /* NULL until it is needed */
    struct pp_region open;      /* the part that is not hidden inside */
    bool open_is_extent;        /* true: the open part is the whole rectangle from
                                 * scene.low to scene.high */
    double grid;                /* grid for overlays of regions */
    bool in_parts;              /* true: patches may be sets of adjacent convex rings */
    bool sky_only;              /* true: patches of obstructions may be left out */
};

/* Fills `visible`. The outline is builder->open or, if that is empty, the rectangle
 * visible->ring. Without `with_outside`, obstructions and skylines are left out. */
enum pp_status pp_patch_builder_fill(struct pp_visible *visible,
                                     struct pp_patch_builder *builder,
                                     bool with_outside, struct pp_error *err);

void pp_patch_builder_clear(struct pp_patch_builder *builder);

#endif
