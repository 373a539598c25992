/* level_crossing.c - see level_crossing.h. */
#include "model/geometry/contour/level_crossing.h"

#include <math.h>
#include <string.h>

#include "model/base/array.h"

/* Largest number of bisections of a chord between two crossings; chosen by trial. */
enum { DEEPEST = 10 };

/* Finds the crossing of the level between a and b, to within the tolerance. ga, gb:
 * value minus level, of opposite sign. Brent's zeroin [BRE73]: secant or inverse
 * quadratic steps, or else bisection. The root stays bracketed, so that a jump of the
 * function is found too. */
static enum pp_status find_level(struct pp_field *field, const double a_xy[2],
                                 double ga, const double b_xy[2], double gb,
                                 double found[2], struct pp_error *err)
{
    double length = hypot(b_xy[0] - a_xy[0], b_xy[1] - a_xy[1]);
    double tolerance = 0.5 * field->tolerance / length;
    double a = 0.0, b = 1.0, c = 0.0, gc = ga;
    double step = 1.0, before = 1.0;
    for (;;) {
        /* b is the best point, c is on the other side of the level, a is the previous
         * b. */
        if ((gb > 0.0) == (gc > 0.0)) {
            c = a;
            gc = ga;
            step = before = b - a;
        }
        if (fabs(gc) < fabs(gb)) {
            a = b, b = c, c = a;
            ga = gb, gb = gc, gc = ga;
        }
        double half = 0.5 * (c - b);
        if (!(fabs(half) > tolerance) || gb == 0.0)
            break;
        if (fabs(before) < tolerance || fabs(ga) <= fabs(gb)) {
            step = before = half;
        } else {
            double p, q, s = gb / ga;
            if (a == c) {
                p = 2.0 * half * s;
                q = 1.0 - s;
            } else {
                double r = gb / gc, t = ga / gc;
                p = s * (2.0 * half * t * (t - r) - (b - a) * (r - 1.0));
                q = (t - 1.0) * (r - 1.0) * (s - 1.0);
            }
            if (p > 0.0)
                q = -q;
            p = fabs(p);
            if (2.0 * p
                < fmin(3.0 * half * q - fabs(tolerance * q), fabs(before * q))) {
                before = step;
                step = p / q;
            } else {
                step = before = half;
            }
        }
        a = b;
        ga = gb;
        b += fabs(step) > tolerance ? step : copysign(tolerance, half);
        double xy[2], value;
        for (int k = 0; k < 2; k++)
            xy[k] = a_xy[k] + b * (b_xy[k] - a_xy[k]);
        enum pp_status status = pp_field_evaluate(field, xy, &value, err);
        if (status != PP_OK)
            return status;
        gb = value - field->level;
    }
    for (int k = 0; k < 2; k++)
        found[k] = a_xy[k] + b * (b_xy[k] - a_xy[k]);
    return PP_OK;
}

/* A triangle crossed by the level: corner A is on one side of the level, B and C are on
 * the other. The curve runs from edge AB to edge AC and crosses each ray from A to a
 * point of BC. */
struct fan {
    const double *a, *b, *c;
    bool a_high;
};

static void between_of(const double p[2], const double q[2], double share, double xy[2])
{
    for (int k = 0; k < 2; k++)
        xy[k] = p[k] + share * (q[k] - p[k]);
}

/* Intersection of the ray from A to r with the chord p q, as a fraction of the ray. */
static double chord_on_ray(const struct fan *fan, const double r[2], const double p[2],
                           const double q[2])
{
    double ux = r[0] - fan->a[0], uy = r[1] - fan->a[1];
    double vx = q[0] - p[0], vy = q[1] - p[1];
    double wx = p[0] - fan->a[0], wy = p[1] - fan->a[1];
    double across = ux * vy - uy * vx;
    double share = fabs(across) > 0.0 ? (wx * vy - wy * vx) / across : 0.5;
    return fmin(fmax(share, 0.0), 1.0);
}

/* Finds the point where the curve crosses the ray from A to r. guess: where the chord
 * crosses the ray, as a fraction of the ray. *strays: the point is farther from the
 * chord than the tolerance. *leaves is set if there is no such point, since the curve
 * leaves the triangle or follows the ray. The function is evaluated on the chord, then
 * one tolerance beside the chord, then farther away until the level is between two
 * points. */
static enum pp_status find_on_ray(struct pp_field *field, const struct fan *fan,
                                  const double r[2], double guess, double found[2],
                                  bool *strays, bool *leaves, struct pp_error *err)
{
    double length = hypot(r[0] - fan->a[0], r[1] - fan->a[1]);
    double near[2], far[2], near_value, far_value, near_step = 0.0;
    *strays = false;
    between_of(fan->a, r, guess, near);
    memcpy(found, near, sizeof near);
    if (!(length > field->tolerance))
        return PP_OK;
    enum pp_status status = pp_field_evaluate(field, near, &near_value, err);
    if (status != PP_OK)
        return status;
    bool near_high = near_value > field->level;
    double sign =
        near_high == fan->a_high ? 1.0 : -1.0; /* away from A, or towards it */

    double share = guess, step = field->tolerance / length;
    for (;;) {
        share = fmin(fmax(guess + sign * step, 0.0), 1.0);
        between_of(fan->a, r, share, far);
        status = pp_field_evaluate(field, far, &far_value, err);
        if (status != PP_OK)
            return status;
        if ((far_value > field->level) != near_high)
            break;
        if (share <= 0.0 || share >= 1.0) {
            *leaves = true; /* the chord stays as it is */
            return PP_OK;
        }
        /* Slightly beyond the linear extrapolation to the level. */
        double rise = (far_value - near_value) / (step - near_step);
        double reach = 1.2 * (field->level - far_value) / rise;
        *strays = true;
        memcpy(near, far, sizeof near);
        near_value = far_value;
        near_step = step;
        step += fmin(fmax(reach, step), 31.0 * step);
    }
    if (!*strays)
        return PP_OK;
    return find_level(field, near, near_value - field->level, far,
                      far_value - field->level, found, err);
}

