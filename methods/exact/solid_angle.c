/* solid_angle.c - sums along the boundary of a clipped polygon.
 *
 * Two rearrangements preserve digits and save function calls. With v the vertices
 * themselves, l their lengths and v x v' taken as v x (v' - v), which does not cancel
 * for near neighbours:
 *
 *     r sin T + (G x r)(1 - cos T) = tan(T/2) (r + r'),   G sin T = r x r'
 *     => (z.G) n.(...) = z.(r x r') n.(r + r') / (1 + cos T)
 *     E0:  T (n.G) = (T / sin T) n.(r x r')
 *
 * so that no division by the sine of a short arc occurs. The solid angle of a triangle
 * of the fan is the argument of a complex number [VOS83]. The argument of the product
 * of these numbers is the whole solid angle, so that one arctangent is enough.
 */
#include "methods/exact/solid_angle.h"

/* The sums over the arcs of the boundary so far. */
struct boundary_sums {
    struct pp_vec3 normal;
    int count; /* number of vertices so far */
    struct pp_vec3 first, last;
    double first_length, last_length;
    double real, imaginary; /* product of the complex numbers of all triangles */
    double twice_cosine, thrice_cosine_sine;
};

/* T / sin T from the sine and cosine of T; T from 0 to pi. */
static double arc_over_sine(double sine, double cosine)
{
    if (cosine > 0.0 && sine < 1e-4)
        return 1.0 + sine * sine / 6.0; /* next term 3/40 sine^4 */
    return atan2(sine, cosine) / sine;
}

static void add_arc(struct boundary_sums *sums, struct pp_vec3 v, double length,
                    struct pp_vec3 next, double next_length)
{
    struct pp_vec3 across = pp_vec_cross(v, pp_vec_sub(next, v));
    double scale = 1.0 / (length * next_length);
    double cosine = pp_vec_dot(v, next) * scale;
    double sine = pp_vec_length(across) * scale;
    if (!(sine > 0.0))
        return; /* no arc, or an edge through the eye, for which the side is undefined */

    double facing = pp_vec_dot(sums->normal, across) * scale;
    double facing_both = pp_vec_dot(sums->normal, v) / length
                         + pp_vec_dot(sums->normal, next) / next_length;
    /* 1 / (1 + cos T), from the sine where 1 + cos T cancels. */
    double half = cosine > -0.5 ? 1.0 / (1.0 + cosine) : (1.0 - cosine) / (sine * sine);
    sums->twice_cosine += arc_over_sine(sine, cosine) * facing;
    sums->thrice_cosine_sine += across.z * scale * facing_both * half;
}

/* Multiplies the product by the complex number of the triangle between the first
 * vertex, the last vertex and v. */
static void add_boundary_triangle(struct boundary_sums *sums, struct pp_vec3 v,
                                  double length)
{
    struct pp_vec3 a = sums->first, b = sums->last;
    double la = sums->first_length, lb = sums->last_length;
    double scale = 1.0 / (la * lb * length);
    double imaginary =
        pp_vec_dot(a, pp_vec_cross(pp_vec_sub(b, a), pp_vec_sub(v, a))) * scale;
    double real =
        1.0
        + (pp_vec_dot(a, b) * length + pp_vec_dot(b, v) * la + pp_vec_dot(v, a) * lb)
              * scale;
    double was = sums->real;
    sums->real = was * real - sums->imaginary * imaginary;
    sums->imaginary = was * imaginary + sums->imaginary * real;
}

static void add_vertex(void *data, struct pp_vec3 v)
{
    struct boundary_sums *sums = data;
    double length = pp_vec_length(v);
    if (!(length > 0.0))
        return;
    if (sums->count == 0) {
        sums->first = v;
        sums->first_length = length;
    } else {
        add_arc(sums, sums->last, sums->last_length, v, length);
        if (sums->count > 1)
            add_boundary_triangle(sums, v, length);
    }
    sums->last = v;
    sums->last_length = length;
    sums->count++;
}

static void end_boundary(struct boundary_sums *sums, struct pp_moments *moments)
{
    if (sums->count < 3)
        return;
    add_arc(sums, sums->last, sums->last_length, sums->first, sums->first_length);
    /* The formulae assume vertices in clockwise order as seen from the eye. */
    double omega = -2.0 * atan2(sums->imaginary, sums->real);
    moments->omega += omega;
    moments->cosine -= sums->twice_cosine / 2.0;
    moments->cosine_sine += (sums->normal.z * omega - sums->thrice_cosine_sine) / 3.0;
}

void pp_solid_angle_add_moments(struct pp_moments *sum, const struct pp_vec3 *vertices,
                                int count, struct pp_vec3 normal,
                                const struct pp_vec3 *half_spaces, int half_space_count)
{
    struct boundary_sums sums;
    sums.normal = normal;
    sums.count = 0;
    sums.real = 1.0;
    sums.imaginary = 0.0;
    sums.twice_cosine = sums.thrice_cosine_sine = 0.0;
    pp_half_space_clip(vertices, count, half_spaces, half_space_count, add_vertex,
                       &sums);
    end_boundary(&sums, sum);
}

bool pp_solid_angle_has_closed_form(const struct pp_sky *sky)
{
    return pp_sky_is_graded(sky);
}

double pp_solid_angle_sky_component(const struct pp_moments *moments,
                                    const struct pp_sky *sky)
{
    double b = sky->gradation;
    return (moments->cosine + b * moments->cosine_sine) / (1.0 + b)
           * sky->per_horizontal;
}
