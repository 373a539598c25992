/* sample_polygon.c - rectangles and triangles sampled by solid angle or by area, with a
 * bilinear density on top. */
#include "simulate/sampling/sample_polygon.h"

#include <math.h>

#include "model/geometry/min_max.h"
#include "model/light/photographs/sky_bright.h"
#include "simulate/sampling/sample_bright.h"
#include "simulate/sampling/sample_part.h"
#include "simulate/sampling/triangle.h"

/* Least density in the unit square, as a fraction of the mean. Limits the variance that
 * a wrong estimate can cause. Chosen by trial. */
static const double LEAST_WEIGHT = 0.05;

/* A rectangle nearer than this many of its diagonals is sampled by solid angle; chosen
 * by trial. */
static const double NEAR_DIAGONALS = 0.6;

/* Distance, in diagonals, below which the importance of a rectangle is estimated by its
 * solid angle. At such short distances, the middle of a long rectangle does not
 * represent its ends. */
static const double GUESSED_DIAGONALS = 1.0;

/* Least weight of an opening in the choice, since the estimate of its light may be
 * wrong. */
static const double LEAST_CHOICE = 0.1;

/* Least height above an opening's plane that the estimate assumes, so that the estimate
 * is positive for all points that see the opening. */
static const double LEAST_HEIGHT_M = 1e-3;

/* Triangles of smaller solid angle are sampled by area, since Arvo's formulae then lose
 * digits. */
static const double SMALL_TRIANGLE_SR = 1e-3;

static double diagonal_squared(const struct pp_target *target)
{
    return target->width_m * target->width_m + target->height_m * target->height_m;
}

static bool any_corner_before(const struct pp_target *target, struct pp_vec3 from,
                              struct pp_vec3 n)
{
    if (target->rectangle) {
        struct pp_vec3 to = pp_vec_sub(target->corner, from);
        double reach = pp_max(0.0, target->width_m * pp_vec_dot(n, target->along))
                       + pp_max(0.0, target->height_m * pp_vec_dot(n, target->up));
        return pp_vec_dot(n, to) + reach > 0.0;
    }
    for (int i = 0; i < target->triangle_count; i++)
        for (int k = 0; k < 3; k++)
            if (pp_vec_dot(n, pp_vec_sub(target->triangles[i][k], from)) > 0.0)
                return true;
    return false;
}

bool pp_sample_polygon_in_sight(const struct pp_target *target, struct pp_vec3 from,
                                struct pp_vec3 n)
{
    return pp_target_height(target, from) > 1e-9 && any_corner_before(target, from, n);
}

/* Cosine at the surface times the brightness outside, for the unnormalised direction
 * v. */
static double receiver_weight(struct pp_vec3 v, double length, struct pp_vec3 n,
                              const struct pp_brightness *brightness)
{
    double facing = pp_vec_dot(n, v) / length;
    if (!(facing > 0.0))
        return 0.0;
    return facing
           * (v.z > 0.0 ? 1.0 + brightness->gradation * v.z / length
                        : brightness->ground);
}

/* Multiplies a complex number by exp(i sign omega), where omega is the solid angle of
 * the rectangle from the foot of a point to x, y on its plane. */
static void turn_by_solid_angle(double z[2], double sign, double x, double y,
                                double off)
{
    double re = off * sqrt(x * x + y * y + off * off), im = sign * x * y;
    double turned = z[0] * re - z[1] * im;
    z[1] = z[0] * im + z[1] * re;
    z[0] = turned;
}

/* Importance of a rectangle for a near point, for which the middle is not
 * representative: its solid angle times the larger of the weights of its middle and its
 * nearest point. */
