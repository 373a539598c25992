/* plane_average.c - see plane_average.h. */
#include "methods/plane_average.h"

#include <cubature.h>
#include <stdlib.h>

/* A piece of the plane: origin + s (a + t b) for s and t from 0 to 1 is a triangle,
 * origin + s a + t b a parallelogram. */
struct piece {
    double origin[2], a[2], b[2];
    bool triangle;
    double area_m2;
};

struct integral {
    const struct pp_world *world;
    pp_plane_function *function;
    void *data;
    const struct piece *piece;
};

/* Value at (s, t) times the area element. */
static bool at_point(const struct integral *integral, const double st[2],
                     double values[PP_PLANE_VALUES])
{
    const struct piece *piece = integral->piece;
    double s = st[0], t = piece->triangle ? st[0] * st[1] : st[1];
    double element = piece->triangle ? 2.0 * piece->area_m2 * st[0] : piece->area_m2;
    struct pp_receiver receiver = {
        .position = {piece->origin[0] + s * piece->a[0] + t * piece->b[0],
                     piece->origin[1] + s * piece->a[1] + t * piece->b[1],
                     integral->world->working_plane_m},
        .normal = {0.0, 0.0, 1.0},
    };
    if (!integral->function(integral->data, &receiver, values))
        return false;
    for (int k = 0; k < PP_PLANE_VALUES; k++)
        values[k] *= element;
    return true;
}

static int at_points(unsigned dim, size_t count, const double *st, void *data,
                     unsigned fdim, double *values)
{
    (void)dim, (void)fdim;
    int stopped = 0;
#pragma omp parallel for schedule(dynamic, 4) if (count > 8)
    for (size_t i = 0; i < count; i++)
        if (!at_point(data, st + 2 * i, values + PP_PLANE_VALUES * i)) {
#pragma omp atomic write
            stopped = 1;
        }
    return stopped;
}

/* Is the region one rectangle with level and upright edges? */
static bool is_upright_rectangle(const struct pp_region *region)
{
    if (region->count != 1 || region->rings[0].count != 4)
        return false;
    double(*xy)[2] = region->rings[0].xy;
    for (int i = 0; i < 4; i++) {
        const double *a = xy[i], *b = xy[(i + 1) % 4];
        if ((a[0] != b[0]) == (a[1] != b[1]))
            return false;
    }
    return true;
}

/* The pieces of the plane, to be freed. */
static enum pp_status cut_up(struct piece **pieces, int *count,
                             const struct pp_region *plane, struct pp_error *err)
{
    if (is_upright_rectangle(plane)) {
        double(*xy)[2] = plane->rings[0].xy;
        *pieces = malloc(sizeof **pieces);
        if (!*pieces)
            return pp_fail_memory(err);
        *count = 1;
        **pieces = (struct piece){
            .origin = {xy[0][0], xy[0][1]},
            .a = {xy[1][0] - xy[0][0], xy[1][1] - xy[0][1]},
            .b = {xy[3][0] - xy[0][0], xy[3][1] - xy[0][1]},
            .area_m2 = pp_region_area(plane),
        };
        return PP_OK;
    }

    struct pp_clipper *clipper = NULL;
    double(*triangles)[3][2] = NULL;
    enum pp_status status = pp_clipper_create(&clipper, err);
    if (status == PP_OK)
        status = pp_region_triangulate(clipper, &triangles, count, plane, err);
    pp_clipper_destroy(clipper);
    if (status != PP_OK)
        return status;
    *pieces = malloc(((size_t)*count + 1) * sizeof **pieces);
    if (!*pieces) {
        free(triangles);
        return pp_fail_memory(err);
    }
    for (int i = 0; i < *count; i++) {
        double(*p)[2] = triangles[i];
        struct piece *piece = *pieces + i;
        *piece = (struct piece){
            .origin = {p[0][0], p[0][1]},
            .a = {p[1][0] - p[0][0], p[1][1] - p[0][1]},
            .b = {p[2][0] - p[1][0], p[2][1] - p[1][1]},
            .triangle = true,
        };
        piece->area_m2 =
            fabs(piece->a[0] * piece->b[1] - piece->a[1] * piece->b[0]) / 2.0;
    }
    free(triangles);
    return PP_OK;
}

/* One piece's integrals, to an absolute or a relative error of their sum. */
static int integrate(struct integral *integral, int most_points, double absolute,
                     double relative, double value[PP_PLANE_VALUES])
{
    double low[2] = {0.0, 0.0}, high[2] = {1.0, 1.0}, error[PP_PLANE_VALUES];
    return hcubature_v(PP_PLANE_VALUES, at_points, integral, 2, low, high,
                       (size_t)most_points, absolute, relative, ERROR_L1, value, error);
}

enum pp_status pp_plane_average(double mean[PP_PLANE_VALUES], bool *stopped,
                                const struct pp_world *world,
                                pp_plane_function *function, void *data,
                                double relative_error, int most_points,
                                struct pp_error *err)
{
    struct piece *pieces = NULL;
    int count = 0;
    *stopped = false;
    enum pp_status status = cut_up(&pieces, &count, &world->plane, err);
    if (status != PP_OK)
        return status;
    double area_m2 = 0.0;
    for (int i = 0; i < count; i++)
        area_m2 += pieces[i].area_m2;
    if (!(area_m2 > 0.0)) {
        free(pieces);
        return pp_fail(err, PP_BAD_INPUT,
                       "the room has no working plane at a height of %g m",
                       world->working_plane_m);
    }

    /* A first sight of the whole tells how exact each piece has to be. */
    struct integral integral = {world, function, data, NULL};
    double absolute = 0.0;
    enum { FIRST_POINTS = 17 };
    for (int i = 0; i < count && count > 1 && !*stopped; i++) {
        double value[PP_PLANE_VALUES] = {0};
        integral.piece = pieces + i;
        *stopped = integrate(&integral, FIRST_POINTS, 0.0, 1.0, value) != 0;
        for (int k = 0; k < PP_PLANE_VALUES; k++)
            absolute += relative_error * value[k];
    }

    double sum[PP_PLANE_VALUES] = {0};
    for (int i = 0; i < count && !*stopped; i++) {
        double value[PP_PLANE_VALUES] = {0};
        double share = pieces[i].area_m2 / area_m2;
        integral.piece = pieces + i;
        *stopped = integrate(&integral, (int)fmax(most_points * share, FIRST_POINTS),
                             absolute * share, relative_error, value)
                   != 0;
        for (int k = 0; k < PP_PLANE_VALUES; k++)
            sum[k] += value[k];
    }
    for (int k = 0; k < PP_PLANE_VALUES; k++)
        mean[k] = sum[k] / area_m2;
    free(pieces);
    return PP_OK;
}
