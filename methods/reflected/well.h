/* well.h - wells of rooflights: the share of the light entering at the top that leaves
 * at the foot.
 *
 * A rooflight with a reveal has a well, a straight shaft from the glass down to the
 * ceiling, of the ceiling's reflectance. The hand formulae of the room take its foot
 * for the opening, and the well's sides for no part of the room. Its shape is told by
 * the well index [IES84], which is 1 for a cube:
 *
 *     w = d (a + b) / (2 a b),   d depth, a and b the sides of the plan
 *
 * The efficiencies are worked out for the well as it is, no curve is read: the light of
 * the sky through the glass passes sections of the shaft by the share by which they
 * overlap along the light, and what falls on the sides is exchanged between 12 bands of
 * them, each evenly lit and diffuse, by closed form (lumen/rectangle_factor.h). Above
 * level glass stands the sky, overcast in place of those of ISO 15469; light on sloping
 * glass is taken to be even, as that through a diffusing pane is. A well that is no
 * rectangle is taken for the square one of its index.
 */
#ifndef PP_METHODS_REFLECTED_WELL_H
#define PP_METHODS_REFLECTED_WELL_H

#include "model/light/glass.h"
#include "model/light/outside_light.h"
#include "model/results/worksheet.h"
#include "model/room/world.h"

struct pp_well_shape {
    double width_m, length_m, depth_m; /* greater than 0 */
    double sides;                      /* reflectance, 0 to 1 */
};

/* Shares of the light through the glass, 0 to 1; N in print. */
struct pp_well_efficiency {
    double whole;  /* N: leaves the foot */
    double direct; /* N_d: has not met the sides */
};

/* A glazed opening that is not vertical and has a reveal. */
bool pp_well_is(const struct pp_opening *opening);

/* b: gradation of the sky above (graded_sky.h), 0 for even light. glass of no panes: none. */
struct pp_well_efficiency pp_well_efficiency(const struct pp_well_shape *shape,
                                             double b, const struct pp_glass *glass);

double pp_well_index(const struct pp_well_shape *shape);

/* The same of an opening; 1 and 1, and an index of 0, of one without a well. */
struct pp_well_efficiency pp_well_of(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening);

/* Puts down w, the reflectance rho_w of the sides, N and N_d of an opening with a well. */
void pp_well_put(struct pp_worksheet *sheet, const struct pp_world *world,
                 const struct pp_outside_light *light,
                 const struct pp_opening *opening);

/* f: share of diffuse light from the middle of the foot that falls on the working plane
 * directly, 0 to 1. */
double pp_well_foot_to_plane(const struct pp_world *world,
                             const struct pp_opening *opening);

/* Puts down f and the area S of the working plane. */
void pp_well_put_foot(struct pp_worksheet *sheet, const struct pp_world *world,
                      const struct pp_opening *opening);

/* Rows of a formula's list of quantities. */
#define PP_WELL_QUANTITIES                                                             \
    {"w", PP_UNIT_NUMBER, "index of the well"},                                        \
        {"rho_w", PP_UNIT_NUMBER, "reflectance of the sides of the well"},             \
        {"N", PP_UNIT_NUMBER, "fraction of the light that leaves the well"},           \
    {                                                                                  \
        "N_d", PP_UNIT_NUMBER, "fraction that leaves without reflection in the well"   \
    }

#endif