static double importance_when_near(const struct pp_target *target, struct pp_vec3 from,
                                   struct pp_vec3 n,
                                   const struct pp_brightness *brightness,
                                   double middle_weight)
{
    struct pp_vec3 d = pp_vec_sub(target->corner, from);
    double off = pp_max(pp_target_height(target, from), LEAST_HEIGHT_M);
    double x0 = pp_vec_dot(d, target->along), x1 = x0 + target->width_m;
    double y0 = pp_vec_dot(d, target->up), y1 = y0 + target->height_m;
    double x = pp_max(x0, pp_min(x1, 0.0)), y = pp_max(y0, pp_min(y1, 0.0));
    double z[2] = {1.0, 0.0};
    turn_by_solid_angle(z, 1.0, x1, y1, off);
    turn_by_solid_angle(z, -1.0, x0, y1, off);
    turn_by_solid_angle(z, -1.0, x1, y0, off);
    turn_by_solid_angle(z, 1.0, x0, y0, off);
    double solid = atan2(z[1], z[0]);
    if (solid < 0.0)
        solid += 2.0 * PP_PI;
    struct pp_vec3 nearest =
        pp_vec_along(pp_vec_along(pp_vec_scale(target->normal, -off), x, target->along),
                     y, target->up);
    double weight = receiver_weight(nearest, pp_vec_length(nearest), n, brightness);
    return solid * pp_max(pp_max(weight, middle_weight), LEAST_CHOICE);
}

double pp_sample_polygon_importance(const struct pp_target *target, struct pp_vec3 from,
                                    struct pp_vec3 n,
                                    const struct pp_brightness *brightness)
{
    if (!pp_sample_polygon_in_sight(target, from, n))
        return 0.0;
    struct pp_vec3 v = pp_vec_sub(target->middle, from);
    double square = pp_vec_dot(v, v), length = sqrt(square);
    double weight = receiver_weight(v, length, n, brightness);
    if (target->rectangle
        && square < GUESSED_DIAGONALS * GUESSED_DIAGONALS * diagonal_squared(target))
        return importance_when_near(target, from, n, brightness, weight);
    /* Interpolates between the far field and a half space filled by a near opening. */
    double slant = pp_target_height(target, from) / length;
    double solid = target->area_m2 * pp_max(slant, 0.05) / (square + target->area_m2);
    return solid * pp_max(weight, LEAST_CHOICE);
}

/* Weight of this corner of a rectangle: cosine times brightness, per solid angle or, if
 * sampled by area, per area. */
static double corner_value(const struct pp_polygon_sampler *sampler, struct pp_vec3 n,
                           const struct pp_brightness *brightness, int right, int top)
{
    const struct pp_target *target = sampler->target;
    struct pp_vec3 v = pp_vec_sub(pp_target_point(target, right ? target->width_m : 0.0,
                                                  top ? target->height_m : 0.0),
                                  sampler->from);
    double square = pp_vec_dot(v, v), length = sqrt(square);
    double value = receiver_weight(v, length, n, brightness);
    if (sampler->by_area)
        value *= sampler->distance_m / (length * square);
    return value;
}

static void weigh_corners(struct pp_polygon_sampler *sampler, struct pp_vec3 n,
                          const struct pp_brightness *brightness)
{
    double sum = 0.0;
    for (int top = 0; top < 2; top++)
        for (int right = 0; right < 2; right++) {
            double value = corner_value(sampler, n, brightness, right, top);
            sampler->corner_weight[top][right] = value;
            sum += value;
        }
    /* A fixed mixture of the estimated and a uniform density. */
    double scale = sum > 0.0 ? (1.0 - LEAST_WEIGHT) * 4.0 / sum : 0.0;
    double least = sum > 0.0 ? LEAST_WEIGHT : 1.0;
    for (int top = 0; top < 2; top++)
        for (int right = 0; right < 2; right++)
            sampler->corner_weight[top][right] =
                sampler->corner_weight[top][right] * scale + least;
}

static double near_square(double low, double high)
{
    double d = low > 0.0 ? low : high < 0.0 ? high : 0.0;
    return d * d;
}

/* The map of [URENA13], in their symbols: the rectangle lies at z = -distance, x to the
 * right, y up from the foot of the point. */
