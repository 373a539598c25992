/* protractor_dial.c - tabulates the density of protractor_scale.h by Simpson's rule and
 * reads the tables by Hermite cubics. */
#include "methods/protractor/protractor_dial.h"

#include <math.h>

#include "model/geometry/gauss.h"
#include "model/geometry/min_max.h"

static const double between_semicircles_rad = 10.0 * PP_RAD;

/* The auxiliary scale is indeterminate at the ends of the primary scale, where the
 * strip has no width; it is evaluated at this distance (rad) from the ends. */
static const double end_rad = 1e-4;

/* The cubic with these values and slopes at both ends of a step, at t in 0..1. */
static double hermite(double t, double step, double a, double a_slope, double b,
                      double b_slope)
{
    double u = 1.0 - t;
    return a * u * u * (1.0 + 2.0 * t) + b * t * t * (3.0 - 2.0 * t)
           + step * t * u * (a_slope * u - b_slope * t);
}

/* Interpolates in a table of values and slopes at equal steps from 0 to `last`. */
static double read_table(const double *values, const double *slopes, double last,
                         double x)
{
    double step = last / PP_DIAL_STEPS;
    double place = pp_clamp(x / step, 0.0, PP_DIAL_STEPS);
    int i = place < PP_DIAL_STEPS ? (int)place : PP_DIAL_STEPS - 1;
    return hermite(place - i, step, values[i], slopes[i], values[i + 1], slopes[i + 1]);
}

static double simpson(double a, double middle, double b, double step)
{
    return (a + 4.0 * middle + b) * step / 6.0;
}

/* dF/dgamma: the density integrated over the strip, on both sides of the section, by
 * one Gauss-Legendre rule; the density is smooth up to the strip's end, where it is
 * 0. */
enum { NODES = 16 };

struct strip_rule {
    struct pp_angle thetas[NODES];
    double weights[NODES];
};

static struct strip_rule strip_rule_of(void)
{
    struct strip_rule rule;
    double nodes[NODES];
    pp_gauss_legendre(nodes, rule.weights, NODES);
    for (int i = 0; i < NODES; i++)
        rule.thetas[i] = pp_angle_of(PP_PI / 4.0 * (1.0 + nodes[i]));
    return rule;
}

static double strip(const struct pp_protractor *protractor,
                    const struct pp_glass_curve *losses, const struct strip_rule *rule,
                    double gamma)
{
    double densities[NODES], sum = 0.0;
    pp_protractor_scale_densities(densities, protractor, losses, gamma, rule->thetas,
                                  NODES);
    for (int i = 0; i < NODES; i++)
        sum += rule->weights[i] * densities[i];
    return PP_PI / 2.0 * sum;
}

static void make_primary(struct pp_protractor_dial *dial,
                         const struct pp_glass_curve *losses)
{
    const struct pp_protractor *protractor = &dial->protractor;
    double step = dial->range_rad / PP_DIAL_STEPS;
    const struct strip_rule rule = strip_rule_of();
    dial->primary[0] = 0.0;
    dial->slope[0] = strip(protractor, losses, &rule, 0.0);
    for (int i = 0; i < PP_DIAL_STEPS; i++) {
        double middle = strip(protractor, losses, &rule, (i + 0.5) * step);
        dial->slope[i + 1] = strip(protractor, losses, &rule, (i + 1) * step);
        dial->primary[i + 1] =
            dial->primary[i]
            + simpson(dial->slope[i], middle, dial->slope[i + 1], step);
    }
}

/* The angles of a semicircle's steps and of their middles. */
enum { HALF_STEPS = 2 * PP_DIAL_STEPS };

static void half_steps(struct pp_angle thetas[HALF_STEPS + 1])
{
    for (int i = 0; i <= HALF_STEPS; i++)
        thetas[i] = pp_angle_of(PP_PI / 2.0 * i / HALF_STEPS);
}

static void make_semicircle(struct pp_protractor_semicircle *semicircle,
                            const struct pp_protractor *protractor,
                            const struct pp_glass_curve *losses,
                            const struct pp_angle thetas[HALF_STEPS + 1],
                            double average_rad)
{
    double range = pp_protractor_scale_range(protractor);
    double gamma = fmin(fmax(average_rad, end_rad), range - end_rad);
    double step = PP_PI / 2.0 / PP_DIAL_STEPS, densities[HALF_STEPS + 1];
    double *factor = semicircle->factor, *rate = semicircle->rate;
    semicircle->average_rad = average_rad;
    semicircle->cos_average = cos(average_rad);
    pp_protractor_scale_densities(densities, protractor, losses, gamma, thetas,
                                  HALF_STEPS + 1);
    factor[0] = 0.0;
    rate[0] = densities[0];
    for (int i = 0; i < PP_DIAL_STEPS; i++) {
        rate[i + 1] = densities[2 * i + 2];
        factor[i + 1] =
            factor[i] + simpson(rate[i], densities[2 * i + 1], rate[i + 1], step);
    }
    double whole = 2.0 * factor[PP_DIAL_STEPS];
    for (int i = 0; i <= PP_DIAL_STEPS; i++) {
        factor[i] /= whole;
        rate[i] /= whole;
    }
}

