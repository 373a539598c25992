/* pepper_pot_dots.c - see pepper_pot_dots.h. */
#include "methods/pepper_pot_dots.h"

#include <cubature.h>
#include <math.h>
#include <stdlib.h>

#include "methods/even_table.h"

enum { PANELS = PP_PEPPER_POT_PANELS, MOST_EVALUATIONS = 20000 };

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

/* dSC / (dgamma dphi) of the header is the product of what depends on the altitude
 * alone and the rest. */
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
           * pp_even_table(pot->losses, PP_PEPPER_POT_LOSSES, 0.0, 1.0,
                           cos_gamma * cos(phi));
}

struct ring_of_sky {
    const struct pp_pepper_pot *pot;
    double cos_gamma;
};

static int azimuth_integrand(unsigned dim, const double *phi, void *data, unsigned fdim,
                             double *value)
{
    (void)dim, (void)fdim;
    const struct ring_of_sky *ring = data;
    *value = by_azimuth(ring->pot, ring->cos_gamma, phi[0]);
    return 0;
}

/* Light from between two azimuths, over what depends on the altitude alone. */
static double from_azimuths(const struct pp_pepper_pot *pot, double gamma, double low,
                            double high)
{
    if (!pot->glazed && !pot->upright)
        return high - low;
    if (!pot->glazed)
        return sin(high - pot->facing_rad) - sin(low - pot->facing_rad);
    struct ring_of_sky ring = {pot, cos(gamma)};
    double sum = 0.0, error;
    hcubature(1, azimuth_integrand, &ring, 1, &low, &high, MOST_EVALUATIONS, 1e-9, 1e-8,
              ERROR_INDIVIDUAL, &sum, &error);
    return sum;
}

static double from_altitude(const struct pp_pepper_pot *pot, double gamma)
{
    double low, high;
    azimuths(pot, &low, &high);
    return by_altitude(pot, gamma) * from_azimuths(pot, gamma, low, high);
}

/* Light of altitudes low to high, a panel or less: Gauss's rule of four points. */
static double between_altitudes(const struct pp_pepper_pot *pot, double low,
                                double high)
{
    static const double place[] = {0.069431844202973712, 0.330009478207571868};
    static const double weight[] = {0.173927422568726929, 0.326072577431273071};
    double sum = 0.0, span = high - low;
    for (int i = 0; i < 2; i++)
        sum += weight[i]
               * (from_altitude(pot, low + place[i] * span)
                  + from_altitude(pot, high - place[i] * span));
    return sum * span;
}

static void fill_altitudes(struct pp_pepper_pot *pot)
{
    static const double panel = PP_PI / 2.0 / PANELS;
    pot->below[0] = 0.0;
    for (int i = 0; i < PANELS; i++)
        pot->below[i + 1] =
            pot->below[i] + between_altitudes(pot, i * panel, (i + 1) * panel);
}

static double share_below(const struct pp_pepper_pot *pot, double gamma)
{
    return pp_even_table(pot->below, PANELS + 1, 0.0, PP_PI / 2.0, gamma);
}

/* The altitude below which `share` comes, by bisection. */
static double altitude_of(const struct pp_pepper_pot *pot, double share)
{
    double low = 0.0, high = PP_PI / 2.0;
    while (high - low > 1e-9) {
        double middle = (low + high) / 2.0;
        if (share_below(pot, middle) < share)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* The azimuth to whose left the part s of altitude gamma's light comes from. */
static double azimuth_of(const struct pp_pepper_pot *pot, double gamma, double s)
{
    double low, high;
    azimuths(pot, &low, &high);
    double wanted = s * from_azimuths(pot, gamma, low, high);
    double phi = low + s * (high - low), left = low, sum = 0.0;
    double bracket_low = low, bracket_high = high;
    for (int i = 0; i < 50; i++) {
        /* Newton's step, or a halving where it would leave the bracket. */
        sum += phi > left ? from_azimuths(pot, gamma, left, phi)
                          : -from_azimuths(pot, gamma, phi, left);
        left = phi;
        if (sum < wanted)
            bracket_low = phi;
        else
            bracket_high = phi;
        double slope = by_azimuth(pot, cos(gamma), phi);
        double next = slope > 0.0 ? phi + (wanted - sum) / slope : NAN;
        if (!(next > bracket_low && next < bracket_high))
            next = (bracket_low + bracket_high) / 2.0;
        if (fabs(next - phi) < 1e-7)
            return next;
        phi = next;
    }
    return phi;
}

static void place_dots(struct pp_pepper_pot *pot, int most)
{
    static const double golden = 0.61803398874989484820; /* (sqrt 5 - 1)/2 */
    for (int i = 0; i < most; i++) {
        double share = (i + 0.5) * pot->worth, whole;
        double s = modf((i + 0.5) * golden, &whole);
        double gamma = altitude_of(pot, share);
        double phi = azimuth_of(pot, gamma, s);
        pot->dots[i][0] = tan(phi);
        pot->dots[i][1] = tan(gamma) / cos(phi);
    }
    pot->count = most;
}

enum pp_status pp_pepper_pot_create(struct pp_pepper_pot **pot,
                                    const struct pp_sky *sky, bool glazed, bool upright,
                                    double facing_rad, double worth,
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
        fill_altitudes(made);
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

void pp_pepper_pot_destroy(struct pp_pepper_pot *pot)
{
    if (!pot)
        return;
    free(pot->dots);
    free(pot);
}

int pp_pepper_pot_count(const struct pp_pepper_pot *pot, const struct pp_region *region)
{
    int count = 0;
    for (int i = 0; i < pot->count; i++)
        count += pp_region_contains(region, pot->dots[i][0], pot->dots[i][1]);
    return count;
}

bool pp_pepper_pot_square(const struct pp_pepper_pot *pot, double a, double b,
                          double *s, double *t)
{
    double low, high, phi = atan(a), gamma = atan2(b, hypot(a, 1.0));
    azimuths(pot, &low, &high);
    if (!(gamma >= 0.0 && phi >= low && phi <= high))
        return false;
    *s = from_azimuths(pot, gamma, low, phi) / from_azimuths(pot, gamma, low, high);
    *t = share_below(pot, gamma) / pot->whole;
    return true;
}
