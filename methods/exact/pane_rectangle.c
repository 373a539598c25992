/* pane_rectangle.c - finds the rectangles, and integrates over them by the rule of
 * Fejer in both directions. */
#include "methods/exact/pane_rectangle.h"

#include "model/geometry/min_max.h"

enum { NODES = PP_PANE_CELL_NODES };

/* Weights of the values at the nodes for the integral from -1 to 1 (Fejer): 2/7 (1 - 2
 * sum over j = 1 to 3 of cos(2 j acos(node)) / (4 j^2 - 1)). */
static const double fejer[NODES] = {
    0.08671618072672239, 0.28783139478869196, 0.3982415401308442, 0.4544217687074829,
    0.3982415401308442,  0.28783139478869196, 0.08671618072672239};

/* Least ratio k of a rectangle's distance to half its longer side for which the rule is
 * used. The cosines over the square of the distance, as a function along the rectangle,
 * have a pole at this distance beside it. The error is about (k + sqrt(k^2 + 1))^-8. */
static const double FAR = 8.0, FAR_ROUGH = 2.0;

/* A rectangle up to this many times nearer is divided until its parts are far enough: a
 * few rectangles take less time than quadrature. */
static const double DIVIDED = 4.0;

struct pp_bounds2 pp_pane_rectangle_around(const struct pp_pane_cell_seen *seen,
                                           const struct pp_visible *visible,
                                           struct pp_vec3 normal)
{
    const struct pp_projection *view = &visible->view;
    const struct pp_pane_plane *plane = &seen->plane;
    struct pp_bounds2 box = pp_region_bounds(&visible->patches[0].region);
    struct pp_bounds2 bounds = pp_bounds2_empty();
    for (int corner = 0; corner < 4; corner++) {
        struct pp_vec3 v = pp_projection_to_room(
            view, pp_vec(corner % 2 ? box.high[0] : box.low[0],
                         corner / 2 ? box.high[1] : box.low[1], view->distance_m));
        double reach = seen->distance_m / pp_vec_dot(v, plane->toward);
        pp_bounds2_add(&bounds, reach * pp_vec_dot(v, plane->along),
                       reach * pp_vec_dot(v, plane->up));
    }
    double rise = pp_vec_dot(normal, plane->up);
    if (fabs(pp_vec_dot(normal, plane->along)) < 1e-12 && rise > 0.1)
        bounds.low[1] =
            fmax(bounds.low[1],
                 -seen->distance_m * pp_vec_dot(normal, plane->toward) / rise);
    return bounds;
}

/* The part of the cell within bounds, from the foot of the eye's perpendicular. */
static struct pp_bounds2 part_within(const struct pp_pane_cell_seen *seen,
                                     const struct pp_bounds2 *bounds)
{
    struct pp_bounds2 part;
    for (int axis = 0; axis < 2; axis++) {
        part.low[axis] =
            fmax(seen->cell->low[axis] - seen->eye[axis], bounds->low[axis]);
        part.high[axis] =
            fmin(seen->cell->high[axis] - seen->eye[axis], bounds->high[axis]);
    }
    return part;
}

/* The vector from the eye to a point of the pane. */
static struct pp_vec3 to_pane(const struct pp_pane_cell_seen *seen, double x, double y)
{
    struct pp_vec3 v = pp_vec_scale(seen->plane.toward, seen->distance_m);
    return pp_vec_along(pp_vec_along(v, x, seen->plane.along), y, seen->plane.up);
}

/* True if the part is farther than `reach` times half its longer side. */
static bool is_far(const struct pp_pane_cell_seen *seen, const struct pp_bounds2 *part,
                   double reach)
{
    double half_m = 0.0, square = seen->distance_m * seen->distance_m;
    for (int axis = 0; axis < 2; axis++) {
        double beside = pp_max(0.0, pp_max(part->low[axis], -part->high[axis]));
        square += beside * beside;
        half_m = pp_max(half_m, (part->high[axis] - part->low[axis]) / 2.0);
    }
    return square > reach * half_m * reach * half_m;
}

/* True if the boxes overlap by more than a common border. */
static bool do_boxes_overlap(const struct pp_bounds2 *a, const struct pp_bounds2 *b)
{
    return a->low[0] < b->high[0] && a->high[0] > b->low[0] && a->low[1] < b->high[1]
           && a->high[1] > b->low[1];
}

/* True if the part is visible, and crossed by no edge of the visible part of the pane
 * and by no horizon of the receiver. */
static bool is_seen_whole(const struct pp_pane_cell_seen *seen,
                          const struct pp_bounds2 *part,
                          const struct pp_visible *visible, struct pp_vec3 normal)
{
    static const double MARGIN = 1e-9; /* rounding errors, where borders coincide */
    const struct pp_projection *view = &visible->view;
    const struct pp_region *region = &visible->patches[0].region;
    struct pp_bounds2 box = pp_bounds2_empty();
    for (int corner = 0; corner < 4; corner++) {
        struct pp_vec3 v = to_pane(seen, corner % 2 ? part->high[0] : part->low[0],
                                   corner / 2 ? part->high[1] : part->low[1]);
        if (!(pp_vec_dot(v, normal) >= -MARGIN * seen->distance_m))
            return false;
        struct pp_vec3 own = pp_projection_direction(view, v);
        pp_bounds2_add(&box, own.x / own.z * view->distance_m,
                       own.y / own.z * view->distance_m);
    }
    for (int axis = 0; axis < 2; axis++) {
        double margin = MARGIN * (box.high[axis] - box.low[axis]);
        box.low[axis] += margin;
        box.high[axis] -= margin;
    }
    for (int i = 0; i < region->count; i++)
        for (int k = 0; k < region->rings[i].count; k++) {
            const struct pp_ring *ring = &region->rings[i];
            const double *a = ring->xy[k];
            const double *b = ring->xy[k + 1 < ring->count ? k + 1 : 0];
            struct pp_bounds2 edge = {{pp_min(a[0], b[0]), pp_min(a[1], b[1])},
                                      {pp_max(a[0], b[0]), pp_max(a[1], b[1])}};
            if (do_boxes_overlap(&edge, &box))
                return false;
        }
    return pp_region_contains(region, (box.low[0] + box.high[0]) / 2.0,
                              (box.low[1] + box.high[1]) / 2.0);
}

