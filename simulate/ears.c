/* ears.c - see ears.h. */
#include "simulate/ears.h"

#include <math.h>
#include <stdbool.h>

/* Twice the area of the triangle, seen against the normal. */
static double turn(struct pp_vec3 a, struct pp_vec3 b, struct pp_vec3 c,
                   struct pp_vec3 normal)
{
    return pp_dot(normal, pp_cross(pp_sub(b, a), pp_sub(c, a)));
}

static bool same_point(struct pp_vec3 a, struct pp_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Does the corner lie in the triangle, its edges included, and is it none of its
 * corners? */
static bool hinders(struct pp_vec3 p, struct pp_vec3 a, struct pp_vec3 b,
                    struct pp_vec3 c, struct pp_vec3 normal)
{
    if (same_point(p, a) || same_point(p, b) || same_point(p, c))
        return false;
    return turn(a, b, p, normal) >= 0.0 && turn(b, c, p, normal) >= 0.0
           && turn(c, a, p, normal) >= 0.0;
}

static bool is_ear(const struct pp_vec3 *corners, const int *order, int left, int i,
                   struct pp_vec3 normal)
{
    struct pp_vec3 a = corners[order[(i + left - 1) % left]], b = corners[order[i]];
    struct pp_vec3 c = corners[order[(i + 1) % left]];
    if (!(turn(a, b, c, normal) > 0.0))
        return false;
    for (int k = 0; k < left; k++)
        if (hinders(corners[order[k]], a, b, c, normal))
            return false;
    return true;
}

/* The next corner to cut off: an ear; else one that turns no way; else the one that
 * turns most, whatever it does. */
static int next_cut(const struct pp_vec3 *corners, const int *order, int left,
                    int start, struct pp_vec3 normal)
{
    int widest = 0;
    double most = -INFINITY;
    for (int k = 0; k < left; k++)
        if (is_ear(corners, order, left, (start + k) % left, normal))
            return (start + k) % left;
    for (int i = 0; i < left; i++) {
        double area = turn(corners[order[(i + left - 1) % left]], corners[order[i]],
                           corners[order[(i + 1) % left]], normal);
        if (area == 0.0)
            return i;
        if (area > most) {
            most = area;
            widest = i;
        }
    }
    return widest;
}

int pp_cut_ears(const struct pp_vec3 *corners, int count, struct pp_vec3 normal,
                int (*triangles)[3], int *order)
{
    int made = 0, start = 0;
    for (int i = 0; i < count; i++)
        order[i] = i;
    for (int left = count; left > 2; left--) {
        int cut = next_cut(corners, order, left, start, normal);
        int before = order[(cut + left - 1) % left], after = order[(cut + 1) % left];
        if (turn(corners[before], corners[order[cut]], corners[after], normal) > 0.0) {
            triangles[made][0] = before;
            triangles[made][1] = order[cut];
            triangles[made++][2] = after;
        }
        for (int i = cut; i < left - 1; i++)
            order[i] = order[i + 1];
        /* Round the outline, so that no corner becomes a fan of slivers. */
        start = cut % (left - 1);
    }
    return made;
}
