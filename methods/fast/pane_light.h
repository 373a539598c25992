/* pane_light.h - the light from a patch through a pane, by tables that serve many
 * points. The light is a sum over the patch's edges (arc_sum.h), not a quadrature over
 * its area. */
#ifndef PP_METHODS_FAST_PANE_LIGHT_H
#define PP_METHODS_FAST_PANE_LIGHT_H

#include "methods/fast/axial_table.h"
#include "methods/fast/sky_table.h"
#include "methods/view/visible.h"
#include "model/base/error.h"

/* Tables of an opening (pane_tables.h makes them); not owned. */
struct pp_pane_light {
    const struct pp_axial_table *glass; /* table of clear glass; NULL: other glass */
    /* Table about the zenith for a sky of ISO 15469 that does not depend on the sun;
     * NULL: another sky. */
    const struct pp_axial_table *gradation;
    const struct pp_sky_table *sky; /* NULL: not created, or not needed */
    /* Axes of the table of the sky; NULL: those of each view. */
    const struct pp_projection *sky_axes;
};

/* Part of a view: a patch within half-spaces (room's axes), for a receiver whose normal
 * is one of them. */
struct pp_pane_part {
    const struct pp_visible *visible;
    const struct pp_visible_patch *patch;
    struct pp_vec3 normal;
    const struct pp_vec3 *half_spaces; /* at most PP_HALF_SPACES_MOST */
    int half_space_count;
    bool glazed;
    bool rough; /* true: accurate to 1e-6 of the open sky; false: to 1e-9 */
};

/* True if the tables can give the light of that sky for this part. pp_pane_light_sky
 * then sets *value to the integral of L tau (n.u), divided by Eh. One of the part's
 * half-spaces must be that above the horizon. */
bool pp_pane_light_has_sky(const struct pp_pane_light *light, const struct pp_sky *sky,
                           const struct pp_pane_part *part);
enum pp_status pp_pane_light_sky(double *value, const struct pp_pane_light *light,
                                 const struct pp_sky *sky,
                                 const struct pp_pane_part *part, struct pp_error *err);

/* The integral of tau (n.u), for glass. */
enum pp_status pp_pane_light_transmitted(double *value,
                                         const struct pp_pane_light *light,
                                         const struct pp_pane_part *part,
                                         struct pp_error *err);

#endif
