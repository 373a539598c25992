/* interior.h - areas and mean reflectances of the inside surfaces of a room, for the
 * formulae of the internally reflected component.
 *
 * Inside surfaces are the faces of the envelope without their openings, the openings
 * (with a reflectance of 0.1), the sides of reveals but not those of wells (well.h),
 * and both sides of free-standing surfaces in the room (of the faces of closed objects,
 * the front only). The lower and the upper part of the room lie below and above a
 * height; polygons across that height are cut. A horizontal face at exactly that height
 * belongs to the upper part if it faces down.
 */
#ifndef PP_METHODS_REFLECTED_INTERIOR_H
#define PP_METHODS_REFLECTED_INTERIOR_H

#include "model/results/worksheet.h"
#include "model/room/world.h"

/* Reflectance of an opening from inside, in mean reflectances [BRE310]. */
#define PP_OPENING_REFLECTANCE 0.1

struct pp_interior {
    double area_m2;
    double reflectance; /* area-weighted mean; 0 without area */
};

/* All inside surfaces, openings included: A and R. */
struct pp_interior pp_interior_all(const struct pp_world *world);

/* Records area and mean reflectance of all inside surfaces as A and R. */
void pp_interior_put(struct pp_worksheet *sheet, const struct pp_interior *all);

/* Area and mean reflectance of the faces of a role (floor, walls or ceiling) without
 * their openings. */
struct pp_interior pp_interior_role(const struct pp_world *world, enum pp_role role);

/* Area and mean reflectance of the faces of a role above the horizontal plane at `z`,
 * including openings with a reflectance of 0.1. */
struct pp_interior pp_interior_role_above(const struct pp_world *world,
                                          enum pp_role role, double z);

/* Rows of a formula's list of quantities for A and R. */
#define PP_INTERIOR_QUANTITIES                                                         \
    {"A", PP_UNIT_SQUARE_METRE, "area of all interior surfaces, openings included"},   \
    {                                                                                  \
        "R", PP_UNIT_NUMBER,                                                           \
            "area-weighted mean reflectance of these surfaces (openings: 0.1)"         \
    }

struct pp_interior_parts {
    struct pp_interior lower, upper;
};

/* The parts below and above `z`, without openings: rho_l, A_l, rho_u, A_u of the
 * split-flux formula. */
struct pp_interior_parts pp_interior_split(const struct pp_world *world, double z);

/* True if both parts have an area. */
bool pp_interior_is_split(const struct pp_world *world, double z);

/* The parts below and above `z`, for R_fw and R_cw of the BRE formula. The face
 * `left_out` is excluded, with its openings and their reveals; other openings are
 * included. */
struct pp_interior_parts pp_interior_split_without(const struct pp_world *world,
                                                   double z, int left_out);

/* Area of the room's section by the horizontal plane at `z` (m2). Since the envelope is
 * closed, this equals the projected area of all surfaces below the plane. */
double pp_interior_section_m2(const struct pp_world *world, double z);

/* Area of a polygon below the horizontal plane at `z` (m2), for any simple plane
 * polygon. The whole area of a horizontal polygon counts if it is below the plane. */
double pp_interior_area_below(const struct pp_polygon *polygon, double z);

#endif
