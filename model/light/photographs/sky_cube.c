/* sky_cube.c - see sky_cube.h. */
#include "model/light/photographs/sky_cube.h"

#include <math.h>

int pp_sky_cube_count(int edge)
{
    return 3 * edge * edge;
}

/* Index of x from -1 to 1 among `edge` equal intervals. */
static int interval_of(double x, int edge)
{
    int index = (int)((x + 1.0) / 2.0 * edge);
    return index < edge ? index : edge - 1;
}

int pp_sky_cube_lamp(int edge, struct pp_vec3 u, double *solid_angle)
{
    double ax = fabs(u.x), ay = fabs(u.y), far = fmax(u.z, fmax(ax, ay));
    if (solid_angle)
        *solid_angle = far * far * far;
    if (far == u.z)
        return interval_of(u.y / far, edge) * edge + interval_of(u.x / far, edge);
    int side = far == ax ? (u.x > 0.0 ? 0 : 1) : (u.y > 0.0 ? 2 : 3);
    int row = interval_of(u.z / far, edge) - edge / 2;
    int column = interval_of((side < 2 ? u.y : u.x) / far, edge);
    return edge * edge + (side * edge / 2 + row) * edge + column;
}

struct pp_vec3 pp_sky_cube_point(int edge, int lamp, double a, double b)
{
    int row = lamp / edge, column = lamp % edge;
    double x = 2.0 * (column + a) / edge - 1.0;
    if (row < edge)
        return pp_vec_unit(pp_vec(x, 2.0 * (row + b) / edge - 1.0, 1.0));
    int half = edge / 2, side = (row - edge) / half;
    double z = ((row - edge) % half + b) / half, toward = side % 2 == 0 ? 1.0 : -1.0;
    return pp_vec_unit(side < 2 ? pp_vec(toward, x, z) : pp_vec(x, toward, z));
}