static void rectangle_init(struct pp_polygon_sampler *sampler)
{
    const struct pp_target *target = sampler->target;
    struct pp_vec3 d = pp_vec_sub(target->corner, sampler->from);
    sampler->x0 = pp_vec_dot(d, target->along);
    sampler->y0 = pp_vec_dot(d, target->up);
    sampler->x1 = sampler->x0 + target->width_m;
    sampler->y1 = sampler->y0 + target->height_m;

    double z2 = sampler->distance_m * sampler->distance_m;
    sampler->by_area = near_square(sampler->x0, sampler->x1)
                           + near_square(sampler->y0, sampler->y1) + z2
                       > NEAR_DIAGONALS * NEAR_DIAGONALS * diagonal_squared(target);
    if (sampler->by_area)
        return;
    sampler->b0 = -sampler->y0 / sqrt(sampler->y0 * sampler->y0 + z2);
    sampler->b1 = sampler->y1 / sqrt(sampler->y1 * sampler->y1 + z2);
    double n1 = sampler->x1 / sqrt(sampler->x1 * sampler->x1 + z2);
    double n3 = -sampler->x0 / sqrt(sampler->x0 * sampler->x0 + z2);
    double g0 = acos(-sampler->b0 * n1), g1 = acos(-n1 * sampler->b1);
    double g2 = acos(-sampler->b1 * n3), g3 = acos(-n3 * sampler->b0);
    sampler->k = 2.0 * PP_PI - g2 - g3;
    sampler->solid = g0 + g1 - sampler->k;
}

static struct pp_vec3 rectangle_by_solid_angle(const struct pp_polygon_sampler *sampler,
                                               double u, double v)
{
    double z0 = -sampler->distance_m, z2 = z0 * z0;
    double sine, cosine;
    sincos(u * sampler->solid + sampler->k, &sine, &cosine);
    double fu = (cosine * sampler->b0 - sampler->b1) / sine;
    double cu = copysign(1.0 / sqrt(fu * fu + sampler->b0 * sampler->b0), fu);
    cu = pp_max(-1.0, pp_min(1.0, cu));
    double xu = -cu * z0 / sqrt(pp_max(1.0 - cu * cu, 1e-300));
    xu = pp_max(sampler->x0, pp_min(sampler->x1, xu));

    double d = sqrt(xu * xu + z2);
    double h0 = sampler->y0 / sqrt(d * d + sampler->y0 * sampler->y0);
    double h1 = sampler->y1 / sqrt(d * d + sampler->y1 * sampler->y1);
    double hv = h0 + v * (h1 - h0), hv2 = hv * hv;
    double yv = hv2 < 1.0 - 1e-12 ? hv * d / sqrt(1.0 - hv2) : sampler->y1;
    yv = pp_max(sampler->y0, pp_min(sampler->y1, yv));
    return pp_target_point(sampler->target, xu - sampler->x0, yv - sampler->y0);
}

/* Solid angle of a triangle of directions a, b, c [VOS83]. */
static double triangle_solid_angle(struct pp_vec3 a, struct pp_vec3 b, struct pp_vec3 c)
{
    double volume = fabs(pp_vec_dot(a, pp_vec_cross(b, c)));
    return 2.0
           * atan2(volume,
                   1.0 + pp_vec_dot(a, b) + pp_vec_dot(b, c) + pp_vec_dot(c, a));
}

static double triangle_of_target(const struct pp_polygon_sampler *sampler, int i)
{
    const struct pp_vec3 *t = sampler->target->triangles[i];
    return triangle_solid_angle(pp_vec_unit(pp_vec_sub(t[0], sampler->from)),
                                pp_vec_unit(pp_vec_sub(t[1], sampler->from)),
                                pp_vec_unit(pp_vec_sub(t[2], sampler->from)));
}

