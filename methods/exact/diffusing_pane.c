/* diffusing_pane.c - finds the lines where the illuminance on the pane is not smooth,
 * interpolates it between them, and integrates over the visible part. */
#include "methods/exact/diffusing_pane.h"

#include <stdlib.h>

#include "methods/exact/exterior.h"
#include "methods/exact/pane_rectangle.h"
#include "methods/exact/quadrature.h"
#include "methods/view/occluders.h"
#include "model/geometry/bounds.h"

enum { NODES = PP_PANE_CELL_NODES, CELLS_MOST = 96 };

/* Bound on the number of evaluations times the square of the number of surfaces in
 * front of the pane. A pane at the bound takes a few seconds. */
static const double WORK_MOST = 2e6;

/* Cells are divided until the estimated error of the flux on the whole pane is this,
 * relative. The estimate is high: daylight factors behind overhangs, shelves and fins
 * have an error of 1e-6 or less. */
static const double RELATIVE_ERROR = 1e-5;

/* ---- lines where the illuminance is not smooth ---- */

/* Borders parallel to one axis of the pane, each given by its coordinate on the other
 * axis. */
struct borders {
    double *at[2];
    int count[2];
    int surfaces; /* number of surfaces in front of the pane */
};

static struct pp_pane_plane pane_plane(const struct pp_opening *opening)
{
    struct pp_vec3 toward = pp_vec_scale(opening->inner.normal, -1.0);
    double offset = pp_vec_dot(opening->outer.vertices[0], toward);
    return (struct pp_pane_plane){pp_vec_scale(toward, offset), opening->along,
                                  opening->up, toward};
}

/* Adds the line where the plane m.p = offset meets the pane's plane, if that line is
 * parallel to an axis. */
static void add_border(struct borders *borders, const struct pp_pane_plane *plane,
                       struct pp_vec3 m, double offset)
{
    double slope[2] = {pp_vec_dot(m, plane->along), pp_vec_dot(m, plane->up)};
    for (int axis = 0; axis < 2; axis++)
        if (fabs(slope[axis]) > 1e-6 && fabs(slope[1 - axis]) < 1e-9)
            borders->at[axis][borders->count[axis]++] =
                (offset - pp_vec_dot(m, plane->foot)) / slope[axis];
}

/* True if any corner of the polygon is in front of the pane's plane. */
static bool is_in_front(const struct pp_polygon *outline,
                        const struct pp_pane_plane *plane)
{
    for (int i = 0; i < outline->count; i++)
        if (pp_vec_dot(pp_vec_sub(outline->vertices[i], plane->foot), plane->toward)
            > PP_OCCLUDERS_COPLANAR_M)
            return true;
    return false;
}

static enum pp_status find_borders(struct borders *borders,
                                   const struct pp_world *world,
                                   const struct pp_opening *opening,
                                   struct pp_error *err)
{
    const struct pp_vec3 zenith = {0.0, 0.0, 1.0};
    struct pp_pane_plane plane = pane_plane(opening);
    size_t most = 1;
    for (int i = 0; i < world->surface_count; i++)
        most += (size_t)world->surfaces[i].outline.count + 1;
    *borders = (struct borders){
        .at = {malloc(most * sizeof(double)), malloc(most * sizeof(double))}};
    if (!borders->at[0] || !borders->at[1])
        return pp_fail_memory(err);
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        const struct pp_polygon *outline = &surface->outline;
        if (i == opening->face || surface->role == PP_REVEAL
            || surface->role == PP_COVER || !is_in_front(outline, &plane))
            continue;
        borders->surfaces++;
        add_border(borders, &plane, outline->normal,
                   pp_vec_dot(outline->normal, outline->vertices[0]));
        for (int k = 0; k < outline->count; k++)
            add_border(borders, &plane, zenith, outline->vertices[k].z);
    }
    return PP_OK;
}

/* The border nearest to the cell's middle, or the middle if the cell has no border. */
static double cut_of(const struct borders *borders, const struct pp_pane_cell *cell,
                     int axis)
{
    double low = cell->low[axis], high = cell->high[axis];
    double middle = (low + high) / 2.0, cut = NAN, margin = 1e-9 * (high - low);
    for (int i = 0; i < borders->count[axis]; i++) {
        double at = borders->at[axis][i];
        if (at > low + margin && at < high - margin
            && !(fabs(at - middle) >= fabs(cut - middle)))
            cut = at;
    }
    return isnan(cut) ? middle : cut;
}

/* ---- the illuminance on the outside of the pane ---- */

/* Adds to tails[axis] the absolute values of the polynomial's last two coefficients
 * along each axis. */
static void add_tails(double tails[2], const double values[NODES][NODES])
{
    double basis[NODES][NODES];
    for (int m = 0; m < NODES; m++)
        for (int i = 0; i < NODES; i++)
            basis[m][i] =
                cos(m * acos(pp_pane_cell_nodes[i])) * (m > 0 ? 2.0 : 1.0) / NODES;
    for (int m = 0; m < NODES; m++)
        for (int n = 0; n < NODES; n++) {
            double sum = 0.0;
            for (int i = 0; i < NODES; i++)
                for (int k = 0; k < NODES; k++)
                    sum += values[i][k] * basis[m][i] * basis[n][k];
            tails[0] += m >= NODES - 2 ? fabs(sum) : 0.0;
            tails[1] += n >= NODES - 2 ? fabs(sum) : 0.0;
        }
}

