/* blind_scatter.c - see blind_scatter.h. s is the angle of a direction to the section:
 * in the axes of the blind, a direction is (cos s cos p, -cos s sin p, sin s), with the
 * second along the sequence of slats. */
#include "model/light/slats/blind_scatter.h"

#include <math.h>

enum { MEAN_STEPS = 32 };

#define HALF_PI (0.5 * PP_PI)

double pp_blind_scatter_range(int bin, int count)
{
    return sin(-HALF_PI + (bin + 1) * PP_PI / count)
           - sin(-HALF_PI + bin * PP_PI / count);
}

double pp_blind_scatter_mean(double (*f)(const struct pp_glass *, double),
                             const struct pp_glass *glass, double profile_rad)
{
    double sum = 0.0;
    for (int i = 0; i < MEAN_STEPS; i++) {
        double s = ((i + 0.5) / MEAN_STEPS - 0.5) * PP_PI;
        sum += f(glass, fabs(cos(s) * cos(profile_rad))) * cos(s) * cos(s);
    }
    return sum * 2.0 / MEAN_STEPS;
}

/* ---- directions ---- */

static double profile_of(const struct pp_blind *blind, struct pp_vec3 d)
{
    return atan2(blind->device.vertical ? -d.x : -d.y, d.z);
}

/* Index of one of `count` equal parts of -90 to 90 degrees. */
static int part_of(double profile_rad, int count)
{
    int part = (int)floor((profile_rad / PP_PI + 0.5) * count);
    return part < 0 ? 0 : part < count ? part : count - 1;
}

/* N(p, q) at this profile angle p, for a bin of q. */
static double through_at(const struct pp_blind *blind, double profile_rad, int bin)
{
    double at = (profile_rad / PP_PI + 0.5) * PP_BLIND_CELLS;
    int cell = part_of(profile_rad, PP_BLIND_CELLS);
    double part = at - cell;
    return (1.0 - part) * blind->through[cell][bin]
           + part * blind->through[cell + 1][bin];
}

static double cell_through(const struct pp_blind *blind, int cell, int bin)
{
    return 0.5 * (blind->through[cell][bin] + blind->through[cell + 1][bin]);
}

/* s for a random number v in (0, 1): density (2/pi) cos^2 s. Solves 2 s + sin 2 s =
 * pi (2 v - 1) by bisection and Newton's method. */
static double angle_to_section(double v)
{
    double target = PP_PI * (2.0 * v - 1.0), low = -PP_PI, high = PP_PI, t = target;
    for (int i = 0; i < 60 && high - low > 1e-12; i++) {
        double miss = t + sin(t) - target, slope = 1.0 + cos(t);
        if (miss > 0.0)
            high = t;
        else
            low = t;
        double next = t - miss / slope;
        t = next > low && next < high ? next : 0.5 * (low + high);
        if (fabs(miss) < 1e-13)
            break;
    }
    return 0.5 * t;
}

/* Direction of travel into the room, in the axes of the pane, within one of `count`
 * parts of the profile angle. u selects sin p, uniformly; v selects s. */
static struct pp_vec3 direction_in(const struct pp_blind *blind, int part, int count,
                                   double u, double v)
{
    double low = sin(-HALF_PI + part * PP_PI / count);
    double sine = low + u * pp_blind_scatter_range(part, count);
    double cosine = sqrt(fmax(0.0, 1.0 - sine * sine)), s = angle_to_section(v);
    double along = -cos(s) * sine;
    return blind->device.vertical ? pp_vec(along, sin(s), cos(s) * cosine)
                                  : pp_vec(sin(s), along, cos(s) * cosine);
}

static struct pp_vec3 reversed(struct pp_vec3 d)
{
    return pp_vec_scale(d, -1.0);
}

/* ---- the functions of the pane ---- */

double pp_blind_scatter_gaps(const struct pp_blind *blind, struct pp_vec3 in)
{
    return pp_slats_straight(&blind->device.slats, profile_of(blind, in));
}

/* Straight light only; light reflected between the panes before and behind the slats is
 * part of N. */
static double blind_straight(const void *data, struct pp_vec3 in)
{
    const struct pp_blind *blind = data;
    return pp_blind_scatter_gaps(blind, in)
           * pp_glass_transmittance(&blind->outer, fabs(in.z))
           * pp_glass_transmittance(&blind->inner, fabs(in.z));
}

/* Scattered share of light that arrives from outside. */
static double scattered_inwards(const struct pp_blind *blind, struct pp_vec3 in)
{
    double p = profile_of(blind, in), sum = 0.0;
    for (int j = 0; j < PP_BLIND_BINS; j++)
        sum += through_at(blind, p, j) * blind->inner_mean[j];
    return sum * pp_glass_transmittance(&blind->outer, in.z);
}

/* Integral of btdf |in.z| over all directions of light from outside. */
static double arriving_inwards(const struct pp_blind *blind, struct pp_vec3 out)
{
    int bin = part_of(profile_of(blind, out), PP_BLIND_BINS);
    return pp_glass_transmittance(&blind->inner, out.z)
           / pp_blind_scatter_range(bin, PP_BLIND_BINS)
           * blind->cumulative[bin][PP_BLIND_CELLS - 1];
}

static double blind_scattered(const void *data, struct pp_vec3 in)
{
    return in.z > 0.0 ? scattered_inwards(data, in)
                      : arriving_inwards(data, reversed(in));
}

static double blind_arriving(const void *data, struct pp_vec3 out)
{
    return out.z > 0.0 ? arriving_inwards(data, out)
                       : scattered_inwards(data, reversed(out));
}

