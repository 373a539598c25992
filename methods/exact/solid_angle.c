/* solid_angle.c - see solid_angle.h.
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

/* The sums while the boundary is followed, arc by arc. */
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

static void walk_arc(struct boundary_sums *walk, struct pp_vec3 v, double length,
                     struct pp_vec3 next, double next_length)
{
    struct pp_vec3 across = pp_vec_cross(v, pp_vec_sub(next, v));
    double scale = 1.0 / (length * next_length);
    double cosine = pp_vec_dot(v, next) * scale;
    double sine = pp_vec_length(across) * scale;
    if (!(sine > 0.0))
        return; /* no arc, or one through the eye, which has no side */

    double facing = pp_vec_dot(walk->normal, across) * scale;
    double facing_both = pp_vec_dot(walk->normal, v) / length
                         + pp_vec_dot(walk->normal, next) / next_length;
    /* 1 / (1 + cos T), by the sine where 1 + cos T cancels. */
    double half = cosine > -0.5 ? 1.0 / (1.0 + cosine) : (1.0 - cosine) / (sine * sine);
    walk->twice_cosine += arc_over_sine(sine, cosine) * facing;
    walk->thrice_cosine_sine += across.z * scale * facing_both * half;
}

/* The triangle of the first vertex, the last one and this. */
static void walk_triangle(struct boundary_sums *walk, struct pp_vec3 v, double length)
{
    struct pp_vec3 a = walk->first, b = walk->last;
    double la = walk->first_length, lb = walk->last_length;
    double scale = 1.0 / (la * lb * length);
    double imaginary =
        pp_vec_dot(a, pp_vec_cross(pp_vec_sub(b, a), pp_vec_sub(v, a))) * scale;
    double real =
        1.0
        + (pp_vec_dot(a, b) * length + pp_vec_dot(b, v) * la + pp_vec_dot(v, a) * lb)
              * scale;
    double was = walk->real;
    walk->real = was * real - walk->imaginary * imaginary;
    walk->imaginary = was * imaginary + walk->imaginary * real;
}

static void walk_to(struct boundary_sums *walk, struct pp_vec3 v)
{
    double length = pp_vec_length(v);
    if (!(length > 0.0))
        return;
    if (walk->count == 0) {
        walk->first = v;
        walk->first_length = length;
    } else {
        walk_arc(walk, walk->last, walk->last_length, v, length);
        if (walk->count > 1)
            walk_triangle(walk, v, length);
    }
    walk->last = v;
    walk->last_length = length;
    walk->count++;
}

static void walk_end(struct boundary_sums *walk, struct pp_moments *sum)
{
    if (walk->count < 3)
        return;
    walk_arc(walk, walk->last, walk->last_length, walk->first, walk->first_length);
    /* The formulae run clockwise as seen from the eye. */
    double omega = -2.0 * atan2(walk->imaginary, walk->real);
    sum->omega += omega;
    sum->cosine -= walk->twice_cosine / 2.0;
    sum->cosine_sine += (walk->normal.z * omega - walk->thrice_cosine_sine) / 3.0;
}

/* Clipping as a row of stages, each of which hands on what is on its side [SH74]: no
 * polygon has to be stored. */
struct clip_stage {
    struct pp_vec3 half_space;
    bool begun;
    struct pp_vec3 first, last;
    double first_depth, last_depth;
};

struct clip {
    struct clip_stage stages[PP_HALF_SPACES_MOST];
    int count;
    struct boundary_sums walk;
};

static void feed(struct clip *clip, int index, struct pp_vec3 v);

static double size_of(struct pp_vec3 v)
{
    return fabs(v.x) + fabs(v.y) + fabs(v.z);
}

/* How far v lies within a half-space; 0 for what is in its plane but for rounding, so
 * that a patch that only touches it leaves no sliver there. */
static double depth_in(struct pp_vec3 half_space, struct pp_vec3 v)
{
    double depth = pp_vec_dot(half_space, v);
    return fabs(depth) > 1e-15 * size_of(half_space) * size_of(v) ? depth : 0.0;
}

/* Where the edge from the inner point to the outer meets the stage's plane. Always
 * reckoned from the inner one, so that two polygons agree on an edge they share. */
static struct pp_vec3 crossing(struct pp_vec3 inner, double inner_depth,
                               struct pp_vec3 outer, double outer_depth)
{
    return pp_vec_along(inner, inner_depth / (inner_depth - outer_depth),
                        pp_vec_sub(outer, inner));
}

static void feed_crossing(struct clip *clip, int index, struct pp_vec3 a,
                          double depth_a, struct pp_vec3 b, double depth_b)
{
    if ((depth_a > 0.0) == (depth_b > 0.0))
        return;
    feed(clip, index + 1,
         depth_a > 0.0 ? crossing(a, depth_a, b, depth_b)
                       : crossing(b, depth_b, a, depth_a));
}

static void feed(struct clip *clip, int index, struct pp_vec3 v)
{
    if (index == clip->count) {
        walk_to(&clip->walk, v);
        return;
    }
    struct clip_stage *stage = &clip->stages[index];
    double depth = depth_in(stage->half_space, v);
    if (stage->begun) {
        feed_crossing(clip, index, stage->last, stage->last_depth, v, depth);
    } else {
        stage->first = v;
        stage->first_depth = depth;
        stage->begun = true;
    }
    if (depth > 0.0)
        feed(clip, index + 1, v);
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
    clip.walk.normal = normal;
    clip.walk.count = 0;
    clip.walk.real = 1.0;
    clip.walk.imaginary = 0.0;
    clip.walk.twice_cosine = clip.walk.thrice_cosine_sine = 0.0;

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
        feed(&clip, 0, vertices[i]);
    for (int s = 0; s < clip.count; s++) {
        struct clip_stage *stage = &clip.stages[s];
        if (stage->begun)
            feed_crossing(&clip, s, stage->last, stage->last_depth, stage->first,
                          stage->first_depth);
    }
    walk_end(&clip.walk, sum);
}

bool pp_solid_angle_has_closed_form(const struct pp_sky *sky)
{
    return sky->kind != PP_SKY_ISO;
}

double pp_solid_angle_sky_component(const struct pp_moments *moments,
                                    const struct pp_sky *sky)
{
    double relative = moments->cosine;
    if (sky->kind == PP_SKY_OVERCAST)
        relative = (moments->cosine + 2.0 * moments->cosine_sine) / 3.0;
    return relative * sky->per_horizontal;
}
