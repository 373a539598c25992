/* sky_table.c - fills the table meridian by meridian, and interpolates it along
 * arcs. */
#include "methods/fast/sky_table.h"

#include <stdlib.h>

#include "methods/fast/axial_table.h"

/* Steps of t from 0 to 1, and of the tangent from -1 to 1; extra rows and columns at
 * the edges, for the splines. */
enum { STEPS = 96, COLUMN_STEPS = 96, BEYOND = 3 };
enum {
    MIDDLE = STEPS + BEYOND,
    ROWS = 2 * MIDDLE + 1,
    COLUMNS = COLUMN_STEPS + 2 * BEYOND + 1
};

/* Bounds on arcs, found by trial: the longest chord; the width about grazing incidence
 * within which the transmittance of glass changes fast; the corresponding width of a
 * gradation, divided by -b, where b is the gradation's parameter. */
#define ARC_LONGEST 1.2
#define PANE_BEND 0.05
#define GRADATION_BEND 0.35

struct pp_sky_table {
    struct pp_vec3 room_normal;
    bool has_sun_part;
    struct pp_arc_spacing spacing;
    struct pp_vec3 sun; /* in the view's axes, like all members below */
    struct pp_axial_table circumsolar;
    struct pp_axial_light sun_part;
    double chart[2][ROWS][COLUMNS]; /* values of B, later the coefficients of the
                                     * splines */
};

/* ---- the integrand ---- */

struct sky_integrand {
    const struct pp_sky *sky;
    const struct pp_glass *glass;
    struct pp_vec3 zenith, normal;
    double at_right_angles; /* exp(d pi/2) */
    const struct pp_sky_table *table;
};

double pp_sky_table_gradation(const struct pp_sky *sky, double z)
{
    return sky->a != 0.0 && z > 0.0 ? 1.0 + sky->a * exp(sky->b / z) : 1.0;
}

static double circumsolar_at(const void *context, double cos_chi)
{
    const struct pp_sky *sky = context;
    double half = sqrt(fmin(1.0, fmax(0.0, (1.0 - cos_chi) / 2.0)));
    return exp(sky->d * 2.0 * asin(half));
}

/* f minus the circumsolar part, for the transmittance tau at u. */
static double remainder_at(const struct sky_integrand *integrand, struct pp_vec3 u,
                           double tau)
{
    const struct pp_sky *sky = integrand->sky;
    const struct pp_sky_table *table = integrand->table;
    double g = sky->per_horizontal * tau * pp_vec_dot(integrand->normal, u)
               * pp_sky_table_gradation(sky, pp_vec_dot(integrand->zenith, u));
    if (sky->c == 0.0 && sky->e == 0.0)
        return g;
    double cos_chi = pp_vec_dot(table->sun, u);
    double around = circumsolar_at(sky, cos_chi);
    double f = g
               * (1.0 + sky->c * (around - integrand->at_right_angles)
                  + sky->e * cos_chi * cos_chi);
    if (!table->has_sun_part)
        return f;
    const struct pp_axial_light *part = &table->sun_part;
    const double *balance = table->circumsolar.balance;
    double along = pp_vec_dot(part->linear, table->sun);
    double across = pp_vec_dot(part->linear, u) - cos_chi * along;
    return f - part->constant * (around - balance[0])
           - along * (around * cos_chi - balance[1]) - across * (around - balance[2]);
}

/* Finds the tangent plane of c G at the sun. */
static void find_sun_part(struct pp_sky_table *table,
                          const struct sky_integrand *integrand)
{
    const struct pp_sky *sky = integrand->sky;
    const struct pp_glass *glass = integrand->glass;
    const struct pp_vec3 w = {0.0, 0.0, 1.0};
    double cos_i = table->sun.z, z = pp_vec_dot(integrand->zenith, table->sun);
    double facing = pp_vec_dot(integrand->normal, table->sun);
    double per = sky->c * sky->per_horizontal;
    double phi = pp_sky_table_gradation(sky, z);
    double phi_slope = z > 0.0 ? -(phi - 1.0) * sky->b / (z * z) : 0.0;
    double tau = pp_glass_transmittance(glass, cos_i);
    const double step = 1e-4;
    double tau_slope = (pp_glass_transmittance(glass, cos_i + step)
                        - pp_glass_transmittance(glass, cos_i - step))
                       / (2.0 * step);
    struct pp_vec3 slope = pp_vec_scale(integrand->normal, per * phi * tau);
    slope = pp_vec_along(slope, per * phi_slope * tau * facing, integrand->zenith);
    slope = pp_vec_along(slope, per * phi * tau_slope * facing, w);
    pp_axial_table_init_balanced(&table->circumsolar, circumsolar_at, sky);
    table->sun_part = (struct pp_axial_light){
        .table = &table->circumsolar,
        .axis = table->sun,
        .constant = per * phi * tau * facing - pp_vec_dot(slope, table->sun),
        .linear = slope};
}

