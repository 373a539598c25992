/* slat_cell.c - solves (1) once for all incident light.
 *
 * Shares are calculated from rays. At a critical angle a ray passes the end of a strip;
 * between two successive critical angles all rays meet the same strip. The equations
 * are solved for the light that leaves in each bin. from_strip[j][k] is the fraction of
 * the light incident on strip side j that leaves in bin k after all reflections.
 */
#include "model/light/slats/slat_cell.h"

#include <stdlib.h>
#include <string.h>

#include "model/base/error.h"
#include "model/geometry/gauss.h"

enum {
    STRIPS = 24,
    SIDES = 2 * STRIPS, /* upper sides, then lower sides */
    POINTS = 4,         /* points of the quadrature over a strip */
    NEIGHBOURS = 3,     /* the slat itself, the one above and the one below */
    ENDS = NEIGHBOURS * (STRIPS + 1),
    CRITICAL = ENDS + PP_SLAT_BINS + 2,
    SKY_STEPS = 180,
};

#define STEEPEST (89.99 * PP_RAD) /* largest tilt: slats close the blind */
#define BIN_RAD (2.0 * PP_PI / PP_SLAT_BINS)

struct slat_place {
    double a, b;
};

struct pp_slat_cell {
    struct pp_slats slats;
    struct slat_place end[STRIPS + 1]; /* ends of the strips of one slat */
    double from_strip[SIDES][PP_SLAT_BINS];
};

/* First strip that a ray meets, the side of the strip, and its slat. */
struct meeting {
    int strip; /* -1: none */
    bool upper;
    int slat; /* -1: the slat below; 0: the same; 1: above */
};

static double cross(struct slat_place p, struct slat_place q)
{
    return p.a * q.b - p.b * q.a;
}

static struct slat_place difference(struct slat_place p, struct slat_place q)
{
    return (struct slat_place){p.a - q.a, p.b - q.b};
}

static struct slat_place strip_end(const struct pp_slat_cell *cell, int slat, int i)
{
    struct slat_place p = cell->end[i];
    p.b += slat * cell->slats.spacing;
    return p;
}

/* First strip that a ray meets beyond the distance `after`; strip `own` of slat 0 is
 * skipped. */
static struct meeting first_strip(const struct pp_slat_cell *cell,
                                  struct slat_place from, struct slat_place way,
                                  double after, int own)
{
    struct meeting first = {-1, false, 0};
    double nearest = INFINITY;
    for (int slat = -1; slat <= 1; slat++)
        for (int i = 0; i < STRIPS; i++) {
            struct slat_place p = difference(strip_end(cell, slat, i), from);
            struct slat_place q = difference(strip_end(cell, slat, i + 1), from);
            double left = cross(way, p), right = cross(way, q);
            if ((slat == 0 && i == own) || left * right > 0.0 || left == right)
                continue;
            double share = left / (left - right);
            double far = way.a * (p.a + share * (q.a - p.a))
                         + way.b * (p.b + share * (q.b - p.b));
            if (far > after && far < nearest) {
                nearest = far;
                first = (struct meeting){i, cross(difference(q, p), way) < 0.0, slat};
            }
        }
    return first;
}

