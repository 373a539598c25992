/* axial_table.c - integrates the moments from node to node of each cell, and fits a
 * polynomial to each cell. */
#include "methods/fast/axial_table.h"

#include <string.h>

#include "model/geometry/polynomial.h"

/* Value of rho between coarse and fine cells. Near rho = 1 (c = 0, grazing incidence)
 * the transmittance of glass changes over a range of 0.005 in c. */
#define BORDER 0.9375
enum { COARSE = 32, FINE = 32 };

/* Chebyshev nodes on -1 to 1: -cos((2 i + 1) pi / 12). */
static const double chebyshev[PP_AXIAL_POWERS] = {
    -0.96592582628906829, -0.70710678118654752, -0.25881904510252076,
    0.25881904510252076,  0.70710678118654752,  0.96592582628906829};

/* The six functions in (2). If p is 0 and the axis is perpendicular to q, n and g, as
 * for a vertical pane and a horizontal plane, only the last two are needed. */
enum { K_1, K_C, K_CC, K_CS, K_S, K_SS };

/* ---- the moments ---- */

struct moment_sums {
    pp_axial_function *function;
    const void *context;
    double theta;                /* upper limit of the integrals so far (rad) */
    double of[PP_AXIAL_MOMENTS]; /* the integrals without 1/s^(j+2) */
};

/* Extends the integrals to rho, by three Gauss points in theta: dc = sin theta
 * dtheta. */
static void extend_sums(struct moment_sums *sums, double rho)
{
    static const double node[3] = {-0.77459666924148338, 0.0, 0.77459666924148338};
    static const double weight[3] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
    double to = 2.0 * asin(rho / sqrt(2.0));
    double middle = (to + sums->theta) / 2.0, half = (to - sums->theta) / 2.0;
    for (int i = 0; i < 3; i++) {
        double c = cos(middle + half * node[i]), s = sin(middle + half * node[i]);
        double f = sums->function(sums->context, c) * s * half * weight[i];
        sums->of[K_1] += f;
        sums->of[K_C] += f * c;
        sums->of[K_S] += f * s;
        sums->of[K_CC] += f * c * c;
        sums->of[K_CS] += f * c * s;
        sums->of[K_SS] += f * s * s;
    }
    sums->theta = to;
}

/* Coefficients, in t from -1 to 1, of the polynomials through the values at the
 * Chebyshev nodes. */
static void fit_cell(double cell[PP_AXIAL_POWERS][PP_AXIAL_MOMENTS],
                     double values[PP_AXIAL_POWERS][PP_AXIAL_MOMENTS])
{
    for (int m = 0; m < PP_AXIAL_MOMENTS; m++) {
        double of[PP_AXIAL_POWERS], powers[PP_AXIAL_POWERS];
        for (int i = 0; i < PP_AXIAL_POWERS; i++)
            of[i] = values[i][m];
        pp_polynomial_through(powers, chebyshev, of, PP_AXIAL_POWERS);
        for (int k = 0; k < PP_AXIAL_POWERS; k++)
            cell[k][m] = powers[k];
    }
}

/* The low end and half the width of a cell, in rho. */
static double cell_extent(const struct pp_axial_table *table, int cell, double *half)
{
    bool coarse = cell < table->coarse_cells;
    double per = coarse ? table->coarse : table->fine;
    *half = 0.5 / per;
    return coarse ? cell / per : table->border + (cell - table->coarse_cells) / per;
}

/* The functions of (2) from the integrals of (3). */
static void divide_sums(double values[PP_AXIAL_MOMENTS], const struct moment_sums *sums,
                        const double balance[3])
{
    double angle = sums->theta, c = cos(angle), s = sin(angle), s2 = s * s;
    values[K_1] = (sums->of[K_1] - balance[0] * (1.0 - c)) / s2;
    values[K_C] = (sums->of[K_C] - balance[1] * (1.0 - c)) / s2;
    values[K_S] = (sums->of[K_S] - balance[2] * (angle - s * c) / 2.0) / (s2 * s);
    values[K_CC] = sums->of[K_CC] / s2;
    values[K_CS] = sums->of[K_CS] / (s2 * s);
    values[K_SS] = sums->of[K_SS] / (s2 * s2);
}

static void fill_cells(struct pp_axial_table *table, struct moment_sums *sums,
                       int cells)
{
    for (int i = 0; i < cells; i++) {
        double values[PP_AXIAL_POWERS][PP_AXIAL_MOMENTS], half;
        double low = cell_extent(table, i, &half);
        for (int k = 0; k < PP_AXIAL_POWERS; k++) {
            extend_sums(sums, low + half * (1.0 + chebyshev[k]));
            divide_sums(values[k], sums, table->balance);
        }
        fit_cell(table->cells[i], values);
    }
}

