/* likelihood.c - sums the density of (1) over noise levels, with a Cholesky factor for
 * each. */
#include "studies/research/compare/likelihood.h"

#include <math.h>
#include <stdlib.h>

enum { SIGMAS = 20 };
static const double SIGMA_LEAST = 0.003, SIGMA_MOST = 0.6;
static const double ALIKE = 0.9;                  /* k */
static const double REACH_M[] = {0.0, 0.6, 1.8};  /* l; 0: k is 0 */
static const double BEFORE[] = {0.5, 0.25, 0.25}; /* prior probabilities of the
                                                   * reaches */
enum { KINDS = sizeof REACH_M / sizeof REACH_M[0] };

/* Standard deviations of theta: COMMON for an error common to all programs; FACTOR for
 * a common factor, small or large. */
static const double COMMON = 0.005, FACTOR[] = {0.1, 0.7};

static double sigma_at(int i)
{
    return SIGMA_LEAST * pow(SIGMA_MOST / SIGMA_LEAST, i / (SIGMAS - 1.0));
}

/* Quadratic forms of a residual r = g - e, with V the inverse of its covariance. */
struct forms {
    double rr, r1, one; /* r' V r, r' V 1, 1' V 1 */
    double log_det;     /* logarithm of the covariance's determinant */
};

/* Calculates ln(exp(a) + exp(b)) without overflow. */
static double log_sum(double a, double b)
{
    double most = fmax(a, b);
    return most + log(exp(a - most) + exp(b - most));
}

/* Logarithm of density (1), with theta normally distributed about 0 with the standard
 * deviation s = `deviation`. *theta: its expected value, 1' V r / (1' V 1 + 1/s^2). */
static double density_of(const struct forms *forms, int count, double deviation,
                         double *theta)
{
    double inverse = 1.0 / (deviation * deviation);
    *theta = forms->r1 / (forms->one + inverse);
    return -0.5 * (forms->rr + forms->log_det + count * log(2.0 * PP_PI))
           + 0.5 * forms->r1 * *theta - 0.5 * log1p(forms->one / inverse);
}

static double density(const struct forms *forms, int count, bool has_factor,
                      double *theta)
{
    double small, large;
    if (!has_factor)
        return density_of(forms, count, COMMON, theta);
    double of_small = density_of(forms, count, FACTOR[0], &small);
    double of_large = density_of(forms, count, FACTOR[1], &large);
    double both = log_sum(of_small, of_large);
    *theta = exp(of_small - both) * small + exp(of_large - both) * large;
    return both - log(2.0);
}

static struct forms white_forms(const struct pp_likelihood_data *data,
                                const struct pp_supposition *supposed, double sigma)
{
    struct forms forms = {0};
    for (int i = 0; i < data->count; i++) {
        double variance = sigma * sigma + supposed->variance[i];
        double r = data->gap[i] - supposed->effect[i];
        forms.rr += r * r / variance;
        forms.r1 += r / variance;
        forms.one += 1.0 / variance;
        forms.log_det += log(variance);
    }
    return forms;
}

/* Lower Cholesky factor of the covariance in (1), row by row, n x n. */
static void factor(double *lower, const struct pp_likelihood_data *data,
                   const double *variance, double sigma, double reach_m)
{
    int n = data->count;
    for (int i = 0; i < n; i++)
        for (int k = 0; k <= i; k++) {
            double far =
                pp_vec_length(pp_vec_sub(data->places[i], data->places[k])) / reach_m;
            double sum = sigma * sigma * ALIKE * exp(-0.5 * far * far);
            if (i == k)
                sum = sigma * sigma + variance[i];
            for (int m = 0; m < k; m++)
                sum -= lower[i * n + m] * lower[k * n + m];
            lower[i * n + k] = i == k ? sqrt(sum) : sum / lower[k * n + k];
        }
}

static struct forms near_forms(const struct pp_likelihood_data *data,
                               const struct pp_supposition *supposed,
                               const double *lower, double *r, double *one)
{
    struct forms forms = {0};
    int n = data->count;
    for (int i = 0; i < n; i++) {
        r[i] = data->gap[i] - supposed->effect[i];
        one[i] = 1.0;
        for (int m = 0; m < i; m++) {
            r[i] -= lower[i * n + m] * r[m];
            one[i] -= lower[i * n + m] * one[m];
        }
        r[i] /= lower[i * n + i];
        one[i] /= lower[i * n + i];
        forms.rr += r[i] * r[i];
        forms.r1 += r[i] * one[i];
        forms.one += one[i] * one[i];
        forms.log_det += 2.0 * log(lower[i * n + i]);
    }
    return forms;
}

double pp_likelihood_white(const struct pp_likelihood_data *data,
                           const struct pp_supposition *supposed)
{
    double of[SIGMAS], most = -INFINITY, sum = 0.0, theta;
    for (int i = 0; i < SIGMAS; i++) {
        struct forms forms = white_forms(data, supposed, sigma_at(i));
        of[i] = density(&forms, data->count, supposed->has_factor, &theta);
        most = fmax(most, of[i]);
    }
    for (int i = 0; i < SIGMAS; i++)
        sum += exp(of[i] - most) / SIGMAS;
    return most + log(sum);
}

/* Averages the densities over noise levels i and kinds of noise k. */
static struct pp_likelihood sum_up(double of[KINDS][SIGMAS],
                                   double theta[KINDS][SIGMAS])
{
    struct pp_likelihood likelihood = {0};
    double most = -INFINITY, sum = 0.0;
    for (int k = 0; k < KINDS; k++)
        for (int i = 0; i < SIGMAS; i++)
            most = fmax(most, of[k][i]);
    for (int k = 0; k < KINDS; k++)
        for (int i = 0; i < SIGMAS; i++) {
            double share = BEFORE[k] / SIGMAS * exp(of[k][i] - most);
            sum += share;
            likelihood.sigma += share * sigma_at(i);
            likelihood.near += k > 0 ? share : 0.0;
            likelihood.theta += share * theta[k][i];
        }
    likelihood.log_density = most + log(sum);
    likelihood.sigma /= sum;
    likelihood.near /= sum;
    likelihood.theta /= sum;
    return likelihood;
}

enum pp_status pp_likelihood(struct pp_likelihood *likelihood,
                             const struct pp_likelihood_data *data,
                             const struct pp_supposition *supposed,
                             struct pp_error *err)
{
    size_t n = (size_t)data->count;
    double of[KINDS][SIGMAS], theta[KINDS][SIGMAS];
    double *lower = malloc((n * n + 2 * n + 1) * sizeof *lower);
    if (!lower)
        return pp_fail_memory(err);
    for (int k = 0; k < KINDS; k++)
        for (int i = 0; i < SIGMAS; i++) {
            double sigma = sigma_at(i);
            struct forms forms;
            if (k == 0) {
                forms = white_forms(data, supposed, sigma);
            } else {
                factor(lower, data, supposed->variance, sigma, REACH_M[k]);
                forms =
                    near_forms(data, supposed, lower, lower + n * n, lower + n * n + n);
            }
            of[k][i] = density(&forms, data->count, supposed->has_factor, &theta[k][i]);
        }
    free(lower);
    *likelihood = sum_up(of, theta);
    return PP_OK;
}