static enum pp_status add_between(struct pp_field *field, const double xy[2],
                                  struct pp_error *err)
{
    enum pp_status status =
        pp_array_reserve(&field->between, &field->between_room,
                         field->between_count + 1, sizeof *field->between, err);
    if (status == PP_OK)
        memcpy(field->between[field->between_count++], xy, sizeof(double[2]));
    return status;
}

/* Positions on a chord at which the curve is searched for. The middle is always used.
 * On a chord across the whole triangle the second position is used too, since an
 * S-shaped curve crosses its chord in the middle. */
static const double asides[] = {0.5, 0.27};
enum { ASIDES = sizeof asides / sizeof *asides };

/* Adds the points of the curve between p, on the ray at p_share of BC, and q, at
 * q_share. */
static enum pp_status follow_level_curve(struct pp_field *field, const struct fan *fan,
                                         const double p[2], double p_share,
                                         const double q[2], double q_share, int depth,
                                         bool *leaves, struct pp_error *err)
{
    if (hypot(q[0] - p[0], q[1] - p[1]) < 2.0 * field->tolerance)
        return PP_OK;
    if (depth == 0) { /* the curve follows a ray, so that other rays do not meet it */
        *leaves = true;
        return PP_OK;
    }
    double share = 0.5, m[2];
    bool strays = false;
    enum pp_status status = PP_OK;
    for (int i = 0; i < (depth == DEEPEST ? ASIDES : 1) && status == PP_OK && !strays;
         i++) {
        double r[2];
        share = p_share + asides[i] * (q_share - p_share);
        between_of(fan->b, fan->c, share, r);
        status = find_on_ray(field, fan, r, chord_on_ray(fan, r, p, q), m, &strays,
                             leaves, err);
    }
    if (status != PP_OK || !strays)
        return status;
    status =
        follow_level_curve(field, fan, p, p_share, m, share, depth - 1, leaves, err);
    if (status == PP_OK)
        status = add_between(field, m, err);
    if (status == PP_OK)
        status = follow_level_curve(field, fan, m, share, q, q_share, depth - 1, leaves,
                                    err);
    return status;
}

/* Finds the crossing of the level with an edge, unless it is known. */
static enum pp_status end_on_edge(struct pp_field *field, int edge,
                                  struct pp_error *err)
{
    struct pp_curve_end *end = &field->ends[edge];
    if (end->stamp == field->stamp)
        return PP_OK;
    *end = (struct pp_curve_end){.stamp = field->stamp, .leaving = -1, .arriving = -1};
    int a = field->mesh.edges[edge].a, b = field->mesh.edges[edge].b;
    return find_level(field, field->mesh.nodes[a], field->values[a] - field->level,
                      field->mesh.nodes[b], field->values[b] - field->level, end->xy,
                      err);
}

enum pp_status pp_level_crossing_follow(struct pp_field *field, int triangle,
                                        bool *leaves, struct pp_error *err)
{
    *leaves = false;
    const int *t = field->mesh.triangles[triangle];
    bool high[3];
    for (int i = 0; i < 3; i++)
        high[i] = field->values[t[i]] > field->level;
    if (high[0] == high[1] && high[1] == high[2])
        return PP_OK;
    int apex = high[1] == high[2] ? 0 : high[2] == high[0] ? 1 : 2;
    int a = t[apex], b = t[(apex + 1) % 3], c = t[(apex + 2) % 3];

    /* Higher values are on the left: the curve runs from AB to AC if A is high. */
    int from = pp_mesh_edge(&field->mesh, a, b), to = pp_mesh_edge(&field->mesh, a, c);
    struct fan fan = {field->mesh.nodes[a], field->mesh.nodes[b], field->mesh.nodes[c],
                      high[apex]};
    if (!high[apex]) {
        int other = from;
        from = to;
        to = other;
        fan.b = field->mesh.nodes[c];
        fan.c = field->mesh.nodes[b];
    }
    enum pp_status status = end_on_edge(field, from, err);
    if (status == PP_OK)
        status = end_on_edge(field, to, err);
    if (status == PP_OK)
        status =
            pp_array_reserve(&field->crossings, &field->crossing_room,
                             field->crossing_count + 1, sizeof *field->crossings, err);
    if (status != PP_OK)
        return status;
    int first = field->between_count;
    status = follow_level_curve(field, &fan, field->ends[from].xy, 0.0,
                                field->ends[to].xy, 1.0, DEEPEST, leaves, err);
    field->ends[from].leaving = field->ends[to].arriving = field->crossing_count;
    field->crossings[field->crossing_count++] =
        (struct pp_crossing){from, to, first, field->between_count - first, false};
    return status;
}
