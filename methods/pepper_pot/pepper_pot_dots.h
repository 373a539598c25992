/* pepper_pot_dots.h - Pleijel's pepper-pot diagram: dots on the true perspective of a
 * window, each worth the same share of the sky component.
 *
 * The drawing is the window's own upright plane at unit distance from the point: (a, b)
 * is seen in the direction a to the right, b up, 1 ahead. What a dot stands for is a
 * piece of the sky that gives the receiver (normal n) `worth`:
 *
 *     dSC = L(gamma) tau(cos gamma cos phi) (n.u) cos gamma dgamma dphi       [PLE54]
 *
 * The sky seen is mapped on to a square, t by altitude (the share that comes from below
 * it) and s by azimuth (the share of that altitude's light that comes from its left),
 * so that equal areas are equal shares; the dots are a Fibonacci lattice of that
 * square: even, without clumps, and with no row along any edge of a window [SP06]. A
 * dot stands for exactly its worth; a window's count is off by the dots that its
 * outline cuts off or takes in.
 */
#ifndef PP_METHODS_PEPPER_POT_PEPPER_POT_DOTS_H
#define PP_METHODS_PEPPER_POT_PEPPER_POT_DOTS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/glass.h"
#include "model/geometry/region.h"
#include "model/light/sky.h"

#define PP_PEPPER_POT_WORTH 0.001       /* of a dot of the ordinary chart */
#define PP_PEPPER_POT_FINE_WORTH 0.0001 /* of the fine one */

enum { PP_PEPPER_POT_PANELS = 64, PP_PEPPER_POT_LOSSES = 513 };

struct pp_pepper_pot {
    struct pp_sky sky;     /* overcast or uniform */
    bool glazed;           /* with the losses of clear single vertical glass */
    struct pp_glass glass; /* clear single, or none */
    bool upright;      /* is the receiver a vertical plane? else horizontal, face up */
    double facing_rad; /* azimuth of an upright receiver's normal from straight ahead,
                        * positive to the right */
    double worth;      /* of a dot */
    double whole;      /* all dots' worth together: what a boundless window gives */
    double losses[PP_PEPPER_POT_LOSSES]; /* of the glass, at even cosines from 0 to 1 */
    double below[PP_PEPPER_POT_PANELS + 1]; /* what comes from below even altitudes */
    int count;
    double (*dots)[2]; /* (a, b), b > 0 */
};

/* Makes the dots. sky other than overcast or uniform, and a worth outside 1e-5 ... 0.1,
 * are refused; facing_rad is not looked at unless upright. */
enum pp_status pp_pepper_pot_dots_create(struct pp_pepper_pot **pot,
                                         const struct pp_sky *sky, bool glazed,
                                         bool upright, double facing_rad, double worth,
                                         struct pp_error *err);
void pp_pepper_pot_dots_destroy(struct pp_pepper_pot *pot); /* NULL is allowed */

/* How many dots lie in a region of the drawing. */
int pp_pepper_pot_dots_count(const struct pp_pepper_pot *pot,
                             const struct pp_region *region);

/* Where (a, b) lies on the square of equal areas; false where it gives nothing. */
bool pp_pepper_pot_dots_to_square(const struct pp_pepper_pot *pot, double a, double b,
                                  double *s, double *t);

#endif
