/* control_variate.c - reads the radiosity solution at a point, by interpolation. */
#include "simulate/fast/control_variate.h"

#include <stdlib.h>

#include "simulate/scene/light_scene_parts.h"

void pp_control_variate_destroy(struct pp_control_variate *variate)
{
    if (!variate)
        return;
    free(variate->grids);
    free(variate->values);
    free(variate);
}

/* Clamps a coordinate (unit: patches) to the range from the first to the last centre.
 * Puts its integer part in *patch and returns the fraction. Avoids a call of
 * floor(). */
static double within(double x, int count, int *patch)
{
    double last = count - 1;
    x = x > 0.0 ? x < last ? x : last : 0.0;
    *patch = (int)x;
    return x - *patch;
}

double pp_control_variate_at(const struct pp_control_variate *variate,
                             const struct pp_light_scene *scene,
                             const struct pp_light_hit *hit)
{
    const struct pp_control_variate_grid *grid = &variate->grids[hit->part][hit->back];
    if (grid->first < 0)
        return 0.0;
    const struct pp_light_part *part = &scene->parts[hit->part];
    int column, row;
    double s = within((pp_vec_dot(hit->point, part->a) - grid->a0) * grid->per_a,
                      grid->columns, &column);
    double t = within((pp_vec_dot(hit->point, part->b) - grid->b0) * grid->per_b,
                      grid->rows, &row);
    int right = column + 1 < grid->columns, above = row + 1 < grid->rows;
    const double *low = &variate->values[grid->first + row * grid->columns + column];
    const double *high = low + above * grid->columns;
    double below = low[0] + s * (low[right] - low[0]);
    double over = high[0] + s * (high[right] - high[0]);
    return below + t * (over - below);
}

double pp_control_variate_of_side(void *variate, const struct pp_light_hit *side,
                                  double worth)
{
    (void)worth;
    const struct pp_control_variate *solution = variate;
    return pp_control_variate_at(solution, solution->scene, side);
}

int pp_control_variate_nearest(const struct pp_control_variate *variate,
                               const struct pp_light_scene *scene,
                               const struct pp_light_hit *hit)
{
    const struct pp_control_variate_grid *grid = &variate->grids[hit->part][hit->back];
    if (grid->first < 0)
        return -1;
    const struct pp_light_part *part = &scene->parts[hit->part];
    double a = (pp_vec_dot(hit->point, part->a) - grid->a0) * grid->per_a + 0.5;
    double b = (pp_vec_dot(hit->point, part->b) - grid->b0) * grid->per_b + 0.5;
    int column = a < 0.0 ? 0 : a < grid->columns ? (int)a : grid->columns - 1;
    int row = b < 0.0 ? 0 : b < grid->rows ? (int)b : grid->rows - 1;
    return grid->first + row * grid->columns + column;
}
