/* sky_cells.c - inverts cumulative sums over a fine grid of directions.
 *
 * The illuminance of a horizontal plane from a patch is L sin(a) cos(a) da db for
 * altitude a and bearing b. Since cos(a) sin(a) da is d(sin^2 a)/2, strips between
 * equal steps of sin^2 a would contribute equally under a uniform sky.
 */
#include "model/light/sky_cells.h"

#include <math.h>
#include <stdlib.h>

enum { STRIPS = 2000, BEARINGS = 720 };

/* Grid of directions: strips of altitude from the zenith downwards, and bearings. */
struct net {
    const struct pp_sky *sky;
    int bearings;              /* 1 if the sky does not depend on bearing */
    double above[STRIPS + 1];  /* share of the light above the strip's upper edge */
    double turn[BEARINGS + 1]; /* in a ring: share of the light before each bearing */
};

static double altitude_of(double strip)
{
    return 0.5 * PP_PI * (1.0 - strip / STRIPS);
}

/* Light at one bearing from the strips between two positions, which may be
 * fractional. */
static double light_of(const struct net *net, double upper, double lower, int bearing)
{
    double high = sin(altitude_of(upper)), low = sin(altitude_of(lower));
    double altitude = altitude_of(0.5 * (upper + lower));
    double b = (bearing + 0.5) * 2.0 * PP_PI / net->bearings;
    struct pp_vec3 u = pp_vec_at_bearing(b, altitude);
    return 0.5 * (high * high - low * low) * pp_sky_luminance(net->sky, u) * 2.0 * PP_PI
           / net->bearings;
}

static void sum_strips(struct net *net)
{
    net->above[0] = 0.0;
    for (int i = 0; i < STRIPS; i++) {
        net->above[i + 1] = net->above[i];
        for (int k = 0; k < net->bearings; k++)
            net->above[i + 1] += light_of(net, i, i + 1.0, k);
    }
    for (int i = 1; i <= STRIPS; i++)
        net->above[i] /= net->above[STRIPS];
}

/* Position, in steps, of `share` in an ascending table of count + 1 shares. */
static double share_position(const double *shares, int count, double share)
{
    int low = 0, high = count;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        *(shares[middle] <= share ? &low : &high) = middle;
    }
    double step = shares[high] - shares[low];
    double t = step > 0.0 ? (share - shares[low]) / step : 0.0;
    return low + fmin(fmax(t, 0.0), 1.0);
}

/* Sums the light of the ring between two positions, bearing by bearing. */
static void sum_ring(struct net *net, double upper, double lower)
{
    net->turn[0] = 0.0;
    for (int k = 0; k < net->bearings; k++) {
        net->turn[k + 1] = net->turn[k];
        for (double at = upper; at < lower;) {
            double next = fmin(floor(at) + 1.0, lower);
            net->turn[k + 1] += light_of(net, at, next, k);
            at = next;
        }
    }
    for (int k = 1; k <= net->bearings; k++)
        net->turn[k] /= net->turn[net->bearings];
}

/* Number of cells in the next ring if `done` of `count` cells exist. It makes the cells
 * of the ring most nearly square, or is the number of remaining cells if a further ring
 * does not fit. */
static int ring_size(const struct net *net, int done, int count)
{
    double top = altitude_of(share_position(net->above, STRIPS, (double)done / count));
    int best = count - done;
    double least = INFINITY;
    for (int size = 1; size <= count - done; size++) {
        double low = altitude_of(
            share_position(net->above, STRIPS, (double)(done + size) / count));
        double wide = 2.0 * PP_PI * cos(0.5 * (top + low)) / size;
        double off = fabs(log((top - low) / wide));
        if (off >= least)
            break;
        least = off;
        best = size;
    }
    return count - done - best < best / 2 ? count - done : best;
}

static void fill_ring(struct net *net, struct pp_sky_cell *cells, int done, int size,
                      int count)
{
    double upper = share_position(net->above, STRIPS, (double)done / count);
    double middle = share_position(net->above, STRIPS, (done + 0.5 * size) / count);
    double lower = share_position(net->above, STRIPS, (double)(done + size) / count);
    double turn = 2.0 * PP_PI / net->bearings;
    sum_ring(net, upper, lower);
    for (int i = 0; i < size; i++)
        cells[done + i] = (struct pp_sky_cell){
            .low = altitude_of(lower),
            .high = altitude_of(upper),
            .from = turn * share_position(net->turn, net->bearings, (double)i / size),
            .to = turn * share_position(net->turn, net->bearings, (i + 1.0) / size),
            .altitude = size == 1 && done == 0 ? 0.5 * PP_PI : altitude_of(middle),
            .bearing =
                turn * share_position(net->turn, net->bearings, (i + 0.5) / size)};
}

enum pp_status pp_sky_cells(struct pp_sky_cell **cells, const struct pp_sky *sky,
                            int count, struct pp_error *err)
{
    struct net *net = malloc(sizeof *net);
    *cells = calloc((size_t)count, sizeof **cells);
    if (!net || !*cells) {
        free(net);
        free(*cells);
        *cells = NULL;
        return pp_fail_memory(err);
    }
    net->sky = sky;
    net->bearings = pp_sky_has_azimuth(sky) ? BEARINGS : 1;
    sum_strips(net);
    for (int done = 0; done < count;) {
        int size = ring_size(net, done, count);
        fill_ring(net, *cells, done, size, count);
        done += size;
    }
    free(net);
    return PP_OK;
}
