/* closed.c - do the faces of an envelope close the room?
 *
 * They do if every edge belongs to two faces that run along it in opposite directions.
 * Points nearer than PP_SAME_M are one and become equal to the bit, so that later steps
 * can follow edges from face to face. With all normals into the room, the volume
 *
 *     V = -1/3 sum A n . c    (c any point of the face)
 *
 * is positive; if it is not, the envelope is inside out.
 */
#include <stdint.h>
#include <stdlib.h>

#include "model/resolve.h"
#include "model/tolerance.h"

/* Points by the cube of space they are in, to find near ones without looking at all. */
struct cubes {
    struct pp_vec3 *points;
    int *next;  /* of the points in the same bucket; -1: the last */
    int *first; /* of a bucket */
    int count;
    unsigned bucket_count;
};

static const double cube_m = 4.0 * PP_SAME_M;

static unsigned bucket_of(const struct cubes *cubes, double x, double y, double z)
{
    uint64_t hash = (uint64_t)(int64_t)x * 0x9E3779B97F4A7C15u;
    hash = (hash ^ (uint64_t)(int64_t)y) * 0xC2B2AE3D27D4EB4Fu;
    hash = (hash ^ (uint64_t)(int64_t)z) * 0x165667B19E3779F9u;
    return (hash >> 32) % cubes->bucket_count;
}

/* The number of the point that p is one with, or of p as a new one. */
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
                    if (pp_length(pp_sub(cubes->points[i], p)) < PP_SAME_M)
                        return i;
    unsigned bucket =
        bucket_of(cubes, floor(p.x / cube_m), floor(p.y / cube_m), floor(p.z / cube_m));
    int number = cubes->count++;
    cubes->points[number] = p;
    cubes->next[number] = cubes->first[bucket];
    cubes->first[bucket] = number;
    return number;
}

/* Makes near corners one, and fills r->corners with their numbers. */
static enum pp_status join_corners(struct pp_resolver *r, int corner_count,
                                   struct pp_error *err)
{
    struct pp_world *world = r->world;
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
            struct pp_vec3 area = pp_area_vector(outline->vertices, outline->count);
            outline->area_m2 = pp_length(area);
            outline->normal = pp_scale(area, 1.0 / outline->area_m2);
        }
    } else {
        status = pp_fail_memory(err);
    }
    free(cubes.points);
    free(cubes.next);
    free(cubes.first);
    return status;
}

struct edge {
    int low, high; /* the corners' numbers */
    bool upward;   /* does the face run from low to high? */
    int face;
    struct pp_vec3 from, to;
};

static int compare_edges(const void *left, const void *right)
{
    const struct edge *a = left, *b = right;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return a->face != b->face ? (a->face < b->face ? -1 : 1) : 0;
}

static void list_edges(const struct pp_resolver *r, struct edge *edges)
{
    int corner = 0;
    for (int i = 0; i < r->world->face_count; i++) {
        const struct pp_polygon *outline = &r->world->surfaces[i].outline;
        const int *numbers = r->corners + corner;
        for (int k = 0; k < outline->count; k++, corner++) {
            int next = (k + 1) % outline->count;
            int from = numbers[k], to = numbers[next];
            edges[corner] = (struct edge){.low = from < to ? from : to,
                                          .high = from < to ? to : from,
                                          .upward = from < to,
                                          .face = i,
                                          .from = outline->vertices[k],
                                          .to = outline->vertices[next]};
        }
    }
}

/* What is wrong with the `count` edges that join the same two corners. */
static bool check_shared_edge(struct pp_resolver *r, const struct edge *edges,
                              int count)
{
    const struct pp_surface *faces = r->world->surfaces;
    const struct edge *edge = &edges[0];
    struct pp_vec3 from = edge->from, to = edge->to;
    int line = faces[edge->face].line;
    if (count == 2 && edges[0].upward != edges[1].upward)
        return true;
    if (count == 1)
        pp_mistake(r->mistakes, line,
                   "envelope does not close: the edge from (%g, %g, %g) to (%g, %g, "
                   "%g) of this face belongs to no other; every edge must be shared by "
                   "two faces",
                   from.x, from.y, from.z, to.x, to.y, to.z);
    else if (count == 2)
        pp_mistake(r->mistakes, faces[edges[1].face].line,
                   "this face and the one of line %d run the same way along the edge "
                   "from (%g, %g, %g) to (%g, %g, %g); one of them is not "
                   "counter-clockwise seen from inside",
                   line, from.x, from.y, from.z, to.x, to.y, to.z);
    else
        pp_mistake(r->mistakes, faces[edges[count - 1].face].line,
                   "the edge from (%g, %g, %g) to (%g, %g, %g) is shared by %d faces, "
                   "first by that of line %d; it must be by two",
                   from.x, from.y, from.z, to.x, to.y, to.z, count, line);
    return false;
}

static enum pp_status check_edges(struct pp_resolver *r, int corner_count,
                                  struct pp_error *err)
{
    struct edge *edges = malloc(corner_count * sizeof *edges);
    if (!edges)
        return pp_fail_memory(err);
    list_edges(r, edges);
    qsort(edges, corner_count, sizeof *edges, compare_edges);
    r->closed = true;
    for (int i = 0, end; i < corner_count; i = end) {
        for (end = i + 1; end < corner_count && edges[end].low == edges[i].low
                          && edges[end].high == edges[i].high;)
            end++;
        if (!check_shared_edge(r, edges + i, end - i))
            r->closed = false;
    }
    free(edges);
    return PP_OK;
}

static double volume_m3(const struct pp_world *world)
{
    double sum = 0.0;
    struct pp_vec3 origin = world->surfaces[0].outline.vertices[0];
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        struct pp_vec3 from = pp_sub(pp_polygon_middle(outline), origin);
        sum -= outline->area_m2 * pp_dot(outline->normal, from);
    }
    return sum / 3.0;
}

static void turn_inside_out(struct pp_world *world)
{
    for (int i = 0; i < world->face_count; i++) {
        struct pp_polygon *outline = &world->surfaces[i].outline;
        outline->normal = pp_scale(outline->normal, -1.0);
        for (int a = 0, b = outline->count - 1; a < b; a++, b--) {
            struct pp_vec3 swap = outline->vertices[a];
            outline->vertices[a] = outline->vertices[b];
            outline->vertices[b] = swap;
        }
    }
}

enum pp_status pp_resolve_closed(struct pp_resolver *r, struct pp_error *err)
{
    struct pp_world *world = r->world;
    int corner_count = 0;
    for (int i = 0; i < world->face_count; i++)
        corner_count += world->surfaces[i].outline.count;
    if (corner_count == 0 || r->faces_missing)
        return PP_OK;
    if (join_corners(r, corner_count, err) != PP_OK
        || check_edges(r, corner_count, err) != PP_OK)
        return PP_SYSTEM;
    if (!r->closed)
        return PP_OK;

    double volume = volume_m3(world);
    if (volume < 0.0) {
        pp_mistake(r->mistakes, r->room->plan.line,
                   "envelope is inside out: its faces run clockwise seen from inside; "
                   "give their vertices counter-clockwise");
        turn_inside_out(world);
        /* The numbers of each face's corners run the other way now, too. */
        return join_corners(r, corner_count, err);
    }
    return PP_OK;
}
