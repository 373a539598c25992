/* interior.h - areas and mean reflectances of the inside of a room, as the formulae of
 * the internally reflected component take them.
 *
 * Inside surfaces are the faces of the envelope less their openings, the openings (with
 * a reflectance of 0.1), the sides of reveals, and loose surfaces in the room, both
 * sides of each. Lower and upper parts are what lies below and above a height; polygons
 * across it are cut. A level face at just that height is upper where it looks down.
 */
#ifndef PP_METHODS_REFLECTED_INTERIOR_H
#define PP_METHODS_REFLECTED_INTERIOR_H

#include "model/results/steps.h"
#include "model/room/world.h"

/* Of an opening seen from inside, in mean reflectances [BRE310]. */
#define PP_OPENING_REFLECTANCE 0.1

struct pp_interior {
    double area_m2;
    double reflectance; /* area-weighted mean; 0 where there is no area */
};

/* All inside surfaces, openings included: A and R. */
struct pp_interior pp_interior_all(const struct pp_world *world);

/* Sets these down, as A and R. steps may be NULL. */
void pp_interior_steps(struct pp_steps *steps, const struct pp_interior *all);

/* The faces of a role (floor, walls or ceiling) without their openings. */
struct pp_interior pp_interior_role(const struct pp_world *world, enum pp_role role);

struct pp_interior_parts {
    struct pp_interior lower, upper;
};

/* Parts below and above `z`, without openings: rho_l, A_l, rho_u, A_u of the split-flux
 * formula. */
struct pp_interior_parts pp_interior_split(const struct pp_world *world, double z);

/* Parts below and above `z` without the face `left_out`, its openings and their
 * reveals, other openings included: R_fw and R_cw of the BRE formula. */
struct pp_interior_parts pp_interior_split_without(const struct pp_world *world,
                                                   double z, int left_out);

/* Area of a polygon below the level plane at `z` (m2). For any simple plane polygon; a
 * level one counts whole if it is under the plane. */
double pp_interior_area_below(const struct pp_polygon *polygon, double z);

#endif
