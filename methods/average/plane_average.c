/* plane_average.c - integrates the light from each opening over its wedges of the plane
 * by hcubature. */
#include "methods/average/plane_average.h"

#include <cubature.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Points in one evaluation of the cubature rule: the minimum for a piece. */
enum { FIRST_POINTS = 17 };

/* Integral over one piece. The function's values at the points of the first evaluation
 * of the rule are kept, since every cubature of the piece begins with them. */
struct piece_integral {
    double values[PP_PLANE_VALUES];
    double error; /* error of all values together; INFINITY until it is estimated */
    double first[FIRST_POINTS][PP_PLANE_VALUES];
    bool stopped;
};

/* The context of the integrand over one piece. */
struct integral {
    const struct pp_plane_wedge *piece;
    double z;
    pp_plane_function *function;
    void *data;
    struct piece_integral *of;
    int points; /* number of points evaluated so far */
    int known;  /* number of points whose values are known from the first estimate; 0 if
                 * none */
    bool stopped;
};

/* The values at a point of the unit square times the area element. Once the function
 * has stopped, they are set to zero, which ends the integration at once (hcubature
 * leaks memory when its integrand fails). */
static int integrand_at(unsigned dim, const double *square, void *data, unsigned fdim,
                        double *values)
{
    (void)dim, (void)fdim;
    struct integral *integral = data;
    int point = integral->points++;
    if (point < integral->known) {
        memcpy(values, integral->of->first[point], sizeof integral->of->first[point]);
        return 0;
    }
    double xy[2], element = pp_plane_wedge_point(integral->piece, square, xy);
    const struct pp_receiver receiver = {.position = {xy[0], xy[1], integral->z},
                                         .normal = {0.0, 0.0, 1.0}};
    if (!integral->stopped)
        integral->stopped = !integral->function(integral->data, integral->piece->centre,
                                                &receiver, values);
    for (int k = 0; k < PP_PLANE_VALUES; k++)
        values[k] = integral->stopped ? 0.0 : values[k] * element;
    if (point < FIRST_POINTS)
        memcpy(integral->of->first[point], values, sizeof integral->of->first[point]);
    return 0;
}

/* The integrals over all pieces, which are divided among the pool's workers. */
struct piece_integrals {
    const struct pp_plane_wedges *pieces;
    const struct integral *like;
    double absolute; /* error bound for one piece, for all its values together */
    int points;      /* most evaluations in one piece */
    struct piece_integral *of;
};

/* Integrates a piece, unless its estimate is accurate enough already. All pieces are
 * processed even after a failure, so that the side effects of the function do not
 * depend on the number of threads. */
static bool integrate_piece(void *data, int worker, int i)
{
    (void)worker;
    const struct piece_integrals *integrals = data;
    const double low[2] = {0.0, 0.0}, high[2] = {1.0, 1.0};
    double error[PP_PLANE_VALUES];
    struct piece_integral *of = &integrals->of[i];
    struct integral own = *integrals->like;
    if (of->error <= integrals->absolute)
        return true;
    own.piece = integrals->pieces->list + i;
    own.of = of;
    own.known = isinf(of->error) ? 0 : FIRST_POINTS;
    bool done = hcubature(PP_PLANE_VALUES, integrand_at, &own, 2, low, high,
                          (size_t)integrals->points, integrals->absolute, 0.0, ERROR_L1,
                          of->values, error)
                == 0;
    of->error = 0.0;
    for (int k = 0; k < PP_PLANE_VALUES; k++)
        of->error += error[k];
    of->stopped = !done || own.stopped;
    return true;
}

/* Integrates all pieces, and adds up the integrals in the order of the pieces. Returns
 * false if the function stopped. */
static bool integrate_pieces(double sum[PP_PLANE_VALUES],
                             struct piece_integrals *integrals,
                             struct pp_thread_pool *pool)
{
    int count = integrals->pieces->count;
    bool stopped = false;
    pp_thread_pool_run(pool, 0, count, integrate_piece, integrals);
    for (int k = 0; k < PP_PLANE_VALUES; k++)
        sum[k] = 0.0;
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < PP_PLANE_VALUES; k++)
            sum[k] += integrals->of[i].values[k];
        stopped |= integrals->of[i].stopped;
    }
    return !stopped;
}

enum pp_status pp_plane_average(double mean[PP_PLANE_VALUES], bool *stopped,
                                const struct pp_world *world,
                                const struct pp_plane_centre *centres, int count,
                                pp_plane_function *function, void *data,
                                double relative_error, int most_points,
                                struct pp_thread_pool *pool, struct pp_error *err)
{
    double area_m2 = pp_region_area(&world->plane);
    if (!(area_m2 > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the room has no working plane at a height of %g m",
                       world->working_plane_m);
    struct pp_plane_wedges pieces;
    enum pp_status status =
        pp_plane_wedges_find(&pieces, &world->plane, centres, count, err);
    struct piece_integral *of = calloc((size_t)pieces.count + 1, sizeof *of);
    if (status != PP_OK || !of) {
        free(of);
        free(pieces.list);
        return status == PP_OK ? pp_fail_memory(err) : status;
    }

    /* A first estimate, one evaluation of the rule for each piece, sets the error
     * allowed to each piece. Errors of different pieces are assumed independent. Only
     * an eighth of the requested error is allowed, since the two sums of a rule may
     * agree although both are wrong. */
    for (int i = 0; i < pieces.count; i++)
        of[i].error = INFINITY;
    struct integral integral = {
        .z = world->working_plane_m, .function = function, .data = data};
    struct piece_integrals integrals = {&pieces, &integral, 1e300, FIRST_POINTS, of};
    double sum[PP_PLANE_VALUES];
    bool done = integrate_pieces(sum, &integrals, pool);
    double total = 0.0;
    for (int k = 0; k < PP_PLANE_VALUES; k++)
        total += sum[k];
    integrals.absolute = relative_error / 8.0 * total / sqrt(pieces.count);
    integrals.points = most_points > FIRST_POINTS ? most_points : FIRST_POINTS;
    if (done && total > 0.0)
        done = integrate_pieces(sum, &integrals, pool);
    for (int k = 0; k < PP_PLANE_VALUES; k++)
        mean[k] = sum[k] / area_m2;
    *stopped = !done;
    free(of);
    free(pieces.list);
    return PP_OK;
}