void pp_protractor_dial_semicircle_init(struct pp_protractor_semicircle *semicircle,
                                        const struct pp_protractor *protractor,
                                        double average_rad)
{
    struct pp_angle thetas[HALF_STEPS + 1];
    half_steps(thetas);
    make_semicircle(semicircle, protractor, NULL, thetas, average_rad);
}

void pp_protractor_dial_init(struct pp_protractor_dial *dial,
                             const struct pp_protractor *protractor)
{
    struct pp_angle thetas[HALF_STEPS + 1];
    struct pp_glass_curve losses;
    pp_glass_curve_init(&losses, &protractor->glass);
    dial->protractor = *protractor;
    dial->range_rad = pp_protractor_scale_range(protractor);
    make_primary(dial, &losses);
    half_steps(thetas);
    for (int k = 0; k < PP_DIAL_SEMICIRCLES; k++) {
        double average = k * between_semicircles_rad;
        if (k > 0 && dial->semicircles[k - 1].average_rad > dial->range_rad) {
            dial->semicircles[k] = dial->semicircles[k - 1]; /* semicircles past the end
                                                              * of the scale are
                                                              * copies */
            dial->semicircles[k].average_rad = average;
            dial->semicircles[k].cos_average = cos(average);
        } else {
            make_semicircle(&dial->semicircles[k], protractor, &losses, thetas,
                            average);
        }
    }
}

double pp_protractor_dial_share(const struct pp_protractor_dial *dial, double gamma_rad)
{
    return read_table(dial->primary, dial->slope, dial->range_rad, gamma_rad);
}

double pp_protractor_dial_slope(const struct pp_protractor_dial *dial, double gamma_rad)
{
    double place = gamma_rad / dial->range_rad * PP_DIAL_STEPS;
    int k = (int)fmin(fmax(place, 0.0), PP_DIAL_STEPS - 1);
    double t = fmin(place - k, 1.0);
    return dial->slope[k] * (1.0 - t) + dial->slope[k + 1] * t;
}

double pp_protractor_dial_angle(const struct pp_protractor_dial *dial, double share,
                                double start_rad)
{
    double low = 0.0, high = dial->range_rad;
    double gamma = fmin(fmax(start_rad, low), high);
    for (int i = 0; i < 100; i++) {
        double off = pp_protractor_dial_share(dial, gamma) - share;
        if (off < 0.0)
            low = gamma;
        else
            high = gamma;
        double next = gamma - off / pp_protractor_dial_slope(dial, gamma);
        if (!(next > low && next < high))
            next = (low + high) / 2.0;
        if (fabs(next - gamma) < 1e-10)
            return next;
        gamma = next;
    }
    return gamma;
}

static double at_theta(const struct pp_protractor_semicircle *semicircle, double theta)
{
    return read_table(semicircle->factor, semicircle->rate, PP_PI / 2.0, theta);
}

double pp_protractor_dial_factor(const struct pp_protractor_dial *dial,
                                 double average_rad, double jamb_rad, bool turned_down)
{
    double place = average_rad / between_semicircles_rad;
    int k = (int)fmin(fmax(place, 0.0), PP_DIAL_SEMICIRCLES - 2);
    double jamb = fmin(fabs(jamb_rad), PP_PI / 2.0);
    double theta[2] = {jamb, jamb}, factor[2];
    if (!turned_down) {
        const struct pp_angle azimuth = pp_angle_of(jamb);
        for (int i = 0; i < 2; i++)
            theta[i] = pp_protractor_scale_theta(dial->semicircles[k + i].cos_average,
                                                 azimuth);
    }
    for (int i = 0; i < 2; i++)
        factor[i] = at_theta(&dial->semicircles[k + i], theta[i]);
    return copysign(factor[0] + (place - k) * (factor[1] - factor[0]), jamb_rad);
}

double pp_protractor_dial_jamb_angle(const struct pp_protractor_semicircle *semicircle,
                                     double factor, bool turned_down)
{
    double low = 0.0, high = PP_PI / 2.0;
    while (high - low > 1e-9) {
        double theta = (low + high) / 2.0;
        if (at_theta(semicircle, theta) < factor)
            low = theta;
        else
            high = theta;
    }
    double theta = (low + high) / 2.0;
    return turned_down ? theta
                       : atan2(sin(theta), cos(theta) * semicircle->cos_average);
}
