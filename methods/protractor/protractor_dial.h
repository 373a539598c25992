/* protractor_dial.h - a protractor with tabulated scales, calculated once for many
 * readings [BRE309].
 *
 * The primary scale gives the sky component of an infinitely long window from the
 * horizon up to any section altitude. The auxiliary scale has semicircles for average
 * altitudes 10 degrees apart; between them readings are interpolated along the jamb's
 * sight line. The angle of that line is
 *
 *   for vertical openings, on the plan, the jamb's azimuth phi from the normal:
 *       tan phi = x / distance on the plan
 *   for all others, on the plan turned down into the plane of the average sight line:
 *       tan theta = x / slant distance along that line
 *
 * since the jambs of an opening overhead cannot be sighted on the plan. For a vertical
 * opening tan theta = tan phi cos gamma, gamma the average altitude.
 */
#ifndef PP_METHODS_PROTRACTOR_PROTRACTOR_DIAL_H
#define PP_METHODS_PROTRACTOR_PROTRACTOR_DIAL_H

#include "methods/protractor/protractor_scale.h"

enum {
    PP_DIAL_STEPS = 180,      /* steps of the primary scale, and of 90 degrees of a
                          * semicircle */
    PP_DIAL_SEMICIRCLES = 19, /* average altitudes of 0, 10 ... 180 degrees */
};

/* The auxiliary scale at one average altitude: CF and dCF/dtheta at equal steps of
 * theta from 0 to pi/2. */
struct pp_protractor_semicircle {
    double average_rad, cos_average;
    double factor[PP_DIAL_STEPS + 1], rate[PP_DIAL_STEPS + 1];
};

struct pp_protractor_dial {
    struct pp_protractor protractor;
    double range_rad; /* end of the primary scale */

    /* F and dF/dgamma at equal steps of gamma from 0 to the range. */
    double primary[PP_DIAL_STEPS + 1], slope[PP_DIAL_STEPS + 1];

    struct pp_protractor_semicircle semicircles[PP_DIAL_SEMICIRCLES];
};

/* Tabulates the scales. Errors are up to 5e-7 of the open sky in readings of the primary
 * scale, and up to 1e-7 in factors. */
void pp_protractor_dial_init(struct pp_protractor_dial *dial,
                             const struct pp_protractor *protractor);

/* Primary scale at gamma_rad, 0 to pi. */
double pp_protractor_dial_share(const struct pp_protractor_dial *dial,
                                double gamma_rad);

/* dF/dgamma at gamma_rad, to 1e-3. */
double pp_protractor_dial_slope(const struct pp_protractor_dial *dial,
                                double gamma_rad);

/* The angle at which the primary scale reads `share`, 0 to the reading at its end, by
 * Newton's method from start_rad. */
double pp_protractor_dial_angle(const struct pp_protractor_dial *dial, double share,
                                double start_rad);

/* Auxiliary scale for an average altitude of 0 to pi and a jamb at jamb_rad, -pi/2 to
 * pi/2; an odd function of jamb_rad. jamb_rad is the jamb's azimuth or, if
 * `turned_down`, theta. */
double pp_protractor_dial_factor(const struct pp_protractor_dial *dial,
                                 double average_rad, double jamb_rad, bool turned_down);

/* The auxiliary scale at any average altitude, 0 to pi, for charts. */
void pp_protractor_dial_semicircle_init(struct pp_protractor_semicircle *semicircle,
                                        const struct pp_protractor *protractor,
                                        double average_rad);

/* The jamb's angle at which the semicircle reads `factor`, 0 to 1/2; to 1e-9. */
double pp_protractor_dial_jamb_angle(const struct pp_protractor_semicircle *semicircle,
                                     double factor, bool turned_down);

#endif
