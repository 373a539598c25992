/* well.h - wells of rooflights: the fraction of the light entering at the top that
 * leaves at the foot.
 *
 * A rooflight with a reveal has a well, a straight shaft from the glass down to the
 * ceiling, of the ceiling's reflectance. The hand formulae of the room treat the foot
 * of the well as the opening; the sides of the well are not part of the room. The shape
 * of a well is described by the well index [IES84], which is 1 for a cube:
 *
 *     w = d (a + b) / (2 a b),   d depth, a and b the sides of the plan
 *
 * The efficiencies are calculated from the geometry of the well, not read from a curve.
 * Direct skylight passes a section of the shaft in proportion to the overlap of glass
 * and section along the light. Light on the sides is exchanged between 12 bands, each
 * uniformly lit and diffuse, by closed-form factors (lumen/rectangle_factor.h). The sky
 * above horizontal glass is that of the room file, with the overcast sky in place of
 * skies of ISO 15469; light through sloping glass or diffusing panes is assumed
 * uniform. A well that is not rectangular is replaced by a square one of the same
 * index.
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

/* Fractions, 0 to 1, of the light that enters through the glass, with their symbols in
 * reports. */
struct pp_well_efficiency {
    double whole;  /* N: light that leaves the foot */
    double direct; /* N_d: light that leaves the foot without touching the sides */
};

/* True for a glazed opening that is not vertical and has a reveal. */
bool pp_well_is(const struct pp_opening *opening);

/* b: gradation of the sky above (graded_sky.h), 0 for uniform light. glass without
 * panes: unglazed. */
struct pp_well_efficiency pp_well_efficiency(const struct pp_well_shape *shape,
                                             double b, const struct pp_glass *glass);

double pp_well_index(const struct pp_well_shape *shape);

/* Reflectance of the glass from below, for diffuse light. */
double pp_well_glass_back(const struct pp_glass *glass);

enum { PP_WELL_BANDS = 12 }; /* horizontal bands of the sides, from the top down */

/* Flux on the parts of a shaft, divided by Eh and by the area of its section. */
struct pp_well_flux {
    double bands[PP_WELL_BANDS];
    double top, foot; /* seen from within */
};

/* Adds the light of the sky that comes straight through glass which covers `share` of
 * the top, spread evenly. b: as for pp_well_efficiency. */
void pp_well_add_sky(struct pp_well_flux *flux, const struct pp_well_shape *shape,
                     double b, const struct pp_glass *glass, double share);

/* Adds all reflections to the light that comes straight from the sky. top, foot:
 * reflectances seen from within. */
void pp_well_exchange(struct pp_well_flux *flux, const struct pp_well_shape *shape,
                      double top, double foot);

/* The efficiencies of an opening's well; both are 1 if there is no well. */
struct pp_well_efficiency pp_well_of(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening);

/* Records w, the reflectance rho_w of the sides, N and N_d of an opening with a
 * well. */
void pp_well_put(struct pp_worksheet *sheet, const struct pp_world *world,
                 const struct pp_outside_light *light,
                 const struct pp_opening *opening);

/* f: fraction of diffuse light from the middle of the foot that falls directly on the
 * working plane, 0 to 1. */
double pp_well_foot_to_plane(const struct pp_world *world,
                             const struct pp_opening *opening);

/* Records f and the area S of the working plane. */
void pp_well_put_foot(struct pp_worksheet *sheet, const struct pp_world *world,
                      const struct pp_opening *opening);

/* Rows of a formula's list of quantities. */
#define PP_WELL_QUANTITIES                                                             \
    {"w", PP_UNIT_NUMBER, "well index"},                                               \
        {"rho_w", PP_UNIT_NUMBER, "reflectance of the sides of the well"},             \
        {"N", PP_UNIT_NUMBER, "fraction of the entering light that leaves the well"},  \
    {                                                                                  \
        "N_d", PP_UNIT_NUMBER,                                                         \
            "fraction that leaves the well without reflection from its sides"          \
    }

#endif
