/* traced_plane.c - chooses the points, and interpolates between them by moving least
 * squares. */
#include "studies/traced_plane.h"

#include <math.h>
#include <stdlib.h>

#include "methods/direct_plane.h"
#include "methods/method.h"
#include "model/base/array.h"
#include "model/geometry/bounds.h"
#include "model/results/common_error.h"
#include "model/room/position.h"
#include "studies/moving_fit.h"

/* Approximate number of squares over the plane, before squares near openings are
 * halved, and their greatest side (m). */
static const double squares = 240.0, largest_m = 0.45;

/* A square is halved, at most twice, if the distance to an opening is less than this
 * number of its sides. */
static const double near_sides = 2.0;
enum { HALVINGS = 2 };

/* Radius within which points have weight, in sides of the square at that position. */
static const double reach_sides = 2.6;

/* Least distance of a point from the edge of the plane (m). looked_from_m: distance by
 * which a position on the edge is moved inside for the visibility test, which is
 * undefined on the edge. */
static const double inset_m = 0.005, looked_from_m = 0.001;

enum { NEIGHBOURS_LEAST = 10, NEIGHBOURS_MOST = 128 };

struct plane_point {
    double x, y;
    double rest, error;
    bool known;
};

/* A line segment on the plane that blocks the view between points. */
struct plane_screen {
    double a[2], b[2];
};

struct pp_traced_plane {
    const struct pp_world *world;
    struct pp_direct_plane *direct; /* by `exact`; NULL: it does not cover the room */
    double external; /* ratio of simulated externally reflected light to that of
                      * `exact` */
    double side_m;   /* side of the squares before halving */
    double common;   /* common fraction of the variance of neighbouring points */
    struct plane_point *points;
    int count;
    struct plane_screen *screens;
    int screen_count;
    struct plane_screen *openings; /* openings as line segments in plan */
    int opening_count;
    int *cells; /* index of the first point in each cell of a lattice of spacing side_m;
                 * its `next` is the following point */
    int *next;
    int columns, rows;
    double low[2];
};

/* ---- visibility ---- */

static double side_of_line(const double a[2], const double b[2], double x, double y)
{
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

static bool crosses(const struct plane_screen *screen, const double p[2],
                    const double q[2])
{
    double a = side_of_line(screen->a, screen->b, p[0], p[1]);
    double b = side_of_line(screen->a, screen->b, q[0], q[1]);
    double c = side_of_line(p, q, screen->a[0], screen->a[1]);
    double d = side_of_line(p, q, screen->b[0], screen->b[1]);
    return a * b < 0.0 && c * d < 0.0;
}

static bool is_in_sight(const struct pp_traced_plane *plane, const double p[2],
                        const struct plane_point *point)
{
    const double q[2] = {point->x, point->y};
    for (int i = 0; i < plane->screen_count; i++)
        if (crosses(&plane->screens[i], p, q))
            return false;
    return true;
}

static enum pp_status add_screen(struct pp_traced_plane *plane, const double a[2],
                                 const double b[2], struct pp_error *err)
{
    enum pp_status status = pp_array_append(&plane->screens, plane->screen_count,
                                            sizeof *plane->screens, err);
    if (status == PP_OK)
        plane->screens[plane->screen_count++] =
            (struct plane_screen){{a[0], a[1]}, {b[0], b[1]}};
    return status;
}

/* Adds the line segments in which the plane cuts a surface in the room. */
static enum pp_status add_cut(struct pp_traced_plane *plane,
                              const struct pp_polygon *outline, struct pp_error *err)
{
    double height = plane->world->working_plane_m, ends[2][2];
    enum pp_status status = PP_OK;
    for (int i = 0, count = 0; i < outline->count && status == PP_OK; i++) {
        struct pp_vec3 a = outline->vertices[i];
        struct pp_vec3 b = outline->vertices[(i + 1) % outline->count];
        if ((a.z > height) == (b.z > height))
            continue;
        struct pp_vec3 p =
            pp_vec_along(a, (height - a.z) / (b.z - a.z), pp_vec_sub(b, a));
        ends[count % 2][0] = p.x;
        ends[count % 2][1] = p.y;
        if (++count % 2 == 0)
            status = add_screen(plane, ends[0], ends[1], err);
    }
    return status;
}

/* Finds the edges of the plane, unless it is a simple quadrilateral, and the objects on
 * it. */
static enum pp_status find_screens(struct pp_traced_plane *plane, struct pp_error *err)
{
    const struct pp_world *world = plane->world;
    const struct pp_region *region = &world->plane;
    enum pp_status status = PP_OK;
    bool plain = region->count == 1 && region->rings[0].count == 4;
    for (int r = 0; r < region->count && !plain; r++)
        for (int i = 0; i < region->rings[r].count && status == PP_OK; i++)
            status =
                add_screen(plane, region->rings[r].xy[i],
                           region->rings[r].xy[(i + 1) % region->rings[r].count], err);
    for (int i = world->face_count; i < world->surface_count && status == PP_OK; i++)
        if (world->surfaces[i].inside && world->surfaces[i].role == PP_FREE_SURFACE)
            status = add_cut(plane, &world->surfaces[i].outline, err);
    return status;
}

/* ---- the points ---- */

static double distance_to(const struct plane_screen *line, double x, double y)
{
    double dx = line->b[0] - line->a[0], dy = line->b[1] - line->a[1];
    double square = dx * dx + dy * dy, share = 0.0;
    if (square > 0.0)
        share = ((x - line->a[0]) * dx + (y - line->a[1]) * dy) / square;
    share = fmin(fmax(share, 0.0), 1.0);
    return hypot(line->a[0] + share * dx - x, line->a[1] + share * dy - y);
}

/* Finds the openings as segments in plan: the longest between two of their corners. */
static enum pp_status find_openings(struct pp_traced_plane *plane, struct pp_error *err)
{
    const struct pp_world *world = plane->world;
    plane->openings = calloc((size_t)world->opening_count + 1, sizeof *plane->openings);
    if (!plane->openings)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_polygon *outline = &world->openings[i].inner;
        /* An opening high above the plane lights the plane evenly. */
        double low = INFINITY;
        for (int k = 0; k < outline->count; k++)
            low = fmin(low, outline->vertices[k].z);
        if (low > world->working_plane_m + 1.0)
            continue;
        struct plane_screen *line = &plane->openings[plane->opening_count++];
        double longest = -1.0;
        for (int a = 0; a < outline->count; a++)
            for (int b = a + 1; b < outline->count; b++) {
                struct pp_vec3 p = outline->vertices[a], q = outline->vertices[b];
                double length = hypot(q.x - p.x, q.y - p.y);
                if (length <= longest)
                    continue;
                longest = length;
                *line = (struct plane_screen){{p.x, p.y}, {q.x, q.y}};
            }
    }
    return PP_OK;
}

