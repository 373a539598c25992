/* solid_angle.c - sums along a polygon's boundary, which is clipped on the way.
 *
 * Two rearrangements keep digits and save functions. With v the vertices themselves,
 * l their lengths and v x v' taken as v x (v' - v), which does not cancel for near
 * neighbours:
 *
 *     r sin T + (G x r)(1 - cos T) = tan(T/2) (r + r'),   G sin T = r x r'
 *     => (z.G) n.(...) = z.(r x r') n.(r + r') / (1 + cos T)
 *     E0:  T (n.G) = (T / sin T) n.(r x r')
 *
 * so that no arc, however short, divides by its own sine. The solid angles of the
 * triangles of a fan are the arguments of complex numbers [VOS83]; the product of those
 * has the argument of the whole, so that one arctangent does for all.
 */
#include "methods/exact/solid_angle.h"

#include <assert.h>

/* The sums over the arcs of the boundary so far. */
struct boundary_sums {
    struct pp_vec3 normal;
    int count; /* vertices so far */
    struct pp_vec3 first, last;
    double first_length, last_length;
    double real, imaginary; /* product of the fan's triangles */
    double twice_cosine, thrice_cosine_sine;
};

/* T / sin T from both; T from 0 to pi. */
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
        return; /* no arc, or one through the eye, which has no side */

    double facing = pp_vec_dot(sums->normal, across) * scale;
    double facing_both = pp_vec_dot(sums->normal, v) / length
                         + pp_vec_dot(sums->normal, next) / next_length;
    /* 1 / (1 + cos T), by the sine where 1 + cos T cancels. */
    double half = cosine > -0.5 ? 1.0 / (1.0 + cosine) : (1.0 - cosine) / (sine * sine);
    sums->twice_cosine += arc_over_sine(sine, cosine) * facing;
    sums->thrice_cosine_sine += across.z * scale * facing_both * half;
}

/* The triangle of the first vertex, the last one and v. */
static void add_triangle(struct boundary_sums *sums, struct pp_vec3 v, double length)
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

static void add_vertex(struct boundary_sums *sums, struct pp_vec3 v)
{
    double length = pp_vec_length(v);
    if (!(length > 0.0))
        return;
    if (sums->count == 0) {
        sums->first = v;
        sums->first_length = length;
    } else {
        add_arc(sums, sums->last, sums->last_length, v, length);
        if (sums->count > 1)
            add_triangle(sums, v, length);
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
    /* The formulae run clockwise as seen from the eye. */
    double omega = -2.0 * atan2(sums->imaginary, sums->real);
    moments->omega += omega;
    moments->cosine -= sums->twice_cosine / 2.0;
    moments->cosine_sine += (sums->normal.z * omega - sums->thrice_cosine_sine) / 3.0;
}

/* Clipping as a row of stages, each of which passes on the vertices on its side [SH74]:
 * no polygon has to be stored. */
struct clip_stage {
    struct pp_vec3 half_space;
    bool begun;
    struct pp_vec3 first, last;
    double first_depth, last_depth;
};

struct clip {
    struct clip_stage stages[PP_HALF_SPACES_MOST];
    int count;
    struct boundary_sums sums;
};

static void clip_vertex(struct clip *clip, int index, struct pp_vec3 v);

static double size_of(struct pp_vec3 v)
{
    return fabs(v.x) + fabs(v.y) + fabs(v.z);
}

/* The depth of v within a half-space; 0 for a point in its plane but for rounding, so
 * that no sliver is left of a patch that only touches the plane. */
static double depth_in(struct pp_vec3 half_space, struct pp_vec3 v)
{
    double depth = pp_vec_dot(half_space, v);
    return fabs(depth) > 1e-15 * size_of(half_space) * size_of(v) ? depth : 0.0;
}

/* The point where the edge from the inner point to the outer meets the stage's plane,
 * always worked out from the inner one, so that two polygons agree on a shared edge. */
static struct pp_vec3 crossing(struct pp_vec3 inner, double inner_depth,
                               struct pp_vec3 outer, double outer_depth)
{
    return pp_vec_along(inner, inner_depth / (inner_depth - outer_depth),
                        pp_vec_sub(outer, inner));
}

static void clip_edge(struct clip *clip, int index, struct pp_vec3 a, double depth_a,
                      struct pp_vec3 b, double depth_b)
{
    if ((depth_a > 0.0) == (depth_b > 0.0))
        return;
    clip_vertex(clip, index + 1,
                depth_a > 0.0 ? crossing(a, depth_a, b, depth_b)
                              : crossing(b, depth_b, a, depth_a));
}

static void clip_vertex(struct clip *clip, int index, struct pp_vec3 v)
{
    if (index == clip->count) {
        add_vertex(&clip->sums, v);
        return;
    }
    struct clip_stage *stage = &clip->stages[index];
    double depth = depth_in(stage->half_space, v);
    if (stage->begun) {
        clip_edge(clip, index, stage->last, stage->last_depth, v, depth);
    } else {
        stage->first = v;
        stage->first_depth = depth;
        stage->begun = true;
    }
    if (depth > 0.0)
        clip_vertex(clip, index + 1, v);
    stage->last = v;
    stage->last_depth = depth;
}

void pp_solid_angle_add_moments(struct pp_moments *sum, const struct pp_vec3 *vertices,
                                int count, struct pp_vec3 normal,
                                const struct pp_vec3 *half_spaces, int half_space_count)
{
    assert(half_space_count <= PP_HALF_SPACES_MOST);
    struct clip clip;
    clip.count = 0;
    clip.sums.normal = normal;
    clip.sums.count = 0;
    clip.sums.real = 1.0;
    clip.sums.imaginary = 0.0;
    clip.sums.twice_cosine = clip.sums.thrice_cosine_sine = 0.0;

    /* A half-space that the ring lies in wholly needs no stage. */
    for (int h = 0; h < half_space_count; h++) {
        int inside = 0;
        for (int i = 0; i < count; i++)
            inside += depth_in(half_spaces[h], vertices[i]) > 0.0;
        if (inside == 0)
            return;
        if (inside < count) {
            clip.stages[clip.count].half_space = half_spaces[h];
            clip.stages[clip.count++].begun = false;
        }
    }
    for (int i = 0; i < count; i++)
        clip_vertex(&clip, 0, vertices[i]);
    for (int s = 0; s < clip.count; s++) {
        struct clip_stage *stage = &clip.stages[s];
        if (stage->begun)
            clip_edge(&clip, s, stage->last, stage->last_depth, stage->first,
                      stage->first_depth);
    }
    end_boundary(&clip.sums, sum);
}

bool pp_solid_angle_has_closed_form(const struct pp_sky *sky)
{
    return sky->kind != PP_SKY_ISO;
}

double pp_solid_angle_sky_component(const struct pp_moments *moments,
                                    const struct pp_sky *sky)
{
    double b = sky->gradation;
    return (moments->cosine + b * moments->cosine_sine) / (1.0 + b)
           * sky->per_horizontal;
}
