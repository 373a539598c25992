/* corners.c - merges points by a spatial hash with cubes of 4 mm. */
#include "model/room/build/corners.h"

#include <stdint.h>
#include <stdlib.h>

#include "model/geometry/tolerance.h"

/* Hash table of points by cube, so that only near points are compared. */
struct cubes {
    struct pp_vec3 *points;
    int *next;  /* next point in the same bucket, by point; -1: none */
    int *first; /* first point, by bucket; -1: none */
    int count;
    unsigned bucket_count;
};

static const double cube_m = 4.0 * PP_SAME_M;

/* Distance below which points are merged. Corners that the file puts exactly 1 mm apart
 * stay separate, whatever the rounding of their difference. */
static const double one_m = PP_SAME_M - PP_ROUNDING_M;

static unsigned bucket_of(const struct cubes *cubes, double x, double y, double z)
{
    uint64_t hash = (uint64_t)(int64_t)x * 0x9E3779B97F4A7C15u;
    hash = (hash ^ (uint64_t)(int64_t)y) * 0xC2B2AE3D27D4EB4Fu;
    hash = (hash ^ (uint64_t)(int64_t)z) * 0x165667B19E3779F9u;
    return (hash >> 32) % cubes->bucket_count;
}

/* Index of the point that equals p to within one_m; p is added if there is none. */
static int point_number(struct cubes *cubes, struct pp_vec3 p)
{
    double low[3] = {floor((p.x - PP_SAME_M) / cube_m),
                     floor((p.y - PP_SAME_M) / cube_m),
                     floor((p.z - PP_SAME_M) / cube_m)};
    double high[3] = {floor((p.x + PP_SAME_M) / cube_m),
                      floor((p.y + PP_SAME_M) / cube_m),
                      floor((p.z + PP_SAME_M) / cube_m)};
    for (double x = low[0]; x <= high[0]; x++)
        for (double y = low[1]; y <= high[1]; y++)
            for (double z = low[2]; z <= high[2]; z++)
                for (int i = cubes->first[bucket_of(cubes, x, y, z)]; i >= 0;
                     i = cubes->next[i])
                    if (pp_vec_length(pp_vec_sub(cubes->points[i], p)) < one_m)
                        return i;
    unsigned bucket =
        bucket_of(cubes, floor(p.x / cube_m), floor(p.y / cube_m), floor(p.z / cube_m));
    int number = cubes->count++;
    cubes->points[number] = p;
    cubes->next[number] = cubes->first[bucket];
    cubes->first[bucket] = number;
    return number;
}

enum pp_status pp_build_corners(struct pp_resolver *r, struct pp_error *err)
{
    struct pp_world *world = r->world;
    int corner_count = 0;
    for (int i = 0; i < world->face_count; i++)
        corner_count += world->surfaces[i].outline.count;
    if (corner_count == 0)
        return PP_OK;
    struct cubes cubes = {.bucket_count = 2 * corner_count + 1};
    cubes.points = malloc(corner_count * sizeof *cubes.points);
    cubes.next = malloc(corner_count * sizeof *cubes.next);
    cubes.first = malloc(cubes.bucket_count * sizeof *cubes.first);
    free(r->corners);
    r->corners = malloc(corner_count * sizeof *r->corners);
    enum pp_status status = PP_OK;
    if (cubes.points && cubes.next && cubes.first && r->corners) {
        for (unsigned i = 0; i < cubes.bucket_count; i++)
            cubes.first[i] = -1;
        int corner = 0;
        for (int i = 0; i < world->face_count; i++) {
            struct pp_polygon *outline = &world->surfaces[i].outline;
            for (int k = 0; k < outline->count; k++) {
                int number = point_number(&cubes, outline->vertices[k]);
                outline->vertices[k] = cubes.points[number];
                r->corners[corner++] = number;
            }
            pp_polygon_measure(outline);
        }
    } else {
        status = pp_fail_memory(err);
    }
    free(cubes.points);
    free(cubes.next);
    free(cubes.first);
    return status;
}