/* Number of times by which the square at a position is halved: a real number, so that
 * it changes gradually. */
static double halvings_at(const struct pp_traced_plane *plane, double x, double y)
{
    double nearest = INFINITY;
    for (int i = 0; i < plane->opening_count; i++)
        nearest = fmin(nearest, distance_to(&plane->openings[i], x, y));
    double halvings = log2(near_sides * plane->side_m / fmax(nearest, 1e-3));
    return fmin(fmax(halvings + 1.0, 0.0), HALVINGS);
}

static enum pp_status add_square(struct pp_traced_plane *plane, double x, double y,
                                 double side, int halved, struct pp_error *err)
{
    const struct pp_world *world = plane->world;
    if (halved < (int)halvings_at(plane, x, y)) {
        enum pp_status status = PP_OK;
        for (int i = 0; i < 4 && status == PP_OK; i++)
            status = add_square(plane, x + (i % 2 ? 0.25 : -0.25) * side,
                                y + (i / 2 ? 0.25 : -0.25) * side, 0.5 * side,
                                halved + 1, err);
        return status;
    }
    const struct pp_vec3 at = pp_vec(x, y, world->working_plane_m);
    if (!pp_region_contains(&world->plane, x, y)
        || pp_region_edge_distance(&world->plane, x, y) < inset_m
        || pp_position_receiver_fault(world, at, pp_vec(0.0, 0.0, 1.0)))
        return PP_OK;
    enum pp_status status =
        pp_array_append(&plane->points, plane->count, sizeof *plane->points, err);
    if (status == PP_OK)
        plane->points[plane->count++] = (struct plane_point){.x = x, .y = y};
    return status;
}

/* Chooses the points, from squares of equal size that fill the plane's extent. */
static enum pp_status choose_points(struct pp_traced_plane *plane, struct pp_error *err)
{
    const struct pp_region *region = &plane->world->plane;
    struct pp_bounds2 box = pp_bounds2_empty();
    for (int r = 0; r < region->count; r++)
        for (int i = 0; i < region->rings[r].count; i++)
            pp_bounds2_add(&box, region->rings[r].xy[i][0], region->rings[r].xy[i][1]);
    plane->side_m = fmin(sqrt(pp_region_area(region) / squares), largest_m);
    double side[2];
    int count[2];
    for (int k = 0; k < 2; k++) {
        plane->low[k] = box.low[k];
        double extent = box.high[k] - box.low[k];
        count[k] = (int)fmax(ceil(extent / plane->side_m - 1e-6), 1.0);
        side[k] = extent / count[k];
    }
    plane->columns = count[0] + 1;
    plane->rows = count[1] + 1;
    enum pp_status status = PP_OK;
    for (int j = 0; j < count[1]; j++)
        for (int i = 0; i < count[0] && status == PP_OK; i++)
            status = add_square(plane, box.low[0] + (i + 0.5) * side[0],
                                box.low[1] + (j + 0.5) * side[1],
                                fmin(side[0], side[1]), 0, err);
    return status;
}

