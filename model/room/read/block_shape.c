/* block_shape.c - see block_shape.h. */
#include "model/room/read/block_shape.h"

#include <math.h>
#include <stdbool.h>

static struct pp_block_shape_face quad(struct pp_vec3 a, struct pp_vec3 b,
                                       struct pp_vec3 c, struct pp_vec3 d)
{
    return (struct pp_block_shape_face){{a, b, c, d}, 4};
}

static struct pp_block_shape_face triangle(struct pp_vec3 a, struct pp_vec3 b,
                                           struct pp_vec3 c)
{
    return (struct pp_block_shape_face){{a, b, c}, 3};
}

/* Mono-pitch roof with its ridge along u. l: length, w: width, z: height of the
 * eaves. */
static int mono(struct pp_block_shape_face *faces, double l, double w, double z,
                double pitch_rad)
{
    double top = z + w * tan(pitch_rad);
    struct pp_vec3 a = pp_vec(0, 0, z), b = pp_vec(l, 0, z), c = pp_vec(l, w, z),
                   d = pp_vec(0, w, z), high_c = pp_vec(l, w, top),
                   high_d = pp_vec(0, w, top);
    faces[0] = quad(a, b, high_c, high_d);
    faces[1] = quad(c, d, high_d, high_c);
    faces[2] = triangle(b, c, high_c);
    faces[3] = triangle(d, a, high_d);
    return 4;
}

/* Roof with a ridge that ends at distance `in` from both ends: 0 for a gable roof, half
 * the width for a hip roof. */
static int ridged(struct pp_block_shape_face *faces, double l, double w, double z,
                  double pitch_rad, double in)
{
    double top = z + 0.5 * w * tan(pitch_rad);
    struct pp_vec3 a = pp_vec(0, 0, z), b = pp_vec(l, 0, z), c = pp_vec(l, w, z),
                   d = pp_vec(0, w, z), from = pp_vec(in, 0.5 * w, top),
                   to = pp_vec(l - in, 0.5 * w, top);
    bool pyramid = l - 2.0 * in < 1e-6 * l;
    faces[0] = pyramid ? triangle(a, b, from) : quad(a, b, to, from);
    faces[1] = triangle(b, c, pyramid ? from : to);
    faces[2] = pyramid ? triangle(c, d, from) : quad(c, d, from, to);
    faces[3] = triangle(d, a, from);
    return 4;
}

int pp_block_shape_roof(struct pp_block_shape_face faces[PP_BLOCK_SHAPE_ROOF_MOST],
                        double width_m, double depth_m, double height_m,
                        enum pp_roof roof, double pitch_rad, enum pp_ridge ridge)
{
    if (roof == PP_ROOF_FLAT)
        return 0;
    bool along_longer = ridge == PP_RIDGE_LONGER || roof == PP_ROOF_HIP;
    bool along_depth = along_longer ? depth_m > width_m : ridge == PP_RIDGE_DEPTH;
    double l = along_depth ? depth_m : width_m, w = along_depth ? width_m : depth_m;
    double in = roof == PP_ROOF_HIP ? 0.5 * w : 0.0;
    int count = roof == PP_ROOF_MONO ? mono(faces, l, w, height_m, pitch_rad)
                                     : ridged(faces, l, w, height_m, pitch_rad, in);
    /* Rotates by a quarter turn: v becomes u, u runs from the other end of v. */
    for (int i = 0; along_depth && i < count; i++)
        for (int k = 0; k < faces[i].count; k++) {
            struct pp_vec3 *p = &faces[i].corners[k];
            *p = pp_vec(p->y, depth_m - p->x, p->z);
        }
    return count;
}
