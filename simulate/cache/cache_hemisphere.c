/* cache_hemisphere.c - the rays of a hemisphere, and their distribution over its
 * cells. */
#include "simulate/cache/cache_hemisphere.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/sampling/hash.h"
#include "simulate/sampling/lobe.h"

/* A place may lie on an edge that its rays meet. Nearer hits are therefore moved to
 * this distance, so that gradients stay finite. */
static const double NEAREST_M = 1e-6;

/* Target relative standard error of an irradiance, and the most passes over all cells.
 * Pictures with 0.05 are as smooth as with 0.03, for half the computing time: the
 * office by --engine cache takes 0.7 s instead of 1.5 s. */
static const double ERROR = 0.05;
static const double PASSES_MOST = 16.0;

struct pp_vec3 *pp_cache_hemisphere_corners(int side)
{
    size_t count = (size_t)(side + 1) * (size_t)(side + 1);
    struct pp_vec3 *corners = malloc(count * sizeof *corners);
    for (int j = 0; corners && j <= side; j++)
        for (int i = 0; i <= side; i++)
            corners[j * (side + 1) + i] =
                pp_lobe_sample_cosine((double)i / side, (double)j / side);
    return corners;
}

/* Sends one more ray into cell k, as path `index`. */
static void send(struct pp_cache_hemisphere *h, struct pp_radiance_state *state,
                 const struct pp_cache_place *place, int k, uint32_t index)
{
    struct pp_cache_hemisphere_cell *cell = &h->cells[k];
    double u[2];
    state->index = index;
    pp_sobol_sequence_draw(&state->sequence, index, 0, 2, u);
    struct pp_vec3 to = pp_lobe_sample_cosine((k % h->side + u[0]) / h->side,
                                              (k / h->side + u[1]) / h->side);
    struct pp_light_ray ray = {place->point, place->normal, pp_frame_out(&h->frame, to),
                               place->space};
    struct pp_light_hit hit;
    struct pp_rgb radiance = pp_radiance_indirect(state, &ray, &hit);
    if (cell->samples == 0.0) {
        cell->to = to;
        cell->distance_m = hit.part >= 0 ? fmax(hit.distance_m, NEAREST_M) : INFINITY;
        cell->facing = pp_frame_in(&h->frame, hit.normal);
    }
    cell->samples += 1.0;
    cell->radiance = pp_rgb_along(cell->radiance, 1.0 / cell->samples,
                                  pp_rgb_sub(radiance, cell->radiance));
}

/* Assigns the cells' first paths in random order. Successive paths of a sequence are
 * spread evenly, so that a small contribution tends to follow a large one. If
 * neighbouring cells had successive paths, the estimate from a cell's neighbours would
 * depend on the cell's own ray. */
static void shuffle(struct pp_cache_hemisphere *h, uint64_t seed)
{
    for (uint32_t k = 0; k < (uint32_t)(h->side * h->side); k++) {
        uint32_t other = (uint32_t)(pp_hash(seed, k) % (k + 1));
        h->cells[k].path = h->cells[other].path;
        h->cells[other].path = k;
    }
}

/* Contrast among the luminances of cell k's neighbours. The cell's own luminance is
 * left out: if a high first sample brought a cell more samples, the mean would be
 * biased low. */
static double contrast_about(const struct pp_cache_hemisphere *h, int k)
{
    int n = h->side, i = k % n, j = k / n, count = 0;
    double seen[4], mean = 0.0, sum = 0.0;
    if (i > 0)
        seen[count++] = pp_rgb_luminance(h->cells[k - 1].radiance);
    if (i < n - 1)
        seen[count++] = pp_rgb_luminance(h->cells[k + 1].radiance);
    if (j > 0)
        seen[count++] = pp_rgb_luminance(h->cells[k - n].radiance);
    if (j < n - 1)
        seen[count++] = pp_rgb_luminance(h->cells[k + n].radiance);
    for (int m = 0; m < count; m++)
        mean += seen[m] / count;
    for (int m = 0; m < count; m++)
        sum += (seen[m] - mean) * (seen[m] - mean);
    return sqrt(sum);
}

