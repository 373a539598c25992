/* quadrature.c - see quadrature.h. */
#include "methods/exact/quadrature.h"

#include <cubature.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Coordinates that agree to this share of the whole extent are one. */
#define GRAIN 1e-13

/* What a whole integral may err by however small it is: a slit as narrow as rounding
 * has no digits to work for. */
#define ABSOLUTE 1e-17

/* Evaluations after which a column, and columns after which a cell, is left as it is;
 * the error bound then says so. */
enum { COLUMN_MOST = 3000, COLUMNS_MOST = 3000 };

/* An edge of the clipped rings, from left to right. */
struct ring_edge {
    double x[2], y[2];
};

/* Between two lines y = level + slope x, from x[0] to x[1]. */
struct cell_bound {
    double level, slope;
};

struct integration_cell {
    double x[2];
    struct cell_bound lower, upper;
    int lower_edge, upper_edge; /* -1: not an edge */
};

/* All there is to integrate over. */
struct integration_cells {
    struct ring_edge *edges;
    int edge_count, edge_room;
    double *stops; /* where cells begin and end */
    int stop_count;
    struct integration_cell *list;
    int count, room;
};

static void clear_cells(struct integration_cells *cells)
{
    free(cells->edges);
    free(cells->stops);
    free(cells->list);
}

/* ---- from rings to edges ---- */

/* Cuts a ring by a x + b y + c > 0. A ring that is not convex keeps bridges along the
 * cut, which run both ways and cancel. Returns how many points are left; out has room
 * for 2 count. */
static int cut_ring(double (*out)[2], const double (*in)[2], int count, double a,
                    double b, double c)
{
    int left = 0;
    for (int i = 0, k = count - 1; i < count; k = i++) {
        double now = a * in[i][0] + b * in[i][1] + c;
        double was = a * in[k][0] + b * in[k][1] + c;
        if ((now > 0.0) != (was > 0.0)) {
            int inner = now > 0.0 ? i : k, outer = now > 0.0 ? k : i;
            double t = fabs(now > 0.0 ? now : was) / (fabs(now) + fabs(was));
            out[left][0] = in[inner][0] + t * (in[outer][0] - in[inner][0]);
            out[left++][1] = in[inner][1] + t * (in[outer][1] - in[inner][1]);
        }
        if (now > 0.0) {
            out[left][0] = in[i][0];
            out[left++][1] = in[i][1];
        }
    }
    return left;
}

static enum pp_status add_ring(struct integration_cells *cells,
                               const struct pp_ring *ring, const struct pp_vec3 *planes,
                               int plane_count, double distance_m, struct pp_error *err)
{
    size_t room = (size_t)ring->count << plane_count;
    double(*buffer)[2] = malloc(2 * room * sizeof *buffer);
    if (!buffer)
        return pp_fail_memory(err);
    double(*from)[2] = buffer, (*to)[2] = buffer + room;
    memcpy(from, ring->xy, (size_t)ring->count * sizeof *from);
    int count = ring->count;
    for (int p = 0; p < plane_count; p++) {
        count = cut_ring(to, (const double(*)[2])from, count, planes[p].x, planes[p].y,
                         planes[p].z * distance_m);
        double(*swap)[2] = from;
        from = to;
        to = swap;
    }
    if (cells->edge_count + count > cells->edge_room) {
        int edge_room = 2 * cells->edge_room + count;
        struct ring_edge *edges =
            realloc(cells->edges, (size_t)edge_room * sizeof *cells->edges);
        if (!edges) {
            free(buffer);
            return pp_fail_memory(err);
        }
        cells->edges = edges;
        cells->edge_room = edge_room;
    }
    for (int i = 0, k = count - 1; i < count; k = i++) {
        int left = from[k][0] <= from[i][0] ? k : i, right = left == k ? i : k;
        cells->edges[cells->edge_count++] = (struct ring_edge){
            {from[left][0], from[right][0]}, {from[left][1], from[right][1]}};
    }
    free(buffer);
    return PP_OK;
}

