/* integration_cells.c - clips rings, sorts the edges that cross each strip, and pairs
 * them. */
#include "methods/exact/integration_cells.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

/* Coordinates that differ by less than this fraction of the whole extent count as
 * equal. */
#define GRAIN 1e-13

void pp_integration_cells_clear(struct integration_cells *cells)
{
    free(cells->edges);
    free(cells->stops);
    free(cells->list);
}

/* ---- from rings to edges ---- */

/* Clips a ring to a x + b y + c > 0. A ring that is not convex keeps bridges along the
 * cut, which are traversed in both directions and cancel. Returns the number of points
 * that remain; out has room for 2 count points. */
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

enum pp_status pp_integration_cells_add_ring(struct integration_cells *cells,
                                             const struct pp_ring *ring,
                                             const struct pp_vec3 *planes,
                                             int plane_count, double distance_m,
                                             struct pp_error *err)
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
    enum pp_status status =
        pp_array_reserve(&cells->edges, &cells->edge_capacity,
                         cells->edge_count + count, sizeof *cells->edges, err);
    if (status != PP_OK) {
        free(buffer);
        return status;
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
    enum pp_status status = pp_array_reserve(
        &cells->list, &cells->capacity, cells->count + 1, sizeof *cells->list, err);
    if (status == PP_OK)
        cells->list[cells->count++] = cell;
    return status;
}

/* Adds the cells between two stops. The edges that cross the strip, ordered by height,
 * bound cells in pairs. A cell that ends at `left` between the same two edges is
 * extended. */
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

/* Splits a cell that has the cusp inside one of its vertical sides, so that the cusp is
 * a corner of both parts. */
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

enum pp_status pp_integration_cells_find(struct integration_cells *cells,
                                         const double *cusp, struct pp_error *err)
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