/* Distributes extra rays in proportion to the contrast, cell by cell; fractions of a
 * ray are carried over. */
static void supersample(struct pp_cache_hemisphere *h, struct pp_radiance_state *state,
                        const struct pp_cache_place *place, int count)
{
    int cells = h->side * h->side;
    double total = 0.0, due = 0.0, dealt = 0.0;
    for (int k = 0; k < cells; k++)
        total += h->cells[k].contrast = contrast_about(h, k);
    if (!(total > 0.0))
        return;
    uint32_t index = (uint32_t)cells;
    for (int k = 0; k < cells; k++) {
        due += h->cells[k].contrast / total * count;
        for (; dealt + 1.0 <= due; dealt += 1.0)
            send(h, state, place, k, index++);
    }
}

/* Number of passes over all cells that reduces the irradiance's standard error to about
 * ERROR. The error is estimated from the first rays of every second row, from `first`
 * on, by the differences between neighbouring cells of a row. Real variation across the
 * hemisphere counts as error too, so the estimate tends to be too high. */
static int passes_by(const struct pp_cache_hemisphere *h, int first)
{
    int n = h->side;
    double sum = 0.0, squares = 0.0;
    for (int j = first; j < n; j += 2)
        for (int i = 0; i < n; i++) {
            double own = pp_rgb_luminance(h->cells[j * n + i].radiance);
            sum += own;
            if (i == 0)
                continue;
            double step = own - pp_rgb_luminance(h->cells[j * n + i - 1].radiance);
            squares += 0.5 * step * step;
        }
    /* The other half of the rows is assumed to have the same sum and squares. */
    double more = sum > 0.0 ? sqrt(0.5 * squares) / sum / ERROR : 0.0;
    return (int)fmax(fmin(more * more, PASSES_MOST), 1.0);
}

/* Sends more rays into all cells if a few rays carry most of the light, as is usual far
 * from a window. The odd rows decide the number of passes over the even rows, and vice
 * versa. If a row's own rays decided, rows that happened to be bright and to vary much
 * would get more rays. The mean would then be biased low (by 1.0 % in a dark corner of
 * the deep office, with 256 cells). */
static void add_passes(struct pp_cache_hemisphere *h, struct pp_radiance_state *state,
                       const struct pp_cache_place *place, const int passes[2],
                       uint32_t index)
{
    int n = h->side;
    for (int j = 0; j < n; j++)
        for (int pass = 1; pass < passes[j % 2]; pass++)
            for (int i = 0; i < n; i++)
                send(h, state, place, j * n + i, index++);
}

void pp_cache_hemisphere_sample(struct pp_cache_hemisphere *h,
                                struct pp_radiance_state *state,
                                const struct pp_cache_place *place, int supersamples)
{
    int cells = h->side * h->side;
    h->frame.z = place->normal;
    pp_lobe_frame(h->frame.z, &h->frame.x, &h->frame.y);
    for (int k = 0; k < cells; k++)
        h->cells[k] = (struct pp_cache_hemisphere_cell){.samples = 0.0};
    shuffle(h, state->sequence.seed);
    for (int k = 0; k < cells; k++)
        send(h, state, place, k, h->cells[k].path);
    const int passes[2] = {passes_by(h, 1), passes_by(h, 0)};
    if (supersamples > 0)
        supersample(h, state, place, supersamples);
    add_passes(h, state, place, passes, (uint32_t)(cells + supersamples));
    struct pp_rgb sum = pp_rgb_grey(0.0);
    for (int k = 0; k < cells; k++)
        sum = pp_rgb_add(sum, h->cells[k].radiance);
    h->irradiance = pp_rgb_scale(sum, PP_PI / cells);
}
