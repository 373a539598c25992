/* year_product.c - calculates four rows and sixteen hours at a time, in registers. */
#include "simulate/year/year_product.h"

#include "simulate/sampling/lanes.h"

typedef float float_lanes __attribute__((vector_size(32)));

enum { ROWS = 4, HALF = PP_LIGHT_LANES / 2 };

/* The sums of up to four rows over one tile; rows beyond `count` repeat the last. */
PP_LANES_BODY void tile_sums(float *out, size_t out_step, const float *rows, int count,
                             const float *tile, int columns)
{
    const float *row[ROWS];
    float_lanes s0 = {0.0f}, s1 = s0, s2 = s0, s3 = s0; /* first half of the hours */
    float_lanes t0 = s0, t1 = s0, t2 = s0, t3 = s0;     /* second half */
    for (int r = 0; r < ROWS; r++)
        row[r] = rows + (size_t)(r < count ? r : count - 1) * (size_t)columns;
    for (int k = 0; k < columns; k++) {
        float_lanes low, high;
        __builtin_memcpy(&low, tile + (size_t)k * PP_LIGHT_LANES, sizeof low);
        __builtin_memcpy(&high, tile + (size_t)k * PP_LIGHT_LANES + HALF, sizeof high);
        s0 += low * row[0][k];
        t0 += high * row[0][k];
        s1 += low * row[1][k];
        t1 += high * row[1][k];
        s2 += low * row[2][k];
        t2 += high * row[2][k];
        s3 += low * row[3][k];
        t3 += high * row[3][k];
    }
    const float_lanes sums[ROWS][2] = {{s0, t0}, {s1, t1}, {s2, t2}, {s3, t3}};
    for (int r = 0; r < count; r++)
        __builtin_memcpy(out + (size_t)r * out_step, sums[r], sizeof sums[r]);
}

PP_LANES_BODY void all_sums(float *out, const float *rows, int row_count,
                            const struct pp_light_columns *light)
{
    size_t step = (size_t)light->tiles * PP_LIGHT_LANES;
    for (int tile = 0; tile < light->tiles; tile++) {
        const float *at = light->columns
                          + (size_t)tile * (size_t)light->column_count * PP_LIGHT_LANES;
        for (int r = 0; r < row_count; r += ROWS) {
            int count = row_count - r < ROWS ? row_count - r : ROWS;
            tile_sums(out + (size_t)r * step + (size_t)tile * PP_LIGHT_LANES, step,
                      rows + (size_t)r * (size_t)light->column_count, count, at,
                      light->column_count);
        }
    }
}

static void narrow_sums(float *out, const float *rows, int row_count,
                        const struct pp_light_columns *light)
{
    all_sums(out, rows, row_count, light);
}

PP_LANES_WIDE static void wide_sums(float *out, const float *rows, int row_count,
                                    const struct pp_light_columns *light)
{
    all_sums(out, rows, row_count, light);
}

void pp_year_product(float *out, const float *rows, int row_count,
                     const struct pp_light_columns *light)
{
    if (pp_lanes_are_wide())
        wide_sums(out, rows, row_count, light);
    else
        narrow_sums(out, rows, row_count, light);
}