/* ---- from edges to cells ---- */

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static enum pp_status find_stops(struct integration_cells *cells, const double *cusp,
                                 struct pp_error *err)
{
    cells->stops = malloc((2 * (size_t)cells->edge_count + 1) * sizeof *cells->stops);
    if (!cells->stops)
        return pp_fail_memory(err);
    int count = 0;
    for (int i = 0; i < cells->edge_count; i++) {
        cells->stops[count++] = cells->edges[i].x[0];
        cells->stops[count++] = cells->edges[i].x[1];
    }
    if (cusp)
        cells->stops[count++] = cusp[0];
    qsort(cells->stops, (size_t)count, sizeof *cells->stops, by_size);
    double grain = count ? GRAIN * (cells->stops[count - 1] - cells->stops[0]) : 0.0;
    for (int i = 0; i < count; i++)
        if (cells->stop_count == 0
            || cells->stops[i] - cells->stops[cells->stop_count - 1] > grain)
            cells->stops[cells->stop_count++] = cells->stops[i];
    return PP_OK;
}

static double height_at(const struct ring_edge *edge, double x)
{
    double t = (x - edge->x[0]) / (edge->x[1] - edge->x[0]);
    return edge->y[0] + t * (edge->y[1] - edge->y[0]);
}

static struct cell_bound line_of(const struct ring_edge *edge)
{
    double slope = (edge->y[1] - edge->y[0]) / (edge->x[1] - edge->x[0]);
    return (struct cell_bound){edge->y[0] - slope * edge->x[0], slope};
}

static enum pp_status add_cell(struct integration_cells *cells,
                               struct integration_cell cell, struct pp_error *err)
{
    if (cells->count == cells->room) {
        int room = cells->room ? 2 * cells->room : 8;
        struct integration_cell *list =
            realloc(cells->list, (size_t)room * sizeof *cells->list);
        if (!list)
            return pp_fail_memory(err);
        cells->list = list;
        cells->room = room;
    }
    cells->list[cells->count++] = cell;
    return PP_OK;
}

/* Cells between two stops: edges that cross the strip, by height, bound them in pairs.
 * A cell between the same two edges as one that ends here is that one, continued. */
static enum pp_status add_strip(struct integration_cells *cells, int *crossing,
                                double left, double right, bool may_continue,
                                struct pp_error *err)
{
    double middle = left + (right - left) / 2.0;
    int count = 0;
    for (int i = 0; i < cells->edge_count; i++) {
        const struct ring_edge *edge = &cells->edges[i];
        if (!(edge->x[0] < middle && middle < edge->x[1]))
            continue;
        int at = count++;
        double height = height_at(edge, middle);
        for (; at > 0 && height_at(&cells->edges[crossing[at - 1]], middle) > height;
             at--)
            crossing[at] = crossing[at - 1];
        crossing[at] = i;
    }
    int known = cells->count;
    for (int i = 0; i + 1 < count; i += 2) {
        int low = crossing[i], high = crossing[i + 1], k = may_continue ? 0 : known;
        while (k < known
               && !(cells->list[k].lower_edge == low
                    && cells->list[k].upper_edge == high
                    && cells->list[k].x[1] == left))
            k++;
        if (k < known) {
            cells->list[k].x[1] = right;
            continue;
        }
        struct integration_cell cell = {{left, right},
                                        line_of(&cells->edges[low]),
                                        line_of(&cells->edges[high]),
                                        low,
                                        high};
        enum pp_status status = add_cell(cells, cell, err);
        if (status != PP_OK)
            return status;
    }
    return PP_OK;
}

static double on_line(struct cell_bound line, double x)
{
    return line.level + line.slope * x;
}

/* A cell with the cusp on one of its sides becomes two, with the cusp at a corner of
 * both. */
static enum pp_status split_at_cusp(struct integration_cells *cells, int index,
                                    const double *cusp, struct pp_error *err)
{
    struct integration_cell *cell = &cells->list[index];
    for (int side = 0; side < 2; side++) {
        if (cell->x[side] != cusp[0] || !(on_line(cell->lower, cusp[0]) < cusp[1])
            || !(cusp[1] < on_line(cell->upper, cusp[0])))
            continue;
        double far = cell->x[1 - side];
        double middle = (on_line(cell->lower, far) + on_line(cell->upper, far)) / 2.0;
        double slope = (middle - cusp[1]) / (far - cusp[0]);
        struct integration_cell other = *cell;
        cell->upper = other.lower =
            (struct cell_bound){cusp[1] - slope * cusp[0], slope};
        cell->upper_edge = other.lower_edge = -1;
        return add_cell(cells, other, err);
    }
    return PP_OK;
}

