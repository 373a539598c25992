/* triangles.c - cuts convex polygons into fans of triangles, and all others into
 * triangles by the clipper. */
#include "simulate/scene/triangles.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/room/face_less_openings.h"
#include "simulate/sampling/lobe.h"

static enum pp_status append_triangle(struct pp_triangles *list, struct pp_vec3 a,
                                      struct pp_vec3 b, struct pp_vec3 c, int facet,
                                      struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&list->corners, list->count, sizeof *list->corners, err);
    if (status == PP_OK)
        status =
            pp_array_append(&list->facet_of, list->count, sizeof *list->facet_of, err);
    if (status != PP_OK)
        return status;
    list->corners[list->count][0] = a;
    list->corners[list->count][1] = b;
    list->corners[list->count][2] = c;
    list->facet_of[list->count++] = facet;
    return PP_OK;
}

/* True if the outline turns left at every corner, by 360 degrees in total. */
static bool outline_is_convex(const struct pp_polygon *polygon)
{
    int n = polygon->count;
    double round = 0.0;
    if (n == 3)
        return true;
    for (int i = 0; i < n; i++) {
        struct pp_vec3 a = polygon->vertices[i], b = polygon->vertices[(i + 1) % n];
        struct pp_vec3 c = polygon->vertices[(i + 2) % n];
        struct pp_vec3 in = pp_vec_sub(b, a), out = pp_vec_sub(c, b);
        double turn = pp_vec_dot(pp_vec_cross(in, out), polygon->normal);
        if (turn < 0.0)
            return false;
        round += atan2(turn, pp_vec_dot(in, out));
    }
    return round < 3.0 * PP_PI;
}

/* Appends a convex polygon as a fan of triangles. */
static enum pp_status fan(struct pp_triangles *list, const struct pp_polygon *polygon,
                          int facet, struct pp_vec3 centre, struct pp_error *err)
{
    struct pp_vec3 first = pp_vec_sub(polygon->vertices[0], centre);
    enum pp_status status = PP_OK;
    for (int i = 2; status == PP_OK && i < polygon->count; i++)
        status =
            append_triangle(list, first, pp_vec_sub(polygon->vertices[i - 1], centre),
                            pp_vec_sub(polygon->vertices[i], centre), facet, err);
    return status;
}

/* Appends the clipper's triangles of a polygon, without the openings in `face` (-1:
 * none). */
static enum pp_status triangulate(struct pp_triangles *list, struct pp_clipper *clipper,
                                  const struct pp_polygon *polygon, int facet,
                                  const struct pp_world *world, int face,
                                  struct pp_vec3 centre, struct pp_error *err)
{
    struct pp_face_axes axes = {.origin = polygon->vertices[0]};
    struct pp_region region = {0, NULL};
    double(*pieces)[3][2] = NULL;
    int count = 0;
    pp_lobe_frame(polygon->normal, &axes.a, &axes.b);
    enum pp_status status =
        pp_face_less_openings(&region, clipper, &axes, polygon, world, face, err);
    if (status == PP_OK)
        status = pp_clipper_triangulate(clipper, &pieces, &count, &region, err);
    for (int i = 0; status == PP_OK && i < count; i++) {
        struct pp_vec3 corner[3];
        for (int k = 0; k < 3; k++)
            corner[k] = pp_vec_sub(
                pp_face_less_openings_corner(&axes, pieces[i][k], polygon, world, face),
                centre);
        status = append_triangle(list, corner[0], corner[1], corner[2], facet, err);
    }
    free(pieces);
    pp_region_clear(&region);
    return status;
}

float (*pp_triangles_single(const struct pp_vec3 (*corners)[3], int count))[3][3]
{
    float(*single)[3][3] = malloc(((size_t)count + 1) * sizeof *single);
    for (int i = 0; single && i < count; i++)
        for (int k = 0; k < 3; k++) {
            struct pp_vec3 v = corners[i][k];
            single[i][k][0] = (float)v.x;
            single[i][k][1] = (float)v.y;
            single[i][k][2] = (float)v.z;
        }
    return single;
}

void pp_triangles_clear(struct pp_triangles *list)
{
    free(list->corners);
    free(list->facet_of);
    *list = (struct pp_triangles){0};
}

enum pp_status pp_triangles_of_polygon(struct pp_triangles *list,
                                       struct pp_clipper *clipper,
                                       const struct pp_polygon *polygon, int facet,
                                       struct pp_vec3 centre, struct pp_error *err)
{
    if (outline_is_convex(polygon))
        return fan(list, polygon, facet, centre, err);
    return triangulate(list, clipper, polygon, facet, NULL, -1, centre, err);
}

enum pp_status pp_triangles_of_surface(struct pp_triangles *list,
                                       struct pp_clipper *clipper,
                                       const struct pp_world *world, int surface,
                                       struct pp_vec3 centre, struct pp_error *err)
{
    const struct pp_polygon *outline = &world->surfaces[surface].outline;
    bool whole = true;
    for (int i = 0; whole && surface < world->face_count && i < world->opening_count;
         i++)
        whole = world->openings[i].face != surface;
    if (whole)
        return pp_triangles_of_polygon(list, clipper, outline, surface, centre, err);
    return triangulate(list, clipper, outline, surface, world, surface, centre, err);
}

enum pp_status pp_triangles_of_plane(struct pp_vec3 (**triangles)[3], int *count,
                                     struct pp_clipper *clipper,
                                     const struct pp_world *world,
                                     struct pp_vec3 centre, struct pp_error *err)
{
    double(*pieces)[3][2] = NULL;
    *triangles = NULL;
    *count = 0;
    if (world->plane.count == 0)
        return PP_OK;
    enum pp_status status =
        pp_clipper_triangulate(clipper, &pieces, count, &world->plane, err);
    if (status != PP_OK)
        return status;
    *triangles = malloc(sizeof **triangles * (size_t)(*count + 1));
    if (!*triangles) {
        free(pieces);
        *count = 0;
        return pp_fail_memory(err);
    }
    for (int i = 0; i < *count; i++)
        for (int k = 0; k < 3; k++)
            (*triangles)[i][k] = pp_vec_sub(
                pp_vec(pieces[i][k][0], pieces[i][k][1], world->working_plane_m),
                centre);
    free(pieces);
    return PP_OK;
}
