/* gloss.c - the gloss lobe: tabulates its scale, evaluates and samples it. */
#include "simulate/sampling/gloss.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    COSINES = PP_GLOSS_COSINES,
    SLOPES = 64, /* slopes of facets: SLOPES radii times SLOPES azimuths */
    FACETS = SLOPES * SLOPES,
    ROUNDS = 60, /* iterations; after 40 nothing changes in the twelfth digit */
};

static const double SMOOTH = 1e-3;

bool pp_gloss_is_mirror(double along, double across)
{
    return along < SMOOTH && across < SMOOTH;
}

bool pp_gloss_is_of(const struct pp_gloss *gloss, double along, double across)
{
    return gloss->along == fmax(along, SMOOTH) && gloss->across == fmax(across, SMOOTH);
}

/* ---- the table's nodes ---- */

/* Roughness in the azimuth of a direction, an even function. */
static double roughness_towards(const struct pp_gloss *gloss, struct pp_vec3 d)
{
    double flat2 = d.x * d.x + d.y * d.y;
    if (gloss->azimuths == 1 || !(flat2 > 0.0))
        return gloss->along;
    double x = gloss->along * d.x, y = gloss->across * d.y;
    return sqrt((x * x + y * y) / flat2);
}

/* The scale changes most where the cosine is about as large as the roughness. With this
 * factor, chosen by trial, columns are densest from there down to grazing incidence. */
static const double COLUMN_SPACING = 4.0;

/* Cell of the table around a direction: the lower row and column, and the interpolation
 * weights of the next row and column. */
struct gloss_node {
    int row, column;
    double up, right;
};

static int node_below(double x, int count, double *rest)
{
    int i = (int)(x * (count - 1));
    if (i > count - 2)
        i = count - 2;
    *rest = x * (count - 1) - i;
    return i;
}

static struct gloss_node gloss_node_at(const struct pp_gloss *gloss, struct pp_vec3 d)
{
    struct gloss_node place = {0, 0, 0.0, 0.0};
    double rough = roughness_towards(gloss, d);
    if (gloss->azimuths > 1)
        place.row = node_below((rough - gloss->along) / (gloss->across - gloss->along),
                               gloss->azimuths, &place.up);
    double z = fmax(d.z, 0.0), k = COLUMN_SPACING * rough;
    place.column =
        node_below(fmin(sqrt(z * (1.0 + k) / (z + k)), 1.0), COSINES, &place.right);
    return place;
}

/* The direction of a node. */
static struct pp_vec3 node_direction(const struct pp_gloss *gloss, int row, int column)
{
    double along = gloss->along, across = gloss->across, rough = along, x2 = 0.0;
    if (gloss->azimuths > 1) {
        rough += (double)row / (gloss->azimuths - 1) * (across - along);
        x2 = (across * across - rough * rough) / (across * across - along * along);
    }
    double k = COLUMN_SPACING * rough, part = (double)column / (COSINES - 1);
    part *= part;
    double z = fmin(fmax(k * part / (1.0 + k - part), 1e-6 * k), 1.0);
    double flat = sqrt(1.0 - z * z);
    return pp_vec(flat * sqrt(fmax(x2, 0.0)), flat * sqrt(1.0 - fmax(x2, 0.0)), z);
}

double pp_gloss_scale(const struct pp_gloss *gloss, struct pp_vec3 direction)
{
    struct gloss_node at = gloss_node_at(gloss, direction);
    const double *low = &gloss->scale[at.row][at.column];
    double value = low[0] + at.right * (low[1] - low[0]);
    if (gloss->azimuths == 1)
        return value;
    const double *high = &gloss->scale[at.row + 1][at.column];
    return value + at.up * (high[0] + at.right * (high[1] - high[0]) - value);
}

/* ---- the lobe ---- */

/* f without the scale. *p and *q: the slope of h, in units of the roughness. */
static double ward(const struct pp_gloss *gloss, struct pp_vec3 i, struct pp_vec3 o,
                   double *p, double *q)
{
    struct pp_vec3 h = pp_vec_add(i, o);
    if (!(h.z > 0.0))
        return 0.0;
    double along = gloss->along, across = gloss->across;
    *p = h.x / (along * h.z);
    *q = h.y / (across * h.z);
    return exp(-(*p * *p + *q * *q)) / (PP_PI * along * across) * pp_vec_dot(h, h)
           / (h.z * h.z * h.z * h.z);
}

double pp_gloss_value(const struct pp_gloss *gloss, struct pp_vec3 i, struct pp_vec3 o)
{
    double p, q, f = ward(gloss, i, o, &p, &q);
    return f > 0.0 ? f * pp_gloss_scale(gloss, i) * pp_gloss_scale(gloss, o) : 0.0;
}

/* The direction into which a facet of slope (a_x p, a_y q) mirrors i, and its weight in
 * the unscaled lobe; 0 if the direction points into the surface. */