/* ---- the table ---- */

/* The cosine c = w.u at t, and its slope -dc/dt. Beyond t = 1 (grazing incidence) c
 * rises again: a function of c is also smooth in t there. */
static double cosine_of(double t)
{
    return (1.0 - t * t) * (1.0 - t * t);
}

static double slope_of(double t)
{
    return 4.0 * t * (1.0 - t * t);
}

/* Cosines c, transmittances, and weights -dc at the Gauss points of each step of t. */
struct pane_steps {
    double c[STEPS][2], tau[STEPS][2], dc[STEPS][2];
};

static struct pane_steps steps_of(const struct pp_glass *glass)
{
    struct pane_steps steps;
    const double off = sqrt(3.0) / 6.0;
    for (int i = 0; i < STEPS; i++)
        for (int k = 0; k < 2; k++) {
            double t = (i + 0.5 + (k ? off : -off)) / STEPS;
            steps.c[i][k] = cosine_of(t);
            steps.dc[i][k] = slope_of(t) / (2.0 * STEPS);
            steps.tau[i][k] = pp_glass_transmittance(glass, steps.c[i][k]);
        }
    return steps;
}

/* Fills half of column k along the meridian towards (a, b), from the middle row on.
 * way: step from row to row, 1 or -1. */
static void fill_meridian(double (*chart)[COLUMNS], int k, int way,
                          const struct sky_integrand *integrand,
                          const struct pane_steps *steps, double a, double b)
{
    double sum = 0.0;
    for (int i = 0; i < STEPS; i++) {
        for (int point = 0; point < 2; point++) {
            double c = steps->c[i][point], s = sqrt(1.0 - c * c);
            struct pp_vec3 u = {s * a, s * b, c};
            sum +=
                remainder_at(integrand, u, steps->tau[i][point]) * steps->dc[i][point];
        }
        double c = cosine_of((i + 1.0) / STEPS);
        chart[MIDDLE + way * (i + 1)][k] = sum / (1.0 - c * c);
    }
    for (int i = 1; i <= BEYOND; i++)
        chart[MIDDLE + way * (STEPS + i)][k] = chart[MIDDLE + way * (STEPS - i)][k];
}

static void fill_charts(struct pp_sky_table *table,
                        const struct sky_integrand *integrand)
{
    const struct pane_steps steps = steps_of(integrand->glass);
    const struct pp_vec3 w = {0.0, 0.0, 1.0};
    double middle =
        remainder_at(integrand, w, pp_glass_transmittance(integrand->glass, 1.0)) / 2.0;
    for (int chart = 0; chart < 2; chart++)
        for (int k = 0; k < COLUMNS; k++) {
            double q = 2.0 * (k - BEYOND) / COLUMN_STEPS - 1.0, r = 1.0 / hypot(1.0, q);
            double a = chart ? q * r : r, b = chart ? r : q * r;
            table->chart[chart][MIDDLE][k] = middle;
            fill_meridian(table->chart[chart], k, 1, integrand, &steps, a, b);
            fill_meridian(table->chart[chart], k, -1, integrand, &steps, -a, -b);
        }
}

/* Converts values along a line, a stride apart, to coefficients of the interpolating
 * cubic B-splines. Approximates the inverse of (4 + 2 cos w) / 6 up to the fourth
 * difference. The first two and the last two values are unchanged. */
static void to_splines(double *at, int count, int stride)
{
    double before2 = at[0], before = at[stride], *v = at + 2 * stride;
    for (int i = 2; i + 2 < count; i++, v += stride) {
        double second = before - 2.0 * v[0] + v[stride];
        double fourth =
            before2 - 4.0 * before + 6.0 * v[0] - 4.0 * v[stride] + v[2 * stride];
        before2 = before;
        before = v[0];
        v[0] += fourth / 36.0 - second / 6.0;
    }
}

