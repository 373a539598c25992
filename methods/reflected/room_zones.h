/* room_zones.h - the room over the working plane as three zones, each uniformly lit:
 * the plane, the ceiling and the walls between them.
 *
 * F is the form factor between plane and ceiling; m is the form factor from the walls
 * to the plane, and to the ceiling; rho_p, rho_c and rho_v are the reflectances of
 * plane, ceiling and walls. u_w, u_c and u_p are the fractions of the light on the
 * walls, on the ceiling, and leaving the plane that reach the plane after reflections
 * above it. With phi_v the light on the walls, and phi_c the light on the ceiling,
 *
 *     phi_v = source + rho_v (1 - 2 m) phi_v + rho_c (1 - F) phi_c
 *     phi_c = source + rho_v m phi_v
 *     u     = rho_v m phi_v + rho_c F phi_c
 *
 * solved with a source of 1 in one equation and 0 in the other. A sloping ceiling, and
 * the space below the plane, are treated as cavities with an effective reflectance. The
 * height of the walls is their area divided by the perimeter of the plane; F is that of
 * a rectangle with the plane's area and perimeter [HSM16]. Objects in the room are
 * neglected.
 */
#ifndef PP_METHODS_REFLECTED_ROOM_ZONES_H
#define PP_METHODS_REFLECTED_ROOM_ZONES_H

#include "model/results/worksheet.h"
#include "model/room/world.h"

/* Rows of a method's list of formulae. */
extern const struct pp_formula pp_room_zones_below, pp_room_zones_above,
    pp_room_zones_m, pp_room_zones_u_w, pp_room_zones_u_c, pp_room_zones_u_p;
#define PP_ROOM_ZONES_FORMULAE                                                         \
    &pp_room_zones_below, &pp_room_zones_above, &pp_room_zones_m, &pp_room_zones_u_w,  \
        &pp_room_zones_u_c, &pp_room_zones_u_p

/* Records S, the area of the working plane, rho_p, u_w, u_c and u_p; returns the height
 * of the walls above the plane (m). */
double pp_room_zones_put(struct pp_worksheet *sheet, const struct pp_world *world);

#endif
