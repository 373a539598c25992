/* sky_bright.c - see sky_bright.h. */
#include "model/light/photographs/sky_bright.h"

#include <math.h>
#include <stdlib.h>

#include "model/light/photographs/sky_cube.h"
#include "model/light/photographs/sky_picture.h"

/* A cell is bright above this multiple of the mean luminance Eh/pi. */
static const double BRIGHT = 4.0;

/* Least share of the light that makes the density worth its samples. */
static const double LEAST_SHARE = 0.01;

/* The excess of a cell; 0 beyond the rows. */
static double excess_of(const struct pp_sky_bright *bright, int row, int column)
{
    if (row < 0 || row >= PP_SKY_PICTURE_ROWS)
        return 0.0;
    column = (column + PP_SKY_PICTURE_COLUMNS) % PP_SKY_PICTURE_COLUMNS;
    int cell = row * PP_SKY_PICTURE_COLUMNS + column;
    return fmax(0.0, (double)bright->sky.picture->cells[cell] - bright->least_cd_m2);
}

/* The density of a cell before normalisation. A sun that is smaller than a cell, or
 * lies at its edge, may be missing in the cell's mean: neighbours add a tenth each. */
static double density_of(const struct pp_sky_bright *bright, int cell)
{
    int row = cell / PP_SKY_PICTURE_COLUMNS, column = cell % PP_SKY_PICTURE_COLUMNS;
    double sum = 0.9 * excess_of(bright, row, column);
    for (int i = -1; i <= 1; i++)
        for (int k = -1; k <= 1; k++)
            sum += 0.1 * excess_of(bright, row + i, column + k);
    return sum;
}

/* Direction, in the axes of the picture, of a cell's point (a, b) from 0 to 1. */
static struct pp_vec3 point_of(int cell, double a, double b)
{
    int row = cell / PP_SKY_PICTURE_COLUMNS, column = cell % PP_SKY_PICTURE_COLUMNS;
    double foot = sin(row * PP_SKY_PICTURE_ROW_RAD),
           head = sin((row + 1) * PP_SKY_PICTURE_ROW_RAD);
    double z = foot + a * (head - foot);
    double bearing = (column + b) * PP_SKY_PICTURE_COLUMN_RAD,
           level = sqrt(fmax(0.0, 1.0 - z * z));
    return pp_vec(level * sin(bearing), level * cos(bearing), z);
}

/* Sets the densities of lamps: the light of the picture's cells within each, over its
 * area. */
static void measure_lamps(struct pp_sky_bright *bright)
{
    double area = 4.0 / (bright->edge * bright->edge);
    for (int i = 0; i < PP_SKY_PICTURE_CELLS; i++) {
        double light =
            (double)bright->sky.picture->cells[i] * pp_sky_picture_solid_angle(i);
        bright->density[pp_sky_cube_lamp(bright->edge, point_of(i, 0.5, 0.5), NULL)] +=
            (float)(light / area);
    }
}

static void measure_excess(struct pp_sky_bright *bright)
{
    for (int i = 0; i < PP_SKY_PICTURE_CELLS; i++)
        bright->density[i] = (float)density_of(bright, i);
}

/* Finds the bright cells and their cumulative probabilities. */
static void gather_bright_cells(struct pp_sky_bright *bright)
{
    int count = bright->edge ? pp_sky_cube_count(bright->edge) : PP_SKY_PICTURE_CELLS;
    for (int i = 0; i < count; i++) {
        if (!(bright->density[i] > 0.0F))
            continue;
        double size = bright->edge ? 4.0 / (bright->edge * bright->edge)
                                   : pp_sky_picture_solid_angle(i);
        bright->cells[bright->count] = i;
        bright->below[bright->count++] = bright->integral;
        bright->integral += (double)bright->density[i] * size;
    }
    for (int i = 0; i < bright->count; i++)
        bright->below[i] /= bright->integral;
}

/* Integral of the density divided by the light of the sky; at most 1. */
static double share_of(const struct pp_sky_bright *bright)
{
    double light = 0.0;
    for (int i = 0; i < PP_SKY_PICTURE_CELLS; i++)
        light += (double)bright->sky.picture->cells[i] * pp_sky_picture_solid_angle(i);
    return fmin(1.0, bright->integral / light);
}

enum pp_status pp_sky_bright_create(struct pp_sky_bright **result,
                                    const struct pp_sky *sky, struct pp_error *err)
{
    *result = NULL;
    if (sky->kind != PP_SKY_PICTURE || sky->picture->sampling == PP_SKY_SAMPLE_CHANCE)
        return PP_OK;
    struct pp_sky_bright *bright = calloc(1, sizeof *bright);
    if (!bright)
        return pp_fail_memory(err);
    bright->sky = *sky;
    bright->least_cd_m2 = BRIGHT * sky->picture->horizontal_lx / PP_PI;
    bright->cells = malloc(PP_SKY_PICTURE_CELLS * sizeof *bright->cells);
    bright->below = malloc(PP_SKY_PICTURE_CELLS * sizeof *bright->below);
    bright->density = calloc(PP_SKY_PICTURE_CELLS, sizeof *bright->density);
    if (!bright->cells || !bright->below || !bright->density) {
        pp_sky_bright_destroy(bright);
        return pp_fail_memory(err);
    }
    if (sky->picture->sampling == PP_SKY_SAMPLE_LAMPS) {
        bright->edge = sky->picture->lamps;
        measure_lamps(bright);
    } else {
        measure_excess(bright);
    }
    gather_bright_cells(bright);
    bright->share = share_of(bright);
    if (!(bright->share > LEAST_SHARE)) {
        pp_sky_bright_destroy(bright);
        return PP_OK;
    }
    for (int i = 0; i < PP_SKY_BRIGHT_SOME; i++)
        bright->some[i] = pp_sky_bright_draw(bright, (i + 0.5) / PP_SKY_BRIGHT_SOME,
                                             fmod((i + 0.5) * 0.618033988749895, 1.0));
    *result = bright;
    return PP_OK;
}

void pp_sky_bright_destroy(struct pp_sky_bright *bright)
{
    if (!bright)
        return;
    free(bright->cells);
    free(bright->below);
    free(bright->density);
    free(bright);
}

struct pp_vec3 pp_sky_bright_draw(const struct pp_sky_bright *bright, double u,
                                  double v)
{
    int low = 0, high = bright->count;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (bright->below[middle] <= u)
            low = middle;
        else
            high = middle;
    }
    double end = low + 1 < bright->count ? bright->below[low + 1] : 1.0;
    double within =
        fmin(1.0, fmax(0.0, (u - bright->below[low]) / (end - bright->below[low])));
    int cell = bright->cells[low];
    return pp_sky_from_north(
        &bright->sky, bright->edge ? pp_sky_cube_point(bright->edge, cell, within, v)
                                   : point_of(cell, within, v));
}

double pp_sky_bright_pdf(const struct pp_sky_bright *bright, struct pp_vec3 to)
{
    if (!(to.z > 0.0))
        return 0.0;
    struct pp_vec3 u = pp_sky_to_north(&bright->sky, to);
    if (bright->edge) {
        double solid_angle;
        int lamp = pp_sky_cube_lamp(bright->edge, u, &solid_angle);
        return (double)bright->density[lamp] / solid_angle / bright->integral;
    }
    return (double)bright->density[pp_sky_picture_cell(u)] / bright->integral;
}
