/* room_zones.h - the room over the working plane as three zones, each uniformly lit:
 * the plane, the ceiling and the walls between them.
 *
 * F is the form factor between plane and ceiling, m that from the walls to each of
 * them, rho_p, rho_c, rho_v the reflectances. The share u_w of light on the walls
 * reaches the plane by reflections above it, u_c of light on the ceiling, u_p of light
 * reflected by the plane. With the light phi_v on walls and phi_c on the ceiling,
 *
 *     phi_v = source + rho_v (1 - 2 m) phi_v + rho_c (1 - F) phi_c
 *     phi_c = source + rho_v m phi_v
 *     u     = rho_v m phi_v + rho_c F phi_c
 *
 * solved for a source of 1 on either. A ceiling that is not horizontal is replaced by
 * the reflectance of its cavity, and so is the space below the plane. The walls are as
 * high as their area over the plane's outline; F is that of the rectangle with the
 * plane's area and outline [HSM16]. Objects in the room are neglected.
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