/* Angle between the planes (a, b) and (a, c) at a. */
static double angle_at(struct pp_vec3 a, struct pp_vec3 b, struct pp_vec3 c)
{
    struct pp_vec3 ab = pp_vec_cross(a, b), ac = pp_vec_cross(a, c);
    return atan2(pp_vec_length(pp_vec_cross(ab, ac)), pp_vec_dot(ab, ac));
}

/* A direction drawn uniformly from the spherical triangle abc of solid angle `solid`
 * [ARVO95b]. */
static struct pp_vec3 spherical_triangle(struct pp_vec3 a, struct pp_vec3 b,
                                         struct pp_vec3 c, double solid, double u,
                                         double v)
{
    double alpha = angle_at(a, b, c), cos_c = pp_vec_dot(a, b);
    double sine, cosine, sin_alpha, cos_alpha;
    sincos(u * solid - alpha, &sine, &cosine);
    sincos(alpha, &sin_alpha, &cos_alpha);
    double p = cosine - cos_alpha, q = sine + sin_alpha * cos_c;
    double top = (q * cosine - p * sine) * cos_alpha - q;
    double bottom = (q * sine + p * cosine) * sin_alpha;
    double cos_b = pp_max(-1.0, pp_min(1.0, top / bottom));

    struct pp_vec3 across = pp_vec_unit(pp_vec_along(c, -pp_vec_dot(c, a), a));
    struct pp_vec3 edge =
        pp_vec_add(pp_vec_scale(a, cos_b),
                   pp_vec_scale(across, sqrt(pp_max(0.0, 1.0 - cos_b * cos_b))));
    double z = 1.0 - v * (1.0 - pp_vec_dot(edge, b));
    struct pp_vec3 side = pp_vec_along(edge, -pp_vec_dot(edge, b), b);
    double length = pp_vec_length(side);
    if (!(length > 0.0))
        return b;
    return pp_vec_add(pp_vec_scale(b, z),
                      pp_vec_scale(side, sqrt(pp_max(0.0, 1.0 - z * z)) / length));
}

static struct pp_direction_sample at_point(const struct pp_polygon_sampler *sampler,
                                           struct pp_vec3 point)
{
    struct pp_direction_sample sample = {.point = point};
    struct pp_vec3 v = pp_vec_sub(point, sampler->from);
    sample.distance_m = pp_vec_length(v);
    sample.direction = pp_vec_scale(v, 1.0 / sample.distance_m);
    return sample;
}

/* Solid angle per area (sr/m2) of the target at the sampled point. */
static double per_area(const struct pp_polygon_sampler *sampler,
                       const struct pp_direction_sample *sample)
{
    double r = sample->distance_m;
    return sampler->distance_m / (r * r * r);
}

/* Index of the triangle selected by u in proportion to solid angle or area, with its
 * size and probability. u is rescaled to (0, 1) within the triangle. */
static int choose_triangle(const struct pp_polygon_sampler *sampler, double *u,
                           double *size, double *probability)
{
    const struct pp_target *target = sampler->target;
    double total = sampler->by_area ? target->area_m2 : sampler->solid;
    double left = *u * total;
    for (int i = 0;; i++) {
        *size = sampler->by_area ? pp_triangle_area(target->triangles[i])
                                 : triangle_of_target(sampler, i);
        if (left < *size || i == target->triangle_count - 1) {
            *u = *size > 0.0 ? pp_min(left / *size, 1.0) : 0.5;
            *probability = *size / total;
            return i;
        }
        left -= *size;
    }
}