static double blind_btdf(const void *data, struct pp_vec3 in, struct pp_vec3 out)
{
    const struct pp_blind *blind = data;
    if (!(in.z * out.z > 0.0))
        return 0.0;
    if (in.z < 0.0)
        return blind_btdf(data, reversed(out), reversed(in));
    int bin = part_of(profile_of(blind, out), PP_BLIND_BINS);
    return pp_glass_transmittance(&blind->outer, in.z) * 2.0 / PP_PI
           * through_at(blind, profile_of(blind, in), bin)
           / pp_blind_scatter_range(bin, PP_BLIND_BINS)
           * pp_glass_transmittance(&blind->inner, out.z);
}

/* For light that leaves to the outside: share of each bin, by reciprocity from light
 * that travels in the opposite direction. Returns the sum of the shares. */
static double leaving_shares(const struct pp_blind *blind, struct pp_vec3 out,
                             double shares[PP_BLIND_BINS])
{
    double p = profile_of(blind, reversed(out)), sum = 0.0;
    for (int j = 0; j < PP_BLIND_BINS; j++)
        sum += shares[j] = through_at(blind, p, j) * blind->inner_mean[j];
    return sum;
}

static double sample_outwards(const struct pp_blind *blind, struct pp_vec3 out,
                              double u, double v, struct pp_vec3 *in)
{
    double shares[PP_BLIND_BINS], left = u * leaving_shares(blind, out, shares);
    int bin = 0;
    while (bin + 1 < PP_BLIND_BINS && left >= shares[bin])
        left -= shares[bin++];
    if (!(shares[bin] > 0.0))
        return 0.0;
    struct pp_vec3 d =
        direction_in(blind, bin, PP_BLIND_BINS, fmin(left / shares[bin], 1.0), v);
    *in = reversed(d);
    return pp_glass_transmittance(&blind->inner, d.z) / blind->inner_mean[bin];
}

static double blind_sample(const void *data, struct pp_vec3 out, double u, double v,
                           struct pp_vec3 *in)
{
    const struct pp_blind *blind = data;
    if (out.z < 0.0)
        return sample_outwards(blind, out, u, v, in);
    int bin = part_of(profile_of(blind, out), PP_BLIND_BINS);
    const double *sums = blind->cumulative[bin];
    double at = u * sums[PP_BLIND_CELLS - 1];
    int cell = 0;
    while (cell + 1 < PP_BLIND_CELLS && at >= sums[cell])
        cell++;
    double before = cell > 0 ? sums[cell - 1] : 0.0, share = sums[cell] - before;
    if (!(share > 0.0))
        return 0.0;
    *in =
        direction_in(blind, cell, PP_BLIND_CELLS, fmin((at - before) / share, 1.0), v);
    if (!(in->z > 0.0))
        return 0.0;
    return pp_glass_transmittance(&blind->outer, in->z) / blind->outer_mean[cell]
           * through_at(blind, profile_of(blind, *in), bin)
           / cell_through(blind, cell, bin);
}

static double blind_density(const void *data, struct pp_vec3 in, struct pp_vec3 out)
{
    const struct pp_blind *blind = data;
    if (!(in.z * out.z > 0.0))
        return 0.0;
    if (out.z < 0.0) {
        double shares[PP_BLIND_BINS], sum = leaving_shares(blind, out, shares);
        int bin = part_of(profile_of(blind, reversed(in)), PP_BLIND_BINS);
        return sum > 0.0 ? -in.z * 2.0 / PP_PI * shares[bin] / sum
                               / pp_blind_scatter_range(bin, PP_BLIND_BINS)
                         : 0.0;
    }
    int bin = part_of(profile_of(blind, out), PP_BLIND_BINS);
    int cell = part_of(profile_of(blind, in), PP_BLIND_CELLS);
    const double *sums = blind->cumulative[bin];
    double share = sums[cell] - (cell > 0 ? sums[cell - 1] : 0.0);
    double sum = sums[PP_BLIND_CELLS - 1];
    return sum > 0.0 ? in.z * 2.0 / PP_PI * share / sum
                           / pp_blind_scatter_range(cell, PP_BLIND_CELLS)
                     : 0.0;
}

/* Class of leaving light for annual simulations: its bin of q. */
static int blind_class(const void *data, struct pp_vec3 out)
{
    return part_of(profile_of(data, out), PP_BLIND_BINS);
}

static double blind_class_btdf(const void *data, struct pp_vec3 in, int bin)
{
    const struct pp_blind *blind = data;
    return pp_glass_transmittance(&blind->outer, in.z) * 2.0 / PP_PI
           * through_at(blind, profile_of(blind, in), bin)
           / pp_blind_scatter_range(bin, PP_BLIND_BINS) * blind->inner_mean[bin];
}

void pp_blind_scatter_init(struct pp_blind *blind)
{
    for (int j = 0; j < PP_BLIND_BINS; j++) {
        double sum = 0.0;
        for (int i = 0; i < PP_BLIND_CELLS; i++) {
            sum += cell_through(blind, i, j) * blind->outer_mean[i]
                   * pp_blind_scatter_range(i, PP_BLIND_CELLS);
            blind->cumulative[j][i] = sum;
        }
    }
    struct pp_pane_scatter *scatter = &blind->scatter;
    scatter->data = blind;
    scatter->splits = true;
    scatter->straight = blind_straight;
    scatter->scattered = blind_scattered;
    scatter->btdf = blind_btdf;
    scatter->arriving = blind_arriving;
    scatter->sample = blind_sample;
    scatter->density = blind_density;
    scatter->class_count = PP_BLIND_BINS;
    scatter->class_of = blind_class;
    scatter->class_btdf = blind_class_btdf;
}
