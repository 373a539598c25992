/* mesh_triangles.c - see mesh_triangles.h. */
#include "model/mesh/mesh_triangles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/convex_parts.h"

const char *const pp_mesh_triangles_no_memory = "out of memory";

void pp_mesh_triangles_clear(struct pp_mesh_triangles *mesh)
{
    free(mesh->corners);
    free(mesh->triangles);
    *mesh = (struct pp_mesh_triangles){0};
}

const char *pp_mesh_triangles_add_corner(struct pp_mesh_triangles *mesh,
                                         struct pp_vec3 corner)
{
    if (!(fabs(corner.x) < PP_MESH_COORDINATE_MOST
          && fabs(corner.y) < PP_MESH_COORDINATE_MOST
          && fabs(corner.z) < PP_MESH_COORDINATE_MOST))
        return "a coordinate exceeds 1e12; expected a model the size of a building";
    if (mesh->corner_count >= PP_MESH_CORNERS_MOST)
        return "there are more than 3000000 corners; expected a coarser model";
    if (pp_array_reserve(&mesh->corners, &mesh->corner_space, mesh->corner_count + 1,
                         sizeof *mesh->corners, NULL)
        != PP_OK)
        return pp_mesh_triangles_no_memory;
    mesh->corners[mesh->corner_count++] = corner;
    return NULL;
}

static const char *add_mesh_triangle(struct pp_mesh_triangles *mesh, int a, int b,
                                     int c)
{
    struct pp_vec3 p = mesh->corners[a];
    struct pp_vec3 along = pp_vec_sub(mesh->corners[b], p);
    struct pp_vec3 across = pp_vec_sub(mesh->corners[c], p);
    double longest = fmax(pp_vec_length(along), pp_vec_length(across));
    if (!(pp_vec_length(pp_vec_cross(along, across)) > 1e-9 * longest * longest))
        return NULL;
    if (mesh->triangle_count >= PP_MESH_MOST)
        return "there are more than 1000000 triangles; expected a coarser model";
    if (pp_array_reserve(&mesh->triangles, &mesh->triangle_space,
                         mesh->triangle_count + 1, sizeof *mesh->triangles, NULL)
        != PP_OK)
        return pp_mesh_triangles_no_memory;
    memcpy(mesh->triangles[mesh->triangle_count++], (int[]){a, b, c}, sizeof(int[3]));
    return NULL;
}

/* Triangulates a concave plane polygon. There are no triangles for a convex polygon;
 * the caller then uses a fan. PP_BAD_INPUT if the polygon crosses itself. */
static enum pp_status cut_concave_polygon(int (**triangles)[3], int *triangle_count,
                                          const struct pp_mesh_triangles *mesh,
                                          const int *corners, int count)
{
    struct pp_polygon polygon = {0};
    struct pp_vec3 *ring = malloc((size_t)count * sizeof *ring);
    *triangles = NULL;
    *triangle_count = 0;
    if (!ring)
        return PP_SYSTEM;
    for (int i = 0; i < count; i++)
        ring[i] = mesh->corners[corners[i]];
    enum pp_status status = pp_polygon_of(&polygon, ring, count, NULL);
    if (status == PP_OK)
        status = pp_convex_parts_triangles(triangles, triangle_count, &polygon, NULL);
    pp_polygon_clear(&polygon);
    free(ring);
    return status;
}

static const char *add_mesh_ring(struct pp_mesh_triangles *mesh, const int *corners,
                                 int count)
{
    int(*triangles)[3], triangle_count = 0;
    if (cut_concave_polygon(&triangles, &triangle_count, mesh, corners, count)
        == PP_SYSTEM)
        return pp_mesh_triangles_no_memory;
    const char *why = NULL;
    for (int i = 0; i < triangle_count && !why; i++)
        why = add_mesh_triangle(mesh, corners[triangles[i][0]],
                                corners[triangles[i][1]], corners[triangles[i][2]]);
    for (int i = 1; i + 1 < count && triangle_count == 0 && !why; i++)
        why = add_mesh_triangle(mesh, corners[0], corners[i], corners[i + 1]);
    free(triangles);
    return why;
}

const char *pp_mesh_triangles_add_face(struct pp_mesh_triangles *mesh,
                                       const int *corners, int count)
{
    if (count == 3)
        return add_mesh_triangle(mesh, corners[0], corners[1], corners[2]);
    int *kept = malloc((size_t)count * sizeof *kept), left = 0;
    if (!kept)
        return pp_mesh_triangles_no_memory;
    for (int i = 0; i < count; i++) {
        struct pp_vec3 here = mesh->corners[corners[i]];
        struct pp_vec3 next = mesh->corners[corners[(i + 1) % count]];
        if (pp_vec_length(pp_vec_sub(here, next)) > 0.0)
            kept[left++] = corners[i];
    }
    const char *why = left >= 3 ? add_mesh_ring(mesh, kept, left) : NULL;
    free(kept);
    return why;
}
