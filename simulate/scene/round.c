/* round.c - intersections of rays with quadrics and rings; their normals, boxes, areas
 * and points. */
#include "simulate/scene/round.h"

#include <math.h>

#include "simulate/sampling/lobe.h"

/* The two roots, in ascending order, of
 *
 *     a t^2 + 2 b t + c = 0
 *
 * false if there are none. Avoids cancellation if b^2 is much greater than a c. */
static bool roots(double a, double b, double c, double t[2])
{
    double inner = b * b - a * c;
    if (!(inner >= 0.0))
        return false;
    double q = -(b + copysign(sqrt(inner), b));
    double first = q / a, second = q != 0.0 ? c / q : first;
    /* If a is 0 the first is infinite or NaN; the second is then used. */
    t[0] = first < second ? first : second;
    t[1] = first < second ? second : first;
    if (!isfinite(first))
        t[0] = t[1] = second;
    return true;
}

static bool meet_sphere(const struct pp_shape *shape, struct pp_vec3 p,
                        struct pp_vec3 u, double t[2])
{
    struct pp_vec3 w = pp_vec_sub(p, shape->is.sphere.centre);
    double r = shape->is.sphere.radius_m;
    return roots(pp_vec_dot(u, u), pp_vec_dot(w, u), pp_vec_dot(w, w) - r * r, t);
}

/* A cone's axis: direction from the first end (unit), length, and increase of the
 * radius per metre. */
struct axis {
    struct pp_vec3 along;
    double length_m, growth;
};

static struct axis axis_of(const struct pp_shape *cone)
{
    struct pp_vec3 d = pp_vec_sub(cone->is.cone.ends[1], cone->is.cone.ends[0]);
    double length = pp_vec_length(d);
    return (struct axis){pp_vec_scale(d, 1.0 / length), length,
                         (cone->is.cone.radii_m[1] - cone->is.cone.radii_m[0])
                             / length};
}

/* With x measured from the first end, h its component along the axis, k the growth and
 * r the first radius, points of the cone satisfy x^2 - h^2 = (r + k h)^2. */
static bool meet_cone(const struct pp_shape *shape, struct pp_vec3 p, struct pp_vec3 u,
                      double t[2])
{
    struct axis axis = axis_of(shape);
    struct pp_vec3 w = pp_vec_sub(p, shape->is.cone.ends[0]);
    double k = axis.growth, r = shape->is.cone.radii_m[0];
    double wd = pp_vec_dot(w, axis.along), ud = pp_vec_dot(u, axis.along);
    double a = pp_vec_dot(u, u) - ud * ud * (1.0 + k * k);
    double b = pp_vec_dot(w, u) - wd * ud * (1.0 + k * k) - k * r * ud;
    double c = pp_vec_dot(w, w) - wd * wd * (1.0 + k * k) - 2.0 * k * r * wd - r * r;
    return roots(a, b, c, t);
}

/* True if the point of the double cone is between the ends of the shape, on the right
 * nappe. */
static bool on_cone(const struct pp_shape *shape, struct pp_vec3 point)
{
    struct axis axis = axis_of(shape);
    double h = pp_vec_dot(pp_vec_sub(point, shape->is.cone.ends[0]), axis.along);
    return h >= 0.0 && h <= axis.length_m
           && shape->is.cone.radii_m[0] + axis.growth * h >= 0.0;
}

static bool meet_ring(const struct pp_shape *shape, struct pp_vec3 p, struct pp_vec3 u,
                      double *t)
{
    struct pp_vec3 w = pp_vec_sub(shape->is.ring.centre, p);
    *t = pp_vec_dot(w, shape->is.ring.axis) / pp_vec_dot(u, shape->is.ring.axis);
    if (!isfinite(*t))
        return false;
    struct pp_vec3 off = pp_vec_sub(pp_vec_scale(u, *t), w);
    double square = pp_vec_dot(off, off);
    const double *radii = shape->is.ring.radii_m;
    return square >= radii[0] * radii[0] && square <= radii[1] * radii[1];
}

bool pp_round_meet(const struct pp_shape *shape, struct pp_vec3 p, struct pp_vec3 u,
                   double least, double most, double *t)
{
    double both[2];
    if (shape->kind == PP_SHAPE_RING)
        return meet_ring(shape, p, u, t) && *t > least && *t < most;
    bool cone = shape->kind == PP_SHAPE_CONE;
    if (!(cone ? meet_cone(shape, p, u, both) : meet_sphere(shape, p, u, both)))
        return false;
    for (int i = 0; i < 2; i++) {
        *t = both[i];
        if (*t > least && *t < most
            && (!cone || on_cone(shape, pp_vec_along(p, *t, u))))
            return true;
    }
    return false;
}

