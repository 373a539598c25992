/* window_drawing.h - an opening and the obstructions seen through it, drawn in true
 * perspective, for the pepper-pot and Waldram diagrams.
 *
 * The drawing lies on the plane parallel to the opening at unit distance from the
 * point: (a, b) is a to the right and b up along the opening's own axes, both divided
 * by the distance of the opening's plane. Straight edges are straight in the drawing.
 */
#ifndef PP_METHODS_VIEW_WINDOW_DRAWING_H
#define PP_METHODS_VIEW_WINDOW_DRAWING_H

#include <stdbool.h>

#include "methods/part_steps.h"
#include "methods/view/visible.h"
#include "model/geometry/region.h"
#include "model/light/outside_light.h"
#include "model/room/world.h"

/* The axes of the plane: a point (a, b) of the drawing lies in the direction a along +
 * b up + out. */
struct pp_window_axes {
    struct pp_vec3 along, up; /* unit, in the plane; along is horizontal */
    struct pp_vec3 out;       /* unit, perpendicular to the plane, away from the
                               * point */
};

struct pp_drawn_part {
    struct pp_region region;
    bool hidden;   /* true: an obstruction; false: the sky */
    double factor; /* luminance factor of the obstruction; 1 for the sky */
};

struct pp_window_drawing {
    struct pp_window_axes axes;
    double distance_m;           /* distance from the point to the plane */
    int count;                   /* 0: the point does not see the opening */
    struct pp_drawn_part *parts; /* parts of the drawing, which do not overlap */
};

/* Fills the drawing, which the caller clears; empty on failure. */
enum pp_status pp_window_drawing_init(struct pp_window_drawing *drawing,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening,
                                      struct pp_vec3 point, struct pp_error *err);

/* Makes the drawing of any view, along the view's own axes. */
enum pp_status pp_window_drawing_of_view(struct pp_window_drawing *drawing,
                                         const struct pp_visible *visible,
                                         const struct pp_sky *sky,
                                         struct pp_error *err);
void pp_window_drawing_clear(struct pp_window_drawing *drawing);

/* Formulae of the sky component and the externally reflected component of a part: the
 * count times the worth of one square or dot ("w" on the sheet). */
extern const struct pp_formula pp_window_drawing_sc, pp_window_drawing_erc;
extern const struct pp_formula *const pp_window_drawing_formulae[]; /* both, and NULL */

/* Records that the next part has `count` squares or dots (`things`), evaluates its
 * component and returns it. */
double pp_window_drawing_work(struct pp_part_steps *terms,
                              const struct pp_drawn_part *part, double count,
                              const char *things);

#endif