static struct pp_direction_sample triangle_sample(
    const struct pp_polygon_sampler *sampler, double u, double v)
{
    double size, probability;
    const struct pp_vec3 *t =
        sampler->target->triangles[choose_triangle(sampler, &u, &size, &probability)];
    if (!sampler->by_area && size > SMALL_TRIANGLE_SR) {
        struct pp_vec3 direction = spherical_triangle(
            pp_vec_unit(pp_vec_sub(t[0], sampler->from)),
            pp_vec_unit(pp_vec_sub(t[1], sampler->from)),
            pp_vec_unit(pp_vec_sub(t[2], sampler->from)), size, u, v);
        double toward = -pp_vec_dot(direction, sampler->target->normal);
        double r = sampler->distance_m / pp_max(toward, 1e-12);
        struct pp_direction_sample sample = {
            .point = pp_vec_along(sampler->from, r, direction),
            .direction = direction,
            .distance_m = r,
            .per_density = size / probability};
        return sample;
    }
    struct pp_direction_sample sample = at_point(sampler, pp_triangle_point(t, u, v));
    sample.per_density = pp_triangle_area(t) / probability * per_area(sampler, &sample);
    return sample;
}

/* A number with density in proportion to a (1 - x) + b x. */
static double sample_linear(double u, double a, double b)
{
    return u * (a + b) / (a + sqrt(a * a + u * (b * b - a * a)));
}

static struct pp_direction_sample rectangle_sample(
    const struct pp_polygon_sampler *sampler, double u, double v)
{
    const double(*w)[2] = sampler->corner_weight;
    v = sample_linear(v, w[0][0] + w[0][1], w[1][0] + w[1][1]);
    double left = w[0][0] + v * (w[1][0] - w[0][0]);
    double right = w[0][1] + v * (w[1][1] - w[0][1]);
    u = sample_linear(u, left, right);
    double density = left + u * (right - left);

    if (sampler->by_area) {
        struct pp_direction_sample sample = at_point(
            sampler, pp_target_point(sampler->target, u * sampler->target->width_m,
                                     v * sampler->target->height_m));
        sample.per_density =
            sampler->target->area_m2 * per_area(sampler, &sample) / density;
        return sample;
    }
    struct pp_direction_sample sample =
        at_point(sampler, rectangle_by_solid_angle(sampler, u, v));
    sample.per_density = sampler->solid / density;
    return sample;
}

void pp_sample_polygon_init(struct pp_polygon_sampler *sampler,
                            const struct pp_target *target, struct pp_vec3 from,
                            struct pp_vec3 n, const struct pp_brightness *brightness)
{
    sampler->target = target;
    sampler->from = from;
    sampler->facing = n;
    sampler->distance_m = pp_target_height(target, from);
    sampler->bright = brightness->bright;
    sampler->bright_share = 0.0;
    if (sampler->bright)
        sampler->bright_share =
            pp_sample_bright_share_of_target(sampler->bright, target, from, n);
    sampler->part.share = 0.0;
    if (target->rectangle) {
        if (brightness->beyond_count > 0)
            sampler->part = pp_sample_part_of(target, from, brightness);
        rectangle_init(sampler);
        weigh_corners(sampler, n, brightness);
        return;
    }
    sampler->solid = 0.0;
    for (int i = 0; i < target->triangle_count; i++)
        sampler->solid += triangle_of_target(sampler, i);
    sampler->by_area = sampler->solid < SMALL_TRIANGLE_SR;
}

static struct pp_direction_sample shape_sample(const struct pp_polygon_sampler *sampler,
                                               double u, double v)
{
    if (sampler->target->rectangle)
        return rectangle_sample(sampler, u, v);
    return triangle_sample(sampler, u, v);
}

/* ---- densities ---- */