struct pp_vec3 pp_round_normal(const struct pp_shape *shape, struct pp_vec3 point)
{
    if (shape->kind == PP_SHAPE_RING)
        return shape->is.ring.axis;
    struct pp_vec3 n;
    if (shape->kind == PP_SHAPE_SPHERE) {
        n = pp_vec_sub(point, shape->is.sphere.centre);
    } else {
        struct axis axis = axis_of(shape);
        struct pp_vec3 w = pp_vec_sub(point, shape->is.cone.ends[0]);
        double h = pp_vec_dot(w, axis.along);
        struct pp_vec3 out = pp_vec_along(w, -h, axis.along);
        n = pp_vec_along(out, -axis.growth * pp_vec_length(out), axis.along);
    }
    double length = pp_vec_length(n);
    if (!(length > 0.0)) /* a cone's tip */
        return pp_vec(0.0, 0.0, 1.0);
    return pp_vec_scale(n, (shape->inward ? -1.0 : 1.0) / length);
}

static void add_disc(struct pp_bounds3 *bounds, struct pp_vec3 centre,
                     struct pp_vec3 reach)
{
    pp_bounds3_add(bounds, pp_vec_sub(centre, reach));
    pp_bounds3_add(bounds, pp_vec_add(centre, reach));
}

/* Extent of a disc about the axis along each coordinate. */
static struct pp_vec3 disc_reach(struct pp_vec3 axis, double radius)
{
    return pp_vec(radius * sqrt(fmax(0.0, 1.0 - axis.x * axis.x)),
                  radius * sqrt(fmax(0.0, 1.0 - axis.y * axis.y)),
                  radius * sqrt(fmax(0.0, 1.0 - axis.z * axis.z)));
}

struct pp_bounds3 pp_round_bounds(const struct pp_shape *shape)
{
    struct pp_bounds3 bounds = pp_bounds3_empty();
    if (shape->kind == PP_SHAPE_SPHERE) {
        double r = shape->is.sphere.radius_m;
        add_disc(&bounds, shape->is.sphere.centre, pp_vec(r, r, r));
    } else if (shape->kind == PP_SHAPE_RING) {
        add_disc(&bounds, shape->is.ring.centre,
                 disc_reach(shape->is.ring.axis, shape->is.ring.radii_m[1]));
    } else {
        struct pp_vec3 axis = axis_of(shape).along;
        for (int i = 0; i < 2; i++)
            add_disc(&bounds, shape->is.cone.ends[i],
                     disc_reach(axis, shape->is.cone.radii_m[i]));
    }
    return bounds;
}

double pp_round_area(const struct pp_shape *shape)
{
    if (shape->kind == PP_SHAPE_SPHERE)
        return 4.0 * PP_PI * shape->is.sphere.radius_m * shape->is.sphere.radius_m;
    if (shape->kind == PP_SHAPE_RING) {
        const double *r = shape->is.ring.radii_m;
        return PP_PI * (r[1] * r[1] - r[0] * r[0]);
    }
    struct axis axis = axis_of(shape);
    const double *r = shape->is.cone.radii_m;
    return PP_PI * (r[0] + r[1]) * hypot(axis.length_m, r[1] - r[0]);
}

struct pp_vec3 pp_round_circle_point(struct pp_vec3 centre, struct pp_vec3 axis,
                                     double radius, double v)
{
    struct pp_vec3 a, b;
    double sine, cosine;
    pp_lobe_frame(axis, &a, &b);
    sincos(2.0 * PP_PI * v, &sine, &cosine);
    return pp_vec_along(pp_vec_along(centre, radius * cosine, a), radius * sine, b);
}

struct pp_vec3 pp_round_point(const struct pp_shape *shape, double u, double v)
{
    if (shape->kind == PP_SHAPE_SPHERE) {
        double z = 1.0 - 2.0 * u, r = shape->is.sphere.radius_m;
        struct pp_vec3 up = {0.0, 0.0, 1.0};
        struct pp_vec3 centre = pp_vec_along(shape->is.sphere.centre, r * z, up);
        return pp_round_circle_point(centre, up, r * sqrt(fmax(0.0, 1.0 - z * z)), v);
    }
    if (shape->kind == PP_SHAPE_RING) {
        const double *r = shape->is.ring.radii_m;
        double square = r[0] * r[0] + u * (r[1] * r[1] - r[0] * r[0]);
        return pp_round_circle_point(shape->is.ring.centre, shape->is.ring.axis,
                                     sqrt(square), v);
    }
    /* Areas on a cone are proportional to the square of the radius. */
    struct axis axis = axis_of(shape);
    const double *r = shape->is.cone.radii_m;
    double radius = sqrt(r[0] * r[0] + u * (r[1] * r[1] - r[0] * r[0]));
    double share = r[0] + radius > 0.0 ? u * (r[0] + r[1]) / (r[0] + radius) : 0.0;
    return pp_round_circle_point(
        pp_vec_along(shape->is.cone.ends[0], share * axis.length_m, axis.along),
        axis.along, radius, v);
}

void pp_round_shift(struct pp_shape *shape, struct pp_vec3 centre)
{
    switch (shape->kind) {
    case PP_SHAPE_SPHERE:
        shape->is.sphere.centre = pp_vec_sub(shape->is.sphere.centre, centre);
        break;
    case PP_SHAPE_RING:
        shape->is.ring.centre = pp_vec_sub(shape->is.ring.centre, centre);
        break;
    case PP_SHAPE_CONE:
        for (int i = 0; i < 2; i++)
            shape->is.cone.ends[i] = pp_vec_sub(shape->is.cone.ends[i], centre);
        break;
    default:
        break;
    }
}