/* Finds the nodes of the part along an axis, and the values of the polynomial there as
 * weights of those at the nodes of the cell. Returns true if both have the same
 * nodes. */
static bool nodes_along(double at[NODES], double weights[NODES][NODES],
                        const struct pp_pane_cell_seen *seen,
                        const struct pp_bounds2 *part, int axis)
{
    double low = seen->cell->low[axis] - seen->eye[axis];
    double high = seen->cell->high[axis] - seen->eye[axis];
    bool same = part->low[axis] == low && part->high[axis] == high;
    for (int i = 0; i < NODES; i++) {
        at[i] = (part->low[axis] + part->high[axis]) / 2.0
                + (part->high[axis] - part->low[axis]) / 2.0 * pp_pane_cell_nodes[i];
        if (same)
            pp_pane_cell_weights(weights[i], pp_pane_cell_nodes[i]);
        else
            pp_pane_cell_weights(weights[i], (2.0 * at[i] - low - high) / (high - low));
    }
    return same;
}

/* The values at the nodes of the part, of `values` at those of the cell. */
static void values_of_part(double part[NODES][NODES], const double values[NODES][NODES],
                           const double across[NODES][NODES],
                           const double up[NODES][NODES])
{
    double lines[NODES][NODES] = {{0.0}};
    for (int i = 0; i < NODES; i++)
        for (int m = 0; m < NODES; m++)
            for (int n = 0; n < NODES; n++)
                lines[i][n] += across[i][m] * values[m][n];
    for (int i = 0; i < NODES; i++)
        for (int k = 0; k < NODES; k++) {
            part[i][k] = 0.0;
            for (int n = 0; n < NODES; n++)
                part[i][k] += up[k][n] * lines[i][n];
        }
}

/* Adds the light of the part by the rule. */
static void add_by_rule(struct pp_direct *sum, const struct pp_pane_cell_seen *seen,
                        const struct pp_bounds2 *part, struct pp_vec3 normal)
{
    const struct pp_pane_cell *cell = seen->cell;
    double at[2][NODES], weights[2][NODES][NODES];
    bool same = nodes_along(at[0], weights[0], seen, part, 0);
    same = nodes_along(at[1], weights[1], seen, part, 1) && same;
    double own[2][NODES][NODES];
    const double(*sky)[NODES] = cell->sky, (*external)[NODES] = cell->external;
    if (!same) {
        values_of_part(own[0], sky, weights[0], weights[1]);
        values_of_part(own[1], external, weights[0], weights[1]);
        sky = (const double(*)[NODES])own[0];
        external = (const double(*)[NODES])own[1];
    }
    double sums[2] = {0.0, 0.0};
    for (int i = 0; i < NODES; i++)
        for (int k = 0; k < NODES; k++) {
            struct pp_vec3 v = to_pane(seen, at[0][i], at[1][k]);
            double square = pp_vec_dot(v, v);
            double weight = fejer[i] * fejer[k] * pp_max(pp_vec_dot(v, normal), 0.0)
                            / (square * square);
            sums[0] += weight * sky[i][k];
            sums[1] += weight * external[i][k];
        }
    double quarter =
        (part->high[0] - part->low[0]) * (part->high[1] - part->low[1]) / 4.0;
    sum->sky += quarter * seen->distance_m * sums[0];
    sum->external += quarter * seen->distance_m * sums[1];
}

/* Adds the light of the part, divided in the middle of its longer side until all parts
 * are farther than `reach`. */
static void add_divided(struct pp_direct *sum, const struct pp_pane_cell_seen *seen,
                        const struct pp_bounds2 *part, struct pp_vec3 normal,
                        double reach)
{
    if (is_far(seen, part, reach)) {
        add_by_rule(sum, seen, part, normal);
        return;
    }
    struct pp_bounds2 lower = *part, upper = *part;
    int axis = part->high[0] - part->low[0] < part->high[1] - part->low[1];
    lower.high[axis] = upper.low[axis] = (part->low[axis] + part->high[axis]) / 2.0;
    add_divided(sum, seen, &lower, normal, reach);
    add_divided(sum, seen, &upper, normal, reach);
}

bool pp_pane_rectangle_add(struct pp_direct *sum, const struct pp_pane_cell_seen *seen,
                           const struct pp_bounds2 *bounds,
                           const struct pp_visible *visible, struct pp_vec3 normal)
{
    struct pp_bounds2 part = part_within(seen, bounds);
    double reach = sum->rough ? FAR_ROUGH : FAR;
    if (!(part.low[0] < part.high[0] && part.low[1] < part.high[1]))
        return true; /* no part of the cell is visible */
    if (!is_far(seen, &part, reach / DIVIDED)
        || !is_seen_whole(seen, &part, visible, normal))
        return false;
    add_divided(sum, seen, &part, normal, reach);
    return true;
}
