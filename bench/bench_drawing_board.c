/* bench_drawing_board.c - errors of the Waldram diagram and the pepper-pot
 * diagram, for windows of different sizes.
 *
 * w is the width of the window, h the height of its head above the point, and d the
 * distance of the point. Area: excess of the exact area on the Waldram diagram over the
 * sky component, in per cent of the sky component. Squares, dots: error of the sky
 * component by counting squares or dots, in per cent daylight factor. Each row contains
 * 500 random windows with clear single glazing, under the overcast sky. Sills are at no
 * more than half the height of the head. The lateral offset of the point from the
 * middle of the window is no more than its distance.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "methods/pepper_pot/pepper_pot_dots.h"
#include "methods/waldram/waldram_squares.h"

enum { BINS = 4, WINDOWS = 500, PANELS = 160 };
static const double edges[BINS + 1] = {0.1, 0.5, 1.0, 2.0, 4.0};

static double next(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-53;
}

/* A window at unit distance: a0 to a1 across, b0 to b1 up. */
struct window {
    double a0, a1, b0, b1;
};

static struct window random_window(uint64_t *seed, int wide, int high)
{
    double width = edges[wide] + (edges[wide + 1] - edges[wide]) * next(seed);
    double head = edges[high] + (edges[high + 1] - edges[high]) * next(seed);
    double middle = 2.0 * next(seed) - 1.0, sill = 0.5 * head * next(seed);
    return (struct window){middle - width / 2.0, middle + width / 2.0, sill, head};
}

/* Sky component by the midpoint rule, with a relative error of 1e-5. */
static double integral(const struct window *window, const struct pp_sky *sky,
                       const struct pp_glass *glass)
{
    double da = (window->a1 - window->a0) / PANELS;
    double db = (window->b1 - window->b0) / PANELS, sum = 0.0;
    for (int i = 0; i < PANELS; i++)
        for (int k = 0; k < PANELS; k++) {
            double a = window->a0 + (i + 0.5) * da, b = window->b0 + (k + 0.5) * db;
            double length = sqrt(1.0 + a * a + b * b), s = b / length;
            struct pp_vec3 u = pp_vec(a / length, 1.0 / length, s);
            sum += pp_sky_luminance(sky, u)
                   * pp_glass_transmittance(glass, 1.0 / length) * s
                   / (length * length * length);
        }
    return sum * da * db;
}

struct spread {
    double mean, rms, high, worst;
};

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Mean, rms, 95th percentile and largest absolute value. Replaces the values of `off`
 * by their absolute values, in ascending order. */
static struct spread spread_of(double *off, int count)
{
    struct spread spread = {0};
    for (int i = 0; i < count; i++) {
        spread.mean += off[i] / count;
        spread.rms += off[i] * off[i] / count;
        off[i] = fabs(off[i]);
    }
    spread.rms = sqrt(spread.rms);
    qsort(off, count, sizeof *off, ascending);
    spread.high = off[(int)(0.95 * count)];
    spread.worst = off[count - 1];
    return spread;
}

struct diagrams {
    struct pp_sky sky;
    struct pp_waldram waldram;
    struct pp_pepper_pot *pot;
};

/* Errors for each window of one shape. The errors by area are relative to the integral;
 * the errors by squares and dots are differences in sky component. */
static void measure(const struct diagrams *diagrams, int wide, int high, double *area,
                    double *squares, double *dots)
{
    static const struct pp_window_axes axes = {
        {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}};
    uint64_t seed = 1000u + 10u * wide + high;
    for (int i = 0; i < WINDOWS; i++) {
        struct window w = random_window(&seed, wide, high);
        double corners[4][2] = {{w.a0, w.b0}, {w.a1, w.b0}, {w.a1, w.b1}, {w.a0, w.b1}};
        struct pp_ring ring = {4, corners};
        const struct pp_region region = {1, &ring};
        double exact = integral(&w, &diagrams->sky, &diagrams->waldram.glass);
        struct pp_waldram_count count = {0};
        if (pp_waldram_squares_count(&count, &diagrams->waldram, &axes, &region, NULL)
            != PP_OK)
            exit(1);
        area[i] =
            pp_waldram_scale_area(&diagrams->waldram, &axes, &region) / exact - 1.0;
        squares[i] = count.squares * PP_WALDRAM_WORTH - exact;
        dots[i] =
            pp_pepper_pot_dots_count(diagrams->pot, &region) * diagrams->pot->worth
            - exact;
        pp_waldram_squares_clear(&count);
    }
}

int main(void)
{
    struct diagrams diagrams = {.sky = pp_sky_overcast()};
    if (pp_waldram_scale_init(&diagrams.waldram, &diagrams.sky, true, NULL) != PP_OK
        || pp_pepper_pot_dots_create(&diagrams.pot, &diagrams.sky, true, false, 0.0,
                                     PP_PEPPER_POT_WORTH, NULL)
               != PP_OK)
        return 1;
    puts("w/d        h/d        area over the integral, %          squares, % DF"
         "     dots, % DF");
    puts("                      mean   rms    95 %   worst          mean   rms"
         "        mean   rms");
    for (int wide = 0; wide < BINS; wide++)
        for (int high = 0; high < BINS; high++) {
            double off[3][WINDOWS];
            measure(&diagrams, wide, high, off[0], off[1], off[2]);
            struct spread area = spread_of(off[0], WINDOWS);
            struct spread squares = spread_of(off[1], WINDOWS);
            struct spread dots = spread_of(off[2], WINDOWS);
            printf("%.1f to %.1f %.1f to %.1f %6.2f %6.2f %6.2f %6.2f        %7.3f "
                   "%6.3f    %7.3f %6.3f\n",
                   edges[wide], edges[wide + 1], edges[high], edges[high + 1],
                   100.0 * area.mean, 100.0 * area.rms, 100.0 * area.high,
                   100.0 * area.worst, 100.0 * squares.mean, 100.0 * squares.rms,
                   100.0 * dots.mean, 100.0 * dots.rms);
        }
    pp_pepper_pot_dots_destroy(diagrams.pot);
    return 0;
}
