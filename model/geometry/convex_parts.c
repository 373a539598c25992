/* convex_parts.c - tests whether a polygon is convex, and triangulates other
 * polygons. */
#include "model/geometry/convex_parts.h"

#include <stdlib.h>
#include <string.h>

#include "model/geometry/clipper.h"

bool pp_convex_parts_is_convex(const struct pp_polygon *outline)
{
    const struct pp_vec3 *v = outline->vertices;
    for (int i = 0; i < outline->count; i++) {
        int next = (i + 1) % outline->count, after = (i + 2) % outline->count;
        struct pp_vec3 turn =
            pp_vec_cross(pp_vec_sub(v[next], v[i]), pp_vec_sub(v[after], v[next]));
        if (pp_vec_dot(turn, outline->normal) < -1e-12 * outline->area_m2)
            return false;
    }
    return true;
}

/* Projects a vertex along the axis nearest to its polygon's normal. The other two
 * coordinates are copied unchanged, so that corners of triangles can be matched
 * exactly. */
static void drop_largest_axis(double xy[2], struct pp_vec3 v, struct pp_vec3 normal)
{
    struct pp_vec3 n = pp_vec(fabs(normal.x), fabs(normal.y), fabs(normal.z));
    if (n.z >= n.x && n.z >= n.y)
        xy[0] = v.x, xy[1] = v.y;
    else if (n.x >= n.y)
        xy[0] = v.y, xy[1] = v.z;
    else
        xy[0] = v.z, xy[1] = v.x;
}

enum pp_status pp_convex_parts_triangles(int (**triangles)[3], int *count,
                                         const struct pp_polygon *outline,
                                         struct pp_error *err)
{
    *triangles = NULL;
    *count = 0;
    if (pp_convex_parts_is_convex(outline))
        return PP_OK;
    double(*flat)[2] = malloc((size_t)outline->count * sizeof *flat);
    double(*found)[3][2] = NULL;
    struct pp_clipper *clipper = NULL;
    struct pp_region region = {0};
    enum pp_status status = flat ? PP_OK : pp_fail_memory(err);
    for (int i = 0; flat && i < outline->count; i++)
        drop_largest_axis(flat[i], outline->vertices[i], outline->normal);
    if (status == PP_OK)
        status = pp_clipper_create(&clipper, err);
    if (status == PP_OK)
        status = pp_clipper_of_ring(clipper, &region, (const double(*)[2])flat,
                                    outline->count, err);
    if (status == PP_OK)
        status = pp_clipper_triangulate(clipper, &found, count, &region, err);
    if (status == PP_OK) {
        *triangles = malloc((size_t)(*count + 1) * sizeof **triangles);
        if (!*triangles)
            status = pp_fail_memory(err);
    }
    for (int t = 0; status == PP_OK && t < *count; t++)
        for (int corner = 0; corner < 3; corner++) {
            int i = 0;
            while (i + 1 < outline->count
                   && memcmp(flat[i], found[t][corner], sizeof *flat) != 0)
                i++;
            (*triangles)[t][corner] = i;
        }
    free(found);
    free(flat);
    pp_region_clear(&region);
    pp_clipper_destroy(clipper);
    return status;
}