static int traced_cell(const struct pp_traced_plane *plane, int axis, double at)
{
    int most = (axis ? plane->rows : plane->columns) - 1;
    double cell = floor((at - plane->low[axis]) / plane->side_m);
    return (int)fmin(fmax(cell, 0.0), most);
}

static enum pp_status sort_into_cells(struct pp_traced_plane *plane,
                                      struct pp_error *err)
{
    size_t cells = (size_t)plane->columns * (size_t)plane->rows;
    plane->cells = malloc(cells * sizeof *plane->cells);
    plane->next = malloc(((size_t)plane->count + 1) * sizeof *plane->next);
    if (!plane->cells || !plane->next)
        return pp_fail_memory(err);
    for (size_t i = 0; i < cells; i++)
        plane->cells[i] = -1;
    for (int i = plane->count - 1; i >= 0; i--) {
        int *cell =
            &plane->cells[traced_cell(plane, 1, plane->points[i].y) * plane->columns
                          + traced_cell(plane, 0, plane->points[i].x)];
        plane->next[i] = *cell;
        *cell = i;
    }
    return PP_OK;
}

enum pp_status pp_traced_plane_create(struct pp_traced_plane **plane,
                                      struct pp_receiver **points, int *count,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      struct pp_error *err)
{
    *plane = NULL;
    *points = NULL;
    struct pp_traced_plane *made = calloc(1, sizeof *made);
    if (!made)
        return pp_fail_memory(err);
    made->world = world;
    struct pp_error why = {0};
    enum pp_status status =
        pp_direct_plane_create(&made->direct, world, light, &pp_method_exact, &why);
    if (status == PP_BAD_INPUT)
        made->direct = NULL;
    else if (status != PP_OK)
        pp_fail(err, status, "%s", why.message);
    if (status == PP_OK || status == PP_BAD_INPUT)
        status = find_screens(made, err);
    if (status == PP_OK)
        status = find_openings(made, err);
    if (status == PP_OK)
        status = choose_points(made, err);
    if (status == PP_OK)
        status = sort_into_cells(made, err);
    if (status == PP_OK) {
        *points = calloc((size_t)made->count + 1, sizeof **points);
        status = *points ? PP_OK : pp_fail_memory(err);
    }
    if (status != PP_OK) {
        pp_traced_plane_destroy(made);
        return status;
    }
    for (int i = 0; i < made->count; i++)
        (*points)[i] = (struct pp_receiver){
            .position =
                pp_vec(made->points[i].x, made->points[i].y, world->working_plane_m),
            .normal = pp_vec(0.0, 0.0, 1.0)};
    *count = made->count;
    *plane = made;
    return PP_OK;
}

void pp_traced_plane_destroy(struct pp_traced_plane *plane)
{
    if (!plane)
        return;
    pp_direct_plane_destroy(plane->direct);
    free(plane->points);
    free(plane->screens);
    free(plane->openings);
    free(plane->cells);
    free(plane->next);
    free(plane);
}

/* ---- fitting ---- */

/* Direct component that is subtracted at the points: the sky component and the scaled
 * externally reflected light of `exact`. */
static enum pp_status known_at(const struct pp_traced_plane *plane, double x, double y,
                               double *value, struct pp_error *err)
{
    double sky, external;
    *value = 0.0;
    if (!plane->direct)
        return PP_OK;
    enum pp_status status =
        pp_direct_plane_at(plane->direct, x, y, &sky, &external, err);
    *value = status == PP_OK ? sky + plane->external * external : 0.0;
    return status;
}

/* Factor by which the externally reflected light of `exact` best fits the simulated
 * light. Minimises the squares of the differences divided by the daylight factor. */
static enum pp_status match_external(struct pp_traced_plane *plane,
                                     const struct pp_reading *factors,
                                     const struct pp_reading *external,
                                     struct pp_error *err)
{
    double products = 0.0, weights = 0.0;
    for (int i = 0; i < plane->count && plane->direct; i++) {
        double sky, by_exact;
        enum pp_status status =
            pp_direct_plane_at(plane->direct, plane->points[i].x, plane->points[i].y,
                               &sky, &by_exact, err);
        if (status != PP_OK)
            return status;
        if (!(factors[i].value > 0.0 && isfinite(external[i].value)))
            continue;
        double of_factor = by_exact / factors[i].value;
        products += of_factor * external[i].value / factors[i].value;
        weights += of_factor * of_factor;
    }
    plane->external = weights > 0.0 ? products / weights : 0.0;
    return PP_OK;
}