static enum pp_status light_cell(struct pp_pane_cell *cell,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_opening *opening,
                                 const struct pp_direct *how, struct pp_error *err)
{
    struct pp_pane_plane plane = pane_plane(opening);
    double middle[2], half[2], sum = 0.0;
    for (int axis = 0; axis < 2; axis++) {
        middle[axis] = (cell->low[axis] + cell->high[axis]) / 2.0;
        half[axis] = (cell->high[axis] - cell->low[axis]) / 2.0;
    }
    for (int i = 0; i < NODES; i++)
        for (int k = 0; k < NODES; k++) {
            struct pp_vec3 at = pp_vec_along(
                plane.foot, middle[0] + half[0] * pp_pane_cell_nodes[i], plane.along);
            at =
                pp_vec_along(at, middle[1] + half[1] * pp_pane_cell_nodes[k], plane.up);
            struct pp_exterior_light outside;
            enum pp_status status = pp_exterior_light_within(
                &outside, world, light, at, plane.toward, opening->face, how, err);
            if (status != PP_OK)
                return status;
            cell->sky[i][k] = outside.sky;
            cell->external[i][k] = outside.external;
            sum += outside.sky + outside.external;
        }
    double area = 4.0 * half[0] * half[1], tails[2] = {0.0, 0.0};
    add_tails(tails, (const double(*)[NODES])cell->sky);
    add_tails(tails, (const double(*)[NODES])cell->external);
    cell->total = area * sum / (NODES * NODES);
    cell->error = area * (tails[0] + tails[1]);
    cell->worse = tails[0] > tails[1] ? 0 : 1;
    return PP_OK;
}

/* Sets the relative error of the pane. Returns the index of the cell with the largest
 * error. */
static int find_worst(struct pp_diffusing_pane *pane)
{
    double total = 0.0, error = 0.0;
    int worst = 0;
    for (int i = 0; i < pane->cell_count; i++) {
        total += pane->cells[i].total;
        error += pane->cells[i].error;
        if (pane->cells[i].error > pane->cells[worst].error)
            worst = i;
    }
    pane->error = total > 0.0 ? error / total : 0.0;
    return worst;
}

static enum pp_status divide_pane(struct pp_diffusing_pane *pane,
                                  const struct borders *borders,
                                  const struct pp_world *world,
                                  const struct pp_outside_light *light,
                                  const struct pp_opening *opening,
                                  const struct pp_direct *how, struct pp_error *err)
{
    enum pp_status status =
        light_cell(&pane->cells[0], world, light, opening, how, err);
    double work = NODES * NODES * (double)borders->surfaces * borders->surfaces;
    int most = (int)fmin(CELLS_MOST, 1.0 + WORK_MOST / fmax(2.0 * work, 1.0));
    pane->cell_count = 1;
    while (status == PP_OK) {
        int worst = find_worst(pane);
        if (!(pane->error > RELATIVE_ERROR) || pane->cell_count == most)
            return PP_OK;
        struct pp_pane_cell *cell = &pane->cells[worst];
        struct pp_pane_cell *other = &pane->cells[pane->cell_count++];
        int axis = cell->worse;
        *other = *cell;
        cell->high[axis] = other->low[axis] = cut_of(borders, cell, axis);
        status = light_cell(cell, world, light, opening, how, err);
        if (status == PP_OK)
            status = light_cell(other, world, light, opening, how, err);
    }
    return status;
}

enum pp_status pp_diffusing_pane_init(struct pp_diffusing_pane *pane,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening, bool by_table,
                                      struct pp_error *err)
{
    const struct pp_polygon *outline = &opening->outer;
    struct pp_bounds2 box = pp_bounds2_empty();
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 v = outline->vertices[i];
        pp_bounds2_add(&box, pp_vec_dot(v, opening->along), pp_vec_dot(v, opening->up));
    }
    struct pp_pane_cell whole = {.low = {box.low[0], box.low[1]},
                                 .high = {box.high[0], box.high[1]}};
    struct borders borders;
    struct pp_sky_table *table = NULL;
    struct pp_projection axes = {.along = opening->along,
                                 .up = opening->up,
                                 .toward = pane_plane(opening).toward};
    enum pp_status status = find_borders(&borders, world, opening, err);
    *pane =
        (struct pp_diffusing_pane){malloc(CELLS_MOST * sizeof *pane->cells), 0, 0.0};
    if (status == PP_OK && !pane->cells)
        status = pp_fail_memory(err);
    if (status == PP_OK && by_table && light->sky.kind == PP_SKY_ISO) {
        struct pp_glass none = pp_glass_none();
        status =
            pp_sky_table_create(&table, &light->sky, &none, &axes, axes.toward, err);
    }
    if (status == PP_OK) {
        struct pp_pane_light tables = {.sky = table, .sky_axes = &axes};
        struct pp_direct how = {.unglazed_error = PP_QUADRATURE_PANE,
                                .tables = table ? &tables : NULL};
        pane->cells[0] = whole;
        status = divide_pane(pane, &borders, world, light, opening, &how, err);
    }
    pp_sky_table_destroy(table);
    free(borders.at[0]);
    free(borders.at[1]);
    if (status != PP_OK)
        pp_diffusing_pane_clear(pane);
    return status;
}

