/* left_over.c - fits the smooth part by polynomials, which the Gram-Schmidt method
 * makes orthogonal over the points. */
#include "studies/research/compare/left_over.h"

#include <math.h>
#include <stdlib.h>

enum { TERMS = 10 };
/* Relative error that both programs are assumed to share. */
static const double COMMON = 0.005;
static const double QUANTILE = 3.0;
/* Noise is estimated only with at least this many degrees of freedom: n - p, the number
 * of points less the number of polynomials. */
enum { FREE_LEAST = 6 };
/* If subtracting the others reduces the norm of a polynomial below this fraction, the
 * polynomial depends linearly on them at these points, and is left out. */
static const double DEPENDENT = 1e-6;

static double dot(const double *a, const double *b, int count)
{
    double sum = 0.0;
    for (int i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Distance of the farthest point from the first. */
static double farthest(const struct pp_vec3 *places, int count)
{
    double far = 1e-9;
    for (int i = 0; i < count; i++)
        far = fmax(far, pp_vec_length(pp_vec_sub(places[i], places[0])));
    return far;
}

static double term_at(int term, struct pp_vec3 at)
{
    const double terms[TERMS] = {1.0,         at.x,        at.y,        at.z,
                                 at.x * at.x, at.x * at.y, at.y * at.y, at.x * at.z,
                                 at.y * at.z, at.z * at.z};
    return terms[term];
}

/* Subtracts from `list` its projections on the first `made` vectors of the basis. */
static void take_off(double *list, const double *basis, int made, int count)
{
    for (int k = 0; k < made; k++) {
        double along = dot(list, &basis[k * count], count);
        for (int i = 0; i < count; i++)
            list[i] -= along * basis[k * count + i];
    }
}

/* Makes orthonormal polynomials over the points, at most `most`; returns their
 * number. */
static int make_basis(double *basis, const struct pp_vec3 *places, int count, int most)
{
    double far = farthest(places, count); /* scales coordinates to order 1 */
    int made = 0;
    for (int term = 0; term < TERMS && made < most; term++) {
        double *next = &basis[made * count];
        for (int i = 0; i < count; i++)
            next[i] = term_at(
                term, pp_vec_scale(pp_vec_sub(places[i], places[0]), 1.0 / far));
        double before = sqrt(dot(next, next, count));
        take_off(next, basis, made, count);
        take_off(next, basis, made, count); /* again, to reduce rounding errors */
        double length = sqrt(dot(next, next, count));
        for (int i = 0; i < count && length > DEPENDENT * before; i++)
            next[i] /= length;
        made += length > DEPENDENT * before;
    }
    return made;
}

enum pp_status pp_left_over(struct pp_left_over *over, const double *left,
                            const struct pp_vec3 *places, int count, double known_noise,
                            struct pp_error *err)
{
    double all = dot(left, left, count);
    double *basis = calloc((size_t)count * (TERMS + 1) + 1, sizeof *basis);
    if (!basis)
        return pp_fail_memory(err);
    double *scatter = basis + (size_t)count * TERMS;
    int most = count > FREE_LEAST ? count - FREE_LEAST : 0;
    int made = make_basis(basis, places, count, most < TERMS ? most : TERMS);
    for (int i = 0; i < count; i++)
        scatter[i] = left[i];
    take_off(scatter, basis, made, count);
    double rough = dot(scatter, scatter, count), noise2 = rough / (count - made);
    free(basis);
    *over = (struct pp_left_over){NAN, NAN, NAN};
    if (known_noise > 0.0) {
        over->noise = known_noise;
        over->left = sqrt(all / count);
        noise2 = known_noise * known_noise * (1.0 + QUANTILE * sqrt(2.0 / count));
    } else if (count - made >= FREE_LEAST && made > 2) {
        over->noise = sqrt(noise2);
        over->left = sqrt(fmax(all - rough, 0.0) / count);
        noise2 *= QUANTILE * made / count;
    } else {
        return PP_OK;
    }
    over->limit = sqrt(noise2 + COMMON * COMMON);
    return PP_OK;
}

bool pp_left_over_is_noise(const struct pp_left_over *over)
{
    return over->left <= over->limit;
}

bool pp_left_over_exceeds(const struct pp_left_over *over)
{
    return over->left > over->limit;
}
