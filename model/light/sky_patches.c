/* sky_patches.c - see sky_patches.h. */
#include "model/light/sky_patches.h"

#include <math.h>

#include "model/geometry/min_max.h"

bool pp_sky_patches_init(struct pp_sky_patches *patches, int count, double north_rad)
{
    static const int tregenza[] = {30, 30, 24, 24, 18, 12, 6};
    int n = count == 145 ? 1 : count == 577 ? 2 : count == 2305 ? 4 : 0;
    *patches = (struct pp_sky_patches){
        .count = count, .row_count = 7 * n + 1, .north_rad = north_rad};
    if (n == 0)
        return false;
    patches->row_height_rad = PP_PI / 2.0 / (7 * n + 0.5);
    for (int r = 0; r < 7 * n; r++)
        patches->first[r + 1] = patches->first[r] + n * tregenza[r / n];
    patches->first[7 * n + 1] = count;
    return true;
}

int pp_sky_patches_of(const struct pp_sky_patches *patches, struct pp_vec3 u)
{
    double altitude = asin(pp_clamp(u.z, 0.0, 1.0));
    int row = (int)(altitude / patches->row_height_rad);
    if (row >= patches->row_count)
        row = patches->row_count - 1;
    int count = patches->first[row + 1] - patches->first[row];
    double turn = (atan2(u.x, u.y) + patches->north_rad) / (2.0 * PP_PI);
    int column = (int)floor(turn * count + 0.5) % count;
    return patches->first[row] + (column + count) % count;
}

static int row_of(const struct pp_sky_patches *patches, int index)
{
    int row = 0;
    while (index >= patches->first[row + 1])
        row++;
    return row;
}

struct pp_vec3 pp_sky_patches_centre(const struct pp_sky_patches *patches, int index)
{
    int row = row_of(patches, index);
    if (row == patches->row_count - 1)
        return pp_vec(0.0, 0.0, 1.0);
    int count = patches->first[row + 1] - patches->first[row];
    double altitude = (row + 0.5) * patches->row_height_rad;
    double bearing =
        2.0 * PP_PI * (index - patches->first[row]) / count - patches->north_rad;
    return pp_vec_at_bearing(bearing, altitude);
}

double pp_sky_patches_solid_angle(const struct pp_sky_patches *patches, int index)
{
    int row = row_of(patches, index);
    double low = row * patches->row_height_rad;
    double high =
        row == patches->row_count - 1 ? PP_PI / 2.0 : low + patches->row_height_rad;
    int count = patches->first[row + 1] - patches->first[row];
    return 2.0 * PP_PI / count * (sin(high) - sin(low));
}