void pp_diffusing_pane_clear(struct pp_diffusing_pane *pane)
{
    free(pane->cells);
    *pane = (struct pp_diffusing_pane){0};
}

/* ---- the direct component ---- */

/* A component of the illuminance of a cell. */
struct cell_light {
    const struct pp_pane_cell_seen *seen;
    const double (*values)[NODES];
};

static double illuminance_at(const void *context, struct pp_vec3 u)
{
    const struct cell_light *light = context;
    const struct pp_pane_cell_seen *seen = light->seen;
    const struct pp_pane_cell *cell = seen->cell;
    double reach_m = seen->distance_m / pp_vec_dot(u, seen->plane.toward);
    double xy[2] = {seen->eye[0] + reach_m * pp_vec_dot(u, seen->plane.along),
                    seen->eye[1] + reach_m * pp_vec_dot(u, seen->plane.up)};
    double weights[2][NODES], sum = 0.0;
    for (int axis = 0; axis < 2; axis++)
        pp_pane_cell_weights(weights[axis],
                             (2.0 * xy[axis] - cell->low[axis] - cell->high[axis])
                                 / (cell->high[axis] - cell->low[axis]));
    for (int i = 0; i < NODES; i++) {
        double row = 0.0;
        for (int k = 0; k < NODES; k++)
            row += weights[1][k] * light->values[i][k];
        sum += weights[0][i] * row;
    }
    return sum;
}

/* The half-spaces whose planes contain the eye and the sides of the cell. */
static void sides_of(struct pp_vec3 sides[4], const struct pp_pane_cell_seen *seen)
{
    const struct pp_vec3 axes[2] = {seen->plane.along, seen->plane.up};
    for (int axis = 0; axis < 2; axis++) {
        double low = seen->cell->low[axis] - seen->eye[axis];
        double high = seen->cell->high[axis] - seen->eye[axis];
        struct pp_vec3 across = pp_vec_scale(axes[axis], seen->distance_m);
        sides[2 * axis] = pp_vec_along(across, -low, seen->plane.toward);
        sides[2 * axis + 1] =
            pp_vec_scale(pp_vec_along(across, -high, seen->plane.toward), -1.0);
    }
}

static enum pp_status add_cell(struct pp_direct *sum,
                               const struct pp_pane_cell_seen *seen,
                               const struct pp_bounds2 *bounds,
                               const struct pp_visible *visible, struct pp_vec3 normal,
                               struct pp_error *err)
{
    if (pp_pane_rectangle_add(sum, seen, bounds, visible, normal))
        return PP_OK;
    struct pp_vec3 half_spaces[5] = {normal};
    sides_of(half_spaces + 1, seen);
    double *values[2] = {&sum->sky, &sum->external};
    enum pp_status status = PP_OK;
    for (int i = 0; i < 2 && status == PP_OK; i++) {
        struct pp_quadrature result;
        struct cell_light light = {seen,
                                   i == 0 ? seen->cell->sky : seen->cell->external};
        struct pp_integrand part = {illuminance_at, &light, NULL, 0.0};
        status = pp_quadrature_over(
            &result, &visible->view, &visible->patches[0].region, half_spaces, 5,
            normal, &part, sum->rough ? PP_QUADRATURE_ROUGH : PP_QUADRATURE_GLAZED,
            err);
        *values[i] += result.value;
        sum->error += result.error;
    }
    return status;
}

enum pp_status pp_diffusing_pane_add(struct pp_direct *sum,
                                     const struct pp_diffusing_pane *pane,
                                     const struct pp_visible *visible,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     struct pp_error *err)
{
    struct pp_pane_cell_seen seen = {.plane = pane_plane(opening)};
    struct pp_vec3 eye = receiver->position;
    seen.eye[0] = pp_vec_dot(eye, seen.plane.along);
    seen.eye[1] = pp_vec_dot(eye, seen.plane.up);
    seen.distance_m = pp_vec_dot(pp_vec_sub(seen.plane.foot, eye), seen.plane.toward);
    struct pp_bounds2 bounds =
        pp_pane_rectangle_around(&seen, visible, receiver->normal);
    double before = sum->sky + sum->external;
    enum pp_status status = PP_OK;
    for (int i = 0; i < pane->cell_count && status == PP_OK; i++) {
        seen.cell = &pane->cells[i];
        status = add_cell(sum, &seen, &bounds, visible, receiver->normal, err);
    }
    sum->error += pane->error * (sum->sky + sum->external - before);
    return status;
}
