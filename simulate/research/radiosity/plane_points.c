/* plane_points.c - see plane_points.h. */
#include "simulate/research/radiosity/plane_points.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/clipper.h"

static const double NOTHING = 1e-9; /* filled fraction below which a square counts as
                                     * empty; above 1 - NOTHING it counts as full */

/* Position, 0 to 1, of the point of row or column `index` within its square. The
 * position follows van der Corput's sequence, so that it differs for all of `count`
 * rows or columns. */
static double place_within(int index, int count)
{
    double place = 0.0, half = 0.5;
    for (; count > 1; count = (count + 1) / 2, index /= 2, half *= 0.5)
        place += index % 2 * half;
    return place + half;
}

static enum pp_status append_plane_point(struct pp_plane_points *points, double x,
                                         double y, double z, double area,
                                         struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&points->list, points->count, sizeof *points->list, err);
    if (status == PP_OK)
        status = pp_array_append(&points->shares, points->count, sizeof *points->shares,
                                 err);
    if (status != PP_OK)
        return status;
    points->list[points->count] = pp_vec(x, y, z);
    points->shares[points->count++] = area;
    return PP_OK;
}

static enum pp_status add_plane_triangles(struct pp_plane_points *points,
                                          struct pp_clipper *clipper,
                                          const struct pp_region *region, double z,
                                          struct pp_error *err)
{
    double(*t)[3][2] = NULL;
    int count = 0;
    enum pp_status status = pp_clipper_triangulate(clipper, &t, &count, region, err);
    for (int i = 0; status == PP_OK && i < count; i++)
        status = append_plane_point(
            points, (t[i][0][0] + t[i][1][0] + t[i][2][0]) / 3.0,
            (t[i][0][1] + t[i][1][1] + t[i][2][1]) / 3.0, z,
            0.5 * fabs(pp_region_turn(t[i][0], t[i][1], t[i][2])), err);
    free(t);
    return status;
}

/* Adds the point of a square whose lower corner is (x, y). If the plane fills only a
 * part of the square, adds the points of the triangles of that part. within: relative
 * position of the point in both directions. */
static enum pp_status add_square(struct pp_plane_points *points,
                                 struct pp_clipper *clipper,
                                 const struct pp_world *world, double x, double y,
                                 const double size[2], const double within[2],
                                 struct pp_error *err)
{
    double xy[4][2] = {
        {x, y}, {x + size[0], y}, {x + size[0], y + size[1]}, {x, y + size[1]}};
    struct pp_ring ring = {4, xy};
    struct pp_region square = {1, &ring}, filled = {0, NULL};
    enum pp_status status =
        pp_clipper_intersection(clipper, &filled, &world->plane, &square, err);
    double area = size[0] * size[1], share = pp_region_area(&filled) / area;
    if (status == PP_OK && share > 1.0 - NOTHING)
        status =
            append_plane_point(points, x + within[0] * size[0], y + within[1] * size[1],
                               world->working_plane_m, area, err);
    else if (status == PP_OK && share > NOTHING)
        status =
            add_plane_triangles(points, clipper, &filled, world->working_plane_m, err);
    pp_region_clear(&filled);
    return status;
}

static enum pp_status fill_plane_points(struct pp_plane_points *points,
                                        struct pp_clipper *clipper,
                                        const struct pp_world *world, int wanted,
                                        struct pp_error *err)
{
    struct pp_bounds2 box = pp_region_bounds(&world->plane);
    double width = box.high[0] - box.low[0], depth = box.high[1] - box.low[1];
    double edge = sqrt(width * depth / wanted), whole = 0.0;
    int columns = (int)fmax(1.0, round(width / edge));
    int rows = (int)fmax(1.0, round(depth / edge));
    const double size[2] = {width / columns, depth / rows};
    enum pp_status status = PP_OK;
    for (int i = 0; i < columns; i++)
        for (int k = 0; status == PP_OK && k < rows; k++) {
            double within[2] = {place_within(k, rows), place_within(i, columns)};
            status = add_square(points, clipper, world, box.low[0] + i * size[0],
                                box.low[1] + k * size[1], size, within, err);
        }
    for (int i = 0; i < points->count; i++)
        whole += points->shares[i];
    for (int i = 0; i < points->count; i++)
        points->shares[i] /= whole;
    return status;
}

enum pp_status pp_plane_points_of(struct pp_plane_points *points,
                                  const struct pp_world *world, int wanted,
                                  struct pp_error *err)
{
    struct pp_clipper *clipper = NULL;
    *points = (struct pp_plane_points){NULL, NULL, 0};
    if (world->plane.count == 0)
        return PP_OK;
    enum pp_status status = pp_clipper_create(&clipper, err);
    if (status == PP_OK)
        status = fill_plane_points(points, clipper, world, wanted, err);
    pp_clipper_destroy(clipper);
    if (status != PP_OK)
        pp_plane_points_clear(points);
    return status;
}

void pp_plane_points_clear(struct pp_plane_points *points)
{
    free(points->list);
    free(points->shares);
    *points = (struct pp_plane_points){NULL, NULL, 0};
}
