/* pepper_pot_dots.h - Pleijel's pepper-pot diagram: dots on the true perspective of a
 * window, each worth the same share of the sky component [PLE54].
 *
 * The drawing is the window's own vertical plane at unit distance from the point: (a,
 * b) is seen in the direction a to the right, b up, 1 ahead. A dot represents a piece
 * of the sky that gives `worth` to the receiver (normal n):
 *
 *     dSC = L(gamma) tau(cos gamma cos phi) (n.u) cos gamma dgamma dphi       [PLE54]
 *
 * The sky is mapped on to the unit square: t is the share of the light from below an
 * altitude, s the share of that altitude's light from the left of an azimuth, so that
 * equal areas are equal shares. The dots are a Fibonacci lattice of the square: even,
 * without clumps, and with no row along any edge of a window [SP06]. Each dot has
 * exactly the same worth; the error of a count comes from the dots next to the outline.
 */
#ifndef PP_METHODS_PEPPER_POT_PEPPER_POT_DOTS_H
#define PP_METHODS_PEPPER_POT_PEPPER_POT_DOTS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/glass_curve.h"
#include "model/geometry/region.h"
#include "model/light/sky.h"

#define PP_PEPPER_POT_WORTH 0.001       /* worth of a dot of the ordinary chart */
#define PP_PEPPER_POT_FINE_WORTH 0.0001 /* worth of a dot of the fine chart */

enum {
    PP_PEPPER_POT_PANELS = 64,
    PP_PEPPER_POT_AZIMUTHS = 20, /* steps of azimuth */
    PP_PEPPER_POT_NODES = 4,     /* nodes of Gauss's rule in each step */
};

struct pp_pepper_pot {
    struct pp_sky sky;     /* overcast or uniform */
    bool glazed;           /* true: with the losses of clear single vertical glass */
    struct pp_glass glass; /* clear single, or none */
    bool
        upright; /* true: the receiver is a vertical plane; false: horizontal, face up */
    double facing_rad; /* azimuth of a vertical receiver's normal from straight
                        * ahead, positive to the right */
    double worth;      /* worth of a dot */
    double whole;      /* worth of all dots together: the light of an infinite window */
    struct pp_glass_curve losses;           /* losses of the glass */
    double below[PP_PEPPER_POT_PANELS + 1]; /* light from the sky below equally spaced
                                             * altitudes */
    double low_rad, high_rad; /* azimuths from which light reaches the receiver */
    /* Cosine and weight at the quadrature nodes between the azimuths. */
    double ahead[PP_PEPPER_POT_AZIMUTHS][PP_PEPPER_POT_NODES];
    double weight[PP_PEPPER_POT_AZIMUTHS][PP_PEPPER_POT_NODES];
    int count;
    double (*dots)[2]; /* coordinates (a, b) of the dots, b > 0 */
};

/* Makes the dots. A sky other than overcast or uniform, and a worth outside 1e-5 ...
 * 0.1, are refused; facing_rad is used for a vertical receiver only. */
enum pp_status pp_pepper_pot_dots_create(struct pp_pepper_pot **pot,
                                         const struct pp_sky *sky, bool glazed,
                                         bool upright, double facing_rad, double worth,
                                         struct pp_error *err);
void pp_pepper_pot_dots_destroy(struct pp_pepper_pot *pot); /* NULL is allowed */

/* The number of dots in a region of the drawing. */
int pp_pepper_pot_dots_count(const struct pp_pepper_pot *pot,
                             const struct pp_region *region);

/* The point of the unit square for (a, b); false for a direction without light. */
bool pp_pepper_pot_dots_to_square(const struct pp_pepper_pot *pot, double a, double b,
                                  double *s, double *t);

#endif
