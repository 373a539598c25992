/* pepper_pot_dots.c - integrates the light by altitude and azimuth, and inverts both
 * integrals at the points of a Fibonacci lattice. */
#include "methods/pepper_pot/pepper_pot_dots.h"

#include <math.h>
#include <stdlib.h>

#include "methods/interpolate.h"
#include "model/geometry/gauss.h"

enum { PANELS = PP_PEPPER_POT_PANELS, AZIMUTHS = PP_PEPPER_POT_AZIMUTHS };

/* The range of azimuths from which light reaches the receiver; it is the same at all
 * altitudes. */
static void azimuths(const struct pp_pepper_pot *pot, double *low, double *high)
{
    *low = -PP_PI / 2.0;
    *high = PP_PI / 2.0;
    if (pot->upright) {
        *low = fmax(*low, pot->facing_rad - PP_PI / 2.0);
        *high = fmin(*high, pot->facing_rad + PP_PI / 2.0);
    }
}

/* Altitude-dependent factor of dSC / (dgamma dphi) in the header. The other factors are
 * the azimuth-dependent one and the losses of the glass. */
static double by_altitude(const struct pp_pepper_pot *pot, double gamma)
{
    double s = sin(gamma), c = cos(gamma);
    return pp_sky_luminance(&pot->sky, pp_vec(c, 0.0, s)) * (pot->upright ? c : s) * c;
}

/* Tabulates the cosine of the azimuth and the azimuth-dependent factor, at the nodes of
 * a Gauss rule in each of several equal steps of azimuth. */
static void place_azimuths(struct pp_pepper_pot *pot)
{
    double nodes[PP_PEPPER_POT_NODES], weights[PP_PEPPER_POT_NODES];
    pp_gauss_legendre(nodes, weights, PP_PEPPER_POT_NODES);
    azimuths(pot, &pot->low_rad, &pot->high_rad);
    double half = (pot->high_rad - pot->low_rad) / AZIMUTHS / 2.0;
    for (int i = 0; i < AZIMUTHS; i++)
        for (int k = 0; k < PP_PEPPER_POT_NODES; k++) {
            double phi = pot->low_rad + (2 * i + 1 + nodes[k]) * half;
            double facing = pot->upright ? cos(phi - pot->facing_rad) : 1.0;
            pot->ahead[i][k] = cos(phi);
            pot->weight[i][k] = weights[k] * half * facing;
        }
}

/* Fills in one altitude: left[i] is the light at that altitude from azimuths to the
 * left of step i, without the factor by_altitude. */
static void fill_ring(double left[AZIMUTHS + 1], const struct pp_pepper_pot *pot,
                      double gamma)
{
    double cos_gamma = cos(gamma), steps[AZIMUTHS];
    int asked = pot->upright ? AZIMUTHS : AZIMUTHS / 2;
    for (int i = 0; i < asked; i++) {
        double sum = 0.0;
        for (int k = 0; k < PP_PEPPER_POT_NODES; k++)
            sum += pot->weight[i][k]
                   * (pot->glazed ? pp_glass_curve_transmittance(
                          &pot->losses, cos_gamma * pot->ahead[i][k])
                                  : 1.0);
        steps[i] = sum;
    }
    for (int i = asked; i < AZIMUTHS; i++) /* for a horizontal receiver, both sides are
                                            * equal */
        steps[i] = steps[AZIMUTHS - 1 - i];
    left[0] = 0.0;
    for (int i = 0; i < AZIMUTHS; i++)
        left[i + 1] = left[i] + steps[i];
}

static double from_altitude(const void *pot, double gamma)
{
    double left[AZIMUTHS + 1];
    fill_ring(left, pot, gamma);
    return by_altitude(pot, gamma) * left[AZIMUTHS];
}

static void place_dots(struct pp_pepper_pot *pot, int most)
{
    static const double golden = 0.61803398874989484820; /* (sqrt 5 - 1)/2 */
    for (int i = 0; i < most; i++) {
        double share = (i + 0.5) * pot->worth, whole;
        double s = modf((i + 0.5) * golden, &whole);
        double gamma =
            pp_interpolate_inverse(pot->below, PANELS + 1, 0.0, PP_PI / 2.0, share);
        double left[AZIMUTHS + 1];
        fill_ring(left, pot, gamma);
        double phi = pp_interpolate_inverse(left, AZIMUTHS + 1, pot->low_rad,
                                            pot->high_rad, s * left[AZIMUTHS]);
        pot->dots[i][0] = tan(phi);
        pot->dots[i][1] = tan(gamma) / cos(phi);
    }
    pot->count = most;
}

enum pp_status pp_pepper_pot_dots_create(struct pp_pepper_pot **pot,
                                         const struct pp_sky *sky, bool glazed,
                                         bool upright, double facing_rad, double worth,
                                         struct pp_error *err)
{
    *pot = NULL;
    if (!pp_sky_is_graded(sky))
        return pp_fail(
            err, PP_BAD_INPUT,
            "no pepper-pot diagram for %s; expected the overcast or the uniform sky",
            pp_sky_name(sky));
    if (!(worth >= 1e-5 && worth <= 0.1))
        return pp_fail(err, PP_BAD_INPUT,
                       "the value of a dot is %g %%; expected 0.001 %% to 10 %%",
                       100.0 * worth);

    struct pp_pepper_pot *made = malloc(sizeof *made);
    if (!made)
        return pp_fail_memory(err);
    *made = (struct pp_pepper_pot){.sky = *sky,
                                   .glazed = glazed,
                                   .glass = glazed ? pp_glass_clear_single()
                                                   : pp_glass_none(),
                                   .upright = upright,
                                   .facing_rad = upright ? facing_rad : 0.0,
                                   .worth = worth};
    if (glazed)
        pp_glass_curve_init(&made->losses, &made->glass);
    place_azimuths(made);
    int most = 0;
    if (made->high_rad > made->low_rad) {
        pp_interpolate_tabulate_integral(made->below, PANELS + 1, 0.0, PP_PI / 2.0,
                                         from_altitude, made);
        made->whole = made->below[PANELS];
        most = (int)ceil(made->whole / worth - 0.5);
    }
    made->dots = malloc((most + 1) * sizeof *made->dots);
    if (!made->dots) {
        free(made);
        return pp_fail_memory(err);
    }
    place_dots(made, most);
    *pot = made;
    return PP_OK;
}

void pp_pepper_pot_dots_destroy(struct pp_pepper_pot *pot)
{
    if (!pot)
        return;
    free(pot->dots);
    free(pot);
}

int pp_pepper_pot_dots_count(const struct pp_pepper_pot *pot,
                             const struct pp_region *region)
{
    return pp_region_count_inside(region, pot->dots, pot->count);
}

bool pp_pepper_pot_dots_to_square(const struct pp_pepper_pot *pot, double a, double b,
                                  double *s, double *t)
{
    double phi = atan(a), gamma = atan2(b, hypot(a, 1.0));
    double left[AZIMUTHS + 1];
    fill_ring(left, pot, gamma);
    if (!(gamma >= 0.0 && phi >= pot->low_rad && phi <= pot->high_rad))
        return false;
    *s = pp_interpolate_cubic(left, AZIMUTHS + 1, pot->low_rad, pot->high_rad, phi)
         / left[AZIMUTHS];
    *t = pp_interpolate_cubic(pot->below, PANELS + 1, 0.0, PP_PI / 2.0, gamma)
         / pot->whole;
    return true;
}
