/* pepper_pot_dots.c - integrates the light by altitude and azimuth, and inverts both
 * integrals at the points of a Fibonacci lattice. */
#include "methods/pepper_pot/pepper_pot_dots.h"

#include <math.h>
#include <stdlib.h>

#include "methods/interpolate.h"

enum { PANELS = PP_PEPPER_POT_PANELS, AZIMUTHS = 20 };

/* The azimuths from which light of altitude gamma reaches the receiver. */
static void azimuths(const struct pp_pepper_pot *pot, double *low, double *high)
{
    *low = -PP_PI / 2.0;
    *high = PP_PI / 2.0;
    if (pot->upright) {
        *low = fmax(*low, pot->facing_rad - PP_PI / 2.0);
        *high = fmin(*high, pot->facing_rad + PP_PI / 2.0);
    }
}

/* dSC / (dgamma dphi) of the header as a product: a factor that depends on the altitude
 * only, times by_azimuth. */
static double by_altitude(const struct pp_pepper_pot *pot, double gamma)
{
    double s = sin(gamma), c = cos(gamma);
    return pp_sky_luminance(&pot->sky, pp_vec(c, 0.0, s)) * (pot->upright ? c : s) * c;
}

static double by_azimuth(const struct pp_pepper_pot *pot, double cos_gamma, double phi)
{
    double facing = pot->upright ? cos(phi - pot->facing_rad) : 1.0;
    if (!pot->glazed)
        return facing;
    return facing
           * pp_interpolate_cubic(pot->losses, PP_PEPPER_POT_LOSSES, 0.0, 1.0,
                                  cos_gamma * cos(phi));
}

/* One altitude, and the light from the left of each of even azimuths. */
struct ring_of_sky {
    const struct pp_pepper_pot *pot;
    double cos_gamma;
    double low, high; /* azimuths */
    double left[AZIMUTHS + 1];
};

static double of_ring(const void *context, double phi)
{
    const struct ring_of_sky *ring = context;
    return by_azimuth(ring->pot, ring->cos_gamma, phi);
}

static void fill_ring(struct ring_of_sky *ring, const struct pp_pepper_pot *pot,
                      double gamma)
{
    ring->pot = pot;
    ring->cos_gamma = cos(gamma);
    azimuths(pot, &ring->low, &ring->high);
    pp_interpolate_tabulate_integral(ring->left, AZIMUTHS + 1, ring->low, ring->high,
                                     of_ring, ring);
}

static double from_altitude(const void *pot, double gamma)
{
    struct ring_of_sky ring;
    fill_ring(&ring, pot, gamma);
    return by_altitude(pot, gamma) * ring.left[AZIMUTHS];
}

static void place_dots(struct pp_pepper_pot *pot, int most)
{
    static const double golden = 0.61803398874989484820; /* (sqrt 5 - 1)/2 */
    for (int i = 0; i < most; i++) {
        double share = (i + 0.5) * pot->worth, whole;
        double s = modf((i + 0.5) * golden, &whole);
        double gamma =
            pp_interpolate_inverse(pot->below, PANELS + 1, 0.0, PP_PI / 2.0, share);
        struct ring_of_sky ring;
        fill_ring(&ring, pot, gamma);
        double phi = pp_interpolate_inverse(ring.left, AZIMUTHS + 1, ring.low,
                                            ring.high, s * ring.left[AZIMUTHS]);
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
    if (sky->kind == PP_SKY_ISO)
        return pp_fail(err, PP_BAD_INPUT,
                       "a pepper-pot diagram is for the overcast or the uniform sky, "
                       "not for %s",
                       pp_sky_name(sky));
    if (!(worth >= 1e-5 && worth <= 0.1))
        return pp_fail(err, PP_BAD_INPUT,
                       "a dot worth %g %% is not between 0.001 %% and 10 %%",
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
    for (int i = 0; i < PP_PEPPER_POT_LOSSES; i++)
        made->losses[i] =
            pp_glass_transmittance(&made->glass, i / (PP_PEPPER_POT_LOSSES - 1.0));
    double low, high;
    azimuths(made, &low, &high);
    int most = 0;
    if (high > low) {
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
    int count = 0;
    for (int i = 0; i < pot->count; i++)
        count += pp_region_contains(region, pot->dots[i][0], pot->dots[i][1]);
    return count;
}

bool pp_pepper_pot_dots_to_square(const struct pp_pepper_pot *pot, double a, double b,
                                  double *s, double *t)
{
    double phi = atan(a), gamma = atan2(b, hypot(a, 1.0));
    struct ring_of_sky ring;
    fill_ring(&ring, pot, gamma);
    if (!(gamma >= 0.0 && phi >= ring.low && phi <= ring.high))
        return false;
    *s = pp_interpolate_cubic(ring.left, AZIMUTHS + 1, ring.low, ring.high, phi)
         / ring.left[AZIMUTHS];
    *t = pp_interpolate_cubic(pot->below, PANELS + 1, 0.0, PP_PI / 2.0, gamma)
         / pot->whole;
    return true;
}
