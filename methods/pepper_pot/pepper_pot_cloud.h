/* pepper_pot_cloud.h - dots on the true perspective of an opening of any slope, each
 * worth the same share of the light of any sky to any receiver, after [PLE54].
 *
 * The drawing is the opening's own plane at unit distance from the point: (a, b) is
 * seen in the direction a along, b up the slope, 1 out. A dot represents a piece of the
 * sky that gives `worth` to the receiver (normal n). For directions u above the
 * horizon,
 *
 *     dSC = L(u) tau(out.u) (n.u) domega
 *
 * L may depend on the azimuth. The half-space in front of the receiver is divided into
 * rings about its normal, each ring into cells, beginning on the side away from the
 * glass. t is the share of the light up to a ring, s the share of the ring's light up
 * to a cell. The dots are a Fibonacci lattice of the square of s and t [SP06]; for
 * horizontal glass and a uniform sky the dots form a sunflower pattern. Within a cell
 * the light is assumed uniform, with the value at its middle.
 */
#ifndef PP_METHODS_PEPPER_POT_PEPPER_POT_CLOUD_H
#define PP_METHODS_PEPPER_POT_PEPPER_POT_CLOUD_H

#include "methods/view/window_drawing.h"
#include "model/base/error.h"
#include "model/geometry/region.h"
#include "model/light/glass.h"
#include "model/light/sky.h"

struct pp_pepper_pot_cloud {
    double whole; /* light of an infinite opening, over Eh */
    int count;
    double (*dots)[2]; /* coordinates a and b of the dots */
};

/* worth must be above 1e-5. The caller clears the cloud; empty on failure. */
enum pp_status pp_pepper_pot_cloud_init(struct pp_pepper_pot_cloud *cloud,
                                        const struct pp_sky *sky,
                                        const struct pp_glass *glass,
                                        const struct pp_window_axes *axes,
                                        struct pp_vec3 normal, double worth,
                                        struct pp_error *err);
void pp_pepper_pot_cloud_clear(struct pp_pepper_pot_cloud *cloud);

/* The number of dots in a region of the drawing. */
int pp_pepper_pot_cloud_count(const struct pp_pepper_pot_cloud *cloud,
                              const struct pp_region *region);

#endif