enum pp_status pp_sky_table_create(struct pp_sky_table **table,
                                   const struct pp_sky *sky,
                                   const struct pp_glass *glass,
                                   const struct pp_projection *view,
                                   struct pp_vec3 normal, struct pp_error *err)
{
    struct pp_sky_table *made = malloc(sizeof *made);
    if (!made)
        return pp_fail_memory(err);
    struct sky_integrand integrand = {
        .sky = sky,
        .glass = glass,
        .zenith = pp_projection_direction(view, pp_vec(0.0, 0.0, 1.0)),
        .normal = pp_projection_direction(view, normal),
        .at_right_angles = exp(sky->d * PP_PI / 2.0),
        .table = made};
    made->room_normal = normal;
    made->sun = pp_projection_direction(view, sky->sun);
    made->has_sun_part = sky->c != 0.0 && made->sun.z > (glass->panes > 0 ? 0.0 : -0.2);
    made->spacing =
        (struct pp_arc_spacing){.longest = ARC_LONGEST,
                                .bend_count = sky->a != 0.0 ? 2 : 1,
                                .bends = {{{0.0, 0.0, 1.0}, PANE_BEND},
                                          {integrand.zenith, -GRADATION_BEND * sky->b}},
                                .cusp = sky->c != 0.0 ? &made->sun : NULL,
                                .axis = {0.0, 0.0, 1.0}};
    if (made->has_sun_part)
        find_sun_part(made, &integrand);
    fill_charts(made, &integrand);
    for (int chart = 0; chart < 2; chart++) {
        for (int row = 0; row < ROWS; row++)
            to_splines(made->chart[chart][row], COLUMNS, 1);
        for (int k = 0; k < COLUMNS; k++)
            to_splines(&made->chart[chart][0][k], ROWS, COLUMNS);
    }
    *table = made;
    return PP_OK;
}

void pp_sky_table_destroy(struct pp_sky_table *table)
{
    free(table);
}

bool pp_sky_table_is_for(const struct pp_sky_table *table, struct pp_vec3 normal)
{
    return table->room_normal.x == normal.x && table->room_normal.y == normal.y
           && table->room_normal.z == normal.z;
}

/* ---- reading it ---- */

/* The step that contains `at` (in steps), and the weights of its four splines. */
static inline int spline_weights(double weights[4], double at, int steps)
{
    int i = (int)at;
    i = i < 0 ? 0 : i < steps ? i : steps - 1;
    double t = at - i, r = 1.0 - t;
    weights[0] = r * r * r / 6.0;
    weights[1] = (4.0 - 3.0 * t * t * (1.0 + r)) / 6.0;
    weights[2] = (4.0 - 3.0 * r * r * (1.0 + t)) / 6.0;
    weights[3] = t * t * t / 6.0;
    return i;
}

static inline double potential_at(const struct pp_sky_table *table, struct pp_vec3 u)
{
    double t = u.z < 1.0 ? sqrt(1.0 - sqrt(u.z)) : 0.0, down[4], across[4], sum = 0.0;
    int chart = fabs(u.y) > fabs(u.x);
    double first = chart ? u.y : u.x, second = chart ? u.x : u.y;
    double q = first != 0.0 ? second / first : 0.0;
    int row = spline_weights(down, (copysign(t, first) + 1.0) * STEPS, 2 * STEPS);
    int k = spline_weights(across, (q + 1.0) * (COLUMN_STEPS / 2.0), COLUMN_STEPS);
    for (int i = 0; i < 4; i++) {
        const double *at = &table->chart[chart][row + BEYOND - 1 + i][k + BEYOND - 1];
        sum += down[i]
               * (across[0] * at[0] + across[1] * at[1] + across[2] * at[2]
                  + across[3] * at[3]);
    }
    return sum;
}

static double sky_potential(const void *context, const struct pp_arc_nodes *nodes)
{
    const struct pp_sky_table *table = context;
    double sum = 0.0;
    for (int i = 0; i < nodes->count; i++)
        sum += nodes->weight[i] * potential_at(table, nodes->u[i]);
    sum *= nodes->across.z;
    if (table->has_sun_part)
        sum += pp_axial_table_potential(&table->sun_part, nodes);
    return sum;
}

double pp_sky_table_sum(const struct pp_sky_table *table,
                        const struct pp_vec3 *vertices, int count,
                        const struct pp_vec3 *half_spaces, int half_space_count)
{
    return pp_arc_sum(sky_potential, table, &table->spacing, vertices, count,
                      half_spaces, half_space_count);
}