static double mirrored(const struct pp_gloss *gloss, struct pp_vec3 i, double p,
                       double q, struct pp_vec3 *o)
{
    struct pp_vec3 h = {gloss->along * p, gloss->across * q, 1.0};
    double facing = pp_vec_dot(h, i);
    *o = pp_vec_along(pp_vec_scale(i, -1.0), 2.0 * facing / pp_vec_dot(h, h), h);
    return facing > 0.0 && o->z > 0.0 ? 2.0 * o->z / (i.z + o->z) : 0.0;
}

double pp_gloss_sample(const struct pp_gloss *gloss, struct pp_vec3 i, double u,
                       double v, struct pp_vec3 *o)
{
    double r = sqrt(-log(u)), sine, cosine;
    sincos(2.0 * PP_PI * v, &sine, &cosine);
    /* Near grazing incidence, usually only one of two opposite slopes mirrors light
     * down. This slope is then used with half its weight, since it is drawn twice as
     * often. */
    struct pp_vec3 opposite;
    double weight = mirrored(gloss, i, r * cosine, r * sine, o);
    double other = mirrored(gloss, i, -r * cosine, -r * sine, &opposite);
    if (!(weight > 0.0))
        *o = opposite;
    if (!(weight > 0.0) || !(other > 0.0))
        weight = (weight + other) / 2.0;
    if (!(weight > 0.0))
        return 0.0;
    return weight * pp_gloss_scale(gloss, i) * pp_gloss_scale(gloss, *o);
}

double pp_gloss_pdf(const struct pp_gloss *gloss, struct pp_vec3 i, struct pp_vec3 o)
{
    double p, q, f = ward(gloss, i, o, &p, &q);
    struct pp_vec3 opposite;
    if (!(f > 0.0))
        return 0.0;
    bool alone = !(mirrored(gloss, i, -p, -q, &opposite) > 0.0);
    return f * (i.z + o.z) / 2.0 * (alone ? 2.0 : 1.0);
}

/* ---- the scale ---- */

/* Facets of equal probability: midpoints of a grid on the unit square, mapped to the
 * Gaussian. */
static void draw_facets(double (*facets)[2])
{
    for (int i = 0; i < SLOPES; i++)
        for (int k = 0; k < SLOPES; k++) {
            double r = sqrt(-log((i + 0.5) / SLOPES)), sine, cosine;
            sincos(2.0 * PP_PI * (k + 0.5) / SLOPES, &sine, &cosine);
            facets[i * SLOPES + k][0] = r * cosine;
            facets[i * SLOPES + k][1] = r * sine;
        }
}

/* The fraction of light from one direction that goes to the neighbourhood of each
 * node. */
static void distribute(const struct pp_gloss *gloss, const double (*facets)[2],
                       struct pp_vec3 from, double *to_node)
{
    for (int i = 0; i < FACETS; i++) {
        struct pp_vec3 to;
        double weight = mirrored(gloss, from, facets[i][0], facets[i][1], &to);
        if (!(weight > 0.0))
            continue;
        struct gloss_node at = gloss_node_at(gloss, to);
        double *low = &to_node[at.row * COSINES + at.column];
        double right = weight / FACETS * at.right, left = weight / FACETS - right;
        low[0] += (1.0 - at.up) * left;
        low[1] += (1.0 - at.up) * right;
        if (gloss->azimuths > 1) {
            low[COSINES] += at.up * left;
            low[COSINES + 1] += at.up * right;
        }
    }
}

/* The iteration of [SK67] for a symmetric lobe: each scale is divided by the square
 * root of the total light that it scatters, which should be 1. */
static void balance(double *scale, const double *lobe, int nodes)
{
    double next[PP_GLOSS_AZIMUTHS * COSINES];
    for (int i = 0; i < nodes; i++)
        scale[i] = 1.0;
    for (int round = 0; round < ROUNDS; round++) {
        for (int i = 0; i < nodes; i++) {
            double sum = 0.0;
            for (int k = 0; k < nodes; k++)
                sum += lobe[i * nodes + k] * scale[k];
            next[i] = sqrt(scale[i] / sum);
        }
        memcpy(scale, next, (size_t)nodes * sizeof *scale);
    }
}

enum pp_status pp_gloss_init(struct pp_gloss *gloss, double along, double across,
                             struct pp_error *err)
{
    *gloss = (struct pp_gloss){.along = fmax(along, SMOOTH),
                               .across = fmax(across, SMOOTH),
                               .azimuths = along == across ? 1 : PP_GLOSS_AZIMUTHS};
    int nodes = gloss->azimuths * COSINES;
    double(*facets)[2] = malloc(FACETS * sizeof *facets);
    double *lobe = calloc((size_t)nodes * (size_t)nodes, sizeof *lobe);
    enum pp_status status = facets && lobe ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK) {
        draw_facets(facets);
        for (int i = 0; i < nodes; i++)
            distribute(gloss, (const double(*)[2])facets,
                       node_direction(gloss, i / COSINES, i % COSINES),
                       &lobe[i * nodes]);
        balance(gloss->scale[0], lobe, nodes);
    }
    free(facets);
    free(lobe);
    return status;
}