static double rectangle_pdf(const struct pp_polygon_sampler *sampler,
                            const struct pp_direction_sample *at)
{
    const struct pp_target *target = sampler->target;
    const double(*w)[2] = sampler->corner_weight;
    struct pp_vec3 in = pp_vec_sub(at->point, target->corner);
    double x = pp_max(0.0, pp_min(target->width_m, pp_vec_dot(in, target->along)));
    double y = pp_max(0.0, pp_min(target->height_m, pp_vec_dot(in, target->up)));
    double u = x / target->width_m, v = y / target->height_m;
    double size = target->area_m2 * per_area(sampler, at);
    if (!sampler->by_area) {
        /* Fraction of the solid angle to the left of the point; within its column,
         * fraction below it. */
        double z2 = sampler->distance_m * sampler->distance_m;
        x += sampler->x0;
        y += sampler->y0;
        double n = x / sqrt(x * x + z2), d2 = x * x + z2;
        double h0 = sampler->y0 / sqrt(d2 + sampler->y0 * sampler->y0);
        double h1 = sampler->y1 / sqrt(d2 + sampler->y1 * sampler->y1);
        size = sampler->solid;
        u = (acos(-sampler->b0 * n) + acos(-n * sampler->b1) - sampler->k) / size;
        v = (y / sqrt(d2 + y * y) - h0) / (h1 - h0);
    }
    double left = w[0][0] + v * (w[1][0] - w[0][0]);
    double right = w[0][1] + v * (w[1][1] - w[0][1]);
    return (left + u * (right - left)) / size;
}

static double triangle_pdf(const struct pp_polygon_sampler *sampler,
                           const struct pp_direction_sample *at)
{
    const struct pp_target *target = sampler->target;
    if (sampler->by_area)
        return 1.0 / (target->area_m2 * per_area(sampler, at));
    for (int i = 0; i < target->triangle_count; i++)
        if (pp_triangle_has(target->triangles[i], at->point)) {
            double size = triangle_of_target(sampler, i);
            if (size > SMALL_TRIANGLE_SR)
                break;
            return size / sampler->solid
                   / (pp_triangle_area(target->triangles[i]) * per_area(sampler, at));
        }
    return 1.0 / sampler->solid;
}

double pp_sample_polygon_pdf(const struct pp_polygon_sampler *sampler,
                             struct pp_vec3 direction)
{
    double toward = -pp_vec_dot(direction, sampler->target->normal);
    if (!(toward > 0.0))
        return 0.0;
    struct pp_direction_sample at = {.direction = direction,
                                     .distance_m = sampler->distance_m / toward};
    at.point = pp_vec_along(sampler->from, at.distance_m, direction);
    double pdf = sampler->target->rectangle ? rectangle_pdf(sampler, &at)
                                            : triangle_pdf(sampler, &at);
    if (sampler->bright_share > 0.0)
        pdf = (1.0 - sampler->bright_share) * pdf
              + sampler->bright_share * pp_sky_bright_pdf(sampler->bright, direction);
    if (sampler->part.share > 0.0)
        pdf = (1.0 - sampler->part.share) * pdf
              + sampler->part.share * pp_sample_part_density(sampler, at.point)
                    / per_area(sampler, &at);
    return pdf;
}

/* ---- mixtures ---- */

/* One sample of the mixtures of sample_part.h and sample_bright.h. */
static struct pp_direction_sample mixed_sample(const struct pp_polygon_sampler *sampler,
                                               double u, double v)
{
    double part = sampler->part.share, bright = sampler->bright_share;
    struct pp_direction_sample sample;
    double rest = (u - part) / (1.0 - part);
    if (u < part)
        sample = at_point(sampler, pp_sample_part_draw(sampler, u / part, v));
    else if (rest >= bright)
        sample = shape_sample(sampler, (rest - bright) / (1.0 - bright), v);
    else if (!pp_sample_bright_draw_to_target(sampler->bright, sampler->target,
                                              sampler->from, rest / bright, v, &sample))
        return (struct pp_direction_sample){.per_density = 0.0};
    sample.per_density = 1.0 / pp_sample_polygon_pdf(sampler, sample.direction);
    return sample;
}

struct pp_direction_sample pp_sample_polygon_draw(
    const struct pp_polygon_sampler *sampler, double u, double v)
{
    bool mixed = sampler->part.share > 0.0 || sampler->bright_share > 0.0;
    return mixed ? mixed_sample(sampler, u, v) : shape_sample(sampler, u, v);
}