static int compare_numbers(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int slat_bin(struct slat_place way)
{
    int bin = (int)floor((atan2(-way.b, way.a) + PP_PI) / BIN_RAD);
    return bin < 0 ? 0 : bin < PP_SLAT_BINS ? bin : PP_SLAT_BINS - 1;
}

/* Directions from a place, as angles from the normal, at which a ray begins to meet
 * another strip or bin. Returns their number. */
static int critical_angles(const struct pp_slat_cell *cell, struct slat_place from,
                           struct slat_place normal, double *angle)
{
    struct slat_place tangent = {-normal.b, normal.a};
    int n = 0;
    angle[n++] = -0.5 * PP_PI;
    angle[n++] = 0.5 * PP_PI;
    for (int i = 0; i < ENDS + PP_SLAT_BINS; i++) {
        struct slat_place d;
        if (i < ENDS)
            d = difference(strip_end(cell, i % NEIGHBOURS - 1, i / NEIGHBOURS), from);
        else
            d = (struct slat_place){cos(i * BIN_RAD), -sin(i * BIN_RAD)};
        double up = d.a * normal.a + d.b * normal.b;
        if (up > 0.0)
            angle[n++] = atan2(d.a * tangent.a + d.b * tangent.b, up);
    }
    qsort(angle, (size_t)n, sizeof *angle, compare_numbers);
    return n;
}

/* Adds the shares of the light from a place on a strip. falls: share that falls on each
 * strip side (F_ij); leaves: share that leaves in each bin. */
static void add_place(const struct pp_slat_cell *cell, int own, struct slat_place from,
                      struct slat_place normal, double weight, double *falls,
                      double *leaves)
{
    double angle[CRITICAL];
    int n = critical_angles(cell, from, normal, angle);
    for (int k = 0; k + 1 < n; k++) {
        double share = 0.5 * weight * (sin(angle[k + 1]) - sin(angle[k]));
        double middle = 0.5 * (angle[k] + angle[k + 1]);
        struct slat_place way = {normal.a * cos(middle) - normal.b * sin(middle),
                                 normal.b * cos(middle) + normal.a * sin(middle)};
        struct meeting at = first_strip(cell, from, way, 0.0, own);
        if (at.strip < 0)
            leaves[slat_bin(way)] += share;
        else
            falls[at.strip + (at.upper ? 0 : STRIPS)] += share;
    }
}

/* Unit normal of a side of a strip. */
static struct slat_place side_normal(const struct pp_slat_cell *cell, int strip,
                                     bool upper)
{
    struct slat_place d = difference(cell->end[strip + 1], cell->end[strip]);
    double length = upper ? hypot(d.a, d.b) : -hypot(d.a, d.b);
    return (struct slat_place){-d.b / length, d.a / length};
}

static double side_reflectance(const struct pp_slat_cell *cell, int side)
{
    return side < STRIPS ? cell->slats.upper : cell->slats.lower;
}

/* Solves (I - F rho) X = leaves by elimination without pivoting: the diagonal
 * dominates, since some light leaves. rows: F_ij rho_j, overwritten. */
static void solve_leaving(double (*rows)[SIDES], double (*leaves)[PP_SLAT_BINS])
{
    for (int i = 0; i < SIDES; i++)
        for (int j = 0; j < SIDES; j++)
            rows[i][j] = (i == j) - rows[i][j];
    for (int i = 0; i < SIDES; i++) {
        double pivot = rows[i][i];
        for (int j = i; j < SIDES; j++)
            rows[i][j] /= pivot;
        for (int k = 0; k < PP_SLAT_BINS; k++)
            leaves[i][k] /= pivot;
        for (int other = 0; other < SIDES; other++) {
            double factor = rows[other][i];
            if (other == i || factor == 0.0)
                continue;
            for (int j = i; j < SIDES; j++)
                rows[other][j] -= factor * rows[i][j];
            for (int k = 0; k < PP_SLAT_BINS; k++)
                leaves[other][k] -= factor * leaves[i][k];
        }
    }
}

static void solve_cell(struct pp_slat_cell *cell, double (*rows)[SIDES])
{
    double nodes[POINTS], weights[POINTS];
    pp_gauss_legendre(nodes, weights, POINTS);
    memset(rows, 0, SIDES * sizeof *rows);
    for (int side = 0; side < SIDES; side++) {
        int strip = side % STRIPS;
        struct slat_place normal = side_normal(cell, strip, side < STRIPS);
        struct slat_place p = cell->end[strip];
        struct slat_place d = difference(cell->end[strip + 1], p);
        for (int i = 0; i < POINTS; i++) {
            double at = 0.5 * (1.0 + nodes[i]);
            struct slat_place from = {p.a + at * d.a, p.b + at * d.b};
            add_place(cell, strip, from, normal, 0.5 * weights[i], rows[side],
                      cell->from_strip[side]);
        }
        for (int j = 0; j < SIDES; j++)
            rows[side][j] *= side_reflectance(cell, j);
    }
    solve_leaving(rows, cell->from_strip);
    for (int side = 0; side < SIDES; side++)
        for (int k = 0; k < PP_SLAT_BINS; k++)
            cell->from_strip[side][k] *= side_reflectance(cell, side);
}

/* True if a strip of the slat crosses one of the slat above. */
static bool slats_cross(const struct pp_slat_cell *cell)
{
    for (int i = 0; i < STRIPS; i++)
        for (int j = 0; j < STRIPS; j++) {
            struct slat_place p = strip_end(cell, 0, i), q = strip_end(cell, 0, i + 1);
            struct slat_place r = strip_end(cell, 1, j), s = strip_end(cell, 1, j + 1);
            struct slat_place d = difference(q, p), e = difference(s, r);
            if (cross(d, difference(r, p)) * cross(d, difference(s, p)) < 0.0
                && cross(e, difference(p, r)) * cross(e, difference(q, r)) < 0.0)
                return true;
        }
    return false;
}

/* Cuts the slat into strips. They are narrower towards the edges of the slat, and end
 * where the edges of its neighbours project onto its chord (closed slats overlap). */
static void cut_strips(struct pp_slat_cell *cell)
{
    double at[STRIPS + 1];
    for (int i = 0; i <= STRIPS; i++)
        at[i] = 0.5 - 0.5 * cos(PP_PI * i / STRIPS);
    double foot =
        cell->slats.spacing * fabs(sin(cell->slats.tilt_rad)) / cell->slats.width;
    int nearest = (int)lround(acos(1.0 - 2.0 * fmin(foot, 1.0)) * STRIPS / PP_PI);
    if (nearest > 0 && nearest < STRIPS) {
        at[nearest] = foot;
        at[STRIPS - nearest] = 1.0 - foot;
    }
    for (int i = 0; i <= STRIPS; i++)
        pp_slats_point(&cell->slats, at[i], &cell->end[i].a, &cell->end[i].b);
}

/* Lays the cell out; false if neighbouring slats touch. */
static bool lay_out_cell(struct pp_slat_cell *cell, const struct pp_slats *slats)
{
    cell->slats = *slats;
    cell->slats.tilt_rad = fmax(-STEEPEST, fmin(slats->tilt_rad, STEEPEST));
    cut_strips(cell);
    return !slats_cross(cell);
}

bool pp_slat_cell_fits(const struct pp_slats *slats)
{
    struct pp_slat_cell *cell = calloc(1, sizeof *cell);
    bool fits = cell && lay_out_cell(cell, slats);
    free(cell);
    return fits;
}

enum pp_status pp_slat_cell_create(struct pp_slat_cell **made,
                                   const struct pp_slats *slats, struct pp_error *err)
{
    struct pp_slat_cell *cell = calloc(1, sizeof *cell);
    double(*rows)[SIDES] = malloc(SIDES * sizeof *rows);
    enum pp_status status = PP_OK;
    if (!cell || !rows) {
        status = pp_fail_memory(err);
    } else {
        if (!lay_out_cell(cell, slats))
            status = pp_fail(err, PP_BAD_INPUT,
                             "slats turned by %g degrees touch each other: curved by "
                             "%g m, they need more than the spacing of %g m",
                             slats->tilt_rad / PP_RAD, slats->rise, slats->spacing);
        else
            solve_cell(cell, rows);
    }
    free(rows);
    if (status != PP_OK) {
        free(cell);
        return status;
    }
    *made = cell;
    return PP_OK;
}

void pp_slat_cell_destroy(struct pp_slat_cell *cell)
{
    free(cell);
}

/* Light that falls on each side of the slat's strips, relative to the light that falls
 * on one spacing. The sum is the light that does not pass straight. */
static void incident_on_strips(const struct pp_slat_cell *cell, double profile_rad,
                               double straight, double *incident)
{
    struct slat_place way = {cos(profile_rad), -sin(profile_rad)};
    double across[ENDS], low = INFINITY, high = -INFINITY, sum = 0.0;
    double far = 2.0 * (cell->slats.width + cell->slats.spacing);
    int n = 0;
    memset(incident, 0, SIDES * sizeof *incident);
    for (int i = 0; i <= STRIPS; i++) {
        double own = cross(way, cell->end[i]);
        low = fmin(low, own);
        high = fmax(high, own);
    }
    for (int i = 0; i < ENDS; i++) {
        double c = cross(way, strip_end(cell, i % NEIGHBOURS - 1, i / NEIGHBOURS));
        if (c >= low && c <= high)
            across[n++] = c;
    }
    qsort(across, (size_t)n, sizeof *across, compare_numbers);
    for (int k = 0; k + 1 < n; k++) {
        double middle = 0.5 * (across[k] + across[k + 1]);
        struct slat_place from = {-far * way.a - middle * way.b,
                                  -far * way.b + middle * way.a};
        struct meeting at = first_strip(cell, from, way, 0.0, -1);
        if (at.strip < 0 || at.slat != 0)
            continue;
        incident[at.strip + (at.upper ? 0 : STRIPS)] += across[k + 1] - across[k];
        sum += across[k + 1] - across[k];
    }
    for (int i = 0; i < SIDES && sum > 0.0; i++)
        incident[i] *= (1.0 - straight) / sum;
}

void pp_slat_cell_light(const struct pp_slat_cell *cell, double profile_rad,
                        struct pp_slat_light *light)
{
    double incident[SIDES];
    memset(light, 0, sizeof *light);
    light->straight = pp_slats_straight(&cell->slats, profile_rad);
    if (light->straight >= 1.0)
        return;
    incident_on_strips(cell, profile_rad, light->straight, incident);
    for (int i = 0; i < SIDES; i++)
        for (int k = 0; k < PP_SLAT_BINS; k++)
            light->leaving[k] += incident[i] * cell->from_strip[i][k];
}

/* Integrates over profile angles; the light from p falls on the plane in proportion to
 * cos p dp. */
void pp_slat_cell_diffuse(const struct pp_slat_cell *cell, double low_rad,
                          double high_rad, struct pp_slat_light *light)
{
    memset(light, 0, sizeof *light);
    double middle = 0.5 * (low_rad + high_rad);
    double turn = cos(middle) < 0.0 ? (middle > 0.0 ? PP_PI : -PP_PI) : 0.0;
    double low = sin(low_rad - turn), high = sin(high_rad - turn);
    for (int i = 0; i < SKY_STEPS; i++) {
        struct pp_slat_light one;
        double p = turn + asin(low + (high - low) * (i + 0.5) / SKY_STEPS);
        pp_slat_cell_light(cell, p, &one);
        light->straight += one.straight / SKY_STEPS;
        for (int k = 0; k < PP_SLAT_BINS; k++)
            light->leaving[k] += one.leaving[k] / SKY_STEPS;
    }
}

double pp_slat_cell_sum(const struct pp_slat_light *light, int first, int end)
{
    double sum = 0.0;
    for (int k = first; k < end; k++)
        sum += light->leaving[k];
    return sum;
}

struct pp_slat_parts pp_slat_cell_parts(const struct pp_slat_light *light)
{
    enum { QUARTER = PP_SLAT_BINS / 4 };
    return (struct pp_slat_parts){
        .straight = light->straight,
        .room_down = pp_slat_cell_sum(light, 2 * QUARTER, 3 * QUARTER),
        .room_up = pp_slat_cell_sum(light, QUARTER, 2 * QUARTER),
        .back_up = pp_slat_cell_sum(light, 0, QUARTER),
        .back_down = pp_slat_cell_sum(light, 3 * QUARTER, PP_SLAT_BINS),
    };
}