void pp_axial_table_init(struct pp_axial_table *table, pp_axial_function *function,
                         const void *context)
{
    table->border = BORDER;
    table->coarse = COARSE / BORDER;
    table->fine = FINE / (1.0 - BORDER);
    table->coarse_cells = COARSE;
    memset(table->balance, 0, sizeof table->balance);
    struct moment_sums sums = {.function = function, .context = context};
    fill_cells(table, &sums, COARSE + FINE);
}

void pp_axial_table_init_balanced(struct pp_axial_table *table,
                                  pp_axial_function *function, const void *context)
{
    const double end = sqrt(2.0);
    table->border = end;
    table->coarse = PP_AXIAL_CELLS / end;
    table->fine = 1.0;
    table->coarse_cells = PP_AXIAL_CELLS;
    struct moment_sums sums = {.function = function, .context = context};
    for (int i = 1; i <= PP_AXIAL_CELLS; i++)
        extend_sums(&sums, end * i / PP_AXIAL_CELLS);
    table->balance[0] = sums.of[K_1] / 2.0;
    table->balance[1] = sums.of[K_C] / 2.0;
    table->balance[2] = sums.of[K_S] / (PP_PI / 2.0);
    sums = (struct moment_sums){.function = function, .context = context};
    fill_cells(table, &sums, PP_AXIAL_CELLS);
}

/* ---- the potential ---- */

/* Values at c of the functions with index `first` and above. */
static inline __attribute__((always_inline)) void moments_at(
    double k[PP_AXIAL_MOMENTS], const struct pp_axial_table *table, double c, int first)
{
    double rho = c < 1.0 ? sqrt(1.0 - c) : 0.0;
    bool coarse = rho < table->border;
    double at = coarse ? rho * table->coarse : (rho - table->border) * table->fine;
    int cell = (int)at;
    double t = 2.0 * (at - cell) - 1.0;
    cell += coarse ? 0 : table->coarse_cells;
    if (cell >= PP_AXIAL_CELLS) { /* beyond the last cell by rounding */
        t += 2.0 * (cell - PP_AXIAL_CELLS + 1);
        cell = PP_AXIAL_CELLS - 1;
    }
    const double(*powers)[PP_AXIAL_MOMENTS] = table->cells[cell];
    for (int m = first; m < PP_AXIAL_MOMENTS; m++)
        k[m] = powers[PP_AXIAL_POWERS - 1][m];
    for (int p = PP_AXIAL_POWERS - 2; p >= 0; p--)
        for (int m = first; m < PP_AXIAL_MOMENTS; m++)
            k[m] = k[m] * t + powers[p][m];
}

/* is_square: p is 0, and the axis is perpendicular to q, n and g, so that q.a, n.a and
 * g.a are 0. The function is inlined twice, and each copy evaluates only the functions
 * that it needs. */
static inline __attribute__((always_inline)) double potential_of(
    const struct pp_axial_light *axial, const struct pp_arc_nodes *nodes, double along,
    double n, double g, bool is_square)
{
    struct pp_vec3 axis = axial->axis;
    double sum = 0.0;
    for (int i = 0; i < nodes->count; i++) {
        struct pp_vec3 u = nodes->u[i];
        double k[PP_AXIAL_MOMENTS], c = pp_vec_dot(axis, u);
        moments_at(k, axial->table, c, is_square ? K_S : K_1);
        double potential = is_square ? 0.0 : axial->constant * k[K_1] + along * k[K_C];
        potential += (pp_vec_dot(axial->linear, u) - c * along) * k[K_S];
        if (axial->quadratic) {
            double across_n = pp_vec_dot(axial->n, u) - c * n;
            double across_g = pp_vec_dot(axial->g, u) - c * g;
            double rest =
                is_square ? 0.0
                          : n * g * k[K_CC] + (n * across_g + g * across_n) * k[K_CS];
            potential += rest + across_n * across_g * k[K_SS];
        }
        sum += nodes->weight[i] * potential;
    }
    return sum * pp_vec_dot(axis, nodes->across);
}

double pp_axial_table_potential(const void *light, const struct pp_arc_nodes *nodes)
{
    const struct pp_axial_light *axial = light;
    double along = pp_vec_dot(axial->linear, axial->axis);
    double n = axial->quadratic ? pp_vec_dot(axial->n, axial->axis) : 0.0;
    double g = axial->quadratic ? pp_vec_dot(axial->g, axial->axis) : 0.0;
    return axial->constant == 0.0 && along == 0.0 && n == 0.0 && g == 0.0
               ? potential_of(axial, nodes, 0.0, 0.0, 0.0, true)
               : potential_of(axial, nodes, along, n, g, false);
}

double pp_axial_table_sum(const struct pp_axial_light *light, double longest,
                          double width, const struct pp_vec3 *vertices, int count,
                          const struct pp_vec3 *half_spaces, int half_space_count)
{
    const struct pp_arc_spacing spacing = {
        .longest = longest, .bend_count = 1, .bends = {{light->axis, width}}};
    return pp_arc_sum(pp_axial_table_potential, light, &spacing, vertices, count,
                      half_spaces, half_space_count);
}
