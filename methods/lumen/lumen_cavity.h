/* lumen_cavity.h - transfer of flux in the room of the lumen method's light from above:
 * what the coefficients of that table are made from.
 */
#ifndef PP_METHODS_LUMEN_LUMEN_CAVITY_H
#define PP_METHODS_LUMEN_LUMEN_CAVITY_H

/* Share of a Lambertian ceiling's light that falls on the working plane: three zones
 * (ceiling, walls, plane), each evenly bright, of a room with a square plan and that
 * room cavity ratio, RCR = 5 h (L + W) / (L W), 0 or more. The light leaves openings
 * spread over the ceiling, whose reflectance `ceiling` (their share of it included)
 * throws back what comes up again. `plane` is the reflectance of the cavity below the
 * plane. */
double pp_lumen_cavity(double rcr, double ceiling, double walls, double plane);

/* Share of diffuse light on top of a well, width x length and `depth` deep, with sides
 * of that reflectance, that leaves it below: two zones; 1 where it has no depth. */
double pp_lumen_cavity_well_efficiency(double width, double length, double depth,
                                       double sides);

#endif
