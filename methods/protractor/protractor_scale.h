/* protractor_scale.h - the scales of a BRS daylight protractor, for any glass, slope
 * and sky without azimuth.
 *
 * A protractor represents an infinitely long strip of sky above horizontal edges
 * parallel to the glass [BRE309]. In the section perpendicular to the glass a sight
 * line has the altitude gamma, from 0 on the horizon in front of the glass, through 90
 * degrees at the zenith, to 180 degrees behind it; theta is the angle of a direction
 * out of that section, within the tilted plane that holds the sight line and the line
 * through the point parallel to the edges:
 *
 *     u = cos theta (cos gamma, sin gamma) + sin theta along
 *     dSC = L(u) tau(cos i) sin gamma cos^2 theta dtheta dgamma,
 *     sin altitude = cos theta sin gamma,  cos i = cos theta sin(gamma + slope)
 *
 * primary scale     F(gamma), integral over all theta, and over gamma from 0
 * auxiliary scale   CF(gamma, theta), share of the strip at gamma that lies between
 *                   the section and theta, to one side: 1/2 if the window is infinite
 *
 * Without glass (protractors 9 and 10), with p and q of graded_sky.h:
 *
 *     F = p (1 - cos gamma) + q (gamma - sin gamma cos gamma)
 *
 * The horizontal receiver lies at the protractor's centre. All values are fractions of
 * Eh.
 *
 * For a vertical receiver the weight sin gamma cos theta of a direction is replaced by
 * cos gamma cos theta for a receiver that faces straight ahead, or by sin theta for a
 * receiver that faces perpendicular to the section. The scales of the second receiver
 * include one side only, since both sides cancel. For a receiver at the azimuth psi,
 * the reading is cos psi times that of the first receiver plus sin psi times that of
 * the second. For a receiver that faces straight ahead, without glass, F is the
 * illuminance of a vertical plane from the sky below an infinitely long skyline of the
 * angle gamma, VSC(0) - VSC(gamma).
 */
#ifndef PP_METHODS_PROTRACTOR_PROTRACTOR_SCALE_H
#define PP_METHODS_PROTRACTOR_PROTRACTOR_SCALE_H

#include "model/base/error.h"
#include "model/geometry/angle.h"
#include "model/light/glass_curve.h"
#include "model/light/sky.h"

/* Receiver of the light. */
enum pp_protractor_receiver {
    PP_PROTRACTOR_UP,    /* a horizontal plane that faces up */
    PP_PROTRACTOR_AHEAD, /* a vertical plane that faces the glass */
    PP_PROTRACTOR_ASIDE, /* a vertical plane perpendicular to the glass; one side
                          * only, doubled */
};

struct pp_protractor {
    struct pp_sky sky;     /* without azimuth dependence */
    struct pp_glass glass; /* not diffusing; pp_glass_none(): an unglazed aperture */
    double slope_rad;      /* slope of the glass: 0 horizontal, to pi/2 vertical */
    enum pp_protractor_receiver receiver;
};

/* Scale of one of the ten published protractors. 1 to 8 have clear single glass
 * (vertical, horizontal, 30 and 60 degrees), 9 and 10 none. Odd numbers are for the
 * uniform sky, even ones for the overcast sky. Fails on any other number. */
enum pp_status pp_protractor_scale_published(struct pp_protractor *protractor,
                                             int number, struct pp_error *err);

/* Number under which such a protractor was published; 0 if it was not (glass other than
 * clear single glass, another slope or sky, a vertical receiver). */
int pp_protractor_scale_number(const struct pp_protractor *protractor);

/* End of the primary scale, up to which light reaches the glass from below: pi - slope
 * with glass, pi without. */
double pp_protractor_scale_range(const struct pp_protractor *protractor);

/* dSC / (dtheta dgamma), as defined at the head of this file. */
double pp_protractor_scale_density(const struct pp_protractor *protractor,
                                   double gamma_rad, double theta_rad);

/* Densities on one sight line at many angles theta. losses: the tabulated transmittance
 * of the glass (NULL: evaluated directly). */
void pp_protractor_scale_densities(double *densities,
                                   const struct pp_protractor *protractor,
                                   const struct pp_glass_curve *losses,
                                   double gamma_rad, const struct pp_angle *thetas,
                                   int count);

/* Primary scale: sky component of an infinitely long strip from the horizon to
 * gamma_rad, 0 to pi (angles beyond the range add nothing). Relative error 1e-9. */
double pp_protractor_scale_primary(const struct pp_protractor *protractor,
                                   double gamma_rad);

/* dF/dgamma, for finding the angle of a reading. */
double pp_protractor_scale_primary_slope(const struct pp_protractor *protractor,
                                         double gamma_rad);

/* The angle at which the primary scale reads `share`, by Newton's method from the
 * bracket [low_rad, high_rad], which must contain it; to 1e-10. */
double pp_protractor_scale_angle(const struct pp_protractor *protractor, double share,
                                 double low_rad, double high_rad);

/* Auxiliary scale at theta_rad (-pi/2 to pi/2; an odd function), for the average
 * altitude gamma_rad. Relative error 1e-9. */
double pp_protractor_scale_auxiliary(const struct pp_protractor *protractor,
                                     double gamma_rad, double theta_rad);

/* Angle from the section of a jamb whose azimuth on the plan is -pi/2 to pi/2 from the
 * normal, for an average altitude gamma below pi/2: tan theta = tan azimuth cos
 * gamma. */
double pp_protractor_scale_theta(double cos_gamma, struct pp_angle azimuth);

#endif