enum pp_status pp_traced_plane_fill(struct pp_traced_plane *plane,
                                    const struct pp_reading *factors,
                                    const struct pp_reading *external, double common,
                                    struct pp_error *err)
{
    plane->common = common;
    enum pp_status status = match_external(plane, factors, external, err);
    for (int i = 0; i < plane->count && status == PP_OK; i++) {
        struct plane_point *point = &plane->points[i];
        double known;
        status = known_at(plane, point->x, point->y, &known, err);
        point->known = isfinite(factors[i].value);
        point->rest = factors[i].value - known;
        point->error = isfinite(factors[i].std_error) ? factors[i].std_error : 0.0;
    }
    return status;
}

/* ---- between the points ---- */

struct neighbours {
    int count;
    const struct plane_point *list[NEIGHBOURS_MOST];
    double offset[NEIGHBOURS_MOST][2]; /* vector from the position to the point, divided
                                        * by the radius */
    double weight[NEIGHBOURS_MOST];
};

/* Finds the points with values that are visible from the position and within the
 * radius, at most NEIGHBOURS_MOST. */
static void find_neighbours(struct neighbours *found,
                            const struct pp_traced_plane *plane, const double at[2],
                            double radius)
{
    found->count = 0;
    for (int j = traced_cell(plane, 1, at[1] - radius);
         j <= traced_cell(plane, 1, at[1] + radius); j++)
        for (int i = traced_cell(plane, 0, at[0] - radius);
             i <= traced_cell(plane, 0, at[0] + radius); i++)
            for (int k = plane->cells[j * plane->columns + i]; k >= 0;
                 k = plane->next[k]) {
                const struct plane_point *point = &plane->points[k];
                double *offset = found->offset[found->count];
                offset[0] = (point->x - at[0]) / radius;
                offset[1] = (point->y - at[1]) / radius;
                double away = hypot(offset[0], offset[1]);
                if (away >= 1.0 || !point->known || !is_in_sight(plane, at, point))
                    continue;
                double weight = 1.0 - away * away;
                found->list[found->count] = point;
                found->weight[found->count++] = weight * weight;
                if (found->count == NEIGHBOURS_MOST)
                    return;
            }
}

/* Limits a fitted value to the range of the points, extended by a quarter at each end,
 * and to at least half of the least value if that is above 0. Beside a cupboard, for
 * example, few points are visible, and all of them are on one side. */
static double bounded(double rest, const struct neighbours *of)
{
    double low = INFINITY, high = -INFINITY;
    for (int n = 0; n < of->count; n++) {
        low = fmin(low, of->list[n]->rest);
        high = fmax(high, of->list[n]->rest);
    }
    double beyond = 0.25 * (high - low), least = low - beyond;
    if (low > 0.0)
        least = fmax(least, 0.5 * low);
    return fmin(fmax(rest, least), high + beyond);
}

/* Fitted value and its standard error. Returns false if no point has a value. */
static bool fit(const struct pp_traced_plane *plane, double x, double y, double *rest,
                double *error)
{
    struct pp_vec3 within =
        pp_direct_plane_off_walls(&plane->world->plane, 0.0, looked_from_m, x, y);
    const double at[2] = {within.x, within.y};
    struct neighbours found = {0};
    double radius = reach_sides * plane->side_m * exp2(-halvings_at(plane, x, y));
    double furthest = hypot(plane->columns, plane->rows) * plane->side_m;
    for (; radius < 2.0 * furthest; radius *= 1.3) {
        find_neighbours(&found, plane, at, radius);
        if (found.count >= NEIGHBOURS_LEAST)
            break;
    }
    *rest = *error = 0.0;
    if (found.count == 0)
        return false;
    pp_moving_fit_coefficients(found.weight, (const double(*)[2])found.offset,
                               found.count);
    double errors = 0.0, variance = 0.0;
    for (int n = 0; n < found.count; n++) {
        double share = found.weight[n] * found.list[n]->error;
        *rest += found.weight[n] * found.list[n]->rest;
        errors += share;
        variance += share * share;
    }
    *rest = bounded(*rest, &found);
    *error = pp_common_error(errors, variance, plane->common);
    return true;
}

enum pp_status pp_traced_plane_value(void *of_points, double x, double y, double *value,
                                     struct pp_error *err)
{
    const struct pp_traced_plane *plane = of_points;
    double rest, error, known = 0.0;
    *value = 0.0;
    if (!fit(plane, x, y, &rest, &error))
        return PP_OK;
    enum pp_status status = known_at(plane, x, y, &known, err);
    *value = fmax(known + rest, 0.0);
    return status;
}

enum pp_status pp_traced_plane_error(void *of_points, double x, double y, double *value,
                                     struct pp_error *err)
{
    double rest;
    (void)err;
    fit(of_points, x, y, &rest, value);
    return PP_OK;
}