static enum pp_status find_cells(struct integration_cells *cells, const double *cusp,
                                 struct pp_error *err)
{
    enum pp_status status = find_stops(cells, cusp, err);
    if (status != PP_OK)
        return status;
    int *crossing = malloc(((size_t)cells->edge_count + 1) * sizeof *crossing);
    if (!crossing)
        return pp_fail_memory(err);
    for (int i = 0; i + 1 < cells->stop_count && status == PP_OK; i++)
        status = add_strip(cells, crossing, cells->stops[i], cells->stops[i + 1],
                           !cusp || cells->stops[i] != cusp[0], err);
    free(crossing);
    int count = cells->count;
    for (int i = 0; cusp && i < count && status == PP_OK; i++)
        status = split_at_cusp(cells, i, cusp, err);
    return status;
}

/* ---- over a cell ---- */

struct cell_integral {
    const struct pp_projection *view;
    const struct pp_integrand *integrand;
    struct pp_vec3 normal;          /* the receiver's, room's axes */
    struct cell_bound lower, upper; /* over the distance of the plane */
    double alpha[2];
    double cos_alpha, sin_alpha;     /* of the column that is being integrated */
    double column_abs, column_error; /* error bounds of a column, either will do */
    long evaluations;
};

/* L (n.u) at the sine s of the altitude in a column. */
static int at_sine(unsigned dim, const double *sine, void *data, unsigned fdim,
                   double *value)
{
    (void)dim, (void)fdim;
    struct cell_integral *walk = data;
    double cosine = sqrt(fmax(0.0, 1.0 - sine[0] * sine[0]));
    struct pp_vec3 own =
        pp_vec(walk->sin_alpha * cosine, sine[0], walk->cos_alpha * cosine);
    struct pp_vec3 u = pp_projection_to_room(walk->view, own);
    double facing = pp_vec_dot(walk->normal, u);
    *value = facing > 0.0
                 ? walk->integrand->luminance(walk->integrand->context, u) * facing
                 : 0.0;
    walk->evaluations++;
    return 0;
}

/* The sine of the altitude of a line at tan alpha = t, with h = 1 / cos alpha. */
static double sine_of(struct cell_bound line, double t, double h)
{
    double y = line.level + line.slope * t;
    return y / sqrt(y * y + h * h);
}

/* The integral over the column at alpha. */
static int at_alpha(unsigned dim, const double *alpha, void *data, unsigned fdim,
                    double *value)
{
    (void)dim, (void)fdim;
    struct cell_integral *walk = data;
    double c = cos(alpha[0]), s = sin(alpha[0]), error;
    walk->cos_alpha = c;
    walk->sin_alpha = s;
    double low = sine_of(walk->lower, s / c, 1.0 / c);
    double high = sine_of(walk->upper, s / c, 1.0 / c);
    return hcubature(1, at_sine, walk, 1, &low, &high, COLUMN_MOST, walk->column_abs,
                     walk->column_error, ERROR_INDIVIDUAL, value, &error);
}

/* Nodes and weights of the Gauss-Legendre rule on -1 to 1, the positive half. */
enum { NODES = 4 };
static const double gauss[NODES / 2][2] = {{0.33998104358485626, 0.65214515486254614},
                                           {0.86113631159405258, 0.34785484513745386}};

/* Places and weights of a rule from one angle to another. */
enum { STRETCHES_MOST = 16 };
struct places {
    int count;
    double at[STRETCHES_MOST * NODES], weight[STRETCHES_MOST * NODES];
};

/* Equal stretches of at most 0.7, a rule each; shorter ones towards 90 degrees, where
 * glass dims light from full to nothing. */
static struct places places_of(double low, double high)
{
    static const double border[] = {-PP_PI / 2.0, -1.5, -1.35, -1.1,
                                    1.1,          1.35, 1.5,   PP_PI / 2.0};
    struct places places = {0};
    for (int b = 0; b + 1 < (int)(sizeof border / sizeof border[0]); b++) {
        double from = fmax(low, border[b]), to = fmin(high, border[b + 1]);
        int stretches = to > from ? 1 + (int)((to - from) / 0.7) : 0;
        double half = stretches ? (to - from) / stretches / 2.0 : 0.0;
        for (int i = 0; i < stretches * NODES; i++) {
            const double *node = gauss[i % NODES / 2];
            double middle = from + half * (2 * (i / NODES) + 1);
            places.at[places.count] = middle + (i % 2 ? half : -half) * node[0];
            places.weight[places.count++] = node[1] * half;
        }
    }
    return places;
}

/* The integral over a cell by fixed rules, up in the altitude itself: towards 90
 * degrees the angle of incidence is smooth in that, not in its sine. */
