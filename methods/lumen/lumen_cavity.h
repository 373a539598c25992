/* lumen_cavity.h - flux transfer in the room of the lumen method for light from above,
 * from which the table of coefficients for such light is made. */
#ifndef PP_METHODS_LUMEN_LUMEN_CAVITY_H
#define PP_METHODS_LUMEN_LUMEN_CAVITY_H

/* Fraction of a Lambertian ceiling's flux that falls on the working plane, directly and
 * by interreflection. The room has a square plan, the room cavity ratio RCR = 5 h (L +
 * W) / (L W), 0 or more, and three zones of uniform exitance: ceiling, walls and plane.
 * The flux leaves openings spread over the ceiling. `ceiling` is the reflectance of the
 * ceiling including its openings; `plane` is the reflectance of the cavity below the
 * working plane. */
double pp_lumen_cavity(double rcr, double ceiling, double walls, double plane);

#endif