static double roughly(struct cell_integral *walk)
{
    double sum = 0.0;
    struct places across = places_of(walk->alpha[0], walk->alpha[1]);
    for (int i = 0; i < across.count; i++) {
        double value, column = 0.0;
        double c = cos(across.at[i]), s = sin(across.at[i]);
        walk->cos_alpha = c;
        walk->sin_alpha = s;
        struct places up = places_of(asin(sine_of(walk->lower, s / c, 1.0 / c)),
                                     asin(sine_of(walk->upper, s / c, 1.0 / c)));
        for (int k = 0; k < up.count; k++) {
            double sine = sin(up.at[k]);
            at_sine(1, &sine, walk, 1, &value);
            column += up.weight[k] * cos(up.at[k]) * value;
        }
        sum += across.weight[i] * column;
    }
    return sum;
}

static struct cell_integral walk_of(const struct pp_projection *view,
                                    const struct integration_cell *cell,
                                    struct pp_vec3 normal,
                                    const struct pp_integrand *what)
{
    double d = view->distance_m;
    return (struct cell_integral){
        .view = view,
        .integrand = what,
        .normal = normal,
        .lower = {cell->lower.level / d, cell->lower.slope},
        .upper = {cell->upper.level / d, cell->upper.slope},
        .alpha = {atan2(cell->x[0], d), atan2(cell->x[1], d)}};
}

enum pp_status pp_quadrature_over(struct pp_quadrature *result,
                                  const struct pp_projection *view,
                                  const struct pp_region *region,
                                  const struct pp_vec3 *half_spaces,
                                  int half_space_count, struct pp_vec3 normal,
                                  const struct pp_integrand *what,
                                  double relative_error, struct pp_error *err)
{
    *result = (struct pp_quadrature){0};
    struct pp_vec3 planes[8];
    for (int i = 0; i < half_space_count; i++)
        planes[i] = pp_projection_direction(view, half_spaces[i]);

    /* Where the cusp is drawn, if it is before the eye. */
    double place[2], *cusp = NULL;
    if (what->cusp) {
        struct pp_vec3 own = pp_projection_direction(view, *what->cusp);
        if (own.z > 0.0) {
            place[0] = own.x / own.z * view->distance_m;
            place[1] = own.y / own.z * view->distance_m;
            if (pp_region_contains(region, place[0], place[1]))
                cusp = place;
        }
    }

    struct integration_cells cells = {0};
    enum pp_status status = PP_OK;
    for (int i = 0; i < region->count && status == PP_OK; i++)
        status = add_ring(&cells, &region->rings[i], planes, half_space_count,
                          view->distance_m, err);
    if (status == PP_OK)
        status = find_cells(&cells, cusp, err);

    if (relative_error >= PP_QUADRATURE_ROUGH) {
        for (int i = 0; i < cells.count && status == PP_OK; i++) {
            struct cell_integral walk = walk_of(view, &cells.list[i], normal, what);
            result->value += roughly(&walk);
            result->evaluations += walk.evaluations;
        }
        clear_cells(&cells);
        return status;
    }

    /* A first idea of the sum, so that no work goes into what does not show in it. */
    double idea = 0.0;
    for (int i = 0; i < cells.count && status == PP_OK; i++) {
        struct cell_integral walk = walk_of(view, &cells.list[i], normal, what);
        double middle = (walk.alpha[0] + walk.alpha[1]) / 2.0, value;
        walk.column_error = 1.0;
        if (at_alpha(1, &middle, &walk, 1, &value) != 0)
            status = pp_fail_memory(err);
        idea += fabs(value) * (walk.alpha[1] - walk.alpha[0]);
    }
    double enough = fmax(0.1 * relative_error * idea, ABSOLUTE) / cells.count;
    for (int i = 0; i < cells.count && status == PP_OK; i++) {
        struct cell_integral walk = walk_of(view, &cells.list[i], normal, what);
        double width = walk.alpha[1] - walk.alpha[0], value, error;
        /* Columns are to err less than the rule across them can tell. */
        walk.column_abs = 0.3 * enough / width;
        walk.column_error = 0.3 * relative_error;
        if (hcubature(1, at_alpha, &walk, 1, &walk.alpha[0], &walk.alpha[1],
                      COLUMNS_MOST, enough, relative_error, ERROR_INDIVIDUAL, &value,
                      &error)
            != 0)
            status = pp_fail_memory(err);
        result->value += value;
        result->error += error + 0.3 * fmax(enough, relative_error * fabs(value));
        result->evaluations += walk.evaluations;
    }
    clear_cells(&cells);
    return status;
}
